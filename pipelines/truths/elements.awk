# Particles as hexahedra of CalculiX: each one element around its place, of a sheet of two dimensions held across it.
#
#   awk -v element=C3D8 -v spacing=1e-3 -v by=1 -v cards=FILE [-v plastic=1 -v ends=LIST -v flat=1 -v inside=FILE] -f HOLD -f elements.awk particles.txt
#
# HOLD has the functions hold(n, x, y, z), called for each node, places in particles from the body's centre, which prescribes
# by fix(n, direction, value) what is not free, and push(n, direction, force); cards: materials, as CalculiX reads them, of the
# element sets PHASE1, PHASE2.  mm, MPa, N.  flat: planes; u_z = 0 throughout.  by: each particle is that many elements along
# each axis (of planes in the plane, and their thickness is one of an element).  Writes the nodes' places to
# the file named in `places`, and to `inside` those of the elements, with their phases; then stresses at the integration points are
# printed at the end.  ends: of the steps, shares of all that is prescribed.

BEGIN {
    quadratic = element ~ /^C3D20/
    corners = split_list("0,0,0 2,0,0 2,2,0 0,2,0 0,0,2 2,0,2 2,2,2 0,2,2 1,0,0 2,1,0 1,2,0 0,1,0 1,0,2 2,1,2 1,2,2 0,1,2 0,0,1 2,0,1 2,2,1 0,2,1")
    if (!quadratic) corners = 8
}

function split_list(text,    n, c, o, a, item) {
    n = split(text, item, " ")
    for (c = 1; c <= n; c++) {
        split(item[c], o, ",")
        for (a = 1; a <= 3; a++) shift[c, a] = o[a]
    }
    return n
}

# On a lattice of half elements, from far out so that all are positive.
function place(v) { return int(v / spacing * 2 * by + 1e5 + 0.5) }

/^#/ { next }
{
    for (piece[1] = 0; piece[1] < by; piece[1]++) for (piece[2] = 0; piece[2] < by; piece[2]++) for (piece[3] = 0; piece[3] < (flat ? 1 : by); piece[3]++) {
        line = ++elements
        phase[elements] = $4
        for (c = 1; c <= corners; c++) {
            for (a = 1; a <= 3; a++) p[a] = place($a) - by + 2 * piece[a] + shift[c, a]
            if (!((p[1], p[2], p[3]) in number)) {
                number[p[1], p[2], p[3]] = ++nodes
                for (a = 1; a <= 3; a++) at[nodes, a] = (p[a] - 1e5) / 2 / by
            }
            line = line "," (c == 11 ? "\n" : "") number[p[1], p[2], p[3]]
        }
        if (inside) {
            for (a = 1; a <= 3; a++) p[a] = $a + (piece[a] - (by - 1) / 2) / by * spacing
            printf "%d,%.9g,%.9g,%.9g,%d\n", elements, p[1], p[2], p[3], $4 > inside
        }
        connectivity[elements] = line
    }
}

function abs(v) { return v < 0 ? -v : v }
function fix(n, direction, displacement) {
    held[++n_held] = n "," direction "," direction
    value[n_held] = displacement
}
function push(n, direction, force) { pushed[++n_pushed] = n "," direction "," sprintf("%.9g", force) }

END {
    print "*NODE, NSET=ALL"
    for (n = 1; n <= nodes; n++) {
        printf "%d,%.9g,%.9g,%.9g\n", n, at[n, 1] * spacing * 1e3, at[n, 2] * spacing * 1e3, at[n, 3] * spacing * 1e3
        printf "%d %.9g %.9g %.9g\n", n, at[n, 1], at[n, 2], at[n, 3] > places
    }
    for (k = 1; k <= 2; k++) {
        first = 1
        for (e = 1; e <= elements; e++) {
            if (phase[e] != k) continue
            if (first) print "*ELEMENT, TYPE=" element ", ELSET=PHASE" k
            first = 0
            print connectivity[e]
        }
    }
    while ((getline line < cards) > 0) print line
    for (n = 1; n <= nodes; n++) {
        if (flat) fix(n, 3, 0)
        hold(n, at[n, 1], at[n, 2], at[n, 3])
    }
    steps = split(ends ? ends : 1, end, " ")
    for (m = 1; m <= steps; m++) {
        print "*STEP" (plastic ? ", NLGEOM" : "") ", INC=2000"
        print "*STATIC"
        if (plastic) print "0.25,1,1e-4,0.25"
        print "*BOUNDARY"
        for (k = 1; k <= n_held; k++) print held[k] "," sprintf("%.9g", value[k] * end[m])
        if (n_pushed) print "*CLOAD"
        for (k = 1; k <= n_pushed; k++) print pushed[k]
        print "*NODE PRINT, NSET=ALL, FREQUENCY=1000"
        print "U"
        print "*NODE PRINT, NSET=ALL, FREQUENCY=1000"
        print "RF"
        for (k = 1; k <= 2 && inside && m == steps; k++) print "*EL PRINT, ELSET=PHASE" k "\nS"
        print "*END STEP"
    }
}
