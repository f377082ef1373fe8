# Stress at five gauge strains of every run: awk -F, -f table.awk calculix.csv hstools.csv
# Both files: method,spacing_um,engineering_strain,engineering_stress_MPa,cpu_s.  Between points: a cubic through four.

BEGIN {
    wanted = split("0.005 0.01 0.02 0.03 0.05", want, " ")
    print "method,spacing_um,stress_0.5_MPa,stress_1_MPa,stress_2_MPa,stress_3_MPa,stress_5_MPa,cpu_s"
}

/^#/ || /^method/ || /^uniform/ { next }

{
    run = $1 "," $2
    if (!(run in points)) order[++runs] = run
    n = ++points[run]
    strain[run, n] = $3
    stress[run, n] = $4
    cpu[run] = $5
}

END {
    for (r = 1; r <= runs; r++) {
        line = order[r]
        for (w = 1; w <= wanted; w++) line = line "," at(order[r], want[w])
        print line "," cpu[order[r]]
    }
}

function at(run, e,    first, i, j, term, sum) {
    if (strain[run, points[run]] < e) return ""
    for (first = 1; first + 3 < points[run] && strain[run, first + 2] < e; first++) ;
    for (i = first; i < first + 4; i++) {
        term = stress[run, i]
        for (j = first; j < first + 4; j++) if (j != i) term *= (e - strain[run, j]) / (strain[run, i] - strain[run, j])
        sum += term
    }
    return sprintf("%.2f", sum)
}
