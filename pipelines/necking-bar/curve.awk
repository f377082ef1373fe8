# What CalculiX printed: awk -v name=MESH -v cpu=S -f curve.awk bar.dat
# of the increments the first ones beyond each tenth of a millimetre, those about the largest force, and the last:
#   mesh, half elongation [mm], force [kN] of the bar (the model is a wedge of 2 degrees), radius of the neck over the first one,
#   largest plastic strain of a point, seconds

function off(a, b) { return a > b ? a - b : b - a }
$0 ~ /^ *(total force|displacements|equivalent plastic strain)/ {
    what = $1
    if ($NF != time) time = at[++n] = $NF
    next
}
what == "total" && NF == 3 { force[n] = 0.18 * $2 }
what == "displacements" && NF == 4 { radius[n] = 1 + $2 / 6.413 }
what == "equivalent" && NF == 3 && $3 > plastic[n] { plastic[n] = $3 }
END {
    for (k = 1; k <= n; k++) if (k == n || off(7 * at[k], 3.45) < 0.15 || int(70 * at[k] + 1e-9) > int(70 * at[k - 1] + 1e-9)) printf "%s,%.5f,%.4f,%.5f,%.4f,%s\n", name, 7 * at[k], force[k], radius[k], plastic[k], cpu
}
