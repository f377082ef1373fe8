# Sheets of corner in plane stress, through the programs: the law's tension and the beam's bending, ranks and restart.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

# sheet LENGTH WIDTH SPACING MATERIAL SOLVER BOUNDARY [OUTPUT]: sheet.g, 0.1 mm thick, lengths in mm
sheet() {
    cat >sheet.yaml <<END
title: Sheet
domain:
  specimen: plate
  dimensions: 2
  size: [$1 mm, $2 mm, 0.1 mm]
  spacing: $3 mm
  topology: homogeneous
  phase: M
  grips: {length: 1 spacings, phase: M}
  gauge: {length: 0.5 mm}
materials:
  M: {model: corner, density: 8900, youngs_modulus: 200 GPa, poissons_ratio: 0.3, $4}
solver: {plane: stress, $5}
boundary:
$6
${7:-}
END
    hsgen -q sheet.yaml -o sheet.g
}

@test "tension into plastic flow: the stress of the law under uniaxial stress and its thinning, within 1e-5" {
    for residual in flowing four_points; do
        sheet 1 0.4 0.1 "$soft" "type: quasi_static, tolerance: 1e-6, end_time: 1, step: 0.1, residual: {form: $residual}" \
            '  - {where: "x < -0.499e-3", direction: x, displacement: "-1e-4*t"}
  - {where: "x > 0.499e-3", direction: x, displacement: "1e-4*t"}
  - {where: "y < -0.199e-3", direction: y, displacement: 0}' 'output:
  quantities:
    - {name: least, quantity: stress_xx, reduce: min, block: M}
    - {name: most, quantity: stress_xx, reduce: max, block: M}
    - {name: across, quantity: stress_zz, reduce: max, block: M}
    - {name: flown, quantity: equivalent_plastic_strain, reduce: mean, block: M}'
        hssolve -q -i sheet.g -H history.e
        # tau = E (ln lambda - p) = sigma_y(p); Cauchy's stress is tau/J, ln J = (1 - 2 nu) tau/E
        columns history.e time_s least most across flown | awk '
            function yield(p) { return 182.1e6 + 513.0e6 * (1 - exp(-5.320 * p)) }
            function off(a, b) { return a > b ? a - b : b - a }
            $1 == 0 { next }
            { l = log(1 + 0.2 * $1); a = 0; b = l
              for (k = 0; k < 60; k++) { p = (a + b) / 2; if (200e9 * (l - p) > yield(p)) a = p; else b = p }
              tau = 200e9 * (l - p); stress = tau / exp(0.4 * tau / 200e9); print $0, stress, p
              if (off($2, stress) > 1e-5 * stress || off($3, stress) > 1e-5 * stress) exit 1
              if (off($4, 0) > 1e-5 * stress || off($5, p) > 1e-5 * p) exit 1; n++ }
            END { if (n < 10) exit 1 }'
    done
}

# bent WIDTH SPACING RESIDUAL: energy of pure bending over E I kappa^2 L/2, less 1 [%]
bent() {
    sheet 2 1 "$1" 'law: elastic' "type: quasi_static, tolerance: 1e-6, end_time: 1, step: 1, most_evaluations: 20000, residual: {form: $2}" \
        '  - {where: "x < -0.999e-3", direction: x, displacement: "0.1*y"}
  - {where: "x > 0.999e-3", direction: x, displacement: "-0.1*y"}
  - {where: "abs(y) < 1e-9 && abs(x) > 0.999e-3", direction: y, displacement: 0}'
    sed -i 's/0\.1\*y/1e-4*y/' sheet.yaml
    hsgen -q sheet.yaml -o sheet.g
    hssolve -q -i sheet.g -H history.e
    # kappa = 2e-4/L, I = t h^3/12
    columns history.e stored_energy_J stabilisation_energy_J | tail -n 1 |
        awk '{ k = 2e-4 / 2e-3; print 100 * (($1 + $2) / (0.5 * 200e9 * 1e-4 * 1e-9 / 12 * k * k * 2e-3) - 1) }'
}

@test "pure bending of a sheet: E, not E/(1 - nu^2), of the second order" {
    for residual in flowing four_points; do
        coarse=$(bent 0.25 $residual)
        fine=$(bent 0.125 $residual)
        echo "$residual: $coarse %, $fine %"
        awk -v a="${coarse#-}" -v b="${fine#-}" -v most="$([ $residual = flowing ] && echo 2 || echo 7)" \
            'BEGIN { exit !(a < most && b < a / 3.5) }'
    done
}

# Kirsch's displacements at the edge of a plate of eight radii, S a/(8 mu) = 1e-7 m; beside the hole at twice its radius
# the stress along x is S (1 + a^2/(2 r^2) + 3 a^4/(2 r^4)).
@test "a plate with a hole: Kirsch's stress at two radii within 0.5 %, spacing a tenth of the radius" {
    r='sqrt(x^2 + y^2)'
    k='((3 - 0.3)/(1 + 0.3))'
    c='(4*(x/R)^3 - 3*x/R)'
    s='(3*y/R - 4*(y/R)^3)'
    ux="1e-7*(R/0.001*($k + 1)*x/R + 0.002/R*((1 + $k)*x/R + $c) - 2*(0.001/R)^3*$c)"
    uy="1e-7*(R/0.001*($k - 3)*y/R + 0.002/R*((1 - $k)*y/R + $s) - 2*(0.001/R)^3*$s)"
    edge='abs(x) > 3.99e-3 || abs(y) > 3.99e-3'
    sheet 8 8 0.1 'law: elastic' 'type: quasi_static, tolerance: 1e-6, end_time: 1, step: 1' \
        "  - {where: \"$edge\", direction: x, displacement: \"${ux//R/($r)}\"}
  - {where: \"$edge\", direction: y, displacement: \"${uy//R/($r)}\"}" 'output:
  quantities:
    - {name: above, quantity: stress_xx, reduce: mean, where: "abs(x) < 0.11e-3 && y > 1.89e-3 && y < 2.11e-3"}
    - {name: beside, quantity: stress_xx, reduce: mean, where: "abs(y) < 0.11e-3 && x > 1.89e-3 && x < 2.11e-3"}'
    sed -i 's/  topology:/  hole: {diameter: 2 mm}\n  volumes: cut\n&/' sheet.yaml
    hsgen -q sheet.yaml -o sheet.g
    hssolve -q -i sheet.g -H history.e
    columns history.e above beside | tail -n 1 | awk '
        { S = 8 * 200e9 / 2.6 * 1e-7 / 1e-3; above = S * (1 + 0.5 / 4 + 1.5 / 16)
          # on the axis of the load S (1 - 5 a^2/(2 r^2) + 3 a^4/(2 r^4))
          beside = S * (1 - 2.5 / 4 + 1.5 / 16); print $1 / above - 1, ($2 - beside) / S
          exit !(($1 / above - 1) ^ 2 < 0.005 ^ 2 && (($2 - beside) / S) ^ 2 < 0.005 ^ 2) }'
}
