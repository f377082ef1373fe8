#!/usr/bin/env bats
# Records in which something happens (tests/data/records): what is measured, and what is not.

bats_require_minimum_version 1.5.0
load ../curves

setup() {
    records="$BATS_TEST_DIRNAME/../data/records"
    cd "$BATS_TEST_TMPDIR" || return 1
}

# measure NAME OPTIONS...: properties in p.csv
measure() { hspost -q "$records/$1.csv" "${@:2}" -p p.csv -o curve.csv 2>said; }

# blank NAME FLAG: without a value, and with the reason
blank() { grep -q "^$1,[^,]*,,.*\[$2\]" p.csv || { grep "^$1," p.csv; return 1; }; }
flagged() { grep -q "^$1,.*\[$2\]" p.csv || { grep "^$1," p.csv; return 1; }; }

# The curve of voce.csv, whatever else happened.
is_voce() {
    near "$(value modulus p.csv)" 69.88 0.1
    near "$(value proof_strength_0.2 p.csv)" 152.88 0.1
    near "$(value tensile_strength p.csv)" 221.29 0.01
    near "$(value extension_at_maximum_force p.csv)" 14.2 0.2
    near "$(value hardening_exponent p.csv)" 0.186 0.003
    blank upper_yield_strength no_yield_point
    blank lower_yield_strength no_yield_point
    blank yield_point_extension no_yield_point
}

@test "upper yield point above the strength of work hardening" {
    measure upper_yield_above_strength
    near "$(value upper_yield_strength p.csv)" 480 0.01
    near "$(value lower_yield_strength p.csv)" 277 0.05
    near "$(value tensile_strength p.csv)" 430 0.01
    near "$(value extension_at_maximum_force p.csv)" 17.9 0.3
    # Slope and stress are equal once more, for the last time, behind the plateau, near ln(1 + Agt).
    near "$(value considere_strain p.csv)" "$(value true_strain_at_maximum_force p.csv)" 0.003
    # The plateau ends at 2 %, the peak is at 0.233 %.
    near "$(value yield_point_extension p.csv)" 1.77 0.05
    # Laws and n begin behind it.
    grep '^voce_yield,' p.csv | grep -qE 'true plastic strain 0.0(18|19|2)'
    grep -qE '^hardening_exponent,n2-Ag,' p.csv
}

@test "a fall of 1.2 % is a yield point, by ISO 6892-1 from 0.5 % on" {
    measure small_yield_drop
    # A wave of the plateau exceeds the first maximum of 300 MPa by 0.45 MPa within 0.05 % of strain, and counts.
    near "$(value upper_yield_strength p.csv)" 300 0.5
    measure small_yield_drop --yield-drop 0.02
    blank upper_yield_strength no_yield_point
}

@test "a yield point in noise, and noise without a yield point" {
    measure yield_point_noise
    near "$(value upper_yield_strength p.csv)" 320 1
    near "$(value tensile_strength p.csv)" 430 1
    near "$(value noise p.csv)" 0.3 0.03
    measure noise
    blank upper_yield_strength no_yield_point
    near "$(value proof_strength_0.2 p.csv)" 152.9 0.5
    near "$(value tensile_strength p.csv)" 221.75 0.45
    near "$(value noise p.csv)" 0.3 0.03
    # Every property of the noisy curve carries an error; none of the exact one does but its fits.
    for property in toe proof_strength_0.2 tensile_strength extension_at_maximum_force plastic_extension_at_fracture; do
        awk -F, -v name="$property" '$1 == name {found = $5 > 0} END {exit !found}' p.csv
    done
    measure voce
    awk -F, '$1 == "tensile_strength" {found = $5 == ""} END {exit !found}' p.csv
}

@test "a loop of unloading and reloading is left out" {
    measure unloading_loop
    is_voce
    near "$(value loops p.csv)" 1 0
    near "$(value proof_strength_0.2_loop p.csv)" 152.88 0.1
    # in the curve its rows are there, without true values
    [ "$(grep -vc '^[#t]' curve.csv)" -eq "$(grep -c '^[0-9-]' "$records/unloading_loop.csv")" ]
    [ "$(grep -v '^[#t]' curve.csv | awk -F, '$7 == "" && $5 < 0.14' | wc -l)" -ge 30 ]
}

@test "a hold with relaxation is left out" {
    measure hold
    is_voce
    near "$(value holds p.csv)" 1 0
}

@test "a start in compression makes no yield point" {
    measure compressive_start
    is_voce
}

@test "an extensometer that stands, or falls off: the force is measured, the extensions are lower bounds" {
    measure extensometer_off
    near "$(value tensile_strength p.csv)" 221.29 0.01
    near "$(value proof_strength_0.2 p.csv)" 152.88 0.1
    for property in extension_at_maximum_force plastic_extension_at_maximum_force extension_at_fracture plastic_extension_at_fracture; do
        flagged "$property" strain_not_measured
    done
    near "$(value extension_at_fracture p.csv)" 9.94 0.01
    blank considere_strain strain_not_measured
    # taken off at 8 %: its reading springs back and stands
    awk -F, '/^e/ {print; next} $1 > 0.08 {print 0.02 "," $2; next} {print}' "$records/voce.csv" >off.csv
    hspost -q off.csv -p p.csv -o /dev/null
    near "$(value tensile_strength p.csv)" 221.29 0.01
    flagged extension_at_fracture strain_not_measured
    near "$(value extension_at_fracture p.csv)" 8 0.2
}

@test "rows that run backwards are turned, with a word" {
    measure reversed
    is_voce
    hspost "$records/reversed.csv" -o /dev/null 2>said
    grep -q 'the strain falls from row to row; taken from the last row to the first' said
}

@test "nine points of a figure: what they give, and that they are few" {
    measure digitised_coarse
    near "$(value modulus p.csv)" 69 0.5
    near "$(value proof_strength_0.2 p.csv)" 153 1
    flagged modulus few_points
}

@test "compression is refused" {
    awk -F, '/^e/ {print; next} {print (-$1) "," (-$2)}' "$records/voce.csv" >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"the record is one of compression"*"change the signs of both columns"* ]]
}

@test "a record that ends unloaded is not broken" {
    awk -F, '/^e/ {print; next} $1 > 0.1 && !u {u = 1; for (i = 0; i <= 20; i++) printf "%.8f,%.5f\n", e - i / 20 * s / 69880, s * (1 - i / 20); exit} {e = $1; s = $2; print}' \
        "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    flagged extension_at_fracture unloaded
    near "$(value extension_at_fracture p.csv)" 9.9 0.2
    flagged tensile_strength not_reached
}

@test "serrations are left out and counted" {
    # 2 % down at standing strain rate and elastically back, four times; not as short as a spike
    awk -F, '/^e/ {print; next} {print; if ($1 > 0.03 && NR % 20 == 0 && k < 4) {k++; d = 0.02 * $2 / 69880
        printf "%.8f,%.5f\n%.8f,%.5f\n", $1 + 0.6 * d, 0.98 * $2, $1 + 1.6 * d, $2}}' "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    is_voce
    near "$(value serrations p.csv)" 4 0
}

# implausible WHAT FACTOR-OF-STRAIN FACTOR-OF-STRESS
implausible() {
    awk -F, -v a="$2" -v b="$3" '/^e/ {print; next} {printf "%.9g,%.9g\n", a * $1, b * $2}' "$records/voce.csv" >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"$1"*"--accept takes it as it is"* ]] || { echo "$stderr"; return 1; }
    hspost -q --accept t.csv -o /dev/null
}

@test "what cannot be a metal is refused with the likely cause" {
    implausible 'slope of the elastic part is 0.699 GPa, the largest strain 18.4' 100 1
    implausible 'the strain seems to be in %' 100 1
    implausible 'the stress seems to be in Pa' 1 1e6
    implausible 'the stress seems to be in kPa' 1 1e3
    implausible 'the stress seems to be in GPa' 1 1e-3
    implausible 'the strain seems to be in um/m' 1e6 1
    implausible 'the strain seems to be in % and the stress in Pa' 100 1e6
    # 2 % of elongation and a slope of 2 GPa, as of a polymer: but no body bears 0.7 of its slope
    awk 'BEGIN {print "strain,stress (MPa)"; for (i = 0; i <= 200; i++) {e = i * 1e-4; s = 2.06e5 * e; print 100 * e "," (s < 1300 ? s : 1300 + 20 * i)}}' >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"no stress above a tenth of the slope; the strain seems to be in %"* ]]
}

@test "signs that do not go together, and rows in no order, are refused" {
    awk -F, '/^e/ {print; next} {print (-$1) "," $2}' "$records/voce.csv" >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"t: the strain is negative where the stress is positive: change the sign of its column"* ]]
    awk -F, '/^e/ {print; next} {print $1 "," (-$2)}' "$records/voce.csv" >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"the stress is negative where the strain is positive"* ]]
    { head -1 "$records/voce.csv"; sed 1d "$records/voce.csv" | awk '{print (NR * 83) % 222 " " $0}' | sort -n | cut -d' ' -f2; } >t.csv
    run -2 --separate-stderr hspost t.csv
    [[ $stderr == *"the rows are in no order: the strain goes 0."*" of its range from one row to the next"* ]]
}

# Rows by number, changed: leap 'NR == 100 {...}'
leap() {
    awk -F, -v OFS=, "$1 {print}" "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    is_voce
    near "$(value extension_at_fracture p.csv)" 18.36 0.01
    near "$(value spikes p.csv)" "$2" 0
}

@test "a few rows that leap as no body's do are left out" {
    leap 'NR == 40 || NR == 150 || NR == 151 {$2 += 60}' 2
    leap 'NR == 150 {$2 = 0}' 1
    leap 'NR == 120 {$1 = 0.9}' 1
    leap 'NR == 120 {$1 = 0}' 1
    leap 'NR == 100 {$1 += 0.01}' 1
}

@test "a fall behind half a per cent of plastic strain is no yield point" {
    # serrations that are regained slowly
    awk -F, '/^e/ {print; next} {print $1 "," ($1 > 0.01 && $1 < 0.18 ? $2 * (1 - 0.02 * (1 - (NR % 10) / 10)) : $2)}' "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    blank upper_yield_strength no_yield_point
    near "$(value hardening_exponent p.csv)" 0.186 0.01
}

@test "a bent toe: the slope behind it, and its origin" {
    # to 0.2 % a parabola with the slope of 70 GPa at its end, which takes 0.1 % more than the straight line would
    for noise in 0 0.5; do
        awk -v noise=$noise 'function normal() {return noise * sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand())}
            BEGIN {srand(3); E = 70000; print "strain,stress (MPa)"
            for (i = 0; i < 60; i++) {e = 0.002 * i / 60; printf "%.9f,%.6f\n", e, E * e * e / 0.004 + normal()}
            for (i = 0; i <= 340; i++) {e = 0.002 + i * (i < 40 ? 4e-5 : 4e-4); x = e - 0.001
                s = E * x; if (s > 150) s = 150 + 1000 * (x - 150 / E); printf "%.9f,%.6f\n", e, s + normal()}}' >t.csv
        hspost -q t.csv -p p.csv -o /dev/null
        # The parts that are tried begin at shares of Rp0.2: the one at its half holds a little of the toe.
        near "$(value modulus p.csv)" 70 "$(awk -v n=$noise 'BEGIN {print 0.3 + 3 * n}')"
        near "$(value toe p.csv)" 0.001 3e-5
        flagged modulus steepest_part
    done
}

@test "values rounded to steps have the errors of that" {
    awk -F, '/^e/ {print; next} {for (i = 0; i < 8; i++) {x = e + (i + 1) / 8 * ($1 - e); y = s + (i + 1) / 8 * ($2 - s); printf "%.9f,%d\n", x, y + 0.5}; e = $1; s = $2}' \
        "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    near "$(value noise p.csv)" 0.2887 0.001
    awk -F, '$1 == "proof_strength_0.2" {found = $3 - 152.88 < 2 * $5 && 152.88 - $3 < 2 * $5 && $5 < 0.5} END {exit !found}' p.csv
}

@test "ISO and ASTM: a yield point by zero slope, n over total strain" {
    # A fall of 0.3 % is a maximum of zero slope, but not one by ISO.
    awk -F, '/^e/ {print; next} {print $1 "," ($1 > 0.001457 && $1 < 0.0203 ? 299.1 : $2)}' "$records/small_yield_drop.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    blank upper_yield_strength no_yield_point
    hspost -q t.csv --standard astm -p p.csv -o /dev/null
    near "$(value upper_yield_strength p.csv)" 300 0.01
    near "$(value lower_yield_strength p.csv)" 299.1 0.01
    # from 0.1456 % to where the line of hardening meets 299.1 MPa, at 2.0 % and a little
    near "$(value yield_point_extension p.csv)" 1.9 0.1
    iso=$(hspost -q "$records/voce.csv" -p p.csv -o /dev/null && value hardening_exponent p.csv)
    astm=$(hspost -q "$records/voce.csv" --standard astm -p p.csv -o /dev/null && value hardening_exponent p.csv)
    # The same points over ln(1 + e): regression by hand.
    by_hand=$(grep '^[0-9]' "$records/voce.csv" | awk -F, '{e = $1; s = $2; p = e - s / 69882.05; if (p >= 0.02 && p <= 0.13883) {
        x = log(log(1 + e)); y = log(s * (1 + e)); n++; a += x; b += y; c += x * x; d += x * y}} END {print (n * d - a * b) / (n * c - a * a)}')
    near "$astm" "$by_hand" 0.0005
    [ "$(awk -v a="$iso" -v b="$astm" 'BEGIN {print (b > a + 0.003)}')" -eq 1 ]
    run -2 --separate-stderr hspost --standard din "$records/voce.csv"
    [[ $stderr == *"--standard: 'din', expected one of iso, astm"* ]]
}

@test "loops as a table and as a figure, of one curve and of several" {
    # A row of two elements side by side (E 100 GPa, yield at 100 and 500 MPa), down by 0.4 % of strain at 2 and 4 %.
    awk 'BEGIN {print "true strain,true stress (MPa)"; split("0 0.02 0.016 0.04 0.036 0.06", turn, " ")
        for (leg = 1; leg < 6; leg++) for (i = 1; i <= 400; i++) {
            e = turn[leg] + i / 400 * (turn[leg + 1] - turn[leg])
            for (k = 1; k <= 2; k++) {y = k == 1 ? 100 : 500; s = 1e5 * (e - p[k])
                if (s > y) p[k] = e - y / 1e5; if (s < -y) p[k] = e + y / 1e5; f[k] = 1e5 * (e - p[k])}
            printf "%.9f,%.6f\n", e, (f[1] + f[2]) / 2}}' >t.csv
    hspost t.csv --loops loops.csv --plot-loops loops.svg -o curve.csv 2>said
    [ "$(head -1 loops.csv)" = loop,true_strain,plastic_strain,flow_stress_MPa,lowest_stress_MPa,unloading_modulus_GPa,reloading_modulus_GPa,reverse_yield_MPa,reload_yield_MPa,back_stress_MPa,effective_stress_MPa,hysteresis_width,hysteresis_area_MJ_per_m3,damage,unloading_modulus_error_GPa,reloading_modulus_error_GPa,reverse_yield_error_MPa,reload_yield_error_MPa,back_stress_error_MPa,effective_stress_error_MPa,flag ]
    [ "$(wc -l <loops.csv)" -eq 3 ]
    # from 300 MPa down to 0 MPa: half of both
    near "$(awk -F, 'NR == 2 {print $10}' loops.csv)" 150 1
    near "$(awk -F, 'NR == 3 {print $2}' loops.csv)" 0.04 1e-6
    grep -q 'loop 2 at 4.00 %: flow stress 300 MPa, back stress 150 MPa (50 %), unloading 100.0 GPa' said
    grep -q 'back' loops.svg
    # the loops of a curve that hspost has written are those of the table
    hspost -q curve.csv --loops again.csv -o /dev/null
    awk -F, 'FNR == 1 {next} NR == FNR {a[FNR] = $10; next} {if ((a[FNR] - $10) ^ 2 > 1e-6) exit 1}' loops.csv again.csv
    hspost -q t.csv "$records/unloading_loop.csv" --loops both.csv
    [ "$(grep -c '^t,' both.csv)" -eq 2 ]
    grep -q '^unloading_loop,1,.*,no_reverse_yield$' both.csv
}

@test "the plastic strain ratio of a table with a strain across" {
    # Along the law of voce.csv; across -nu of the elastic strain and -r/(1 + r) of the plastic one, r = 1.5, nu = 0.33.
    awk -F, '/^e/ {print "Strain (-),Stress (MPa),Transverse strain (-)"; next}
        {s = $2 * (1 + $1); q = s / 70000; p = log(1 + $1) - q; printf "%s,%s,%.9f\n", $1, $2, exp(-0.33 * q - 0.6 * p) - 1}' \
        "$records/voce.csv" >t.csv
    hspost -q t.csv -p p.csv -o /dev/null
    grep -q '^plastic_strain_ratio,r2-Ag,' p.csv
    near "$(value plastic_strain_ratio p.csv)" 1.5 0.01
    hspost -q "$records/voce.csv" -p p.csv -o /dev/null
    run ! grep -q plastic_strain_ratio p.csv
}
