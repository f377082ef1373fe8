# Stress in MPa of curves (hspost) of three spacings, coarsest first, at a few strains; extrapolated from the two finest (errors that
# fall with the square of the spacing); what the finest differs from that, and the coarser ones from the finest, in per cent.
#   awk -f table.awk 25um/curve.csv 12.5um/curve.csv 8.33um/curve.csv
BEGIN { FS = ","; wanted = split("0.005 0.01 0.02 0.04 0.06 0.08 0.1", at, " ") }
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
    weight = spacing[3] ^ 2 / (spacing[2] ^ 2 - spacing[3] ^ 2)
    print "strain_percent,at_25um_MPa,at_12.5um_MPa,at_8.33um_MPa,extrapolated_MPa,finest_percent,25um_percent,12.5um_percent"
    for (k = 1; k <= wanted; k++) {
        limit = value[3, k] - weight * (value[2, k] - value[3, k])
        a = 100 * (value[3, k] / limit - 1); b = 100 * (value[1, k] / value[3, k] - 1); c = 100 * (value[2, k] / value[3, k] - 1)
        printf "%g,%.1f,%.1f,%.1f,%.1f,%.2f,%.2f,%.2f\n", 100 * at[k], value[1, k], value[2, k], value[3, k], limit, a, b, c
        # A shell of 1.2, 2.5 and 3.7 spacings: the structure itself differs from one to the next.
        must(c * c < 1.5 ^ 2 && b * b < 5 ^ 2, "off by " b " and " c " % at " 100 * at[k] " % of strain")
    }
    exit failed
}
