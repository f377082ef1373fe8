# The plate at rest under 10 MPa, from its displacements: awk -f pipelines/columns.awk -v name=ordinary-2mm -f measure.awk displacement.csv
# Writes model, spacing, strain, Poisson's ratio, displacement at x = 43 mm, y = 0 (mm), and the errors of the
# three against plane stress in per cent.

BEGIN {
    FS = ","
    split(name, is, "-")
    strain = 10e6 / 203.636363636364e9
    nu = 3 / 11
}

/^x/ { header_ends("DisplacementX,DisplacementY") }
/^[#x]/ { next }
$1 * $1 < 0.01 ^ 2 && $2 * $2 < 0.0125 ^ 2 {
    xx += $1 * $1
    yy += $2 * $2
    ux += $1 * $4
    uy += $2 * $5
}
# The row y = 0, or the two beside it; linear between nodes.
$2 * $2 < 0.0006 ^ 2 && $1 > 0.0415 && $1 < 0.0445 {
    n++
    at += $1
    end += $4
}

END {
    e = ux / xx
    v = -(uy / yy) / e
    u = end / n * 0.043 / (at / n)
    printf "%s,%s,%.5g,%.4f,%.5g,%.2f,%.2f,%.2f\n", is[1], is[2], e, v, 1e3 * u, 100 * (e / strain - 1), 100 * (v / nu - 1), 100 * (u / (0.043 * strain) - 1)
}
