# Small bodies for the suite of numerical stability, and the columns of their histories.

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
  grips: {length: ${GRIP:-1} spacings, phase: M}
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
# The chequerboard of the lattice as velocities: the fastest waves, and those that a family's mean does not see.
pi=3.141592653589793
checks="initial:
  - {where: \"1\", direction: x, velocity: \"V*sin($pi/25e-6*x)*sin($pi/25e-6*y)*sin($pi/25e-6*(z+12.5e-6))\"}
  - {where: \"1\", direction: y, velocity: \"V*sin($pi/25e-6*x)\"}"

columns() {
    local file=$1
    shift
    hspost -q --columns "$file" | awk -F, -v names="$*" '/^#/ { next }
        !n { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
        { for (k = 1; k <= n; k++) printf "%.12g%s", $at[name[k]], k < n ? " " : "\n" }'
}
elastic='youngs_modulus: 210 GPa, poissons_ratio: 0.31'
models=("model: bond_based, youngs_modulus: 210 GPa|horizon: 3.015" "model: ordinary, $elastic|horizon: 3.015"
    "model: madenci_oterkus, $elastic|horizon: 2.015"
    "model: correspondence_elastic, $elastic|horizon: 1, stabilisation: {law: mix}"
    "model: correspondence_elastic, $elastic|horizon: 2, stabilisation: {law: mix}"
    "model: correspondence_elastic, $elastic|horizon: 1, stabilisation: {law: capped}"
    "model: correspondence, $elastic, hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}|horizon: 1, stabilisation: {law: mix}"
    "model: ordinary_plastic, $elastic, hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}|horizon: 2.015")
