# Periodic bodies for tests: their particles, decks and what comes out.

load ../columns

# body NAME NX NY NZ EXPRESSION: NAME.txt, particles of 10 um, of block 1 where the expression in i, j, k is true, else 2
body() {
    awk -v nx="$2" -v ny="$3" -v nz="$4" 'BEGIN {
        for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++)
            printf "%.9g %.9g %.9g %d 1e-15\n", (i + 0.5) * 1e-5, (j + 0.5) * 1e-5, (k + 0.5) * 1e-5, ('"$5"') ? 1 : 2
    }' >"$1.txt"
}

# deck NAME AXES MATERIAL1 MATERIAL2 MACROSCOPIC SOLVER
deck() {
    cat >"$1.yaml" <<END
domain: {periodic: [$2], spacing: 10 um}
materials:
  block_1: {model: ${model:-corner}, density: 8900, $3}
  block_2: {model: ${model:-corner}, density: 8900, $4}
macroscopic: [$5]
solver: {$6}
END
}

# solve NAME BODY [OPTIONS]: NAME.e
solve() {
    hssolve -q --deck "$1.yaml" -i "$2.txt" --history "$1.e" "${@:3}"
}

# near A B TOLERANCE: relative
near() {
    awk -v a="$1" -v b="$2" -v most="$3" 'BEGIN {
        d = (a - b) / b; if (d < 0) d = -d
        if (!(d <= most)) { printf "%.12g is not %.12g within %g: off by %.3g\n", a, b, most, d; exit 1 } }'
}

last() { columns "$@" | tail -1; }

# cells_of_a_sphere: bodies of a sphere of block 1 in block 2: one cell, one cut elsewhere, and many, three times three times three
cells_of_a_sphere() {
    local sphere='(x - 3.5) ^ 2 + (y - 3.5) ^ 2 + (z - 3.5) ^ 2 < 7'
    body one 8 8 8 "(x = i) * 0 + (y = j) * 0 + (z = k) * 0 + ($sphere)"
    body cut 8 8 8 "(x = (i + 3) % 8) * 0 + (y = (j + 5) % 8) * 0 + (z = (k + 1) % 8) * 0 + ($sphere)"
    body many 24 24 24 "(x = i % 8) * 0 + (y = j % 8) * 0 + (z = k % 8) * 0 + ($sphere)"
}

# cells_are_alike MATERIAL1 MATERIAL2 SOLVER SIDE: in tension all three carry the same stress to 1e-8, and narrow alike to SIDE
cells_are_alike() {
    local cell stress side other_stress other_side
    for cell in one cut many; do
        deck $cell 'x, y, z' "$1" "$2" '{component: xx, rate: 1 1/s}' "$3"
        solve $cell $cell
    done
    read -r stress side < <(last one.e mean_stress_xx_Pa mean_gradient_yy)
    for cell in cut many; do
        read -r other_stress other_side < <(last $cell.e mean_stress_xx_Pa mean_gradient_yy)
        near "$other_stress" "$stress" 1e-8 || return
        near "$other_side" "$side" "$4" || return
    done
}
