# What the block and the cells of two phases are, for hssolve and CalculiX; sourced behind common.bash.

# cubes: of a body of two cubes to an edge, WIDTH wide, phases in turn, mirrored beyond.  fcc: an eighth of the cubic cell of
# cores at the places of a face-centred lattice, four places to its edge; the fine phase, 2, is where two cores are equally far.
# random: four places to an edge, 40 per cent of a sequence without order.  mirror(): a place in the cell or its images.
structures='
function mirror(v, width) { while (v < 0 || v > width) v = v < 0 ? -v : 2 * width - v; return int(v) }
function cubes(x, y, z, width) { return 1 + (mirror(x / width, 2) + mirror(y / width, 2) + mirror(z / width, 2)) % 2 }
function distance(i, j, k, a, b, c) { return (i + 0.5 - a) ^ 2 + (j + 0.5 - b) ^ 2 + (k + 0.5 - c) ^ 2 }
function least(a, b) { return a < b ? a : b }
function fcc(x, y, z,    i, j, k, a, b, c, d) {
    i = mirror(x, 4); j = mirror(y, 4); k = mirror(z, 4)
    a = distance(i, j, k, 0, 0, 0); b = distance(i, j, k, 4, 4, 0)
    c = distance(i, j, k, 4, 0, 4); d = distance(i, j, k, 0, 4, 4)
    return 1 + ((a == b) * (a <= least(c, d)) + (a == c) * (a <= least(b, d)) + (a == d) * (a <= least(b, c)) + (b == c) * (b <= least(a, d)) + (b == d) * (b <= least(a, c)) + (c == d) * (c <= least(a, b)) > 0)
}
function random(x, y, z,    i, j, k) {
    i = mirror(x, 4); j = mirror(y, 4); k = mirror(z, 4)
    return 1 + ((i * 73 + j * 179 + k * 283 + i * j * 37 + j * k * 61 + k * i * 97 + 11) % 101 < 40)
}'

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
