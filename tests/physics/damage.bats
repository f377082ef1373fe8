# Bars that break, through the programs: the grips let go, the energies add up, and the same bits come from
# any number of ranks.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
load ../ranks
setup() { cd "$BATS_TEST_TMPDIR"; }

# study CG UFG SOLVER DAMAGE VELOCITY END: domain.g of a plate of two phases
# FLAT=yes: of one layer.
study() {
    cat >study.yaml <<END
title: Breaking
$(grains 3)
materials:
  CG: {density: 8900 kg/m3, $1}
  UFG: {density: 8800 kg/m3, $2}
$(pulled "$5 m/s")
solver: {type: explicit, $3, end_time: $6 us}
$4
output:
  history: 60
  fields:
    frames: 3
    variables: [displacement, velocity, force, stress, equivalent_plastic_strain, phase, damage]
END
    hsgen -q study.yaml -o domain.g
}

last() { values "$1" "$2" | tail -n 1; }
most() { values "$1" "$2" | awk '{ if ($1 < 0) $1 = -$1; if ($1 > most) most = $1 } END { print most }'; }


# compare BROKEN RANKS...: over BROKEN bonds have broken, and each number of ranks gives the bits of one
compare() {
    local least=$1
    shift
    solve_on 1
    run ! grep 'cut no bond' messages
    bonds=$(last 1/history.e broken_bonds)
    echo "broken $bonds, fracture $(last 1/history.e fracture_energy_J) J, without gradient \
$(last 1/history.e nodes_without_gradient), drift $(most 1/history.e energy_drift)"
    holds "$bonds > $least"
    for ranks in "$@"; do
        same_as_one "$ranks"
    done
}

cracks='cracks:
  - {rectangle: [[-0.02 mm, -0.1 mm, -0.08 mm], [0, 0.06 mm, 0], [0, 0, 0.16 mm]]}
  - {disc: {centre: [0.03 mm, 0.05 mm, 0.01 mm], normal: [1, 0.5, 0], radius: 45 um}}'

@test "bond-based, three spacings, cracks: 2, 3, 4 and 8 ranks give the bits of one" {
    study 'model: bond_based, youngs_modulus: 210 GPa' 'model: bond_based, youngs_modulus: 190 GPa' \
        'horizon: 3, volumes: partial' "damage:
  - {pair: [CG, CG], law: critical_stretch, value: 0.012}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 3 kJ/m2}
  - {pair: [CG, UFG], law: critical_stretch, fracture_energy: 2 kJ/m2}
$cracks" 30 0.5
    compare 1000 2 3 4 8
}

@test "correspondence, mix, plastic strain: 2, 3, 4 and 8 ranks give the bits of one" {
    study "model: correspondence, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: correspondence, $elastic, $hard" \
        'horizon: 1, stabilisation: {law: mix}' "damage:
  - {phase: CG, law: plastic_strain, value: 0.12}
  - {phase: UFG, law: plastic_strain, value: 0.05}" 60 0.6
    compare 100 2 3 4 8
}

@test "correspondence, capped, critical stretch and cracks: 2, 3, 4 and 8 ranks give the bits of one" {
    study "model: correspondence, $elastic, $soft, flaw: {centre: [0, 0, 0], radius: 50 um, reduction: 0.3}" \
        "model: correspondence, $elastic, $hard" \
        'horizon: 2, stabilisation: {law: capped}, safety: 0.4' "damage:
  - {pair: [CG, CG], law: critical_stretch, value: 0.15}
  - {pair: [UFG, UFG], law: critical_stretch, value: 0.05}
  - {pair: [CG, UFG], rule: harmonic}
$cracks" 60 0.5
    compare 100 2 3 4 8
}

@test "ordinary, Mitchell's plasticity, plastic strain and stretch: 3 and 8 ranks give the bits of one" {
    study "model: ordinary_plastic, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: ordinary_plastic, $elastic, $hard" 'horizon: 2.2' "damage:
  - {phase: CG, law: plastic_strain, value: 0.05}
  - {pair: [CG, UFG], law: critical_stretch, value: 0.03}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 8 kJ/m2}
$cracks" 60 0.5
    compare 100 3 8
}

# The rule between the phases is none of those that either end would give alone.
ductile='damage:
  - {phase: CG, law: ductile, onset: 0.04, full: 0.12}
  - {phase: UFG, law: ductile, onset: 0.02, full: 0.05, length: 30 um}'
between='  - {pair: [CG, UFG], rule: harmonic}'

@test "correspondence, mix, ductile: 2, 3, 4 and 8 ranks give the bits of one" {
    study "model: correspondence, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: correspondence, $elastic, $hard" \
        'horizon: 1, stabilisation: {law: mix}' "$ductile
$between" 60 0.6
    compare 100 2 3 4 8
    holds "$(last 1/history.e removed_nodes) > 10 && $(last 1/history.e removed_nodes) < 400"
}

@test "corner, ductile: 2, 3, 4 and 8 ranks give the bits of one" {
    study "model: corner, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: corner, $elastic, $hard" 'residual: {form: flowing}' "$ductile" 60 0.6
    compare -1 2 3 4 8
    holds "$(last 1/history.e removed_nodes) > 10 && $(last 1/history.e removed_nodes) < 400"
}

@test "correspondence, capped, ductile and a crack: 3 ranks give the bits of one" {
    study "model: correspondence, $elastic, $soft" "model: correspondence, $elastic, $hard" \
        'horizon: 2, stabilisation: {law: capped}' "$ductile
$between
$cracks" 60 0.6
    compare 100 3
}

@test "ordinary, Mitchell's plasticity, ductile: 3 ranks give the bits of one" {
    study "model: ordinary_plastic, $elastic, $soft, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: ordinary_plastic, $elastic, $hard" 'horizon: 2.2' "$ductile" 60 0.5
    compare 100 3
}

@test "flat, the a, b, d form, partial volumes and a crack: 3 and 8 ranks give the bits of one" {
    FLAT=yes study "model: madenci_oterkus, $elastic" "model: madenci_oterkus, youngs_modulus: 190 GPa, poissons_ratio: 0.3" \
        'plane: stress, horizon: 2.2, volumes: partial, safety: 0.4' "damage:
  - {pair: [CG, CG], law: critical_stretch, fracture_energy: 3 kJ/m2}
  - {pair: [UFG, UFG], law: bond_energy, fracture_energy: 8 kJ/m2}
  - {pair: [CG, UFG], law: critical_stretch, value: 0.02}
$cracks" 60 0.5
    compare 30 3 8
}

@test "flat, linear ordinary in plane strain, surface correction: 3 ranks give the bits of one" {
    FLAT=yes study "model: ordinary, $elastic" "model: ordinary, youngs_modulus: 190 GPa, poissons_ratio: 0.3" \
        'plane: strain, horizon: 3.015, surface_correction: energy, safety: 0.4' "damage:
  - {pair: [CG, CG], law: critical_stretch, value: 0.02}
  - {pair: [UFG, UFG], law: critical_stretch, value: 0.03}
  - {pair: [CG, UFG], rule: min}
$cracks" 60 0.5
    compare 30 3
}

# A bar with a notch is pulled in two.  What rings in the halves has no mean, the less so the longer one looks: over the last
# third of the records a hundredth of the largest force may be left of it, where the bar carried all of it before.
crack='cracks: [{rectangle: [[0, -0.05 mm, -0.05 mm], [0, 0.03 mm, 0], [0, 0, 0.1 mm]]}]'
separates() {
    cat >bar.yaml <<END
title: Two halves
domain:
  specimen: plate
  size: [0.7 mm, 0.1 mm, 0.1 mm]
  gauge: {length: 0.3 mm}
  spacing: 25 um
  topology: homogeneous
  phase: CG
  grips: {length: 3 spacings, phase: structure}
materials:
  CG: {density: 8900 kg/m3, $1}
$(pulled '15 m/s')
solver: {type: explicit, $2, end_time: $4 us}
damage:
  - $3
${notch-"$crack"}
output:
  history: 600
  quantities: [{name: worst, quantity: damage, reduce: max, where: "y > 0"}]
END
    hsgen -q bar.yaml | hssolve -q >history.e 2>messages || { cat messages && false; }
    run ! grep 'cut no bond' messages
    peak=$(most history.e force_right_N)
    left=$(values history.e force_right_N | tail -n 200 | awk '{ sum += $1 } END { print sum / NR }')
    drift=$(most history.e energy_drift)
    echo "peak $peak N, at the end $left N; drift $drift; broken $(last history.e broken_bonds), \
fracture $(last history.e fracture_energy_J) J of $(last history.e external_work_J) J"
    holds "$peak > 0.5 && $left < 0.01 * $peak && $left > -0.01 * $peak"
    holds "$(last history.e broken_bonds) + $(last history.e removed_nodes) > 0"
    holds "$(last history.e fracture_energy_J) > 0"
    holds "$drift < 0.01"
}

@test "a bond-based bar separates, and the grips let go" {
    separates 'model: bond_based, youngs_modulus: 210 GPa' 'horizon: 2, safety: 0.4' \
        '{pair: [CG, CG], law: critical_stretch, value: 0.01}' 12
}

@test "a bar of correspondence with mix separates, and the grips let go" {
    separates "model: correspondence, $elastic, $soft" 'horizon: 1, stabilisation: {law: mix}' \
        '{phase: CG, law: plastic_strain, value: 0.15}' 16
}

@test "a bar of correspondence with capped separates, and the grips let go" {
    separates "model: correspondence, $elastic, $soft" \
        'horizon: 2, stabilisation: {law: capped}' '{phase: CG, law: plastic_strain, value: 0.15}' 16
}

weak='flaw: {centre: [0, 0, 0], radius: 50 um, reduction: 0.2}' # in place of the notch

@test "a bar of corner separates, and the grips let go" {
    notch='' separates "model: corner, $elastic, $soft, $weak" 'residual: {form: flowing}' \
        '{phase: CG, law: plastic_strain, value: 0.15}' 16
}

# What the energy balance goes wrong by, in J, from the last record without damage in the ligament to the end.
wrong_energy() {
    paste <(values history.e energy_drift) <(values history.e external_work_J) <(values history.e worst) |
        awk '$3 == 0 { before = $1 * $2 } { wrong = $1 * $2 } END { print (wrong > before ? wrong - before : before - wrong) }'
}

# The scheme is of second order: half the step leaves a quarter, for which a half leaves room.
@test "bars whose nodes degrade separate, and the energy is kept the better the shorter the step" {
    for law in mix capped corner; do
        for safety in 0.8 0.4; do
            if [ $law = corner ]; then
                notch='' separates "model: corner, $elastic, $soft, $weak" "safety: $safety" \
                    '{phase: CG, law: ductile, onset: 0.1, full: 0.2}' 16
            else
                separates "model: correspondence, $elastic, $soft" \
                    "horizon: 1, stabilisation: {law: $law}, safety: $safety" \
                    '{phase: CG, law: ductile, onset: 0.1, full: 0.2}' 16
            fi
            holds "$(last history.e removed_nodes) > 5"
            wrong[${safety#0.}]=$(wrong_energy)
            echo "$law, safety $safety: energy wrong by ${wrong[${safety#0.}]} J"
        done
        holds "${wrong[4]} < 0.5 * ${wrong[8]} && ${wrong[8]} < 1e-3 * $(last history.e external_work_J)"
    done
}
