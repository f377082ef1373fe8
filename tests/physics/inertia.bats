# Explicit runs of slow tests: scaled inertia, local damping.

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

# bar NAME SOLVER BOUNDARY [INITIAL]: NAME.g of 24 x 4 x 4 nodes
bar() {
    cat >"$1.yaml" <<END
title: Bar
$(even 24 4 4 2)
materials:
  M: {model: ${MODEL:-correspondence_elastic}, density: 8900 kg/m3, youngs_modulus: 210 GPa, poissons_ratio: 0.3${LAW:-}}
$3
solver: {horizon: 1, stabilisation: {law: mix}, $2}
output:
  history: 50
  quantities:
    - {name: end, quantity: displacement_x, reduce: mean, set: grip_right}
END
    hsgen -q "$1.yaml" -o "$1.g"
}
last() { columns "$1.e" "${@:2}" | tail -n 1; }

@test "inertia times 4 doubles the stable step and every period, and nothing else" {
    stretch='initial:
  - {where: "1", direction: x, velocity: "SPEED*x"}'
    # Half of the speed and four times the inertia are the same energy: the same motion, in twice the time.
    bar light 'type: explicit, end_steps: 400' "${stretch/SPEED/8e4}"
    bar heavy 'type: explicit, end_steps: 400, mass_scaling: 4' "${stretch/SPEED/4e4}"
    solve light
    solve heavy
    last light time_s end kinetic_energy_J >light
    last heavy time_s end kinetic_energy_J >heavy
    # Steps are found by differences of the force: 1e-6 for those, and what 400 steps make of it.
    paste -d' ' light heavy | awk '{ print; t = $4 / $1 / 2 - 1; u = $5 / $2 - 1; k = $6 / $3 - 1
        exit !(t * t < 1e-12 && u * u < 1e-8 && k * k < 1e-8 && $2 * $2 > 1e-14) }'
}

@test "local damping lets a bar that is struck by a force come to rest where load steps have it" {
    held='boundary:
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: 1 N}'
    bar struck 'type: explicit, safety: 0.1, energy_tolerance: 0.05, local_damping: 0.7, end_time: 6 us' "$held"
    bar static 'type: quasi_static, end_steps: 1' "$held"
    solve struck
    solve static
    last struck end kinetic_energy_J energy_drift damping_energy_J external_work_J >struck
    last static end >static
    # Half of the work of a dead load is stored, the other half is damped, within 1 % for the jump of the force at the start.
    paste -d' ' struck static | awk '{ print; u = $1 / $6 - 1; half = $4 / $5 - 0.5
        exit !(u * u < 1e-6 && $3 * $3 < 1e-4 && half * half < 1e-4 && $2 < 1e-4 * $5) }'
}

@test "scaled inertia and both dampings: 2, 3 and 4 ranks give the bits of one" {
    MODEL=correspondence LAW=', hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}' bar pulled \
        'type: explicit, mass_scaling: 20, local_damping: 0.3, damping: 1e5 1/s, end_steps: 300' 'boundary:
  - {set: grip_left, direction: x, velocity: -10 m/s}
  - {set: grip_right, direction: x, velocity: 10 m/s}'
    for ranks in 1 2 3 4; do
        hssolve -q -j $ranks -i pulled.g -H "$ranks.e"
        hspost -q --columns "$ranks.e" | grep -v '^#' >"$ranks.csv"
        cmp 1.csv "$ranks.csv"
    done
    [ "$(wc -l <1.csv)" -gt 30 ]
}

@test "a share of the force beyond what moves, or inertia of nothing, is refused with its place" {
    bar wrong 'type: explicit, end_steps: 1, local_damping: 1.5' ''
    run hssolve -i wrong.g -H wrong.e
    [ "$status" -eq 2 ]
    [[ $output == *wrong.yaml:*local_damping* || $output == *wrong.yaml:*1.5* ]]
    bar wrong 'type: quasi_static, end_steps: 1, mass_scaling: 2' ''
    run hssolve -i wrong.g -H wrong.e
    [ "$status" -eq 2 ]
    [[ $output == *"'mass_scaling' belongs to type: explicit or hybrid"* ]]
}
