# Numbers of a run that the deck or the manual promises, recomputed from what the run has written.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

mix='horizon: 1, stabilisation: {law: mix}'
perfect='hardening: {law: linear, yield: 300 MPa, modulus: 2 GPa}'
nickel="model: correspondence, poissons_ratio: 0.31, $perfect"
off='function off(a, b) { return a > b ? a - b : b - a }'

# bar NAME MATERIAL SOLVER [BOUNDARY [MORE]]: NAME.g of 16 x 4 x 4 nodes; grips at SPEED m/s unless BOUNDARY says otherwise
bar() {
    cat >"$1.yaml" <<END
title: Bar
$(even 16 4 4 2 6)
materials:
  M: {density: 8900 kg/m3, youngs_modulus: 210 GPa, $2}
boundary:
${4:-  - {set: grip_left, direction: x, velocity: -${SPEED:-5} m/s\}
  - {set: grip_right, direction: x, velocity: ${SPEED:-5} m/s\}}
solver: {$3}
output:
  history: ${RECORDS:-100}
  quantities:
    - {name: stress, quantity: stress_xx, reduce: mean, where: "1"}
    - {name: most_damage, quantity: damage, reduce: max, where: "1"}
    - {name: least_damage, quantity: damage, reduce: min, where: "1"}
${5:-}
END
    hsgen -q "$1.yaml" -o "$1.g"
}

# every node moves by its place times the time: uniaxial strain
uniaxial='  - {where: "1", direction: x, displacement: "x*t*RATE"}
  - {where: "1", direction: y, displacement: 0}
  - {where: "1", direction: z, displacement: 0}'

@test "kinetic to internal is kinetic over stored, plastic and stabilisation" {
    # Uneven: the bonds of the stabilisation hold a good part.
    SPEED=15 bar uneven "$nickel" "type: explicit, horizon: 1, stabilisation: {law: mix, share: 0.5}, end_strain: 0.02, energy_tolerance: 0.1"
    solve uneven
    columns uneven.e kinetic_energy_J stored_energy_J plastic_energy_J stabilisation_energy_J kinetic_to_internal | awk "$off"'
        $2 + $3 + $4 > 0 { n++; if ($4 > 0.05 * ($2 + $3)) much++; if (off($5 * ($2 + $3 + $4), $1) > 1e-9 * $1) bad++ }
        END { print n, much, bad; exit !(n > 50 && much > 20 && !bad) }'
}

@test "records of explicit steps lie at (n/N)^2 of the time" {
    RECORDS=50 bar dense "$nickel" "type: explicit, $mix, end_time: 4 us"
    solve dense
    # The first record at or beyond each time: later by a step at most; early ones fall into one step.
    columns dense.e time_s | awk '
        NR > 1 { time[++n] = $1 }
        END { step = 4e-9
              for (k = 1; k <= 50; k++) {
                  due = 4e-6 * (k / 50) ^ 2; nearest = 1
                  for (i = 1; i <= n; i++) if (time[i] - due > -step && time[i] - due < step) { met++; break }
              }
              # As many records as times, but for those that share a step, and none between.
              print n, met; exit !(met == 50 && n > 40 && n <= 51) }'
}

@test "the stable step is found again with each 5 % of strain" {
    SPEED=40 RECORDS=100000 bar long "$nickel" "type: explicit, $mix, end_strain: 0.25, energy_tolerance: 0.1"
    solve long
    # Steps are the differences of the records; one for each 5 % of strain from 0 on, 25 or 29 % at the end.
    columns long.e time_s extension_m | awk '
        NR > 2 { step = $1 - last; if (step < (1 - 1e-6) * before || step > (1 + 1e-6) * before) { if (before) changes++; before = step } if (!first) first = step; end = step }
        { last = $1; strain = $2 / 150e-6 }
        END { print changes, first, end, strain; exit !(NR > 100 && strain > 0.24 && changes >= 4 && changes <= 5) }'
}

@test "a load that grows from step to step does the work of its mean" {
    # Hooke's law: half of force times way at the end, exactly, however long the steps.
    bar pulled "model: bond_based" "type: quasi_static, horizon: 2, end_time: 1, step: 0.5, first_step: 0.5" '
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: "0.02*t"}'
    solve pulled
    columns pulled.e external_work_J stored_energy_J energy_drift quasi_static | tail -n 1 | awk "$off"'
        { print; exit !($1 > 0 && $4 == 1 && off($2 / $1, 1) < 1e-4 && $3 * $3 < 1e-8) }'
}

@test "explicit steps degrade the nodes, each step by the strain of the one before" {
    bar growing "$nickel" "type: explicit, $mix, end_time: 0.6 us, energy_tolerance: 0.5" "${uniaxial/RATE/1e5}" 'damage:
  - {phase: M, law: ductile, onset: 0.002, full: 0.1}'
    solve growing
    # D = (p - onset)/(full - onset); all nodes alike; a step of 4 ns is 4e-4 of strain, 4e-3 of D.
    columns growing.e M_plastic_strain most_damage least_damage removed_nodes | awk "$off"'
        { D = $1 > 0.002 ? ($1 - 0.002) / 0.098 : 0; if (off($2, D) > 5e-3 || off($2, $3) > 1e-9) bad++; if ($2 > 0.1) grown++ }
        END { print $0, bad, grown; exit !(!bad && grown > 20 && $4 == 0) }'
}

@test "at rest a node's stress is degraded by its own strain, not by that of the step before" {
    bar resting "$nickel" "type: quasi_static, $mix, end_time: 1, step: 0.05, first_step: 0.05" "${uniaxial/RATE/0.06}" 'damage:
  - {phase: M, law: ductile, onset: 0.002, full: 0.08}'
    bar whole "$nickel" "type: quasi_static, $mix, end_time: 1, step: 0.05, first_step: 0.05" "${uniaxial/RATE/0.06}"
    solve resting
    solve whole
    columns resting.e time_s stress most_damage >resting
    columns whole.e time_s stress >whole
    # The sound bar at the same strain is the answer.  What still changes without a new equilibrium is 1e-3 of D.
    awk "$off"' FNR == NR { sound[$1] = $2; next }
        $3 > 0 { n++; if (!($1 in sound) || off($2 / sound[$1], 1 - $3) > 2e-3) bad++; most = $3 }
        END { print n, bad, most; exit !(n > 8 && !bad && most > 0.3) }' whole resting
}

@test "a table that bends sharply up and down again is followed by bisection" {
    # Newton goes to and fro across the steep part, 1 TPa between 300 and 1300 MPa: 3 mu g from either side of it.  Uniaxial strain, one
    # load step: q = 2 mu ln F, q - 3 mu p = sigma_y(p), in the steep part 300 + 1e6 (p - 0.01) MPa.
    bar kinked 'model: correspondence, poissons_ratio: 0, hardening: {law: tabulated, points: [[0, 300 MPa], [0.01, 300 MPa], [0.011, 1300 MPa], [1, 1300 MPa]]}' \
        "type: quasi_static, $mix, end_time: 1, step: 1, first_step: 1" "${uniaxial/RATE/0.01913}"
    solve kinked
    columns kinked.e M_plastic_strain | tail -n 1 | awk "$off"'
        { q = 210e3 * log(1.01913); p = (q - 300 + 1e6 * 0.01) / (315e3 + 1e6)
          # Tables have cells of 1.6e-4 here; the steep part is straight in those within it.
          printf "%.9f %.9f\n", $1, p; exit !(p > 0.0102 && p < 0.0108 && off($1, p) < 1e-9) }'
}

@test "a hybrid run is quiet for as long as the deck says before it goes back to load steps, and books what is left" {
    SPEED=2 bar hybrid "$nickel" "type: hybrid, step: 0.002, $mix, end_strain: 0.02, explicit_strain: 0.01, \
static_when: {kinetic_to_internal: 0.1, quiet: 0.4 us}"
    hssolve -i hybrid.g -H hybrid.e 2>messages
    sed -n 's/.*explicit from strain .*t = \([^ ]*\) s.*/\1/p' messages | head -n 1 >start
    sed -n 's/.*load steps from strain .*t = \([^ ]*\) s.*/\1/p' messages | head -n 1 >end
    paste -d' ' start end | awk '{ print; exit !($2 - $1 > 0.399e-6 && $2 - $1 < 1e-6) }'
    # Nothing moves between the last explicit record and the first at rest: what is held then and no more is damped.
    columns hybrid.e quasi_static kinetic_energy_J stored_energy_J plastic_energy_J stabilisation_energy_J damping_energy_J external_work_J | awk "$off"'
        $1 && !was && NR > 1 && !n { n++; held = $3 + $4 + $5; gone = before + $7 - work - held; booked = $6 - damped
            printf "moving %g, internal %g -> %g, work %g, booked %g, gone %g\n", moving, before - moving, held, $7 - work, booked, gone
            if (booked > 0 && off(booked, gone) < 1e-9 * before) good = 1 }
        { was = $1; moving = $2; before = $2 + $3 + $4 + $5; damped = $6; work = $7 }
        END { exit !(n == 1 && good) }'
}
