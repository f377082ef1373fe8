# From voxels to a deck of CalculiX: each voxel is one hexahedron.
#
#   awk -v element=C3D20R -v spacing=12.5e-6 [-v uniform=1] [-v increment=0.02] [-v solver="ITERATIVE CHOLESKY"] -v weights=FILE -f mesh.awk voxels.txt > bar.inp
#
# Lengths in mm, stresses in MPa, forces in N.  The nodes of the grips have a prescribed u_x; three components of
# two nodes stop translation along y and z and rotation about x.  uniform=1: phase 1 everywhere, and
# no grips but the end planes, so that the stress is uniaxial.  Writes the gauge nodes' weights in the mean of u_x over
# the planes x = -0.2 mm and 0.2 mm beside the deck.

BEGIN {
    spacing *= 1e3
    quadratic = element ~ /^C3D20/
    if (!increment) increment = 0.02
    half = spacing / 2
    grip = uniform ? 0.4 : 0.35
    extension = 0.07 * 2 * grip
    # Corners, then the middles of the edges, in the order of CalculiX
    corners = split("0,0,0 2,0,0 2,2,0 0,2,0 0,0,2 2,0,2 2,2,2 0,2,2 1,0,0 2,1,0 1,2,0 0,1,0 1,0,2 2,1,2 1,2,2 0,1,2 0,0,1 2,0,1 2,2,1 0,2,1", offset, " ")
    if (!quadratic) corners = 8
    for (c = 1; c <= corners; c++) {
        split(offset[c], o, ",")
        for (a = 1; a <= 3; a++) shift[c, a] = o[a]
    }
}

/^#/ { next }

{
    elements++
    phase[elements] = uniform ? 1 : $4
    # Places in halves of a spacing from the corner of the body
    corner[1] = round(($1 * 1e3 + 0.4) / half) - 1
    corner[2] = round(($2 * 1e3 + 0.1) / half) - 1
    corner[3] = round(($3 * 1e3 + 0.05) / half) - 1
    line = elements
    for (c = 1; c <= corners; c++) {
        i = corner[1] + shift[c, 1]
        j = corner[2] + shift[c, 2]
        k = corner[3] + shift[c, 3]
        if (!((i, j, k) in number)) {
            number[i, j, k] = ++nodes
            x[nodes] = i * half - 0.4
            y[nodes] = j * half - 0.1
            z[nodes] = k * half - 0.05
        }
        n = number[i, j, k]
        line = line "," (c == 11 ? "\n" : "") n
        # The mean over the face of each element that ends at a gauge plane
        if (shift[c, 1] == 2 && near(sqrt(x[n] ^ 2), 0.2)) {
            on_corner = shift[c, 2] != 1 && shift[c, 3] != 1
            weight[n] += (quadratic ? (on_corner ? -1 / 12 : 1 / 3) : 1 / 4)
            faces[(x[n] > 0)] += c == 2
        }
    }
    connectivity[elements] = line
}

END {
    print "*NODE, NSET=ALL"
    for (n = 1; n <= nodes; n++) printf "%d,%.9g,%.9g,%.9g\n", n, x[n], y[n], z[n]
    for (p = 1; p <= 2 - uniform; p++) {
        print "*ELEMENT, TYPE=" element ", ELSET=" (p == 1 ? "CG" : "UFG")
        for (e = 1; e <= elements; e++) if (phase[e] == p) print connectivity[e]
    }
    set("LEFT", -1)
    set("RIGHT", 1)
    print "*NSET, NSET=GAUGE"
    for (n = 1; n <= nodes; n++)
        if (n in weight) {
            print n ","
            print n, (x[n] > 0 ? 1 : -1), weight[n] / faces[(x[n] > 0)] > weights
        }
    material("CG", 182.1, 513.0, 5.320)
    if (!uniform) material("UFG", 1259.8, 564.5, 238.5)
    print "*BOUNDARY"
    for (n = 1; n <= nodes; n++)
        if (near(x[n], -0.4) && near(z[n], 0)) {
            if (near(y[n], 0)) print n ",2,3"
            if (near(y[n], 0.1)) print n ",3,3"
        }
    print "*STEP, NLGEOM, INC=2000"
    print "*STATIC" (solver ? ", SOLVER=" solver : "")
    printf "%g,1,1e-5,%g\n", increment / 4, increment
    print "*BOUNDARY"
    printf "LEFT,1,1,%.9g\nRIGHT,1,1,%.9g\n", -extension / 2, extension / 2
    print "*NODE PRINT, NSET=GAUGE"
    print "U"
    print "*NODE PRINT, NSET=RIGHT, TOTALS=ONLY"
    print "RF"
    print "*NODE PRINT, NSET=LEFT, TOTALS=ONLY"
    print "RF"
    print "*END STEP"
}

function set(name, side,    n) {
    print "*NSET, NSET=" name
    for (n = 1; n <= nodes; n++) if (side * x[n] > grip - 1e-6) print n ","
}

# True stress against logarithmic plastic strain: at most 200 rows, close together where the law bends.
function material(name, yield, saturation, rate,    i, p) {
    print "*MATERIAL, NAME=" name
    print "*ELASTIC\n210000,0.31"
    print "*PLASTIC"
    for (i = 0; i < 180; i++) {
        p = 0.5 * (exp(i / 179 * 7) - 1) / (exp(7) - 1)
        printf "%.9g,%.9g\n", yield + saturation * (1 - exp(-rate * p)), p
    }
    print "*SOLID SECTION, ELSET=" name ", MATERIAL=" name
}

function near(a, b) {
    return a - b < 1e-6 && b - a < 1e-6
}

function round(v) {
    return int(v + 0.5)
}
