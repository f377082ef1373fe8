# A row of the table from the columns of a history: awk -f pipelines/columns.awk -v name=cg-25-16.7-length -f measure.awk columns.csv
#   peak in MPa; strain of the gauge of 0.5 mm at the first damage and where the load has fallen below a tenth of the peak;
#   what the gauge has lengthened by between, in um; energy dissipated in all, and since the load was last above 99 % of
#   the peak, in mJ; length of the bar (1 mm) times its mean damage at the end, in um; largest drift of the energy balance
#   after the first tenth of the records.

BEGIN {
    FS = ","
    split(name, is, "-")
}
/^#/ { next }
header() { next }
{
    n++
    force[n] = $col("force_right_N")
    extension[n] = $col("extension_m")
    dissipated[n] = $col("plastic_energy_J") + $col("fracture_energy_J")
    if (!damaged && $col("most_damage") > 0) damaged = n
    if (!$col("removed_nodes") && force[n] > peak) peak = force[n]
    drift = $col("energy_drift")
    drifts[n] = drift < 0 ? -drift : drift
    removed = $col("removed_nodes")
    width = 1e3 * $col("mean_damage")
}
END {
    for (k = 1; k <= n; k++) {
        if (!parted && k > damaged && force[k] < 0.1 * peak) parted = k
        if (!parted && force[k] > 0.99 * peak) high = k
        if (k > n / 10 && drifts[k] > most) most = drifts[k]
    }
    printf "%s,%s,%s,%s,%.2f,%.4f,%.4f,%.2f,%.4f,%.4f,%.1f,%d,%.2g\n", is[1], is[3], is[4], is[2], peak / 0.02, extension[damaged] / 0.5e-3,
           parted ? extension[parted] / 0.5e-3 : "nan", parted ? 1e6 * (extension[parted] - extension[damaged]) : "nan",
           1e3 * dissipated[n], 1e3 * (dissipated[n] - dissipated[high]), width, removed, most
}
