# Engineering strain of the gauge and stress in MPa from what CalculiX prints: awk -f curve.awk weights bar.dat

BEGIN {
    print "engineering_strain,engineering_stress_MPa,force_balance"
    print "0,0,0"
}

FNR == NR {
    weight[$1] = $2 * $3
    next
}
/displacements/ { what = "u" }
/set RIGHT/ { what = "right" }
/set LEFT/ { what = "left" }
what == "u" && $1 in weight { elongation += weight[$1] * $2 }
what ~ /right|left/ && NF == 3 && $1 + 0 == $1 {
    force[what] = $1
    if (what == "left") {
        printf "%.8g,%.8g,%.2g\n", elongation / 0.4, (force["right"] - force["left"]) / 2 / 0.02, force["right"] / force["left"] + 1
        elongation = 0
    }
}
