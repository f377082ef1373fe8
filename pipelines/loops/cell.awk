# From the particles of a periodic cell (hspost --frames --csv) to a deck of CalculiX of its mirror cell, the eighth in
# which x, y and z are positive:
#   awk -F, -v spacing=SPACING_UM -v cells=EDGE_IN_SPACINGS -v turns="0.01 0.007 ... 0.04" -f cell.awk particles.csv > cell.inp
#
# Lengths in mm, stresses in MPa, forces in N; each particle is one C3D8I.  The three faces through the middle keep to
# their planes, those beside them stay plane: that across x goes to the strains `turns`, one after the other, those
# across y and z where they carry no force together.  That is the periodic cell, whose planes of symmetry these are.

BEGIN {
    spacing *= 1e-3
    split("0,0,0 1,0,0 1,1,0 0,1,0 0,0,1 1,0,1 1,1,1 0,1,1", offset, " ")
    stride = cells + 1
}

/^#/ { next }
!header {
    for (f = 1; f <= NF; f++) column[$f] = f
    header = 1
    next
}
{
    for (a = 1; a <= 3; a++) at[a] = int($column[substr("xyz", a, 1) "_m"] * 1e3 / spacing + 1000) - 1000
    if (at[1] < 0 || at[2] < 0 || at[3] < 0) next
    line = ++elements
    for (c = 1; c <= 8; c++) {
        split(offset[c], o, ",")
        line = line "," node(at[1] + o[1], at[2] + o[2], at[3] + o[3])
    }
    phase = $column["Phase"] > 0.5 ? "UFG" : "CG"
    connectivity[phase] = connectivity[phase] line "\n"
}

function node(i, j, k) { return 1 + i + stride * (j + stride * k) }

# Nodes of the face across axis a (1 to 3) at index i, one by one in list[]
function face(a, i,    p, q, n) {
    n = 0
    for (p = 0; p < stride; p++)
        for (q = 0; q < stride; q++) list[++n] = a == 1 ? node(i, p, q) : a == 2 ? node(p, i, q) : node(p, q, i)
    return n
}

function set(name, a, i,    n, m) {
    print "*NSET, NSET=" name
    n = face(a, i)
    for (m = 1; m <= n; m++) print list[m] ","
}

# All nodes of a face move along its normal as its first one does.
function stay_plane(a,    n, m) {
    n = face(a, cells)
    for (m = 2; m <= n; m++) printf "*EQUATION\n2\n%d,%d,1,%d,%d,-1\n", list[m], a, list[1], a
}

# True stress against logarithmic plastic strain, close together where the law bends
function material(name, yield, saturation, rate,    i, p) {
    print "*MATERIAL, NAME=" name "\n*ELASTIC\n210000,0.31\n*PLASTIC"
    for (i = 0; i < 180; i++) {
        p = 0.5 * (exp(i / 179 * 7) - 1) / (exp(7) - 1)
        printf "%.9g,%.9g\n", yield + saturation * (1 - exp(-rate * p)), p
    }
    print "*SOLID SECTION, ELSET=" name ", MATERIAL=" name
}

END {
    if (elements != cells ^ 3) {
        print "cell.awk: " elements + 0 " particles in the eighth, expected " cells ^ 3 > "/dev/stderr"
        exit 1
    }
    print "*NODE, NSET=ALL"
    for (k = 0; k < stride; k++)
        for (j = 0; j < stride; j++)
            for (i = 0; i < stride; i++) printf "%d,%.9g,%.9g,%.9g\n", node(i, j, k), i * spacing, j * spacing, k * spacing
    for (name in connectivity) printf "*ELEMENT, TYPE=C3D8I, ELSET=%s\n%s", name, connectivity[name]
    set("MIDDLE1", 1, 0)
    set("MIDDLE2", 2, 0)
    set("MIDDLE3", 3, 0)
    set("RIGHT", 1, cells)
    printf "*NSET, NSET=CORNER\n%d,\n", node(cells, 0, 0)
    stay_plane(2)
    stay_plane(3)
    material("CG", 182.1, 513.0, 5.320)
    material("UFG", 1259.8, 564.5, 238.5)
    print "*BOUNDARY\nMIDDLE1,1\nMIDDLE2,2\nMIDDLE3,3"
    n = split(turns, turn, " ")
    print "*AMPLITUDE, NAME=PROGRAMME, TIME=TOTAL TIME\n0,0"
    for (t = 1; t <= n; t++) printf "%d,%.9g\n", t, turn[t]
    printf "*STEP, NLGEOM, INC=20000\n*STATIC\n0.01,%d,1e-6,0.05\n", n
    printf "*BOUNDARY, AMPLITUDE=PROGRAMME\nRIGHT,1,1,%.9g\n", cells * spacing
    printf "*NODE PRINT, NSET=RIGHT, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=CORNER\nU\n*END STEP\n"
}
