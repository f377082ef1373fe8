# Periodic bodies for tests: their particles, decks and what comes out.

load ../columns

# body NAME NX NY NZ EXPRESSION: NAME.txt, particles of 10 um, of block 1 where the expression in i, j, k is true, else 2
body() {
    awk -v nx="$2" -v ny="$3" -v nz="$4" 'BEGIN {
        for (k = 0; k < nz; k++) for (j = 0; j < ny; j++) for (i = 0; i < nx; i++)
            printf "%.9g %.9g %.9g %d 1e-15\n", (i + 0.5) * 1e-5, (j + 0.5) * 1e-5, (k + 0.5) * 1e-5, ('"$5"') ? 1 : 2
    }' >"$1.txt"
}

# cloud NAME FROM JITTER NX NY NZ: NAME.txt, the particles of FROM.txt, each off its place by up to half of JITTER spacings along each
# axis, and what the deck says of them besides: that they repeat themselves after NX, NY, NZ spacings
declare -gA also
cloud() {
    awk -v jitter="$3" 'BEGIN { seed = 12345 } {
        for (a = 1; a <= 3; a++) {
            seed = seed * 16807 % 2147483647
            $a = sprintf("%.12g", $a + (seed / 2147483647 - 0.5) * jitter * 1e-5)
        }
        print }' "$2.txt" >"$1.txt"
    also[$1]="period: [${4}0 um, ${5}0 um, ${6}0 um]"
}

# deck NAME AXES MATERIAL1 MATERIAL2 MACROSCOPIC SOLVER [BODY]
deck() {
    local said=${also[${7:-$1}]:-}
    cat >"$1.yaml" <<END
domain: {periodic: [$2], spacing: 10 um${said:+, $said}}
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

# near_share A B SHARE: off by that share of B at most
near_share() {
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

# cells_of_a_cloud JITTER: the same of particles off the lattice by so much (cloud)
cells_of_a_cloud() {
    cells_of_a_sphere
    cloud cloud one "$1" 8 8 8
    mv cloud.txt one.txt
    awk 'function moved(x, by) { x += by * 1e-5; return sprintf("%.12g", x > 8e-5 ? x - 8e-5 : x) }
        { $1 = moved($1, 3.33); $2 = moved($2, 5.1); $3 = moved($3, 1.1); print }' one.txt >cut.txt
    awk '{ for (k = 0; k < 27; k++)
        printf "%.12g %.12g %.12g %d %s\n", $1 + k % 3 * 8e-5, $2 + int(k / 3) % 3 * 8e-5, $3 + int(k / 9) * 8e-5, $4, $5 }' one.txt >many.txt
    also[one]=${also[cloud]} also[cut]=${also[cloud]} also[many]=${also[cloud]//80/240}
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
        near_share "$other_stress" "$stress" 1e-8 || return
        near_share "$other_side" "$side" "$4" || return
    done
}

steel='youngs_modulus: 200 GPa, poissons_ratio: 0.3'
linear_1="$steel, hardening: {law: linear, yield: 180 MPa, modulus: 4 GPa}"
linear_2="$steel, hardening: {law: linear, yield: 1260 MPa, modulus: 2 GPa}"

# take KIND: the deck's model, materials one and two, and keys of its solver section
take() {
    case $1 in
    mix) model=correspondence keys='stabilisation: {law: mix}' one=$linear_1 two=$linear_2 ;;
    capped) model=correspondence keys='horizon: 1.8, stabilisation: {law: capped}' one=$linear_1 two=$linear_2 ;;
    plastic) model=ordinary_plastic keys='horizon: 2.015' one=$linear_1 two=$linear_2 ;;
    ordinary) model=ordinary keys='horizon: 2.015' one=$steel two='youngs_modulus: 20 GPa, poissons_ratio: 0.2' ;;
    bonds) model=bond_based keys='horizon: 2.015' one='youngs_modulus: 200 GPa' two='youngs_modulus: 20 GPa' ;;
    esac
}

# moduli KIND: that of a uniform body and Young's moduli across and along layers of 5/8 of phase 1 and 3/8 of phase 2 (Backus, J. Geophys. Res. 67 (1962) 4427),
# of a continuum, or of cubic moduli C11, C12 that the sums over the lattice have in uniform strain: 1/2 sum c w xi^4/|xi|^3 V with
# c = 18 K/M (Silling, Askari, Comput. Struct. 83 (2005) 1526), and K - 5/3 mu + 15 mu/m sum w xi^4/|xi|^2 V (Silling et al.,
# J. Elasticity 88 (2007) 151).
moduli() {
    awk -v kind="$1" -v h="${horizon:-2.015}" 'BEGIN {
        E[1] = 200e9; E[2] = 20e9; nu[1] = kind == "bonds" ? 0.25 : 0.3; nu[2] = kind == "bonds" ? 0.25 : 0.2; c[1] = 0.625; c[2] = 0.375
        for (x = -2; x <= 2; x++) for (y = -2; y <= 2; y++) for (z = -2; z <= 2; z++) {
            r = sqrt(x * x + y * y + z * z); if (r == 0 || r > h) continue
            w = kind == "bonds" ? 1 / r : 1 - r / h
            s11 += w * x ^ 4 / r ^ 2; s12 += w * x * x * y * y / r ^ 2; m += w * r * r
        }
        for (i = 1; i <= 2; i++) {
            K = E[i] / 3 / (1 - 2 * nu[i]); mu = E[i] / 2 / (1 + nu[i]); p = K + 4 * mu / 3; l = K - 2 * mu / 3
            if (kind == "bonds") { p = 9 * K / atan2(0, -1) / h ^ 4; l = p * s12; p *= s11 }
            if (kind == "ordinary") { l = K - 5 * mu / 3 + 15 * mu / m * s12; p = K - 5 * mu / 3 + 15 * mu / m * s11 }
            if (i == 1) uniform = (p - l) * (p + 2 * l) / (p + l)
            a += c[i] / p; b += c[i] * l / p; d += c[i] * (p - l * l / p); g += c[i] * (l - l * l / p)
        }
        A = 1 / a; B = b / a; D = d + b * b / a; G = g + b * b / a; det = A * D - B * B
        printf "%.12g %.12g %.12g\n", uniform, A - 2 * B * B / (D + G), D + B * (G - D) * B / det + G * (B * B - A * G) / det }'
}

# modulus NAME BODY COMPONENT: Young's modulus in small strain along this axis
modulus() {
    deck "$1" 'x, y, z' "$one" "$two" "{component: $3, rate: 1 1/s}" \
        "end_time: 1e-6, step: 1e-6, tolerance: 1e-8, most_evaluations: 20000, $keys" "$2"
    solve "$1" "$2"
    last "$1.e" "mean_stress_$3_Pa" "mean_gradient_$3" | awk '{ printf "%.12g", $1 / $2 }'
}
