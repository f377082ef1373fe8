# Stress in MPa of curves (hspost) of some spacings, coarsest first, at a few strains; extrapolated from the two finest (errors that
# fall with the square of the spacing); what the finest differs from that, and the coarser ones from the finest, in per cent.
#   awk -f pipelines/columns.awk -v names="25um 12.5um 8.33um" -f table.awk 25um/curve.csv 12.5um/curve.csv 8.33um/curve.csv
BEGIN { FS = ","; wanted = split("0.005 0.01 0.02 0.04 0.06 0.08 0.1", at, " "); split(names, name, " ") }
FNR == 1 { files++; k = strain = stress = 0; delete column }
/^# spacing_m/ { split($0, word, ": "); spacing[files] = word[2] }
/^#/ { next }
!("engineering_strain" in column) { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    while (k < wanted && $col("engineering_strain") >= at[k + 1]) {
        k++
        value[files, k] = stress + (at[k] - strain) / ($col("engineering_strain") - strain) * ($col("engineering_stress_MPa") - stress)
    }
    strain = $col("engineering_strain")
    stress = $col("engineering_stress_MPa")
}
END {
    weight = spacing[files] ^ 2 / (spacing[files - 1] ^ 2 - spacing[files] ^ 2)
    printf "strain_percent"
    for (f = 1; f <= files; f++) printf ",at_%s_MPa", name[f]
    printf ",extrapolated_MPa,finest_percent"
    for (f = 1; f < files; f++) printf ",%s_percent", name[f]
    print ""
    for (k = 1; k <= wanted; k++) {
        finest = value[files, k]
        limit = finest - weight * (value[files - 1, k] - finest)
        printf "%g", 100 * at[k]
        for (f = 1; f <= files; f++) printf ",%.1f", value[f, k]
        printf ",%.1f,%.2f", limit, 100 * (finest / limit - 1)
        for (f = 1; f < files; f++) printf ",%.2f", 100 * (value[f, k] / finest - 1)
        print ""
    }
}
