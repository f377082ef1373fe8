# Small bodies for the suite of numerical stability, and what becomes of their energy.

load ../bodies
load ../columns

# body NAME MODEL SOLVER REST [SIZE]: NAME.g of 8 x 6 x 5 nodes, 25 um apart
body() {
    cat >"$1.yaml" <<END
title: Stress
domain:
  specimen: plate
  size: ${5:-[0.2 mm, 0.15 mm, 0.125 mm]}
  spacing: ${SPACING:-25 um}
  topology: homogeneous
  phase: M
  grips: {length: ${GRIP:-2} spacings, phase: M}
materials:
  M: {density: 8900 kg/m3, $2}
$4
solver: {$3}
output:
  history: ${RECORDS:-40}
  quantities:
    - {name: pull, quantity: force_x, reduce: sum, set: grip_right}
${QUANTITIES:-}
END
    hsgen -q "$1.yaml" -o "$1.g"
}

# contrast LENGTH MODEL SOLVER: contrast.g, soft cores in a matrix with a hundred times their yield; LENGTH in mm
contrast() {
    cat >contrast.yaml <<END
title: Contrast
domain:
  specimen: plate
  size: [$1 mm, 0.2 mm, 0.1 mm]
  spacing: 25 um
  topology: random
  phases: {cg: SOFT, ufg: HARD}
  core: cell
  core_distance: 75 um
  ufg_fraction: 0.40
  override: true
  seed: 3
  grips: {length: 2 spacings, phase: structure}
  gauge: {length: $(awk "BEGIN { print $1 / 2 }") mm}
materials:
  SOFT: {density: 8900, model: $2, $elastic, hardening: {law: linear, yield: 20 MPa, modulus: 100 MPa}}
  HARD: {density: 8900, model: $2, $elastic, hardening: {law: linear, yield: 2000 MPa, modulus: 100 MPa}}
$(pulled '1 m/s')
solver: {end_strain: 0.03, $3}
END
    hsgen -q contrast.yaml -o contrast.g 2>/dev/null
}

# swings FILE: mean size of the energy drift in the second and in the last quarter of the records
swings() {
    columns "$1" energy_drift | awk '{ d[NR] = $1 < 0 ? -$1 : $1 }
        END { n = int(NR / 4); for (i = 1; i <= n; i++) { early += d[i + n]; late += d[NR + 1 - i] } print early / n, late / n }'
}

# The chequerboard of the lattice as velocities: the fastest waves, and those that a family's mean does not see.
pi=3.141592653589793
planes="sin($pi/25e-6*x)"
chequerboard="$planes*sin($pi/25e-6*y)*sin($pi/25e-6*(z+12.5e-6))"
checks="initial:
  - {where: \"1\", direction: x, velocity: \"0.5*$chequerboard\"}
  - {where: \"1\", direction: y, velocity: \"0.5*$planes\"}"

flow='hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}'
models=("model: bond_based, youngs_modulus: 210 GPa|horizon: 3.015" "model: ordinary, $elastic|horizon: 3.015"
    "model: madenci_oterkus, $elastic|horizon: 2.015"
    "model: correspondence_elastic, $elastic|horizon: 1, stabilisation: {law: mix}"
    "model: correspondence_elastic, $elastic|horizon: 2, stabilisation: {law: mix}"
    "model: correspondence_elastic, $elastic|horizon: 1, stabilisation: {law: capped}"
    "model: correspondence, $elastic, $flow|horizon: 1, stabilisation: {law: mix}"
    "model: ordinary_plastic, $elastic, $flow|horizon: 2.015")
