# A row of the table from a history (hspost --columns): name, largest engineering stress in MPa, gauge strain there, "yes" and the gauge
# strain of the last record before the load fell below 5 % of that with broken bonds ("no" and the last strain otherwise), broken bonds, drift
# of the energy balance.  Of explicit steps, whose waves unload the grips now and then: "yes" where the mean force of the last half of the
# time is below 5 %, and the strain at the largest load.
#   awk -f pipelines/columns.awk -v name=01 -f measure.awk history.csv
BEGIN { FS = "," }
/^# gauge_length_m/ { split($0, word, ": "); gauge = word[2] }
/^# section_m2/ { split($0, word, ": "); section = word[2] }
/^#/ { next }
header() { next }
{
    strain = $col("extension_m") / gauge
    stress = 1e-6 * $col("force_right_N") / section
    bonds = $col("broken_bonds")
    drift = $col("energy_drift")
    moving = $col("quasi_static") == 0
    if (moving && $col("time_s") > 100e-6) { sum += (stress + last) / 2 * ($col("time_s") - time); whole += $col("time_s") - time }
    last = stress; time = $col("time_s")
    if (stress > most) { most = stress; at = strain }
    if (!moving && !broken && bonds > 0 && stress < 0.05 * most) { broken = 1; end = before }
    if (!broken) end = strain
    before = strain
}
END {
    if (moving) { end = at; broken = whole > 0 && bonds > 0 && sum / whole < 0.05 * most }
    printf "%s,%.1f,%.5f,%s,%.5f,%d,%.1e\n", name, most, at, broken ? "yes" : "no", end, bonds, drift
}
