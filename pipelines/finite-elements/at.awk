# Stress in MPa of a curve (strain, stress) at 0.5, 1, 2, 3 and 5 % of strain, then CPU seconds (of `time -p`, the second file):
#   awk -v name=C3D20R -v refined=1 -f at.awk curve.csv time
BEGIN { FS = ","; wanted = split("0.005 0.01 0.02 0.03 0.05", at, " "); printf "%s,%d", name, refined }
FNR == 1 { files++; next }
files == 2 { if ($0 ~ /^user/) seconds = substr($0, 6); next }
{
    while (k < wanted && $1 >= at[k + 1]) {
        k++
        printf ",%.2f", stress + (at[k] - strain) / ($1 - strain) * ($2 - stress)
    }
    strain = $1
    stress = $2
}
END { printf ",%.1f\n", seconds }
