# What the block and the cell of two phases are, for hssolve and CalculiX; sourced behind common.bash.

# column: of a body of two cubes to an edge, WIDTH wide, the fine phase, 2, is a column along z, a quarter of the section, and
# its mirror images.  sc: an eighth of the cubic cell around a core of a simple lattice, four places to its edge, of which the core
# has three but for their farthest corner: 26 of 64.  Both phases hang together through faces: a phase that touches itself along edges
# has no stiffness there once the voxels are split.  random_1, random_2: 26 of 64 places by lot (minimal standard generator, seeds 1 and
# 2), in which there are such edges; of the fine ones 24 and 17 hang together.  mirror(): a place in the cell or its images.
structures='
function mirror(v, width) { while (v < 0 || v > width) v = v < 0 ? -v : 2 * width - v; return int(v) }
function column(x, y, width) { return 1 + (mirror(x / width, 2) * mirror(y / width, 2)) }
function sc(x, y, z,    i, j, k) {
    i = mirror(x, 4); j = mirror(y, 4); k = mirror(z, 4)
    return 1 + (i == 3 || j == 3 || k == 3 || i + j + k == 6)
}
function place(x, y, z, phases) { return +substr(phases, 1 + mirror(x, 4) + 4 * mirror(y, 4) + 16 * mirror(z, 4), 1) }
function random_1(x, y, z) { return place(x, y, z, "2211212122221111112111122212221211211122112221112111112112121111") }
function random_2(x, y, z) { return place(x, y, z, "2121121122112211222221122112112111112112111121212211122112121111") }'

# hardening LAW PHASE: of the deck; flow: the same in awk, MPa of p.
hardening() {
    case $1-$2 in
    LIN-1) echo '{law: linear, yield: 185 MPa, modulus: 898 MPa}' ;;
    LIN-2) echo '{law: linear, yield: 1502 MPa, modulus: 4356 MPa}' ;;
    POW-1) echo '{law: swift, yield: 185 MPa, strength: 980 MPa, exponent: 0.399}' ;;
    POW-2) echo '{law: voce, yield: 1502 MPa, saturation: 351 MPa, rate: 76.923}' ;;
    esac
}
flow() {
    case $1-$2 in
    LIN-1) echo '185 + 898 * p' ;;
    LIN-2) echo '1502 + 4356 * p' ;;
    POW-1) echo '980 * ((185 / 980) ^ (1 / 0.399) + p) ^ 0.399' ;;
    POW-2) echo '1502 + 351 * (1 - exp(-76.923 * p))' ;;
    esac
}
strains='0.005 0.01 0.02 0.05'
