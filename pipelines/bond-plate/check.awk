# What the table of the bond-based sheet must show: awk -v study=bond-plate [-v small=yes] -f pipelines/must.awk -f check.awk table.csv
# small: of one horizon.

FNR == 1 { next }
{
    kind = $4 "-" $5
    if ($1 == "strain") {
        strain[kind] = $8
        next
    }
    error[$2, $3, kind] = $8
    lattice[$2, kind] = $9
    # 3e-4 is what the inertia and the damping of the lateral motion leave at this speed.
    if ($3 == 1) must(off($10, $11) < 1e-3, $2 " " kind ": Poisson's ratio " $10 ", of the lattice " $11)
}

END {
    # The edges' part is their share of the area, horizon/width: proportional to the spacing, gone in
    # the linear extrapolation.  What is left of higher order is 1e-2 %.
    for (i in lattice) {
        split(i, k, SUBSEP)
        limit = 2 * error[k[1], 1, k[2]] - error[k[1], 2, k[2]]
        must(off(limit, lattice[i]) < 0.05, k[1] " " k[2] ": error " limit " % at spacing 0, of the lattice " lattice[i] " %")
    }
    # The planes differ by the factor of the micromodulus, 16/15, that of the exact moduli, too.
    for (kind in strain)
        must(off(strain[kind], error["3.015", 2, kind]) < 0.01, kind ": plane strain is off by " strain[kind] " %, plane stress by " error["3.015", 2, kind] " %")
    # E comes back where the quadrature is good and the edges are corrected.
    if (small == "") must(off(error["4.015", 1, "whole-energy"], 0) < 2 && off(error["5.015", 1, "whole-energy"], 0) < 2, "E is off by more than 2 %")
    complete(error, "error")
    complete(lattice, "error of the lattice")
    complete(strain, "error in plane strain")
    finish()
}
