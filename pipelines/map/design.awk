# The design of the map: awk -v runs=N -f design.awk
#
# Points of Halton's sequence (Numer. Math. 2 (1960) 84) in the factors' ranges, a row of keys a point; the seed is another one in each.

function inverse(i, base,   sum, part) {
    for (part = 1 / base; i > 0; part /= base) { sum += part * (i % base); i = int(i / base) }
    return sum
}
function between(low, high, base) { return low + (high - low) * inverse(n, base) }

BEGIN {
    split("sc bcc fcc", lattice, " ")
    split("0.2 0.346410161514 0.282842712475", distance, " ") # eight, two and four cores
    print "name,domain.ufg_fraction,UFG.hardening.yield,UFG.hardening.saturation,CG.hardening.saturation,domain.lattice,domain.core_distance,domain.jitter,domain.spacing,domain.seed"
    for (n = 1; n <= runs; n++) {
        arrangement = 1 + int(3 * inverse(n, 3))
        printf "%d,%.4f,%.2f MPa,%.1f MPa,%.1f MPa,%s,%s mm,%.4f,%.10g um,%d\n", n, between(0.2, 0.7, 2), 182.1 * between(1.5, 7, 5),
            between(100, 600, 7), between(250, 750, 11), lattice[arrangement], distance[arrangement], between(0, 0.15, 13),
            400 / (16 + 4 * int(5 * inverse(n, 17))), n
    }
}
