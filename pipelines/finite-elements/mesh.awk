# A CalculiX model of particles as text: each is a hexahedron.  Units mm, MPa, N.
#   awk -v type=C3D20R -v spacing=0.025 -v grip=0.05 -v gauge=0.2 -v end=0.02 -v increments=25 -f mesh.awk domain.txt
# Nodes sit on a lattice of half spacings.  Those of the grips' elements are moved along x by +-end; one node of the left end holds the
# body in y and z, a second one against turning: nothing else does, and their reactions are none.

function node(a, b, c,   key) { # in half spacings
    key = a " " b " " c
    if (!(key in number)) {
        number[key] = ++nodes
        printf "%d,%.9g,%.9g,%.9g\n", nodes, a * h, b * h, c * h > points
        if (a * h <= low + grip + h / 2) left[nodes]
        if (a * h >= -low - grip - h / 2) right[nodes]
        if (same(a * h, -gauge)) gauge_left[nodes]
        if (same(a * h, gauge)) gauge_right[nodes]
        if (same(a * h, low) && b == 0 && c == 0) pinned = nodes
        if (same(a * h, low) && same(b * h, 0.1) && c == 0) turning = nodes
    }
    return number[key]
}
function same(p, q) { return p - q < h / 4 && q - p < h / 4 }
function set(name, members,   i, k) {
    printf "*NSET, NSET=%s", name
    for (i in members) printf "%s%d", k++ % 12 ? "," : ",\n", i
    printf "\n"
}
function law(name, a, b, c,   p) {
    printf "*MATERIAL, NAME=%s\n*ELASTIC\n210000,0.31\n*PLASTIC\n", name
    for (p = 0; p < 1.5 / c; p += 0.02 / c) printf "%.6f,%.8f\n", a + b * (1 - exp(-c * p)), p
    for (; p < 1.2; p *= 1.1) printf "%.6f,%.8f\n", a + b * (1 - exp(-c * p)), p
    printf "*SOLID SECTION, ELSET=%s, MATERIAL=%s\n", name, name
}

BEGIN {
    h = spacing / 2
    low = -0.4
    points = "/dev/stdout"
    split("-1 1 1 -1 -1 1 1 -1 0 1 0 -1 0 1 0 -1 -1 1 1 -1", dx, " ")
    split("-1 -1 1 1 -1 -1 1 1 -1 0 1 0 -1 0 1 0 -1 -1 1 1", dy, " ")
    split("-1 -1 -1 -1 1 1 1 1 -1 -1 -1 -1 1 1 1 1 0 0 0 0", dz, " ")
    count = type == "C3D20R" ? 20 : 8
    print "*NODE, NSET=ALL"
}
/^#/ { next }
{
    a = $1 * 1e3 / h; b = $2 * 1e3 / h; c = $3 * 1e3 / h
    a = int(a + (a < 0 ? -0.5 : 0.5)); b = int(b + (b < 0 ? -0.5 : 0.5)); c = int(c + (c < 0 ? -0.5 : 0.5))
    line = ++elements
    for (k = 1; k <= count; k++) line = line "," (k == 15 ? "\n" : "") node(a + dx[k], b + dy[k], c + dz[k])
    block[$4] = block[$4] line "\n"
}
END {
    for (k in block) printf "*ELEMENT, TYPE=%s, ELSET=%s\n%s", type, k == 1 ? "CG" : "UFG", block[k]
    set("LEFT", left); set("RIGHT", right)
    set("GAUGELEFT", gauge_left); set("GAUGERIGHT", gauge_right)
    law("CG", 182.1, 513.0, 5.320)
    if (2 in block) law("UFG", 1259.8, 564.5, 238.5)
    printf "*STEP, NLGEOM, INC=2000\n*STATIC\n%g,1,1e-6,%g\n", 0.2 / increments, 1 / increments
    printf "*BOUNDARY\nLEFT,1,1,%g\nRIGHT,1,1,%g\n", -end, end
    printf "%d,2,3\n%d,3,3\n", pinned, turning
    print "*NODE PRINT, NSET=RIGHT, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=GAUGELEFT\nU\n*NODE PRINT, NSET=GAUGERIGHT\nU\n*END STEP"
}
