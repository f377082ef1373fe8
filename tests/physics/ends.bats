# Where explicit runs end, how long their steps may be, and the balance of energies along the way.

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

nickel='model: correspondence, youngs_modulus: 210 GPa, poissons_ratio: 0.31, hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}'
linear="model: correspondence_elastic, $elastic"

# bar NAME MATERIAL SOLVER RECORDS SPEED [REST]
bar() {
    cat >"$1.yaml" <<END
title: Bar
$(even 16 6 4 2 8)
materials:
  M: {density: 8900 kg/m3, $2}
${6:-$(pulled "$5")}
solver: {type: explicit, horizon: 1, stabilisation: {law: mix}, $3}
output: {history: $4}
END
    hsgen -q "$1.yaml" -o "$1.g"
}

@test "a run ends at its strain to a millionth of a step, and records do not move the end" {
    for speed in '3 m/s' '100 m/s'; do
        for records in 1 7 20 500 100000; do
            bar end "$nickel" 'end_strain: 0.02' "$records" "$speed"
            hssolve -q -i end.g -H end.e
            columns end.e time_s extension_m kinetic_energy_J stored_energy_J plastic_energy_J | tail -n 1 >end.$records
            cmp end.1 end.$records
        done
        awk '{ over = $2 / 225e-6 / 0.02 - 1; print $0, over; exit !(over >= 0 && over < 1e-6) }' end.1
    done
    # One at a given time ends there, too.
    bar end "$linear" 'end_time: 0.4567 us' 1 '1 m/s'
    hssolve -q -i end.g -H end.e
    columns end.e time_s | tail -n 1 | awk '{ off = $1 / 0.4567e-6 - 1; print off; exit !(off * off < 1e-20) }'
}

@test "steps that waves would allow are cut to what shows the test" {
    # The grips' inner layers are 13 spacings apart.
    for case in '100 m/s|strain_step: 1e-3, least_steps: 1|0.001' '1000 m/s|strain_step: 1e-4, least_steps: 1|1e-4' '100 m/s|strain_step: 1, least_steps: 400|5e-5'; do
        solver=${case#*|}
        bar steps "$nickel" "end_strain: 0.02, energy_tolerance: 10, ${solver%|*}" 1000000 "${case%%|*}"
        hssolve -q -i steps.g -H steps.e
        columns steps.e grip_extension_m | awk -v most="${case##*|}" '
            NR > 1 { step = ($1 - last) / 325e-6; if (step > longest) longest = step } { last = $1 }
            END { print NR, longest, most; exit !(longest > 0.9 * most && longest < 1.1 * most) }'
    done
}

@test "a test that is over within one step is refused, and asks for the units" {
    for change in 's/end_strain/mass_scaling: 1e10, &/' 's/velocity: \(-*\)3 m/velocity: \11e5 m/'; do
        bar quick "$nickel" 'end_strain: 0.02' 20 '3 m/s'
        sed -i "$change" quick.yaml
        hsgen -q quick.yaml -o quick.g
        run hssolve -q -i quick.g -H quick.e
        echo "$output"
        [ "$status" -eq 2 ]
        [[ $output == *"quick.yaml:"*"over in"*"did you mean GPa"*"mass_scaling"* ]]
        [ ! -e quick.e ]
    done
    sed -i 's/solver: {/&accept: true, energy_tolerance: 1e6, /' quick.yaml
    hsgen -q quick.yaml -o quick.g
    hssolve -q -i quick.g -H quick.e
}

@test "elastic collisions and driven bars keep the balance within 1e-6" {
    # Two halves that fly at each other, a wave of 1e-5 of strain, of which as much of a step's energy is lost as forces are not
    # linear; a bar that is driven to and fro at both ends.
    bar struck "$linear" 'end_steps: 3000' 500 0 "initial: [{where: 'x < 0', direction: x, velocity: 0.05}, {where: 'x >= 0', direction: x, velocity: -0.05}]
boundary: []"
    bar driven "$linear" 'end_steps: 3000' 500 0 'boundary:
  - {set: grip_left, direction: x, displacement: "1e-8*sin(2e7*t)"}
  - {set: grip_right, direction: x, velocity: "0.1*sin(3e7*t)"}'
    for run in struck driven; do
        hssolve -q -i $run.g -H $run.e
        columns $run.e energy_drift kinetic_energy_J staggered_energy_J stored_energy_J | awk -v run=$run '
            { d = $1 < 0 ? -$1 : $1; if (d > most) most = d; if (-$3 / ($2 + $4 + 1e-300) > share) share = -$3 / ($2 + $4 + 1e-300) }
            END { print run, most, share, NR; exit !(NR > 100 && most < 1e-6 && share > 1e-3) }'
    done
}

@test "a load that begins below the rounding of the sums stops no run" {
    bar smooth "$linear" 'end_steps: 3000' 500 0 'boundary:
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: {ramp: 1 ms, to: 4 N}}'
    hssolve -q -i smooth.g -H smooth.e
    # Not by a balance of nothing: once there is enough to see the drift is that of the scheme.
    columns smooth.e energy_drift stored_energy_J | awk '{ d = $1 < 0 ? -$1 : $1; if (d > most) most = d }
        END { print most, $2, d; exit !(most < 1e-4 && $2 > 0) }'
}

@test "damping, raised loads and steps that change leave the balance closed" {
    # Half of the energy goes; the load comes in steps; the step shrinks as the bar stretches by a third.
    bar damped "$linear" 'end_steps: 2000, damping: 2e6 1/s, local_damping: 0.1' 500 0 "initial: [{where: 'x < 0', direction: x, velocity: 0.05}, {where: 'x >= 0', direction: x, velocity: -0.05}]
boundary: []"
    bar raised "$linear" 'end_steps: 2000, damping: 1e6 1/s' 500 0 'boundary:
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: {initial: 0.02 N, increment: 0.02 N, every: 150 steps}}'
    bar long "$linear" 'end_strain: 0.3' 500 '30 m/s'
    for case in 'damped|1e-6' 'raised|1e-6' 'long|1e-4'; do
        run=${case%|*}
        hssolve -q -i "$run.g" -H "$run.e"
        columns "$run.e" energy_drift damping_energy_J | awk -v run="$run" -v limit="${case#*|}" '
            { d = $1 < 0 ? -$1 : $1; if (d > most) most = d; damped = $2 }
            END { print run, most, damped, NR; exit !(NR > 100 && most < limit && (damped > 0 || run == "long")) }'
    done
}

@test "bare numbers that no metal has are refused where they stand, and accepted on request" {
    # What is changed | line:column | what is said
    for case in \
        's/210 GPa/210/|210 Pa, expected 1 MPa to 2 TPa: did you mean GPa?' \
        's/210 GPa/210e2 GPa/|expected 1 MPa to 2 TPa: did you mean MPa or Pa?' \
        's/8900 kg.m3/8.9/|8.9 kg/m3, expected 10 to 30,000: did you mean g/cm3' \
        's/8900 kg.m3/8.9e5/|expected 10 to 30,000' \
        's/200 MPa/200 GPa/|yields at 200000 MPa, over a tenth' \
        's/1 GPa/1000 GPa/|hardens by 10000 MPa'; do
        bar odd "$nickel" 'end_steps: 3, energy_tolerance: 1e6' 5 '1 m/s'
        sed -i "${case%%|*}" odd.yaml
        hsgen -q odd.yaml -o odd.g
        run hssolve -q -i odd.g -H odd.e
        echo "$output"
        [ "$status" -eq 2 ]
        [[ $output == *"odd.yaml:11:"*"${case#*|}"*"'accept: true' in solver"* ]]
        run hssolve --check -i odd.g
        [ "$status" -eq 2 ]
        sed -i 's/solver: {/&accept: true, /' odd.yaml
        hsgen -q odd.yaml -o odd.g
        hssolve -q -i odd.g -H odd.e
    done
}
