# Load steps, explicit steps, and both in one run: the same curve, and bars that break at rest.

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

steps='type: quasi_static, step: 0.002'

# bar NAME MODEL SOLVER [DAMAGE]: NAME.g of 32 x 6 x 4 nodes, pulled at SPEED m/s
bar() {
    cat >"$1.yaml" <<END
title: Bar
$(even 32 6 4 2 16)
materials:
  M: {density: 8900 kg/m3, youngs_modulus: 210 GPa, $2}
$(pulled "${SPEED:-2} m/s")
${4:-}
solver: {$3, tolerance: 1e-6}
output: {history: 400}
END
    hsgen -q "$1.yaml" -o "$1.g"
}

correspondence="model: correspondence, poissons_ratio: 0.31, $soft"
mix='horizon: 1, stabilisation: {law: mix, share: 0.1}'

# silent MODEL FORMULATION: a hybrid run goes on where load steps would
silent() {
    bar static "$1" "$steps, $2 end_strain: 0.03"
    bar hybrid "$1" "type: hybrid, step: 0.002, $2 end_strain: 0.025, explicit_strain: 0.02"
    solve static
    solve hybrid
    columns static.e extension_m force_right_N >static
    # Each explicit record against the static curve between its two neighbours.
    columns hybrid.e quasi_static extension_m force_right_N force_left_N |
        awk 'FNR == NR { x[++n] = $1; f[n] = $2; next }
            $1 { was++; next }
            { for (i = 2; i < n && x[i] < $2; i++); w = ($2 - x[i - 1]) / (x[i] - x[i - 1])
              jump = $3 / (f[i - 1] + w * (f[i] - f[i - 1])) - 1; jump = jump < 0 ? -jump : jump
              sum = ($3 + $4) / $3; sum = sum < 0 ? -sum : sum
              most = jump > most ? jump : most; balance = sum > balance ? sum : balance; explicit++ }
            END { printf "%d static, %d explicit, jump %.2g, grips %.2g\n", was, explicit, most, balance
                  exit !(was > 10 && explicit > 5 && most < 1e-3 && balance < 1e-3) }' static -
}

@test "the switch to explicit steps is silent: the force goes on within 0.1 %" {
    silent "$correspondence" "$mix,"
    rm ./*.e
    silent "${correspondence/correspondence/corner}" ''
}

@test "and back: the rest of the motion is damped, and the curve goes on" {
    bar static "$correspondence" "$steps, $mix, end_strain: 0.02"
    bar hybrid "$correspondence" "type: hybrid, step: 0.002, $mix, end_strain: 0.02, explicit_strain: 0.01, \
static_when: {kinetic_to_internal: 0.1, quiet: 0.5 us}"
    solve static
    # Once back, the strain is at its limit and calls for explicit steps again.
    solve hybrid
    columns hybrid.e quasi_static | uniq | tr '\n' ' ' | grep '^1 0 1 0 1 '
    columns static.e extension_m force_right_N >static
    columns hybrid.e extension_m force_right_N energy_drift residual |
        awk 'FNR == NR { x[++n] = $1; f[n] = $2; next }
            $1 < x[8] || $1 > x[n] { next }
            { for (i = 2; i < n && x[i] < $1; i++); w = ($1 - x[i - 1]) / (x[i] - x[i - 1])
              jump = $2 / (f[i - 1] + w * (f[i] - f[i - 1])) - 1; jump = jump < 0 ? -jump : jump
              most = jump > most ? jump : most; count++ }
            END { printf "%d records, jump %.2g\n", count, most; exit !(count > 20 && most < 1e-3) }' static -
}

@test "the load maximum calls for explicit steps, at the stress of Considere" {
    SPEED=10 bar hybrid "model: correspondence, poissons_ratio: 0.31, \
hardening: {law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}" \
        "type: hybrid, $mix, step: 0.001, end_strain: 0.03, explicit_when: [maximum_load]"
    solve hybrid
    grep -q 'the load falls' hybrid.log || hssolve -i hybrid.g -H again.e 2>&1 | grep 'the load falls'
    # sigma = d sigma / d p of the law; the elastic part of the strain takes s/E of the section's contraction.
    columns hybrid.e quasi_static force_right_N | awk '
        $1 { last = $2; highest = $2 > highest ? $2 : highest }
        END { for (p = 0; p < 0.1; p += 1e-6) { s = 1259.8 + 564.5 * (1 - exp(-238.5 * p))
                  if (564.5 * 238.5 * exp(-238.5 * p) <= s) break }
              stress = s * exp(-p) * (1 - s / 210e3); found = highest / 0.015
              printf "%.1f MPa for %.1f MPa\n", found, stress
              exit !(last < highest && found > 0.995 * stress && found < 1.005 * stress) }'
}

@test "a load beyond the limit has no equilibrium: explicit steps take over" {
    bar hybrid "model: correspondence, poissons_ratio: 0.31, hardening: {law: linear, yield: 200 MPa, modulus: 0 MPa}" \
        "type: hybrid, $mix, step: 0.2 us, end_time: 6 us, energy_tolerance: 0.05"
    # The limit of 200 MPa on 0.015 mm2 is 3 N; 4 N are reached at 4 us.
    sed -i 's/velocity: -2 m.s/displacement: 0/; s/velocity: 2 m.s/force: "1e6*t"/' hybrid.yaml
    hsgen -q hybrid.yaml -o hybrid.g
    hssolve -i hybrid.g -H hybrid.e 2>log
    grep 'explicit from .*no equilibrium' log
    columns hybrid.e time_s quasi_static kinetic_energy_J |
        awk '$2 { last = $1 } END { print last, $3; exit !(last > 2.8e-6 && last < 3.05e-6 && $3 > 0) }'
}

@test "a brittle bar breaks at rest: no load is left, and what was stored is what it took" {
    # It breaks beside a grip, so that the gauge knows no end.
    bar brittle 'model: bond_based' "type: quasi_static, step: 0.04 us, horizon: 2, end_time: 2 us, break_at_once: 4" \
        "damage:
  - {pair: [M, M], law: critical_stretch, value: 0.004}"
    solve brittle
    columns brittle.e force_right_N broken_bonds residual fracture_energy_J external_work_J stored_energy_J |
        awk '{ highest = $1 > highest ? $1 : highest; worst = $3 > worst ? $3 : worst }
            # A few bonds along the broken plane stretch little and hold on: 0.2 % of the load.
            END { printf "%g N of %g, %d broken, residual %g, %g + %g J of %g\n", $1, highest, $2, worst, $4, $6, $5
                  lost = ($4 + $6) / $5 - 1
                  exit !($2 > 100 && $1 < 1e-2 * highest && worst <= 1e-6 && lost * lost < 1e-6) }'
}

@test "a ductile bar separates at rest and in motion at the same strain" {
    weak="$correspondence, flaw: {centre: [0, 0, 0], radius: 75 um, reduction: 0.05}"
    damage='damage:
  - {phase: M, law: ductile, onset: 0.45, full: 0.6}'
    bar static "$weak" "type: quasi_static, step: 0.0025, $mix, end_strain: 0.55" "$damage"
    SPEED=10 bar hybrid "$weak" "type: hybrid, step: 0.0025, $mix, end_strain: 0.55, explicit_when: [damage]" "$damage"
    solve static
    solve hybrid
    for run in static hybrid; do
        # Strain at which half of the largest load is lost; the balance of energy.
        columns $run.e extension_m force_right_N removed_nodes energy_drift | awk -v run=$run '
            { x[NR] = $1 / 0.4e-3; f[NR] = $2; if ($2 > highest) { highest = $2; at = NR } removed = $3; drift = $4 }
            END { for (i = at; i < NR && f[i] > 0.5 * highest; i++);
                  printf "%.5f %.4f %d %.2g\n", x[i], highest, removed, drift }' >$run
        cat $run
    done
    # The bar at 10 m/s breaks within two load steps of the one at rest, 1 % of strain each there; its maximum is that of the law at rest.
    paste -d' ' static hybrid | awk '{ d = $5 / $1 - 1; l = $6 / $2 - 1
        exit !($3 >= 24 && $7 >= 24 && d * d < 0.02 * 0.02 && l * l < 0.002 * 0.002 && $4 * $4 < 1e-4 && $8 * $8 < 1e-4) }'
}

@test "fracture at rest and both solvers in one run: 2, 3 and 4 ranks give the bits of one" {
    damage='damage:
  - {phase: M, law: ductile, onset: 0.08, full: 0.12}'
    bar static "$correspondence, yield_scatter: {deviation: 0.1, seed: 2}" \
        "type: quasi_static, $mix, end_strain: 0.14, break_at_once: 3" "$damage"
    SPEED=20 bar hybrid "$correspondence, yield_scatter: {deviation: 0.1, seed: 2}" \
        "type: hybrid, $mix, end_strain: 0.14, explicit_when: [damage], static_when: {kinetic_to_internal: 0.1, quiet: 0.1 us}" "$damage"
    for run in static hybrid; do
        for ranks in 1 2 3 4; do
            hssolve -q -j $ranks -i $run.g -H $run-$ranks.e 2>log || { cat log && false; }
            hspost -q --columns $run-$ranks.e | grep -v '^#' >$run-$ranks.csv
            cmp $run-1.csv $run-$ranks.csv
        done
        columns $run-1.e removed_nodes | tail -n 1
        holds "$(columns $run-1.e removed_nodes | tail -n 1) > 0"
    done
    columns hybrid-1.e quasi_static | uniq | tr '\n' ' ' | grep '^1 0 1'
}
