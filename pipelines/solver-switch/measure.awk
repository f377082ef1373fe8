# A curve beside the reference (both of hspost): mean and largest deviation of the stress between 1 and 9.5 % of strain, that at 0.5 and
# 2 %, all in per cent, forces evaluated, CPU seconds (of the log of
# `time -p hssolve`, the third file).
#   awk -f pipelines/columns.awk -v name=run -f measure.awk reference.csv curve.csv time

FNR == 1 { files++; delete column }
/^#/ { next }
files == 3 { if ($1 == "user") seconds = $2; if (match($0, /[0-9]+ forces:/)) forces = substr($0, RSTART) + 0; next }
{ n = split($0, value, ",") }
!("engineering_strain" in column) { for (i = 1; i <= n; i++) column[value[i]] = i; next }
files == 1 { x[++count] = value[col("engineering_strain")]; s[count] = value[col("engineering_stress_MPa")]; next }
{
    strain = value[col("engineering_strain")]
    if (strain <= x[1] || strain > 0.095) next
    for (i = 2; i < count && x[i] < strain; i++);
    w = (strain - x[i - 1]) / (x[i] - x[i - 1])
    off = 100 * (value[col("engineering_stress_MPa")] / (s[i - 1] + w * (s[i] - s[i - 1])) - 1)
    size = off < 0 ? -off : off
    if (before < 0.005 && strain >= 0.005) half = off
    if (before < 0.02 && strain >= 0.02) two = off
    if (strain > 0.01) { sum += size * (strain - before); length_ += strain - before; most = size > most ? size : most }
    before = strain
}
END { printf "%s,%.3f,%.3f,%.3f,%.3f,%d,%.1f\n", name, sum / length_, most, half, two, forces, seconds }
