# awk -f pipelines/columns.awk -F, -f finite.awk curve.csv: engineering stress of a plate of linear hardening over that of J2 plasticity in
# logarithmic strain, tau = 185 + 898 p = 210e3 (ln(1 + e) - p) MPa, and the section that is left.

function exact(e,   l) {
    l = log(1 + e)
    return (185 + 898 * (210e3 * l - 185) / (210e3 + 898)) / (1 + e)
}

BEGIN { n = split("0.01 0.02 0.05 0.10 0.1575", wanted, " "); at = 1 }
/^#/ { next }
!head {
    for (i = 1; i <= NF; i++) column[$i] = i
    head = 1
    print "engineering_strain,engineering_stress_MPa,exact_MPa,excess,volume"
    next
}
at <= n && $col("engineering_strain") >= wanted[at] {
    e = $col("engineering_strain")
    s = $col("engineering_stress_MPa")
    printf "%.4f,%.1f,%.1f,%.3f,%.4f\n", e, s, exact(e), s / exact(e) - 1,
        (1 + e) * $col("minimum_section_ratio")
    at++
}
