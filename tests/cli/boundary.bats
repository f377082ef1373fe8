# Boundary conditions, initial values and chosen columns from the outside: what a deck may ask for, what it
# gets, and what is refused.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
setup_file() {
    cd "$BATS_FILE_TMPDIR"
    cat >bar.yaml <<'DECK'
title: Bar under loads
domain:
  specimen: plate
  size: [24 spacings, 4 spacings, 4 spacings]
  spacing: 25 um
  topology: homogeneous
  phase: A
  sets: [{name: foot, box: [[-300 um, -1 mm, -1 mm], [-250 um, 1 mm, 1 mm]]}]
materials:
  A: {model: correspondence_elastic, density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31}
boundary:
  - {set: foot, direction: x, displacement: 0}
  - {box: [[11 spacings, -1 mm, -1 mm], [12 spacings, 1 mm, 1 mm]], direction: x, force: 1 N}
  - {where: "abs(x) < 100e-6", direction: y, body_force: "1e9*x*sin(1e7*t)"}
solver:
  type: explicit
  horizon: 1
  stabilisation: {law: mix}
  end_steps: 200
output:
  history: 30
  quantities:
    - {name: load, quantity: external_force_x, reduce: sum, block: A}
    - {name: tip, quantity: displacement_x, nearest: [11.4 spacings, 0.6 spacings, 0.5 spacings]}
    - {name: mean_stress, quantity: stress_xx, reduce: mean, where: "x > 0"}
    - {name: held, quantity: force_x, reduce: sum, set: foot}
    - {name: least, quantity: velocity_x, reduce: min, block: A}
    - {name: most, quantity: von_mises, reduce: max, box: [[-4 spacings, -1 mm, -1 mm], [4 spacings, 1 mm, 1 mm]]}
  fields: {every: 60 steps, variables: [displacement, velocity, force, external_force, stress, von_mises]}
DECK
    hsgen -q bar.yaml -o bar.g
}

setup() {
    cd "$BATS_TEST_TMPDIR"
    cp "$BATS_FILE_TMPDIR"/{bar.yaml,bar.g} .
}

# The deck with one thing changed by sed.
change() {
    sed "$1" bar.yaml >changed.yaml
    run ! cmp -s bar.yaml changed.yaml
}

# wrong PLACE TEXT SED: a deck changed by sed is refused with this place and text, and leaves nothing.
wrong() {
    change "$3"
    run hssolve -q -H out.e -i bar.g -d changed.yaml
    if [ "$status" -ne 2 ] || [ "${#lines[@]}" -ne 1 ] || [[ "$output" != *"$2"* ]] ||
        [[ "$output" != "hssolve: changed.yaml:$1: "* ]]; then
        echo "exit $status, expected 2 with '$2' at $1; said:"
        echo "$output"
        return 1
    fi
    [ ! -e out.e ]
}

# frame FILE VARIABLE: its values in the last frame, one node a line
frame() {
    ncdump -p 9,17 -v "vals_nod_var$2" "$1" | sed "1,/vals_nod_var$2 =/d; /}/d" | tr -d ' \n;' |
        tr ',' '\n' | awk 1 | tail -384
}

# positions AXIS: of the nodes
positions() {
    ncdump -p 9,17 -v "coord$1" bar.g | sed '1,/^data:/d; /}/d' | tr -d ' \n;' | sed "s/coord$1=//" | tr ',' '\n' | awk 1
}

# same A B TOLERANCE: relative
same() {
    echo "$1 and $2"
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; if (b < 0) b = -b; exit !(d <= t * b) }'
}

@test "a wrong entry of boundary is refused with its place" {
    wrong 12:5 "which nodes? Expected exactly one of: set, block, box, where" 's/set: foot, direction: x/direction: x/'
    wrong 12:24 "'block' beside 'set'" 's/set: foot, /set: foot, block: A, /'
    wrong 12:5 "expected one of: velocity, displacement, force, body_force" 's/, displacement: 0//'
    wrong 12:58 "'displacement' beside 'velocity', expected one of them" 's/displacement: 0/velocity: 0, displacement: 0/'
    wrong 12:45 "'s' is a time, expected a length in m" 's/displacement: 0/displacement: 1 s/'
    wrong 13:90 "this value cannot depend on x, y, z" 's/force: 1 N/force: "x"/'
    wrong 12:11 "no node set 'feet' in the domain, which has: foot" 's/set: foot, direction/set: feet, direction/'
    wrong 14:58 "is infinite at t = 0, expected a finite number" 's/1e9\*x\*sin(1e7\*t)/1\/(t - t)/'
    wrong 14:5 "node 1 is held along one direction twice, by set foot and by block A" \
        's/where: "abs.*$/block: A, direction: x, velocity: 0}/'
    wrong 15:1 "unknown key" 's/^solver:/solvers:/'
    wrong 12:31 "unknown key 'energy'" 's/^boundary:/initial:/; s/displacement: 0/energy: 0/'
}

@test "a wrong quantity or frame is refused with its place" {
    wrong 23:30 "did you mean external_force_x?" 's/external_force_x/external_forces_x/'
    wrong 23:56 "expected one of: sum, mean, min, max" 's/reduce: sum, block/reduce: total, block/'
    wrong 24:14 "two columns named 'load'" 's/name: tip/name: load/'
    wrong 24:14 "no name for a column" 's/name: tip/name: "my tip"/'
    wrong 24:14 "the history has a column 'energy_drift' already" 's/name: tip/name: energy_drift/'
    wrong 24:54 "the nearest node is" 's/nearest: \[11.4/nearest: [110.4/'
    wrong 29:19 "such as '250 steps'" 's/every: 60 steps/every: equilibrium/'
    wrong 29:11 "give one of frames and every" 's/every: 60 steps/every: 60 steps, frames: 3/'
}

@test "a run without grips has no columns of a tension test, and hspost says so" {
    hssolve -q -i bar.g -H out.e
    columns=$(ncdump -v name_glo_var out.e | sed -n '/name_glo_var =/,$p')
    [[ "$columns" == *energy_drift*unsteady_to_internal*load*tip*mean_stress*held*least*most* ]]
    [[ "$columns" != *force_left_N* && "$columns" != *extension_m* && "$columns" != *A_stress_Pa* ]]
    run hspost -q out.e
    [ "$status" -eq 2 ]
    [[ "$output" == *"no column force_left_N"*"--columns"* ]]
    rm out.e
    wrong 19:15 "end_strain needs a gauge" 's/end_steps: 200/end_strain: 0.01/'
}

@test "hspost --columns prints what ncdump shows" {
    hssolve -q -i bar.g -H out.e
    hspost --columns out.e >columns.csv
    grep -v '^#' columns.csv | head -1 | grep -q '^time_s,kinetic_energy_J,.*,load,tip,mean_stress,held,least,most$'
    grep -v '^#' columns.csv | awk -F, 'NR > 1 { print $(NF - 4) }' >tips
    values out.e tip >theirs
    [ "$(wc -l <tips)" -ge 20 ]
    [ "$(wc -l <tips)" -eq "$(wc -l <theirs)" ]
    paste tips theirs | awk '($1 - $2) ^ 2 > 1e-28 * $2 ^ 2 { exit 1 }'
    hspost --columns <out.e -o again.csv
    cmp <(grep -v '^#' columns.csv) <(grep -v '^#' again.csv)
    run hspost --columns out.e --plot out.svg
    [ "$status" -eq 2 ]
}

@test "quantities are what the fields add up to" {
    hssolve -q -i bar.g -H out.e -o fields.e
    last() { values out.e "$1" | tail -1; }
    volume=1.5625e-14
    # Sums of 384 doubles in another order: 1e-13.  The load is 1 N, whatever its nodes.
    same "$(last load)" "$(frame fields.e 10 | awk -v v=$volume '{ s += $1 * v } END { printf "%.17g", s }')" 1e-13
    same "$(last load)" 1 1e-13
    same "$(last held)" "$(paste <(positions x) <(frame fields.e 7) |
        awk -v v=$volume '$1 < -250e-6 { s += $2 * v } END { printf "%.17g", s }')" 1e-13
    same "$(last mean_stress)" "$(paste <(positions x) <(frame fields.e 13) |
        awk '$1 > 0 { s += $2; n++ } END { printf "%.17g", s / n }')" 1e-13
    # One of the numbers themselves.
    same "$(last least)" "$(frame fields.e 4 | sort -g | head -1)" 0
    same "$(last most)" "$(paste <(positions x) <(frame fields.e 19) |
        awk '$1 > -101e-6 && $1 < 101e-6 { print $2 }' | sort -g | tail -1)" 0
    same "$(last tip)" "$(paste <(positions x) <(positions y) <(positions z) <(frame fields.e 1) |
        awk '$1 > 280e-6 && $2 > 0 && $2 < 20e-6 && $3 > 0 && $3 < 20e-6 { print $4 }')" 0
}

@test "any number of ranks gives the same bits, with loads, motions in place and time, and quantities" {
    change 's/set: foot, direction: x, displacement: 0/set: foot, direction: x, displacement: "1e-3*(y + 1e-4)*sin(1e7*t)"/
        s/force: 1 N/force: {initial: 1 N, increment: 0.5 N, every: 40 steps}/
        s/^solver:/initial: [{where: "x > 0", direction: z, velocity: "1e4*y"}]\n&/
        s/  horizon: 1/&\n  damping: 1e6/'
    hssolve -q -i bar.g -d changed.yaml -H one.e -o one_fields.e
    for ranks in 2 3 8; do
        hssolve -q -j "$ranks" -i bar.g -d changed.yaml -H many.e -o many_fields.e
        diff <(numbers one.e) <(numbers many.e)
        cmp one_fields.e many_fields.e
    done
}

@test "frames of a stepped load show it before it grows" {
    change 's/force: 1 N/force: {initial: 1 N, increment: 2 N, every: 60 steps}/; s/history: 30/history: 200/'
    hssolve -q -i bar.g -d changed.yaml -H out.e -o fields.e
    [[ "$(ncdump -h fields.e)" == *"UNLIMITED ; // (5 currently)"* ]] # 0, 60, 120, 180, 200
    ncdump -p 9,17 -v vals_nod_var10 fields.e | sed '1,/vals_nod_var10 =/d; /}/d' | tr -d ' \n;' |
        tr ',' '\n' | awk 1 | awk -v v=1.5625e-14 '{ s += $1 * v } NR % 384 == 0 { printf "%.6f\n", s; s = 0 }' >loads
    diff loads <(printf '%s\n' 1.000000 1.000000 3.000000 5.000000 7.000000)
}

@test "a load that waits for equilibrium grows only where the body rests, and stretches it as it should" {
    change '/abs(x) < 100e-6/d
        s/force: 1 N/force: {initial: 1 N, increment: 1 N, every: equilibrium}/
        s/horizon: 1/&\n  damping: 4e6/; s/end_steps: 200/end_steps: 3000/; s/history: 30/history: 3000/
        s/- {name: held/- {name: ahead, quantity: displacement_x, nearest: [4.5 spacings, 0.5 spacings, 0.5 spacings]}\n    - {name: behind, quantity: displacement_x, nearest: [-3.5 spacings, 0.5 spacings, 0.5 spacings]}\n    &/'
    hssolve -q -i bar.g -d changed.yaml -H out.e
    paste <(values out.e load) <(values out.e kinetic_to_internal) <(values out.e ahead) <(values out.e behind) >steps
    awk 'NR > 1 && $1 != before { # the record before is the last under the old load, at rest
             n++
             # Strain F/(E A) in the middle third; 1e-3 of kinetic energy leave 3 % of it in motion.
             strain = (ahead - behind) / 200e-6; exact = before / (210e9 * 16 * 625e-12)
             print before, ratio, strain / exact
             if ($1 - before > 1.0001 || ratio > 1e-3 || strain / exact < 0.96 || strain / exact > 1.04) exit bad = 1
         }
         { before = $1; ratio = $2; ahead = $3; behind = $4 }
         END { exit bad || n < 2 }' steps
}

@test "grips that are moved give the curve of grips with a velocity" {
    cat >pull.yaml <<DECK
title: Pull
$(even 24 4 4 3 12)
materials:
  M: {model: correspondence, density: 8900 kg/m3, $elastic, $soft}
$(pulled '10 m/s')
solver: {type: explicit, horizon: 1, stabilisation: {law: mix}, end_time: 0.3 us}
output: {history: 30}
DECK
    hsgen -q pull.yaml -o pull.g
    sed 's/velocity: -10 m.s/displacement: "-10*t"/; s/velocity: 10 m.s/displacement: "10*t"/' pull.yaml >moved.yaml
    hssolve -q -i pull.g -H velocity.e
    hssolve -q -i pull.g -d moved.yaml -H moved.e
    # Roundings of the displacement, 1e-16 of it a step, amplified by the change of force with strain.
    paste <(values velocity.e force_right_N) <(values moved.e force_right_N) |
        awk '{ d = $1 - $2; if (d < 0) d = -d; if (d > 1e-9 * most) bad = 1; if ($1 > most) most = $1 }
             END { exit bad || !(most > 0) }'
    hspost -q moved.e >/dev/null
}

@test "a boundary is not needed: a body in free flight keeps its energy" {
    sed '/^boundary:/,/^solver:/{/^solver:/!d}; s/^solver:/initial: [{block: A, direction: x, velocity: 3 m\/s}]\n&/
         s/external_force_x, reduce: sum/velocity_x, reduce: mean/' bar.yaml >free.yaml
    hssolve -q -i bar.g -d free.yaml -H out.e
    same "$(values out.e load | tail -1)" 3 1e-12
    same "$(values out.e kinetic_energy_J | tail -1)" "$(awk 'BEGIN { printf "%.17g", 0.5 * 8900 * 384 * 1.5625e-14 * 9 }')" 1e-12
}

# A free particle sees a horizon far: so thick has a grip to be.  `ordinary` to three layers, with a place.
@test "grips thinner than the horizon needs are refused where they are named" {
    cat >held.yaml <<DECK
domain: {specimen: plate, size: [24 spacings, 4 spacings, 4 spacings], spacing: 25 um, topology: homogeneous, phase: A, grips: {length: 2 spacings, phase: A}}
materials:
  A: {model: ordinary, density: 8900, $elastic}
$(pulled '1 m/s')
solver: {type: explicit, horizon: 3.015, end_steps: 2}
DECK
    # thick LAYERS MODEL HORIZON: exit code of a check
    thick() {
        sed -e "s/length: [0-9]* spacings/length: $1 spacings/" -e "s/model: ordinary/model: $2/" \
            -e "s/horizon: 3.015, /${3:+horizon: $3, }/" held.yaml >thick.yaml
        hsgen -q thick.yaml -o thick.g
        hssolve -q --check -i thick.g -d thick.yaml
    }
    run -2 thick 2 ordinary 3.015
    [[ "$output" == "hssolve: thick.yaml:5:5: this grip is 2 layers of particles thick, and a horizon of 3.015 spacings needs 3: "* ]]
    run -0 thick 3 ordinary 3.015
    run -2 thick 1 ordinary 2
    run -0 thick 2 ordinary 2
    # Where stress is that of nodes, those next to the free ones need a gradient.
    run -2 thick 1 correspondence_elastic 1
    run -0 thick 2 correspondence_elastic 1
    # Corners are held as they are.
    sed -i 's/poissons_ratio: 0.31/&, law: elastic/' held.yaml
    run -0 thick 1 corner ''
}
