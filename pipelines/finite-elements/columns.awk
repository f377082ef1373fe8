# strain of the gauge (0.4 mm) and engineering stress in MPa (0.02 mm2) of hssolve's history: hspost --columns history.e | awk -f columns.awk
BEGIN { FS = ","; print "strain,stress_MPa" }
/^#/ { next }
!n { n = split($0, names); for (i = 1; i <= n; i++) column[names[i]] = i; next }
{ printf "%.8f,%.5f\n", ($column["right"] - $column["left"]) / 0.4e-3, $column["force_right_N"] / 0.02 }
