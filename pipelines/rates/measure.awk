# A run beside the exact curve of its law (Voce, Kirchhoff stress over logarithmic strain): errors in per cent of E (0.02 to 0.08 % of
# strain, at least squares through all records there) and of the engineering stress at 1, 2, 5 and 10 % of gauge strain, largest kinetic
# energy beyond 1 % of strain over internal energy in per cent, forces evaluated, CPU seconds (log of `time -p hssolve`, second file).
#   awk -f pipelines/columns.awk -v name=run -f measure.awk history.csv log

function exact(strain,   e, low, high, p, k) { # stress 182.1 + 513 (1 - exp(-5.32 p)), e = p + stress/E
    e = log(1 + strain)
    low = 0; high = e
    for (k = 0; k < 60; k++) {
        p = (low + high) / 2
        if (p + (182.1 + 513.0 * (1 - exp(-5.320 * p))) / 210e3 < e) low = p; else high = p
    }
    return (182.1 + 513.0 * (1 - exp(-5.320 * p))) * exp(-e)
}
BEGIN { FS = ","; wanted = split("0.01 0.02 0.05 0.1", at, " ") }
FNR == 1 { files++ }
files == 2 { if ($0 ~ /^user/) seconds = substr($0, 6); if (match($0, /[0-9]+ forces:/)) forces = substr($0, RSTART) + 0; next }
/^# gauge_length_m/ { split($0, word, ": "); gauge = word[2] }
/^#/ { next }
header() { next }
{
    strain = $col("extension_m") / gauge
    stress = 1e-6 * ($col("force_right_N") - $col("force_left_N")) / 2 / 0.04e-6
    if (strain > 0.0002 && strain < 0.0008) { m++; sx += strain; sy += stress; sxx += strain * strain; sxy += strain * stress }
    while (k < wanted && strain >= at[k + 1]) {
        k++
        w = (at[k] - before) / (strain - before)
        error[k] = 100 * ((stress_before + w * (stress - stress_before)) / exact(at[k]) - 1)
    }
    if (strain > 0.01 && $col("kinetic_to_internal") > kinetic) kinetic = $col("kinetic_to_internal")
    before = strain; stress_before = stress
}
END {
    E = m > 1 ? (m * sxy - sx * sy) / (m * sxx - sx * sx) : 0
    printf "%s,%s,%.2f,%.2f,%.2f,%.2f,%.2g,%d,%.1f\n", name, (m > 1 ? sprintf("%.2f", 100 * (E / 210e3 - 1)) : ""), error[1], error[2], error[3], error[4], \
        100 * kinetic, forces, seconds
}
