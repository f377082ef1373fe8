# One row of the table: awk -f pipelines/columns.awk -v name=1 -f measure.awk nodes.csv
# Of the plastic strain p: mean, largest, and root mean square of p(x, y) - p(-x, y), of p(x, y) - p(x, -y) and of
# p(x, y) - p(-x, -y) over that of p, in per cent; of the nodes outside the grips.

BEGIN { FS = "," }
/^x/ { header_ends("EquivalentPlasticStrain,VonMises") }
/^[#x]/ { next }
$1 * $1 < 2.35e-3 ^ 2 {
    x = sprintf("%.0f", 1e6 * $1)
    y = sprintf("%.0f", 1e6 * $2)
    z = sprintf("%.0f", 1e6 * $3)
    p[x, y, z] = $4
    n++
    mean += $4
    mises += $5
    if ($4 > most) most = $4
}
END {
    for (k in p) {
        split(k, at, SUBSEP)
        square += p[k] ^ 2
        across_x += (p[k] - p[-at[1], at[2], at[3]]) ^ 2
        across_y += (p[k] - p[at[1], -at[2], at[3]]) ^ 2
        turned += (p[k] - p[-at[1], -at[2], at[3]]) ^ 2
    }
    printf "%s,%.3f,%.3f,%.1f,%.3g,%.3g,%.3g\n", name, 100 * mean / n, 100 * most, mises / n / 1e6,
           100 * sqrt(across_x / square), 100 * sqrt(across_y / square), 100 * sqrt(turned / square)
}
