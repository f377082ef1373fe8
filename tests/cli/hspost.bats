#!/usr/bin/env bats
# hspost from the command line, on the two digitised curves.

bats_require_minimum_version 1.5.0
load ../curves

setup() {
    data="$BATS_TEST_DIRNAME/../data"
    cd "$BATS_TEST_TMPDIR" || return 1
}

@test "help and version go to standard output" {
    hspost --help 2>/dev/null | grep -q -- --properties
    hspost --version 2>/dev/null | grep -q '^hspost '
}

@test "a table from a pipe becomes a curve on standard output" {
    hspost < "$data/ni200_cg.csv" > curve.csv 2> messages
    grep -q '^# program: hspost' curve.csv
    grep -v '^#' curve.csv | head -1 > header
    grep -q '^time_s,force_left_N,force_right_N,extension_m,engineering_strain,engineering_stress_MPa,true_strain,true_stress_MPa,plastic_strain,' header
    [ "$(grep -vc '^#' curve.csv)" -eq 47 ]
    grep -q 'Rm .* 431 MPa .*not_reached' messages
}

@test "the check sum of the input is that of cksum" {
    hspost -q "$data/ni200_cg.csv" > curve.csv
    grep -q "^# input_cksum: $(cksum < "$data/ni200_cg.csv")\$" curve.csv
}

# Tolerances: half a unit of the last digit printed with the digitised curve.
@test "properties as CSV and as JSON, by options" {
    hspost -q --modulus-rows 1:4 "$data/hpt_ni_ufg.csv" -o curve.csv -p properties.csv -j properties.json
    [ "$(head -1 properties.csv)" = property,symbol,value,unit,uncertainty,definition ]
    near "$(value modulus properties.csv)" 41.06 0.005
    near "$(value proof_strength_0.2 properties.csv)" 1450.18 0.005
    near "$(value plastic_extension_at_fracture properties.csv)" 7.669 0.0005
    perl -MJSON::PP -e 'local $/; my %p = map { $_->{property} => $_ } @{decode_json(<>)};
        exit !(abs($p{tensile_strength}{value} - 1766.67) <= 0.005 && $p{tensile_strength}{unit} eq "MPa"
               && !defined $p{hardening_exponent}{value} && $p{hardening_exponent}{flag} eq "too_few_points")' \
        properties.json
}

@test "options and the deck's section say the same" {
    printf 'post: {title: HPT, modulus_rows: [1, 4], true_modulus: 200 GPa, fit_range: [0.0015, 1]}\n' > deck.yaml
    hspost -q "$data/hpt_ni_ufg.csv" --deck deck.yaml -p deck.csv -o /dev/null
    hspost -q "$data/hpt_ni_ufg.csv" --modulus-rows 1:4 --true-modulus '200 GPa' --fit-range 0.0015:1 \
        -p options.csv -o /dev/null
    cmp deck.csv options.csv
    near "$(value voce_yield deck.csv)" 1259.76 0.005
}

@test "a curve written by hspost reads back to the same curve and properties" {
    hspost -q "$data/hpt_ni_ufg.csv" --modulus-rows 1:4 --true-modulus '200 GPa' -o once.csv -p once.p
    hspost -q once.csv -o twice.csv -p twice.p
    # MPa to Pa and back costs the last digit; plastic strain is a difference: 1e-14 of true strain
    paste -d, <(grep -v '^[#t]' once.csv) <(grep -v '^[#t]' twice.csv) | awk -F, '
        {for (i = 1; i <= NF / 2; i++) {
            a = $i; b = $(i + NF / 2)
            if ((a == "") != (b == "") || (a - b) ^ 2 > (1e-13 * (a ^ 2 > 1e-2 ? a : 0.1)) ^ 2) exit 1}}
        END {exit NR != 19}'
    # the polish of a fit stops at 1e-10 or so
    near "$(value modulus twice.p)" 200 1e-9
    near "$(value plastic_extension_at_maximum_force once.p)" \
        "$(value plastic_extension_at_maximum_force twice.p)" 1e-9
    near "$(value voce_rate once.p)" "$(value voce_rate twice.p)" 1e-6
}

@test "figures of several curves with their mixtures" {
    hspost -q "$data/ni200_cg.csv" --modulus-rows 1:3 -o cg.csv --title "Ni 200, it's CG"
    hspost -q "$data/hpt_ni_ufg.csv" --modulus-rows 1:4 --true-modulus '200 GPa' -o ufg.csv
    hspost -q cg.csv ufg.csv --plot f.svg --voigt voigt.csv --reuss reuss.csv --fraction 0.4 > out
    [ ! -s out ]
    grep -q "Ni 200, it.*s CG" f.svg
    hspost -q cg.csv ufg.csv voigt.csv reuss.csv --plot f.png
    [ "$(head -c 4 f.png | tail -c 3)" = PNG ]
    hspost -q cg.csv ufg.csv --true --plot f.pdf
    [ "$(head -c 4 f.pdf)" = %PDF ]
    [ -z "$(find . -name '*partial*')" ]
    # 60/40 at equal plastic strain has its maximum at 870 MPa; equal total strain, the elastic parts
    # being unequal, may move that by a few tenths of a per cent
    hspost -q voigt.csv -o /dev/null -p voigt.p
    near "$(value tensile_strength voigt.p)" 870 3
}

@test "properties of several curves name the curve" {
    hspost -q "$data/ni200_cg.csv" "$data/hpt_ni_ufg.csv" -p both.csv > out
    [ ! -s out ]
    [ "$(head -1 both.csv)" = curve,file,varied,property,symbol,value,unit,uncertainty,definition ]
    [ "$(grep -c ',tensile_strength,' both.csv)" -eq 2 ]
    grep -q '^ni200_cg,' both.csv
}

@test "difference of two curves" {
    awk -F, 'BEGIN {OFS = ","} /^[0-9]/ {print $1, 1.02 * $2; next} !/^#/ {print $1, $2}' \
        "$data/ni200_cg.csv" > stronger.csv
    hspost -q --difference --strain-range 0.01:0.2 stronger.csv "$data/ni200_cg.csv" > difference.csv
    [ "$(head -1 difference.csv)" = quantity,value,unit ]
    # two per cent everywhere, to the six digits awk prints
    near "$(awk -F, '/^largest/ {print $2}' difference.csv)" 0.02 1e-5
    near "$(awk -F, '/^rms/ {print $2}' difference.csv)" 0.02 1e-5
}

# fails CODE PATTERN COMMAND...: exit code and message; nothing on stdout
fails() {
    local code=$1 pattern=$2 status=0
    shift 2
    "$@" > out 2> messages < /dev/null || status=$?
    [ "$status" -eq "$code" ] || { echo "exit $status"; cat messages; return 1; }
    grep -q -- "$pattern" messages || { cat messages; return 1; }
    [ ! -s out ]
}

@test "wrong options are the user's error" {
    fails 2 'help' hspost --no-such-option
    fails 2 'toe' hspost --toe '3 MPa' "$data/ni200_cg.csv"
    fails 2 'the strain 1 of the toe' hspost --toe 1 "$data/ni200_cg.csv"
    fails 2 'as large as that of the highest stress, 0.144' hspost --toe 0.16 "$data/records/voce.csv"
    fails 2 'modulus-range' hspost --modulus-range 0.4 "$data/ni200_cg.csv"
    fails 2 'modulus-range' hspost --modulus-range 0.4:0.1 "$data/ni200_cg.csv"
    fails 2 'row 99' hspost --modulus-rows 1:99 "$data/ni200_cg.csv"
    fails 2 'svg' hspost --plot figure.jpg "$data/ni200_cg.csv"
    fails 2 'nothing to do' hspost "$data/ni200_cg.csv" "$data/hpt_ni_ufg.csv"
    fails 2 'fraction' hspost --voigt v.csv "$data/ni200_cg.csv" "$data/hpt_ni_ufg.csv"
    fails 2 'no law' hspost --law vice "$data/ni200_cg.csv"
    fails 2 'two files' hspost --difference "$data/ni200_cg.csv"
    fails 2 'empty' hspost
    fails 2 'no-such-file' hspost no-such-file.csv
    fails 2 'no-such-directory' hspost "$data/ni200_cg.csv" -o no-such-directory/curve.csv
}

@test "an output over an input is refused before anything is told of it" {
    cp "$data/ni200_cg.csv" own.csv
    fails 2 'own.csv is an input' hspost own.csv -p own.csv
    [ "$(wc -l <messages)" -le 2 ]
    cmp own.csv "$data/ni200_cg.csv"
}

@test "a name with line ends stays in its line, and a title of digits is one" {
    cp "$data/ni200_cg.csv" $'a\n1,2\nb.csv'
    hspost -q --title 42 -o curve.csv $'a\n1,2\nb.csv'
    hspost -q curve.csv -o again.csv
    grep -qx '# title: 42' again.csv
    [ "$(sed -n "s/^# command: //p" curve.csv)" = "hspost -q --title 42 -o curve.csv \$'a\\0121,2\\012b.csv'" ]
    run ! grep -vq '^#' <(sed '/^time_s/,$d' curve.csv)
}

@test "wrong decks are told by line and column" {
    printf 'post:\n  modulus_rang: [0.1, 0.4]\n' > deck.yaml
    fails 2 'deck.yaml:2:.*modulus_range' hspost --deck deck.yaml "$data/ni200_cg.csv"
    printf 'post:\n  modulus_range: [0.4, 0.1]\n' > deck.yaml
    fails 2 'deck.yaml:2:' hspost --deck deck.yaml "$data/ni200_cg.csv"
}

@test "--check reads all and makes nothing" {
    hspost --check -p p.csv --plot f.svg "$data/ni200_cg.csv" -o curve.csv >out 2>said
    [ ! -s out ]
    for file in p.csv f.svg curve.csv; do [ ! -e "$file" ]; done
    grep -q "ni200_cg.csv: curve '.*' of $(grep -vc '^#\|^eng' "$data/ni200_cg.csv") points, [0-9]* properties" said
    grep -q 'would write p.csv$' said
    # Options and deck alone: no pipe is waited for.
    printf 'post:\n  window: 2\n' > deck.yaml
    fails 2 'deck.yaml:2:11: 2 is out of range' hspost --check --deck deck.yaml
    fails 2 'window: 3 is out of range' hspost --check --window 3
    fails 2 'row 99' hspost --check --modulus-rows 1:99 "$data/ni200_cg.csv"
    fails 2 'f.jpg' hspost --check --plot f.jpg
    hspost --check </dev/null
    hspost --check --columns
    fails 2 'no-such-file' hspost --check --columns no-such-file.e
}

@test "wrong tables are told by line and column" {
    printf 'engineering_strain,engineering_stress_MPa\n0,0\n0.1,1e999\n' > t.csv
    fails 2 't.csv:3:5:' hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa\n0,0\n0.1\n' > t.csv
    fails 2 't.csv:3: 1 fields' hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa\n0,0,0\n' > t.csv
    fails 2 't.csv:2:5:' hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa\n0,nan\n' > t.csv
    fails 2 "t.csv:2:3: 'nan'" hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa\n0,\n' > t.csv
    fails 2 'row 1' hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa\n' > t.csv
    fails 2 'no row' hspost t.csv
    printf 'engineering_strain,engineering_stress_MPa,x,x\n1,2,3,4\n' > t.csv
    fails 2 't.csv:1:45: .*twice' hspost t.csv
    printf 'CDF\002 but no more' > t.e
    fails 2 't.e' hspost t.e
    printf '\001\000\002\003\000' > t.csv
    fails 2 'neither' hspost t.csv
}

@test "one row is a curve, too" {
    printf 'engineering_strain,engineering_stress_MPa\n0,0\n' | hspost -q -p p.csv > curve.csv
    [ "$(grep -vc '^#' curve.csv)" -eq 2 ]
    grep -q '^tensile_strength_reached,,0,' p.csv
    run ! grep -q -i -E '(,|^| )-?(nan|inf)(,|$| )' p.csv curve.csv
}

@test "a full disk is a failed run" {
    [ -w /dev/full ] || skip "no /dev/full"
    status=0
    hspost -q "$data/ni200_cg.csv" > /dev/full 2> messages || status=$?
    [ "$status" -eq 1 ]
}

@test "no gnuplot is a failed run and leaves no file" {
    mkdir empty
    program=$(command -v hspost)
    status=0
    PATH=$PWD/empty "$program" -q "$data/ni200_cg.csv" -o curve.csv --plot f.png 2> messages || status=$?
    [ "$status" -eq 1 ]
    /bin/grep -q gnuplot messages
    [ ! -e f.png ]
}
