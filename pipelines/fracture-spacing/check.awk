# What the bars must show: awk -v study=fracture-spacing -v rows=24 -f pipelines/must.awk -f check.awk table.csv

# Largest difference among the spacings, of the value at the coarsest.
function spread(of, bar, kind,   k, low, high) {
    low = high = of[bar, 25, kind]
    for (k = 2; k <= 3; k++) {
        if (of[bar, spacing[k], kind] < low) low = of[bar, spacing[k], kind]
        if (of[bar, spacing[k], kind] > high) high = of[bar, spacing[k], kind]
    }
    return (high - low) / of[bar, 25, kind]
}

BEGIN {
    FS = ","
    split("25 16.7 12.5", spacing, " ")
    split("32 72 128", layer, " ")
    for (k in spacing) nodes[spacing[k]] = layer[k]
}
FNR == 1 { next }
{
    bar = $1 " at " $2 " m/s"
    bars[bar] = $2
    must($7 + 0 > 0 && $12 >= nodes[$3], bar " " $3 " um, " $4 ": not parted (" $12 " nodes removed)")
    must($13 < 1e-3, bar " " $3 " um, " $4 ": energy drift " $13)
    peak[bar, $3, $4] = $5
    first[bar, $3, $4] = $6
    strain[bar, $3, $4] = $7
    opening[bar, $3, $4] = $8
    energy[bar, $3, $4] = $10
}
END {
    for (bar in bars) {
        must(spread(peak, bar, "local") < 0.005, bar ": the peaks differ by " 100 * spread(peak, bar, "local") " %")
        # One law is the other where length and spacing are equal, and up to the first damage everywhere.
        must(off(strain[bar, 25, "local"], strain[bar, 25, "length"]) == 0, bar ": the length of one spacing changes something")
        for (k in spacing)
            must(off(first[bar, spacing[k], "local"], first[bar, spacing[k], "length"]) == 0, bar ": the length changes the first damage")
        # What softens gathers in a band as wide as the lattice can resolve, and the shorter the spacing, the less it opens.
        must(opening[bar, 12.5, "local"] < opening[bar, 16.7, "local"] && opening[bar, 16.7, "local"] < opening[bar, 25, "local"],
             bar ": the opening does not fall with the spacing")
        # What the length buys: half of the difference in strain at fracture.
        must(spread(strain, bar, "length") < 0.55 * spread(strain, bar, "local"),
             bar ": strains at fracture differ by " 100 * spread(strain, bar, "length") " % with length, " 100 * spread(strain, bar, "local") " % without")
        # Where it ends: more than the band opens, and all of it is scaled.
        must(opening[bar, 12.5, "length"] > opening[bar, 25, "length"], bar ": the opening with length does not grow")
        # At 25 m/s the plateau of the load rings by as much as the hundredth that is measured from.
        if (bars[bar] == 5)
            must(spread(energy, bar, "length") < 0.75 * spread(energy, bar, "local"),
                 bar ": energies after the peak differ by " 100 * spread(energy, bar, "length") " % with length, " 100 * spread(energy, bar, "local") " % without")
    }
    complete(peak, "peak")
    complete(first, "first damage")
    complete(strain, "strain at fracture")
    complete(opening, "opening")
    complete(energy, "energy")
    finish()
}
