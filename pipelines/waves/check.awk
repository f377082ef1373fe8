# What the waves must show: awk -v study=waves -v rows=N -v blank=all -f pipelines/must.awk -f check.awk
#   lattice.csv bars-table.csv pulses.csv fronts.csv

FNR == 1 { table = FILENAME; sub(/.*\//, "", table); next }

# Two ways to one number: they differ by what is heard of the surfaces, which is what the fit leaves.
table == "lattice.csv" {
    wave = $1 " " $2 " " $3 ", " $4 " " $5 " " $6
    must(off($9, 0) < $10 + 1e-6, wave ": the run is off its symbol by " $9)
    must($10 < 2e-3, wave ": no single frequency, " $10)
    waves[$1]++
}

# The solid's speed but for 0.1 %; at free surfaces the pulse is as wide as six bars, which leaves some per mille; bonds cut at them
# are made up for by a correction that is known to be too stiff in thin bars.
table == "bars-table.csv" {
    bonds = $2 == "ordinary" || $2 == "bond-based"
    must(off($6, 0) < (bonds ? 6 : $1 == "plane" ? 0.1 : 0.5), $1 " of " $2 ": " $4 " m/s, the solid " $5)
    must(off($3 / $4, 1) < 0.005, $1 " of " $2 ": " $3 " m/s on the first way, " $4 " on the next")
    must(off($7, 100) < (bonds ? 6 : 0.5), $1 " of " $2 ": the standing end feels " $7 " % of the impulse")
    must(off($8, 100) < 0.5, $1 " of " $2 ": " $8 " % come back")
    bars[$1]++
}

table == "pulses.csv" { front[$1, $2] = $3; peak[$1, $2] = $4; plastic[$1, $2] = $8; structures[$1] }

# At rest and in motion are two computations.  A front is about as wide as the plate, 0.4 mm, and its middle known to a quarter of that; behind
# it, ripples of that length and the cells of a structure leave per cents of the strain.  A random plate is another bar at each place.
table == "fronts.csv" { fronts[$1] = $4 }
table == "fronts.csv" && $1 != "R40" {
    must(off($2 / $3, 1) < 0.04, $1 ": " $2 " % behind the front, the curve at rest asks for " $3)
    must($5 == "" || off($4, $5) < 100, $1 ": front at " $4 " um, the curve at rest asks for " $5)
    must($7 == "" || off($6 / $7, 1) < 0.04, $1 ": " $6 " MPa at the standing end, the curve at rest asks for " $7)
}

END {
    bar = sqrt(210e9 / 8900)
    for (s in structures) {
        must(off(front[s, 1] / bar, 1) < 0.015, s ": the elastic front runs at " front[s, 1] " m/s")
        # Both phases have the same constants: elastic waves do not see the arrangement.
        must(off(peak[s, 1] / peak["CG", 1], 1) < 1e-6, s ": an elastic pulse arrives with " peak[s, 1] " MPa, in CG with " peak["CG", 1])
        must(s in fronts, s ": no front")
    }
    must(plastic["CG", 20] > plastic["HS40", 20], "coarse grains alone take less of the work than HS40")
    must(fronts["HS40"] > 2 * fronts["CG"], "the front in HS40 is not much faster than in CG")
    must(bars["bar"] && bars["plane"], "bar and plane wave")
    must(waves["corner"] == 5 && waves["mix"] >= 5 && waves["ordinary"] >= 5 && waves["bond-based"] >= 5, "waves are missing")
    finish()
}
