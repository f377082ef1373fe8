# A homogeneous plate gives back what went into it: Young's modulus, yield and flow stress up to 25 %
# of strain, through the three programs as a user runs them.
#
# Exact answer of uniaxial tension: tau = E (ln lambda - p) = sigma_y(p), engineering stress
# tau/lambda.  The gauge lies 2.7 widths from the grips, whose nodes cannot contract along x and so
# disturb the stress; that decays by exp(-4) a width.  What is left of inertia falls with the square of
# the speed: the grips reach theirs gently, and a damping of 4e5 1/s takes out the waves that first
# yield sends along the plate.

load ../bodies
load ../columns
setup() { cd "$BATS_TEST_TMPDIR"; }

# plate SPEED RAMP STABILISATION: the curve in curve.csv, the properties in properties.csv
plate() {
    cat >plate.yaml <<END
title: Homogeneous plate
$(even 36 4 4 3 8)
materials:
  M: {model: correspondence, density: 8900 kg/m3, $elastic, $soft}
$(pulled "$1 m/s")
solver:
  type: explicit
  horizon: 1
  stabilisation: {law: $3}
  end_strain: 0.252
  start: ramp
  ramp: $2 us
  damping: 4e5 1/s
output: {history: 400}
END
    hsgen -q plate.yaml | hssolve -q | hspost -q -p properties.csv >curve.csv
}

exact='
    function yield(p) { return 182.1 + 513.0 * (1 - exp(-5.320 * p)) }
    function exact(strain,    l, a, b, k, m) {
        l = log(1 + strain); a = 0; b = l
        if (210e3 * l <= yield(0)) return 210e3 * l / (1 + strain)
        for (k = 0; k < 60; k++) {
            m = (a + b) / 2
            if (210e3 * (l - m) > yield(m)) a = m; else b = m
        }
        return 210e3 * (l - a) / (1 + strain)
    }'

# Largest and mean |stress/exact - 1| in per cent between two engineering strains, number of rows.
errors() {
    awk -F, -v low="$1" -v high="$2" "$exact"'
        /^#/ { next }
        !head { for (i = 1; i <= NF; i++) column[$i] = i; head = 1; next }
        $column["engineering_strain"] >= low && $column["engineering_strain"] <= high {
            e = 100 * ($column["engineering_stress_MPa"] / exact($column["engineering_strain"]) - 1)
            if (e < 0) e = -e
            if (e > worst) worst = e
            mean += e; n++
        }
        END { if (n < 20) exit 1; printf "%.4f %.4f %d\n", worst, mean / n, n }' curve.csv
}

# Stress at 0.2 % of plastic strain on the exact curve [MPa].
exact_proof_stress() {
    awk "$exact"'
        BEGIN {
            a = 0.002; b = 0.01
            for (k = 0; k < 60; k++) {
                m = (a + b) / 2
                if (exact(m) / 210e3 > m - 0.002) a = m; else b = m
            }
            printf "%.6f\n", exact(a)
        }'
}

property() { awk -F, -v p="$1" '$2 == p { print $3 }' properties.csv; }

# within TOLERANCE VALUE EXPECTED: relative
within() {
    echo "$2, expected $3 within $1"
    holds "($2) / ($3) - 1 <= $1 && 1 - ($2) / ($3) <= $1"
}

@test "mix: modulus, yield and flow stress within 0.1 %, inertia falling with the square of the speed" {
    plate 1.25 100 mix
    read -r worst mean n <<<"$(errors 0.005 0.25)"
    echo "flow stress at 2500/s: worst $worst %, mean $mean % of $n records"
    holds "$worst < 0.1" # 0.03 here: waves that the damping has left
    within 0.001 "$(property m_E)" 210
    within 0.001 "$(property Rp0.2)" "$(exact_proof_stress)"
    slow=$mean
    plate 2.5 50 mix
    read -r worst mean n <<<"$(errors 0.005 0.25)"
    echo "flow stress at 5000/s: worst $worst %, mean $mean % of $n records"
    holds "$mean > 2.5 * $slow" # a quarter of it is left at half the speed: so it is inertia
    holds "$worst < 0.2"
}

@test "capped: modulus, yield and flow stress within 0.1 %" {
    plate 1.25 100 capped
    read -r worst mean n <<<"$(errors 0.005 0.25)"
    echo "flow stress: worst $worst %, mean $mean % of $n records"
    holds "$worst < 0.1"
    within 0.001 "$(property m_E)" 210
    within 0.001 "$(property Rp0.2)" "$(exact_proof_stress)"
}
