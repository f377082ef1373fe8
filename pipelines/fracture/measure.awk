# A row of the table from a history (hspost --columns):
#   Rm in MPa (of the mean of both grips' forces), gauge strain there, gauge strain and grip strain where the load has fallen below 5 % of its largest, work per volume until
#   there in MJ/m3, largest difference of both grips' forces until Rm and in all over Rm in per cent, nodes gone, drift of the
#   energy balance, evaluations of the force: at rest and in motion
#   awk -f pipelines/columns.awk -v name=cg -f measure.awk history.csv

BEGIN { FS = ","; section = 0.08e-6; between_grips = 1.5e-3 }
/^# gauge_length_m/ { split($0, word, ": "); gauge = word[2] }
/^#/ { next }
!n { n = split($0, names); for (i = 1; i <= n; i++) column[names[i]] = i; next }
{
    f = ($col("force_right_N") - $col("force_left_N")) / 2 # waves of either sign are in one grip or the other
    apart = $col("force_right_N") + $col("force_left_N")
    apart = apart < 0 ? -apart : apart
    x = $col("extension_m") / gauge
    if (f > most) { most = f; at = x; until_most = apart > until_most ? apart : until_most }
    all = apart > all ? apart : all
    if (!broken && $col("broken_bonds") > 0 && f < 0.05 * most) {
        broken = x
        grips = $col("grip_extension_m") / between_grips
        work = $col("external_work_J")
    }
    if ($col("quasi_static")) at_rest = $col("force_evaluations")
    forces = $col("force_evaluations")
    gone = $col("removed_nodes")
    drift = $col("energy_drift")
}
END {
    printf "%s,%.1f,%.4f,%.4f,%.4f,%.1f,%.3f,%.2f,%d,%.1e,%d,%d\n", name, 1e-6 * most / section, at, broken, grips, \
        work / (section * between_grips) * 1e-6, 100 * until_most / most, 100 * all / most, gone, drift, at_rest, forces - at_rest
}
