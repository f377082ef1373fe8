# awk -v n=6 -v spacing=1e-3 -v share=0.01 -v seed=1 -f lattice.awk
# n^3 particles on a cubic lattice; each component of the displacement and each volume is random:
# up to share of the spacing, and up to a tenth from spacing^3.  For forces and formula.awk.

# Park and Miller's generator, exact in doubles and so the same in every awk.
function random() {
    seed = 16807 * seed % 2147483647
    return seed / 2147483647
}
function around(width) {
    return width * (2 * random() - 1)
}

BEGIN {
    for (k = 0; k < 10; k++) random()
    for (z = 0; z < n; z++) for (y = 0; y < n; y++) for (x = 0; x < n; x++)
        printf "%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", x * spacing, y * spacing, z * spacing,
            spacing ^ 3 * (1 + around(0.1)), around(share * spacing), around(share * spacing),
            around(share * spacing)
}
