# One row of the table of a bond-based sheet: its modulus at the end of the test, Poisson's ratio of
# the displacements there, and both as a lattice without edges has them.
#   awk -f pipelines/columns.awk -v name=stress-3.015-2mm-whole-none -f measure.awk curve.csv displacement.csv
#
# A deformation e of the lattice stretches the bond xi by e_ij n_i n_j; the bonds of a family make
#   C_11 = 1/2 sum c V xi_1^4/|xi|^3,  C_12 = 1/2 sum c V xi_1^2 xi_2^2/|xi|^3,
# with c of the continuum.  Tension with free edges: E = C_11 - C_12^2/C_11, nu = C_12/C_11.

function lattice(horizon, partial, c,   x, y, r, w, C11, C12, reach) {
    reach = int(horizon)
    for (x = -reach; x <= reach; x++)
        for (y = -reach; y <= reach; y++) {
            r = sqrt(x * x + y * y)
            if (r == 0 || r > horizon) continue
            w = partial && r > horizon - 0.5 ? horizon + 0.5 - r : 1
            C11 += w * x ^ 4 / r ^ 3 / 2
            C12 += w * x * x * y * y / r ^ 3 / 2
        }
    lattice_E = c / (atan2(0, -1) * horizon ^ 3) * (C11 - C12 * C12 / C11)
    lattice_nu = C12 / C11
}

BEGIN {
    FS = ","
    split(name, is, "-")
}

/^# youngs_modulus_Pa: / { E = substr($0, 22) }
/^#/ { next }

/^[a-z]/ {
    split("", column)
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}

"engineering_strain" in column {
    measured = $col("engineering_stress_MPa") * 1e6 / $col("engineering_strain")
    next
}

{
    x = $col("x_m")
    y = $col("y_m")
    if (x * x > 0.02 ^ 2 || y * y > 0.01 ^ 2) next   # the gauge, half the width
    xx += x * x
    yy += y * y
    ux += x * $col("DisplacementX")               # the sums of x and of y vanish
    uy += y * $col("DisplacementY")
}

END {
    exact = is[1] == "strain" ? E / (1 - 1 / 16) : E
    lattice(is[2], is[4] == "partial", is[1] == "strain" ? 48 / 5 * E : 9 * E)   # c pi h horizon^3
    printf "%s,%s,%d,%s,%s,%.3f,%.4f,%.3f,%.3f,%.5f,%.5f\n", is[1], is[2], is[3], is[4], is[5], exact / 1e9,
           measured / 1e9, 100 * (measured / exact - 1), 100 * (lattice_E / exact - 1),
           -(uy / yy) / (ux / xx), lattice_nu
}
