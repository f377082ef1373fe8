# Load steps through the programs as a user runs them: exact elastic and plastic answers, loads, all methods, the balance of
# energy, what has no equilibrium.

bats_require_minimum_version 1.5.0

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

correspondence="model: correspondence, poissons_ratio: 0.31, $soft"
mix='horizon: 1, stabilisation: {law: mix}'

# bar NAME LENGTH_NODES MODEL SOLVER [BOUNDARY [OUTPUT]]: NAME.g of LENGTH x 4 x 4 nodes, 5 of them in the gauge, load steps with
# a residual of 1e-6
bar() {
    local tolerance=', tolerance: 1e-6'
    [[ $4 != *"type: explicit"* && $4 != *tolerance:* ]] || tolerance=
    cat >"$1.yaml" <<END
title: Bar
$(even "$2" 4 4 3 5)
materials:
  M: {density: 8900 kg/m3, youngs_modulus: 210 GPa, $3}
boundary:
${5:-  - {set: grip_left, direction: x, velocity: -1 m/s\}
  - {set: grip_right, direction: x, velocity: 1 m/s\}}
solver: {$4$tolerance}
output:
  history: 400
${6:-}
END
    hsgen -q "$1.yaml" -o "$1.g"
}

# converged FILE [TOLERANCE]: no record is above the tolerance
converged() {
    columns "$1" residual quasi_static | awk -v most="${2:-1e-6}" '
        { if (!($1 <= most) || $2 != 1) bad++ } END { exit !(NR > 1 && !bad) }'
}

exact='
    function yield(p) { return 182.1 + 513.0 * (1 - exp(-5.320 * p)) }
    # engineering stress in MPa under uniaxial stress: tau = E (ln lambda - p) = sigma_y(p), tau/lambda
    function exact(strain,    l, a, b, k, m) {
        l = log(1 + strain); a = 0; b = l
        if (210e3 * l <= yield(0)) return 210e3 * l / (1 + strain)
        for (k = 0; k < 60; k++) { m = (a + b) / 2; if (210e3 * (l - m) > yield(m)) a = m; else b = m }
        return 210e3 * (l - a) / (1 + strain)
    }
    function off(a, b) { return a > b ? a - b : b - a }'

@test "a bar under uniform strain gives Young's modulus and Poisson's ratio back within 1e-5" {
    # All nodes of two layers at either end have the displacement of their place, so that the strain is uniform.
    bar uniform 24 "model: correspondence_elastic, poissons_ratio: 0.31" \
        "type: quasi_static, $mix, end_time: 1, step: 0.5" '
  - {set: grip_left, direction: x, displacement: "1e-3*x*t"}
  - {set: grip_right, direction: x, displacement: "1e-3*x*t"}' '
  quantities:
    - {name: inner, quantity: force_x, reduce: sum, set: grip_right}
    - {name: corner, quantity: displacement_y, nearest: [0, 37.5 um, 37.5 um]}'
    solve uniform
    converged uniform.e
    # nominal stress E ln(1 + e)/(1 + e) on (0.1 mm)^2; lateral stretch (1 + e)^-nu at 37.5 um
    columns uniform.e time_s inner corner extension_m | awk "$exact"'
        $1 > 0 { e = 1e-3 * $1; n++
            E = -$2 / 1e-8 * (1 + e) / log(1 + e) / 210e9; nu = -log(1 + $3 / 37.5e-6) / log(1 + e) / 0.31
            strain = $4 / (5 * 25e-6) / e
            printf "E %.8f, nu %.8f, strain %.8f\n", E, nu, strain
            if (!(off(E, 1) < 1e-5 && off(nu, 1) < 1e-5 && off(strain, 1) < 1e-5)) bad = 1 }
        END { exit !(n == 2 && !bad) }'
}

@test "pulled to 12 %, the stress is that of the law, and all methods find the same" {
    # The gauge is 4.5 widths from the grips, whose disturbance decays by exp(-4) a width: 1e-8.  The residual is 1e-6 of
    # the forces on the grips.
    for method in lbfgs newton relaxation; do
        bar $method 44 "$correspondence" \
            "type: quasi_static, method: $method, $mix, end_strain: 0.12, first_step: 0.01, step: 0.01, accuracy: 1"
        solve $method
        converged $method.e
        columns $method.e extension_m force_right_N force_left_N | awk "$exact"'
            $1 > 0 { e = $1 / (5 * 25e-6); s = $2 / 1e-8 / 1e6; d = off(s / exact(e), 1); worst = d > worst ? d : worst
                sum = off($2, -$3) / $2; balance = sum > balance ? sum : balance; n++ }
            END { printf "to %.3f: stress off by %.2g, grips by %.2g in %d records\n", e, worst, balance, n
                  exit !(e > 0.12 && worst < 1e-5 && balance < 1e-5) }'
        columns $method.e time_s force_right_N extension_m >$method.txt
    done
    # The last step is as long as the gauge takes to its end.  Forces differ by ten times the residual at most; extensions by that times the elastic over the plastic slope, 100.
    for method in newton relaxation; do
        paste -d' ' lbfgs.txt $method.txt | awk "$exact"'
            $2 > 0 { if (off($1 / $4, 1) > 1e-5) exit bad = 1; d = off($5 / $2, 1); force = d > force ? d : force
                     d = off($6 / $3, 1); way = d > way ? d : way }
            END { printf "methods differ by %.2g and %.2g\n", force, way; exit !(!bad && force < 1e-5 && way < 1e-4) }'
    done
}

@test "a slow explicit test follows the same curve" {
    slow='  - {set: grip_left, direction: x, velocity: -0.1 m/s}
  - {set: grip_right, direction: x, velocity: 0.1 m/s}'
    bar static 24 "$correspondence" "type: quasi_static, $mix, end_strain: 0.03, step: 5e-4" "$slow"
    bar explicit 24 "$correspondence" \
        "type: explicit, $mix, end_strain: 0.028, start: ramp, ramp: 2 us, damping: 1e6 1/s" "$slow"
    solve static
    solve explicit
    columns static.e extension_m force_right_N >static
    # The waves that first yield sends have gone by 0.3 % of strain; inertia of 0.1 m/s is next to nothing, and straight lines
    # between the steps are off by 1e-5.
    columns explicit.e extension_m force_right_N | awk "$exact"'
        FNR == NR { x[++n] = $1; f[n] = $2; next }
        $1 / 125e-6 < 0.003 { next }
        { for (i = 2; i < n && x[i] < $1; i++); w = ($1 - x[i - 1]) / (x[i] - x[i - 1])
          d = off($2 / (f[i - 1] + w * (f[i] - f[i - 1])), 1); worst = d > worst ? d : worst; count++ }
        END { printf "%d records, off by %.2g\n", count, worst; exit !(count > 50 && worst < 3e-4) }' static -
}

@test "a bar under force follows the law, in steps of load and in steps that wait for equilibrium" {
    # Bonds with all of the energy, since the alternating strain beside a grip decays by 0.69 a node with a tenth of it.
    bonds='horizon: 1, stabilisation: {law: mix, share: 1}'
    bar pulled 40 "$correspondence" "type: quasi_static, $bonds, end_time: 1, step: 0.05" '
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: "3.5*t"}'
    bar stepped 40 "$correspondence" "type: quasi_static, $bonds, end_steps: 7" '
  - {set: grip_left, direction: x, force: {initial: -0.5 N, increment: -0.5 N, every: equilibrium}}
  - {set: grip_right, direction: x, force: {initial: 0.5 N, increment: 0.5 N, every: equilibrium}}
  - {set: gauge_left, direction: x, displacement: 0}'
    for run in pulled stepped; do
        solve $run
        converged $run.e
        columns $run.e time_s extension_m | awk -v most="$([ $run = pulled ] && echo 3.5 || echo 0.5)" "$exact"'
            $1 > 0 { s = most * $1 / 1e-8 / 1e6; d = off(exact($2 / 125e-6) / s, 1); worst = d > worst ? d : worst; n++ }
            END { printf "%d records to %.3f, off by %.2g\n", n, $2 / 125e-6, worst
                  exit !(n >= 7 && $2 / 125e-6 > 0.1 && worst < 1e-5) }'
    done
}

@test "a bar hangs under its weight like an elastic one" {
    # From the layer that is held: u(x) = b/E (L x - x^2/2) in the mean of a section, L to the end of the last cell.  
    # The hold keeps its plane plane; two widths on, exp(-8) of that is left.
    bar hanging 40 "model: correspondence_elastic, poissons_ratio: 0.31" \
        "type: quasi_static, horizon: 1, stabilisation: {law: mix, share: 1}, end_steps: 1" '
  - {box: [[-1, -1, -1], [-487 um, 1, 1]], direction: x, displacement: 0}
  - {block: M, direction: x, body_force: 1e9}' '
  quantities:
    - {name: high, quantity: displacement_x, reduce: mean, box: [[-240 um, -1, -1], [-230 um, 1, 1]]}
    - {name: low, quantity: displacement_x, reduce: mean, box: [[230 um, -1, -1], [240 um, 1, 1]]}
    - {name: support, quantity: force_x, reduce: sum, box: [[-1, -1, -1], [-487 um, 1, 1]]}
    - {name: weight, quantity: external_force_x, reduce: sum, block: M}'
    solve hanging
    converged hanging.e
    columns hanging.e time_s high low weight support | tail -n 1 | awk "$exact"'
        function u(x) { return 1e9 / 210e9 * (0.5e-3 * x - x * x / 2) }
        { found = $3 - $2; want = u(237.5e-6) - u(-237.5e-6); weight = 1e9 * 640 * 25e-6 ^ 3
          printf "%g for %g, %g and %g N for %g\n", found, want, $4, $5, weight
          exit !(off(found / want, 1) < 1e-4 && off($4 / weight, 1) < 1e-9 && off($5 / (weight * 39 / 40), 1) < 1e-5) }'
}

@test "every plastic formulation and a dog-bone: all methods, the same curve" {
    flat='s/^  size: .*/  size: [24 spacings, 6 spacings, 25 um]\n  dimensions: 2/'
    odd='s/^  size: .*/  size: [36 spacings, 8 spacings, 4 spacings]/; s/plate/dogbone/'
    odd+='; s/^  gauge: .*/  gauge: {length: 12 spacings, width: 4 spacings, fillet: 4 spacings}/'
    while IFS='|' read -r name change model solver; do
        for method in lbfgs newton relaxation; do
            bar x 24 "$model" "type: quasi_static, method: $method, $solver, end_strain: 0.004, step: 0.001, first_step: 5e-4"
            sed -i "$change" x.yaml
            hsgen -q x.yaml -o x.g
            solve x
            converged x.e
            columns x.e force_right_N M_plastic_strain | tail -n 1 >"$name-$method"
        done
        # Ten times the residual that either may have.
        cat "$name"-{lbfgs,newton,relaxation} | awk -v name="$name" "$exact"'
            { f[NR] = $1; p = $NF } END { d = off(f[2] / f[1], 1); e = off(f[3] / f[1], 1)
                printf "%s: %.6g N, plastic %.2g, differ by %.2g and %.2g\n", name, f[1], p, d, e
                exit !(NR == 3 && p > 1e-3 && d < 1e-5 && e < 1e-5) }'
    done <<END
mitchell||model: ordinary_plastic, poissons_ratio: 0.31, $soft|horizon: 3.015
corrected||model: ordinary_plastic, poissons_ratio: 0.31, $soft|horizon: 2.015, surface_correction: volume
capped||$correspondence|horizon: 1, stabilisation: {law: capped}
wide||$correspondence|horizon: 2, stabilisation: {law: mix}
flat|$flat|$correspondence|$mix, plane: strain
dogbone|$odd|$correspondence|$mix
END
}

@test "scattered particles are pulled at rest, by every method" {
    awk 'BEGIN { srand(1); print "# blocks: 1 M"
        for (z = 0; z < 5; z++) for (y = 0; y < 5; y++) for (x = 0; x < 24; x++)
            printf "%.9e %.9e %.9e 1 1e-9\n", (x + 0.3 * (rand() - 0.5)) * 1e-3, (y + 0.3 * (rand() - 0.5)) * 1e-3,
                (z + 0.3 * (rand() - 0.5)) * 1e-3 }' >particles.txt
    for method in lbfgs newton relaxation; do
        cat >scattered.yaml <<END
title: Scattered
domain: {dimensions: 3, spacing: 1 mm, grips: {length: 3 spacings}, gauge: {length: 8 mm}}
materials:
  M: {model: ordinary_plastic, density: 8000, youngs_modulus: 200 GPa, poissons_ratio: 0.3, $soft}
$(pulled '1 m/s')
solver: {type: quasi_static, method: $method, horizon: 2.6, end_strain: 0.005, step: 0.001, first_step: 0.001, accuracy: 1, tolerance: 1e-6}
END
        hssolve -q -d scattered.yaml -i particles.txt -H $method.e
        converged $method.e
        columns $method.e force_right_N M_plastic_strain force_evaluations | tail -n 1 >$method
    done
    cat lbfgs newton relaxation | tee /dev/stderr | awk "$exact"'
        { f[NR] = $1; p = $2; count[NR] = $3 }
        END { exit !(NR == 3 && p > 1e-3 && off(f[2] / f[1], 1) < 1e-5 && off(f[3] / f[1], 1) < 1e-5 && count[1] < 800) }'
}

@test "a load that the bar cannot carry has no equilibrium: the history up to there is kept" {
    bar perfect 24 "model: correspondence, poissons_ratio: 0.31, hardening: {law: linear, yield: 200 MPa, modulus: 0 MPa}" \
        "type: quasi_static, $mix, end_time: 1, step: 0.1" '
  - {set: grip_left, direction: x, displacement: 0}
  - {set: grip_right, direction: x, force: "2.5*t"}'
    run ! hssolve -q -i perfect.g -H perfect.e
    echo "$output" | tee log
    [ ! -e perfect.e ]
    grep 'no equilibrium with the smallest step.*more than the body carries' log
    converged perfect.e.failed
    # 200 MPa of true stress on (0.1 mm)^2 that has lost 2 nu times the elastic strain, 0.06 %: 1.9976 N at 0.799 s.
    columns perfect.e.failed time_s | tail -n 1 | awk '{ print; exit !($1 > 0.797 && $1 < 0.7996) }'
}

@test "the balance of energy closes with the square of the step" {
    for step in 0.002 0.001 0.0005; do
        bar steps 24 "$correspondence" "type: quasi_static, $mix, end_strain: 0.02, step: $step, first_step: $step"
        solve steps
        columns steps.e energy_drift external_work_J plastic_energy_J | tail -n 1
        # The trapezium is off where the curve has its kink, by E step^2/8 V at most; a tenth of that for the rest.
    done | awk '{ step = 0.004 / 2^NR; drift = $1 < 0 ? -$1 : $1; bound = 1.1 * 210e9 * step * step / 8 * (0.5e-3 * 1e-8) / $2
            print drift, bound; if (!(drift > 0 && drift < bound)) bad = 1 }
        END { exit !(NR == 3 && bound < 0.003 && !bad) }'
}

@test "an elastic step takes as many evaluations however long the bar is" {
    for length in 40 160; do
        bar long 40 "$correspondence" "type: quasi_static, $mix, end_steps: 1, step: 0.01 us"
        sed -i "s/size: .*/size: [$length spacings, 8 spacings, 4 spacings]/; s/ 1 m.s/ $((length / 40)) m\/s/; s/-1 m.s/-$((length / 40)) m\/s/" long.yaml
        hsgen -q long.yaml -o long.g
        solve long
        columns long.e force_evaluations force_right_N | tail -n 1
    done | awk '{ count[NR] = $1; print } END { exit !(count[1] < 40 && count[2] <= 1.2 * count[1]) }'
}

@test "hspost takes a history of load steps for what it is" {
    bar judged 48 "$correspondence" "type: quasi_static, $mix, end_strain: 0.03"
    solve judged
    hspost judged.e -p properties.csv -o curve.csv 2>table
    cat table
    # The slope has its three points; nothing moves; the grips balance; steps are in equilibrium.
    awk -F, "$exact"'
        $1 ~ /^(modulus|force_imbalance|kinetic_to_internal|unsteady_to_internal|residual)$/ { value[$1] = $3; n++; flags += /\[/ }
        END { print value["modulus"], value["residual"], n, flags
              exit !(n == 5 && flags == 0 && off(value["modulus"] / 210, 1) < 1e-3 && value["kinetic_to_internal"] == 0 &&
                     value["unsteady_to_internal"] == 0 && value["force_imbalance"] < 1e-5 && value["residual"] > 0 &&
                     value["residual"] <= 1e-6) }' properties.csv
}

@test "keys of load steps and of explicit steps are told apart, with their place" {
    for wrong in 'safety: 0.5' 'damping: 1 1/s' 'start: affine' 'energy_tolerance: 1' 'first_step: 0.1, step: 0.01' \
        'smallest_step: 0.1, first_step: 0.001' 'method: gauss' 'tolerance: 1' 'step: 1 us'; do
        bar wrong 24 "$correspondence" "type: quasi_static, $mix, end_strain: 0.01, $wrong"
        run ! hssolve -q -i wrong.g -H wrong.e
        echo "$output"
        [[ $output =~ wrong.yaml:[0-9]+:[0-9]+: ]]
    done
    bar wrong 24 "$correspondence" "type: explicit, $mix, end_strain: 0.01, step: 0.001"
    run ! hssolve -q -i wrong.g -H wrong.e
    echo "$output"
    [[ $output == *"'step' belongs to type: quasi_static or hybrid or auto, not to type: explicit"* ]]
}
