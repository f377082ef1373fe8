# Bars that break, through the programs: the grips let go, the energies add up, and the same bits come from
# any number of ranks.

setup() { cd "$BATS_TEST_TMPDIR"; }

plastic='hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}'
hard='hardening: {law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}'
elastic='youngs_modulus: 210 GPa, poissons_ratio: 0.31'

# study CG UFG SOLVER DAMAGE VELOCITY END: domain.g of a plate of two phases
study() {
    cat >study.yaml <<END
title: Breaking
domain:
  specimen: plate
  size: [0.6 mm, 0.2 mm, 0.15 mm]
  gauge: {length: 0.3 mm}
  spacing: 25 um
  topology: random
  phases: {cg: CG, ufg: UFG}
  core: cell
  core_distance: 75 um
  ufg_fraction: 0.40
  override: true
  seed: 3
  grips: {length: 2 spacings, phase: structure}
materials:
  CG: {density: 8900 kg/m3, $1}
  UFG: {density: 8800 kg/m3, $2}
boundary:
  - {set: grip_left, direction: x, velocity: -$5 m/s}
  - {set: grip_right, direction: x, velocity: $5 m/s}
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

solve() {
    mkdir "$1"
    (cd "$1" && hssolve -q -j "$1" -i ../domain.g -o fields.e -H history.e) 2>messages || { cat messages && false; }
    LC_ALL=C sed -i "s/ -j $1 / -j N /g" "$1/fields.e" "$1/history.e"
}

# column FILE NAME last|most|least: of the history
column() {
    hspost -q "$1" | awk -F, -v name="$2" -v what="$3" '
        /^#/ { next }
        !column { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        { last = $column; if (!n++ || last > most) most = last; if (n == 1 || last < least) least = last }
        END { print what == "last" ? last : what == "most" ? most : least }'
}

holds() { awk "BEGIN { exit !($1) }"; }

# compare BROKEN RANKS...: over BROKEN bonds have broken, and each number of ranks gives the bits of one
compare() {
    local least=$1
    shift
    solve 1
    bonds=$(column 1/history.e broken_bonds last)
    echo "broken $bonds, fracture $(column 1/history.e fracture_energy_J last) J, without gradient \
$(column 1/history.e nodes_without_gradient last), drift $(column 1/history.e energy_drift most)"
    holds "$bonds > $least"
    for ranks in "$@"; do
        solve "$ranks"
        cmp 1/history.e "$ranks/history.e"
        cmp 1/fields.e "$ranks/fields.e"
    done
}

cracks='cracks:
  - {rectangle: [[0.28 mm, 0, 0], [0, 0.06 mm, 0], [0, 0, 0.15 mm]]}
  - {disc: {centre: [0.33 mm, 0.15 mm, 0.08 mm], normal: [1, 0.5, 0], radius: 45 um}}'

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
    study "model: correspondence, $elastic, $plastic, yield_scatter: {deviation: 0.1, seed: 2}" \
        "model: correspondence, $elastic, $hard" \
        'horizon: 1, stabilisation: {law: mix}' "damage:
  - {phase: CG, law: plastic_strain, value: 0.12}
  - {phase: UFG, law: plastic_strain, value: 0.05}" 60 0.6
    compare 100 2 3 4 8
}

@test "correspondence, capped, critical stretch and cracks: 2, 3, 4 and 8 ranks give the bits of one" {
    study "model: correspondence, $elastic, $plastic, flaw: {centre: [0.3 mm, 0, 0], radius: 50 um, reduction: 0.3}" \
        "model: correspondence, $elastic, $hard" \
        'horizon: 2, stabilisation: {law: capped}' "damage:
  - {pair: [CG, CG], law: critical_stretch, value: 0.15}
  - {pair: [UFG, UFG], law: critical_stretch, value: 0.05}
  - {pair: [CG, UFG], rule: harmonic}
$cracks" 60 0.5
    compare 100 2 3 4 8
}
