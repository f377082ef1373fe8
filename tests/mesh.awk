# A block of nx x ny x nz hexahedra as text for ncgen: sets are its faces low_x, high_x, low_y, high_y and the nodes
# gauge_left and gauge_right, 3/8 and 5/8 of the elements along x.
# form: what becomes of the block between -1 and 1 along x, y, z (or 0 and 1):
#   box        edges lx, ly, lz around the origin
#   distorted  the same, nodes inside moved by up to a fifth of an element's edge, those of the surface within it, of the first two faces not at all
#   cell       every node moved by up to a fifth of an element's edge times `moved` (1), those of opposite faces alike
#   ring       a quarter of a ring between the radii 1 and 2 around z, lz high, x being radial
#   dogbone    lx long, ly wide in the middle half and twice that at the ends, elements shorter in the fillets
# parts = 2: elements beyond x = 0 are a block of their own, with nodes of their own.
function node(i, j, k) { return 1 + i + (nx + 1) * (j + (ny + 1) * k) }
function wave(p) { return sin(3.14159265358979 * p) }
function shift(i, n, l, seed) { return i > 0 && i < n ? l / n / 5 * sin(12.9898 * seed) : 0 }
function width(x,    s) {
    s = (x < 0 ? -x : x) * 2 / lx
    if (s < 0.5) return 1
    if (s > 0.75) return 2
    return 1.5 - 0.5 * cos(3.14159265358979 * (s - 0.5) * 4)
}
function place(i, j, k,    p, q, r) {
    p = i / nx - 0.5; q = j / ny - 0.5; r = k / nz - 0.5
    x = lx * p; y = ly * q; z = lz * r
    if (form == "distorted" && i > 0 && i < nx) {
        x += shift(i, nx, lx, 3 * node(i, j, k))
        y += shift(j, ny, ly, 3 * node(i, j, k) + 1)
        z += shift(k, nz, lz, 3 * node(i, j, k) + 2)
    } else if (form == "cell") {
        if (moved == "") moved = 1
        x += moved * shift(1, nx, lx, 3 * node(i % nx, j % ny, k % nz))
        y += moved * shift(1, ny, ly, 3 * node(i % nx, j % ny, k % nz) + 1)
        z += moved * shift(1, nz, lz, 3 * node(i % nx, j % ny, k % nz) + 2)
    } else if (form == "ring") {
        x = (1.5 + p) * cos(1.5707963267949 * (q + 0.5)); y = (1.5 + p) * sin(1.5707963267949 * (q + 0.5))
    } else if (form == "dogbone") {
        x = lx * (p + 0.3 * wave(4 * p) / (4 * 3.14159265358979))
        y *= width(x)
    }
}
function out(name, list) { printf "%s = %s ;\n", name, list }
function join_to(list, value) { return list == "" ? value : list ", " value }
BEGIN {
    n = (nx + 1) * (ny + 1) * (nz + 1)
    for (k = 0; k <= nz; k++) for (j = 0; j <= ny; j++) for (i = 0; i <= nx; i++) {
        place(i, j, k)
        X = join_to(X, sprintf("%.17g", x)); Y = join_to(Y, sprintf("%.17g", y)); Z = join_to(Z, sprintf("%.17g", z))
        if (i == 0) A = join_to(A, node(i, j, k))
        if (i == nx) B = join_to(B, parts == 2 ? node(i, j, k) + n : node(i, j, k))
        if (8 * i == 3 * nx) L = join_to(L, node(i, j, k))
        if (8 * i == 5 * nx) R = join_to(R, parts == 2 ? node(i, j, k) + n : node(i, j, k))
        if (j == 0) C = join_to(C, node(i, j, k))
        if (j == ny) D = join_to(D, node(i, j, k))
    }
    for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++) {
        more = parts == 2 && 2 * i >= nx ? n : 0
        e[more > 0] = join_to(e[more > 0], more + node(i, j, k) ", " more + node(i + 1, j, k) ", " more + node(i + 1, j + 1, k) ", " \
            more + node(i, j + 1, k) ", " more + node(i, j, k + 1) ", " more + node(i + 1, j, k + 1) ", " \
            more + node(i + 1, j + 1, k + 1) ", " more + node(i, j + 1, k + 1))
        count[more > 0]++
    }
    blocks = parts == 2 ? 2 : 1
    printf "netcdf mesh {\ndimensions: len_string = 33; len_line = 81; four = 4; len_name = 33; time_step = unlimited; num_dim = 3; "
    printf "num_nodes = %d; num_elem = %d; num_el_blk = %d; ", blocks * n, nx * ny * nz, blocks
    for (b = 1; b <= blocks; b++) printf "num_el_in_blk%d = %d; num_nod_per_el%d = 8; ", b, count[b - 1], b
    sets = L == "" ? 4 : 6
    printf "num_node_sets = %d; ", sets
    for (s = 1; s <= sets; s++) printf "num_nod_ns%d = %d; ", s, (s == 3 || s == 4 ? nx + 1 : ny + 1) * (nz + 1)
    print "variables: double time_whole(time_step); int eb_status(num_el_blk); int eb_prop1(num_el_blk);"
    print "eb_prop1:name = \"ID\"; char eb_names(num_el_blk, len_name); int ns_status(num_node_sets); int ns_prop1(num_node_sets);"
    print "ns_prop1:name = \"ID\"; char ns_names(num_node_sets, len_name);"
    print "double coordx(num_nodes); double coordy(num_nodes); double coordz(num_nodes);"
    for (s = 1; s <= sets; s++) printf "int node_ns%d(num_nod_ns%d); ", s, s
    for (b = 1; b <= blocks; b++)
        printf "int connect%d(num_el_in_blk%d, num_nod_per_el%d); connect%d:elem_type = \"HEX8\";\n", b, b, b, b
    print ":api_version = 6.02f; :version = 6.02f; :floating_point_word_size = 8; :file_size = 1; :title = \"mesh\"; :maximum_name_length = 32;"
    print "data:"
    out("eb_status", blocks == 2 ? "1, 1" : "1"); out("eb_prop1", blocks == 2 ? "1, 2" : "1")
    out("eb_names", blocks == 2 ? "\"A\", \"B\"" : "\"A\"")
    out("ns_status", sets == 4 ? "1, 1, 1, 1" : "1, 1, 1, 1, 1, 1")
    out("ns_prop1", sets == 4 ? "1, 2, 3, 4" : "1, 2, 3, 4, 5, 6")
    out("ns_names", "\"low_x\", \"high_x\", \"low_y\", \"high_y\"" (sets == 4 ? "" : ", \"gauge_left\", \"gauge_right\""))
    out("coordx", blocks == 2 ? X ", " X : X); out("coordy", blocks == 2 ? Y ", " Y : Y)
    out("coordz", blocks == 2 ? Z ", " Z : Z)
    out("node_ns1", A); out("node_ns2", B); out("node_ns3", C); out("node_ns4", D)
    if (sets == 6) { out("node_ns5", L); out("node_ns6", R) }
    for (b = 1; b <= blocks; b++) out("connect" b, e[b - 1])
    print "}"
}
