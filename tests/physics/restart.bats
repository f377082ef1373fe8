# A run that was cut off and goes on from a checkpoint, on another number of ranks, gives the history and the fields of one
# that never stopped, to the last bit: every formulation, damage, load steps, both ways to advance, loads in steps.

bats_require_minimum_version 1.5.0

load ../columns
load ../bodies
setup() { cd "$BATS_TEST_TMPDIR"; }

# study CG UFG SOLVER [DAMAGE]: study.yaml and domain.g of a plate of two phases, pulled at $speed
# FLAT=yes: of one layer; $domain, which makes it another one by sed; $boundary, $every
study() {
    cat >study.yaml <<END
title: Goes on
$(grains 2 | sed "${domain:-}")
materials:
  CG: {density: 8900 kg/m3, $1}
  UFG: {density: 8800 kg/m3, $2}
${boundary:-$(pulled "${speed:-60} m/s")}
solver: {$3}
${4:-}
output:
  history: 60
  quantities: [{name: pull, quantity: force_x, reduce: sum, block: CG}]
  fields: {frames: 6, variables: [displacement, velocity, force, stress, equivalent_plastic_strain, damage]}
  checkpoint: {every: ${every:-20} steps, keep: 100}
END
    hsgen -q study.yaml -o domain.g
}

# goes_on FIRST COUNT RANKS...: the run on FIRST ranks made at least COUNT checkpoints, which change no number of it; from one early,
# one in the middle and the last one it goes on with each number of ranks as the whole run went; options of the first run in $options
goes_on() {
    local first=$1 count=$2 found middle from ranks
    shift 2
    mkdir whole
    # shellcheck disable=SC2086 # words
    (cd whole && hssolve -q -j "$first" ${options:--i ../domain.g} -H history.e -o fields.e) 2>messages ||
        { cat messages && false; }
    found=$(find whole -name 'history.e.checkpoint*' | wc -l)
    echo "$found checkpoints"
    [ "$found" -ge "$count" ]
    sed 's/checkpoint: {every: [0-9]* steps/checkpoint: {every: 1 h/' study.yaml >seldom.yaml
    # shellcheck disable=SC2086 # words
    (cd whole && hssolve -q -j "$first" ${options:--i ../domain.g} -d ../seldom.yaml -H seldom.e -o seldom.f) 2>/dev/null
    cmp <(hspost -q --columns whole/history.e | grep -v '^#') <(hspost -q --columns whole/seldom.e | grep -v '^#')
    numbers whole/history.e >whole.history
    numbers whole/fields.e >whole.fields
    middle=$((found / 2))
    for from in "checkpoint.$((found - 1))" "checkpoint.$middle" checkpoint; do
        for ranks in "$@"; do
            hssolve -q --restart "whole/history.e.$from" -j "$ranks" -H history.e -o fields.e
            echo "from $from on $ranks ranks"
            cmp whole.history <(numbers history.e)
            cmp whole.fields <(numbers fields.e)
        done
    done
}

# last NAME: of the whole run's history, at its end
last() { columns whole/history.e "$1" | tail -n 1; }

ductile='damage:
  - {phase: CG, law: ductile, onset: 0.04, full: 0.12}
  - {phase: UFG, law: ductile, onset: 0.02, full: 0.05, length: 30 um}'
between='  - {pair: [CG, UFG], rule: harmonic}'
cracks='cracks:
  - {rectangle: [[-0.02 mm, -0.1 mm, -0.08 mm], [0, 0.06 mm, 0], [0, 0, 0.16 mm]]}'

@test "correspondence, mix, ductile: from 1 rank to 1, 2, 3 and 8" {
    study "model: correspondence, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: correspondence, $elastic, $hard" \
        'type: explicit, horizon: 1, stabilisation: {law: mix}, end_time: 0.6 us, damping: 1e5 1/s' "$ductile
$between"
    goes_on 1 6 1 2 3 8
    holds "$(last removed_nodes) > 10"
}

@test "correspondence, capped, ductile and a crack: from 3 ranks to 2" {
    study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $hard" \
        'type: explicit, horizon: 2, stabilisation: {law: capped}, end_time: 0.6 us, local_damping: 0.1' "$ductile
$between
$cracks"
    goes_on 3 6 2
    holds "$(last broken_bonds) > 100"
}

@test "two laws in one body: the states of each" {
    study "model: correspondence, $elastic, $soft" "model: correspondence_elastic, $elastic" \
        'type: explicit, horizon: 1, stabilisation: {law: mix}, end_time: 0.3 us' "damage:
  - {phase: CG, law: plastic_strain, value: 0.03}"
    goes_on 2 3 1 3
}

@test "corner, ductile: from 2 ranks to 1 and 4" {
    study "model: corner, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: corner, $elastic, $hard" 'type: explicit, end_time: 0.6 us' "$ductile"
    goes_on 2 4 1 4
    holds "$(last removed_nodes) > 10"
}

@test "corner, the law at four points: from 1 rank to 3" {
    study "model: corner, $elastic, $soft" "model: corner, $elastic, $hard" \
        'type: explicit, residual: {form: four_points}, end_time: 0.4 us' "$ductile"
    goes_on 1 2 3
}

@test "corner in a distorted mesh: from 2 ranks to 1 and 3" {
    awk -v form=distorted -v nx=16 -v ny=5 -v nz=4 -v lx=16e-4 -v ly=5e-4 -v lz=4e-4 -v parts=2 \
        -f "$BATS_TEST_DIRNAME/../mesh.awk" >mesh.cdl
    ncgen -k 64-bit-offset -o mesh.g mesh.cdl
    cat >study.yaml <<END
title: Goes on
materials:
  A: {model: corner, density: 8900, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}}
  B: {model: corner, density: 8800, $elastic, $soft}
boundary:
  - {set: low_x, direction: x, velocity: -20 m/s}
  - {set: high_x, direction: x, velocity: 20 m/s}
solver: {type: explicit, end_time: 8 us, coincident_nodes: join}
damage:
  - {phase: A, law: ductile, onset: 0.04, full: 0.12}
  - {phase: B, law: ductile, onset: 0.02, full: 0.05}
output:
  history: 60
  fields: {frames: 6, variables: [displacement, velocity, force, stress, equivalent_plastic_strain, damage]}
  checkpoint: {every: 40 steps, keep: 100}
END
    options='-i ../mesh.g -d ../study.yaml' goes_on 2 4 1 3
    holds "$(last removed_nodes) > 2"
}

@test "corner, a sheet in plane stress: from 2 ranks to 3" {
    FLAT=yes study "model: corner, $elastic, $soft" "model: corner, $elastic, $hard" \
        'type: explicit, plane: stress, end_time: 0.6 us' "$ductile"
    goes_on 2 4 3
    holds "$(last removed_nodes) > 1"
}

@test "ordinary, plastic and ductile, bonds that break: from 1 rank to 2 and 8" {
    study "model: ordinary_plastic, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: ordinary_plastic, $elastic, $hard" 'type: explicit, horizon: 2.2, end_time: 0.5 us' "damage:
  - {phase: CG, law: ductile, onset: 0.04, full: 0.12}
  - {pair: [CG, UFG], law: critical_stretch, value: 0.03}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 8 kJ/m2}
$cracks"
    goes_on 1 4 2 8
    holds "$(last broken_bonds) > 100"
}

@test "bond-based, cracks and energies of bonds: from 4 ranks to 1 and 3" {
    speed=30 study 'model: bond_based, youngs_modulus: 210 GPa' 'model: bond_based, youngs_modulus: 190 GPa' \
        'type: explicit, horizon: 3, volumes: partial, end_time: 0.5 us' "damage:
  - {pair: [CG, CG], law: critical_stretch, value: 0.012}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 3 kJ/m2}
  - {pair: [CG, UFG], law: critical_stretch, fracture_energy: 2 kJ/m2}
$cracks"
    sed -i 's/grips: {length: 2/grips: {length: 3/' study.yaml
    hsgen -q study.yaml -o domain.g
    goes_on 4 3 1 3
    holds "$(last broken_bonds) > 1000"
}

@test "flat, the a, b, d form, surface correction and a crack: from 1 rank to 3" {
    FLAT=yes study "model: madenci_oterkus, $elastic" "model: madenci_oterkus, $elastic" \
        'type: explicit, plane: stress, horizon: 2.2, surface_correction: energy, safety: 0.4, end_time: 0.5 us' "damage:
  - {pair: [CG, CG], law: critical_stretch, fracture_energy: 3 kJ/m2}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 8 kJ/m2}
  - {pair: [CG, UFG], law: critical_stretch, value: 0.02}
$cracks"
    goes_on 1 4 3
}

@test "load steps with ductile damage: from 1 rank to 2 and 3" {
    every=2 speed=1 study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $hard" \
        'type: quasi_static, horizon: 1, stabilisation: {law: mix}, step: 0.003, end_strain: 0.02' "$ductile
$between"
    goes_on 1 3 2 3
}

@test "load steps of corner, by relaxation and by Newton's method" {
    for method in relaxation newton; do
        rm -rf whole
        every=2 speed=1 study "model: corner, $elastic, $soft" "model: corner, $elastic, $hard" \
            "type: quasi_static, method: $method, step: 0.003, end_strain: 0.012"
        goes_on 1 2 2
    done
}

@test "forces and motions that depend on place and time, raised in steps: at rest and explicit" {
    boundary='boundary:
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_left, direction: y, displacement: 0}
  - {set: grip_left, direction: z, displacement: "1e-3*y*t/(1e-6)"}
  - {set: grip_right, direction: x, force: {initial: 1 N, increment: 0.3 N, every: 3 steps}}
  - {box: [[-1 mm, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]], direction: y, body_force: "1e9*x/1e-3*t/1e-6"}'
    every=2 study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $hard" \
        'type: quasi_static, horizon: 1, stabilisation: {law: mix}, step: 0.1 us, end_time: 1 us'
    goes_on 1 3 2
    rm -rf whole
    boundary=${boundary/every: 3 steps/every: 25 steps}
    study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $hard" \
        'type: explicit, horizon: 1, stabilisation: {law: mix}, end_time: 0.3 us'
    goes_on 1 3 2
}

@test "load steps, explicit ones, and back: before and after each switch" {
    every=1 speed=2 study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $soft" \
        'type: hybrid, horizon: 1, stabilisation: {law: mix}, step: 0.002, end_strain: 0.012, explicit_strain: 0.008, static_when: {kinetic_to_internal: 0.1, quiet: 0.05 us}'
    mkdir whole
    (cd whole && hssolve -q -i ../domain.g -H history.e -o fields.e)
    hspost -q --columns whole/history.e | grep -v '^#' | awk -F, '
        !column { for (i = 1; i <= NF; i++) if ($i == "quasi_static") column = i; next }
        $column != was { printf "%s ", $column; was = $column } END { print "" }' | grep '^1 0 1 0 1 '
    numbers whole/history.e >whole.history
    numbers whole/fields.e >whole.fields
    found=$(find whole -name 'history.e.checkpoint*' | wc -l)
    echo "$found checkpoints"
    [ "$found" -gt 40 ]
    for ((number = 1; number < found; number += found / 9)); do
        hssolve -q --restart "whole/history.e.checkpoint.$number" -j $((number % 3 + 1)) -H history.e -o fields.e
        cmp whole.history <(numbers history.e)
        cmp whole.fields <(numbers fields.e)
    done
}

# scattered MODEL SOLVER DAMAGE: particles.txt and study.yaml, which go beside each other
scattered() {
    scatter 16 0.3 >particles.txt
    cat >study.yaml <<END
title: Scattered
domain: {dimensions: 3, spacing: 1 mm, grips: {length: 3 spacings}, gauge: {length: 6 mm}}
materials:
  A: {model: $1}
damage:
  - $3
$(pulled '60 m/s')
solver: {type: explicit, $2, end_time: 15 us, energy_tolerance: 0.05}
output:
  history: 40
  fields: {frames: 4, variables: [displacement, force, stress, damage]}
  checkpoint: {every: 20 steps, keep: 100}
END
}
steel='density: 8000, youngs_modulus: 200 GPa, poissons_ratio: 0.3'
linear='hardening: {law: linear, yield: 200 MPa, modulus: 2 GPa}'

@test "scattered particles from a text with the deck beside it: correspondence, degrading" {
    scattered "correspondence, $steel, $linear" 'horizon: 1.6, stabilisation: {law: capped}' \
        '{phase: A, law: ductile, onset: 0.03, full: 0.1}'
    options='-i ../particles.txt -d ../study.yaml' goes_on 2 3 1 3
    holds "$(last removed_nodes) > 3"
}

@test "scattered particles: ordinary plastic, breaking" {
    scattered "ordinary_plastic, $steel, $linear" 'horizon: 2.6' '{pair: [A, A], law: critical_stretch, value: 0.06}'
    options='-i ../particles.txt -d ../study.yaml' goes_on 1 3 3
    holds "$(last broken_bonds) > 20"
}

# cell SOLVER [DAMAGE]: study.yaml and domain.g of random cells that repeat, under a mean strain or $mean
cell() {
    domain='/^  g/d; s/size: .*/size: [0.2 mm, 0.2 mm, 0.15 mm]/; s/^  spacing/  periodic: [x, y, z]\n&/' boundary="macroscopic:
${mean:-  - {component: xx, rate: 1 1/s\}}" study "model: corner, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: corner, $elastic, $hard" "$@"
}

@test "periodic cells: load steps with damage, sheared and compressed ones, explicit ones" {
    every=2 cell 'type: quasi_static, step: 0.004, end_strain: 0.05' "$ductile"
    goes_on 2 5 1 3
    holds "$(last removed_nodes) > 2"
    rm -rf whole
    mean='  - {component: xy, rate: 1 1/s}
  - {component: zz, stress: -50 MPa}
  - {component: yy, strain: "-0.2*t"}' every=2 cell 'type: quasi_static, step: 0.5 ms, end_time: 5 ms'
    goes_on 3 4 2
    rm -rf whole
    mean='  - {component: xx, rate: 1e5 1/s}' cell 'type: explicit, end_strain: 0.04' "$ductile"
    goes_on 1 4 3
}

@test "a cell and a bar between grips that are taken through a programme of loops" {
    local loops='type: quasi_static, programme: [{to_strain: 0.4 %}, {unload_to: 0 MPa}, {cycles: 1, between: [-0.2 %, 0.3 %]}]'
    every=4 cell "$loops"
    goes_on 1 4 2
    rm -rf whole
    every=9 speed=1 study "model: corner, $elastic, $soft" "model: corner, $elastic, $hard" "$loops"
    goes_on 3 4 1
}

@test "an eighth of a body, to its planes of symmetry: load steps and explicit ones" {
    local every speed type
    while read -r every speed type; do
        rm -rf whole
        boundary="boundary:
  - {set: grip_right, direction: x, velocity: $speed m/s}" domain='s/^  spacing/  symmetry: [x, y, z]\n&/' \
            study "model: corner, $elastic, $soft" "model: corner, $elastic, $hard" "type: $type" "$ductile"
        goes_on 2 3 1 3
    done <<'END'
1 1 quasi_static, step: 0.5 us, end_time: 5 us
20 60 explicit, end_time: 0.4 us
END
}
