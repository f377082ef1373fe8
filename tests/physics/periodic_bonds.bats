# Periodic bodies whose particles have bonds: lattice sums, laminates, cells against cells of them, explicit steps, ranks, restart
# and damage in every formulation but corner, which periodic.bats has.

bats_require_minimum_version 1.5.0

load ../cells
setup() { cd "$BATS_TEST_TMPDIR"; }

tension='{component: xx, rate: 1 1/s}'
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

# laminate.awk: Young's moduli across and along layers of 5/8 of phase 1 and 3/8 of phase 2 (Backus, J. Geophys. Res. 67 (1962) 4427),
# of a continuum, or of cubic moduli C11, C12 that the sums over the lattice have in uniform strain: 1/2 sum c w xi^4/|xi|^3 V with
# c = 18 K/M (Silling, Askari, Comput. Struct. 83 (2005) 1526), and K - 5/3 mu + 15 mu/m sum w xi^4/|xi|^2 V (Silling et al.,
# J. Elasticity 88 (2007) 151).
moduli() {
    awk -v kind="$1" -v h=2.015 'BEGIN {
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
    deck "$1" 'x, y, z' "$one" "$two" "{component: $3, rate: 1 1/s}" "end_time: 1e-6, step: 1e-6, tolerance: 1e-8, most_evaluations: 20000, $keys"
    solve "$1" "$2"
    last "$1.e" "mean_stress_$3_Pa" "mean_gradient_$3" | awk '{ printf "%.12g", $1 / $2 }'
}

# The strain of 1e-6 is what is left of geometry.
@test "a uniform body has the modulus of its lattice's sums, that of correspondence the given one, to 2e-6" {
    body cube 6 5 4 1
    for kind in mix capped ordinary bonds; do
        take "$kind"
        [ "$model" = correspondence ] && one="law: elastic, $steel" two=$one
        [ "$model" = bond_based ] && one='youngs_modulus: 200 GPa'
        read -r uniform _ < <(moduli "$kind")
        [ "$model" = correspondence ] && uniform=200e9
        near "$(modulus "$kind" cube xx)" "$uniform" 2e-6
    done
}

# A family that sees both layers errs by the horizon over their thickness: twice the finer less the coarser is the limit, to the square
# of it.
@test "elastic laminates at contrast 10, across and along: errors of first order in the thickness, in the limit Backus' moduli" {
    for n in 8 16 32; do body layers$n $n 4 4 "i >= $n * 3 / 8"; done
    for kind in mix capped ordinary bonds; do
        take "$kind"
        coarse=8 fine=16 most=5e-4
        if [ "$model" = correspondence ]; then
            one="law: elastic, $steel" two='law: elastic, youngs_modulus: 20 GPa, poissons_ratio: 0.2'
            coarse=16 fine=32 most=4e-3
        fi
        read -r _ across along < <(moduli "$kind")
        for way in xx:$across yy:$along; do
            read -r first second < <(echo "$(modulus "$kind" "layers$coarse" "${way%:*}") $(modulus "$kind" "layers$fine" "${way%:*}")")
            echo "$kind $way: $first $second"
            near "$(awk "BEGIN { printf \"%.12g\", 2 * $second - $first }")" "${way#*:}" $most
            near "$second" "${way#*:}" 0.04
        done
    done
}

@test "a cell, three times three times three of it, and one cut elsewhere carry the same stress to 1e-8" {
    cells_of_a_sphere
    for kind in mix capped plastic ordinary bonds; do
        take "$kind"
        cells_are_alike "$one" "$two" "end_steps: 3, step: 0.001, tolerance: 1e-10, most_evaluations: 20000, $keys" 1e-8
    done
}

# The work of the mean stress is the energy that is stored, by other sums; its conjugate pulls at the unknown components.
@test "explicit steps follow the curve of load steps within 0.5 %, and keep the energy to 1e-6" {
    body sphere 8 8 8 '(i - 3.5) ^ 2 + (j - 3.5) ^ 2 + (k - 3.5) ^ 2 < 7'
    for kind in mix capped plastic ordinary bonds; do
        take "$kind"
        deck moving 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}' "end_strain: 0.003, type: explicit, $keys"
        deck resting 'x, y, z' "$one" "$two" "$tension" "end_strain: 0.003, accuracy: 1e-4, $keys"
        solve moving sphere
        solve resting sphere
        columns resting.e mean_gradient_xx mean_stress_xx_Pa >resting
        echo "$kind"
        columns moving.e mean_gradient_xx mean_stress_xx_Pa energy_drift | awk '
            NR == FNR { e[NR] = $1; s[NR] = $2; n = NR; next }
            $1 > 0.0015 { for (k = 1; k < n - 1 && e[k + 1] < $1;) k++
                off = $2 / (s[k] + (s[k + 1] - s[k]) * ($1 - e[k]) / (e[k + 1] - e[k])) - 1; looked++
                if (off > most) most = off; if (-off > most) most = -off
                if ($3 > drift) drift = $3; if (-$3 > drift) drift = -$3 }
            END { printf "off by %g, drift %g\n", most, drift
                exit !(looked > 10 && most < 5e-3 && drift < 1e-6) }' resting -
    done
}

# Leapfrog's error is of second order in the step.
@test "free swinging keeps the energy, to an error that falls by 4 with half the step" {
    body cube 8 6 4 'i < 3'
    for kind in capped bonds; do
        take "$kind"
        [ "$model" = correspondence ] && one="law: elastic, $steel" two='law: elastic, youngs_modulus: 20 GPa, poissons_ratio: 0.2'
        for safety in 0.4 0.2; do
            deck swing 'x, y, z' "$one" "$two" '' "end_time: 2e-7, type: explicit, safety: $safety, $keys"
            cat >>swing.yaml <<END
initial:
  - {where: 1, direction: x, velocity: "5*sin(78539.8*x+1e5*y)"}
  - {where: 1, direction: y, velocity: "5*cos(78539.8*x)"}
output: {history: 40}
END
            solve swing cube
            drift[${safety#0.}]=$(columns swing.e kinetic_energy_J stored_energy_J energy_drift | awk '
                NR == 1 { all = $1 } $2 > stored { stored = $2 } { d = $3 < 0 ? -$3 : $3; if (d > most) most = d }
                END { if (stored < 0.3 * all) exit 1; print most }')
        done
        echo "$kind: ${drift[4]} ${drift[2]}"
        awk -v coarse="${drift[4]}" -v fine="${drift[2]}" 'BEGIN { exit !(coarse < 5e-5 && fine < coarse / 2.5 && fine > coarse / 6) }'
    done
}

# Without the work of the mean gradient in the half step the balance would be off by 3e-4.
@test "bonds that break in explicit steps of a cell: their energy closes the balance to 2e-6" {
    body sphere 8 7 6 '(i - 1) ^ 2 + (j - 4.5) ^ 2 + (k - 5) ^ 2 < 12'
    take bonds
    deck breaking 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}' "end_strain: 0.0015, type: explicit, safety: 0.4, accept: true, $keys"
    printf 'damage:\n  - {pair: [block_1, block_1], law: critical_stretch, value: 0.0004}\n' >>breaking.yaml
    solve breaking sphere
    last breaking.e broken_bonds fracture_energy_J stored_energy_J energy_drift | tee /dev/stderr |
        awk '{ exit !($1 > 100 && $2 > 0.1 * $3 && $4 < 2e-6 && $4 > -2e-6) }'
}

@test "load steps, explicit ones and load steps again, under a mean stress across: the stress of load steps to 1e-3, the energy to 2e-6" {
    body sphere 6 6 6 '(i - 2.5) ^ 2 + (j - 2.5) ^ 2 + (k - 2.5) ^ 2 < 5'
    for kind in mix corner; do
        take mix
        [ $kind = corner ] && model=corner keys='residual: {form: flowing}'
        for type in quasi_static 'hybrid, explicit_strain: 0.002, static_when: {quiet: 0.2 us, kinetic_to_internal: 1e-2}'; do
            deck hybrid 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}, {component: yy, stress: 20 MPa}' \
                "end_strain: 0.004, accuracy: 1e-4, type: $type, $keys"
            hssolve --deck hybrid.yaml -i sphere.txt --history hybrid.e 2>log
            [ "$type" = quasi_static ] && exact=$(last hybrid.e mean_stress_xx_Pa)
        done
        grep -q 'explicit from' log
        grep -q 'load steps from strain' log
        near "$(last hybrid.e mean_stress_xx_Pa)" "$exact" 1e-3 # waves that the way into explicit steps sends out
        last hybrid.e energy_drift | tee /dev/stderr | awk '{ exit !($1 < 2e-6 && $1 > -2e-6) }'
    done
}

@test "the same bits on 1, 2 and 4 ranks and after a restart, with what flows and breaks across the faces" {
    body sphere 8 7 6 '(i - 1) ^ 2 + (j - 4.5) ^ 2 + (k - 5) ^ 2 < 12'
    for kind in mix capped plastic bonds; do
        take "$kind"
        rate=1 end=0.005 type=quasi_static ends=(0.001 0.004)
        [ $kind = bonds ] && rate=1e3 end=0.0015 type=explicit
        deck broken 'x, y, z' "$one" "$two" "{component: xx, rate: $rate 1/s}" "end_strain: $end, type: $type, accept: true, $keys"
        if [ $kind = bonds ]; then
            printf 'damage:\n  - {pair: [block_1, block_1], law: critical_stretch, value: 0.0004}\n'
        else
            printf 'damage:\n  - {phase: block_1, law: ductile, onset: %s, full: %s}\n' "${ends[@]}"
        fi >>broken.yaml
        echo 'output: {checkpoint: {every: 11 steps, keep: 1}}' >>broken.yaml
        rm -f run.cp
        solve broken sphere --checkpoint run.cp
        hspost -q --columns broken.e | grep -v '^#' >one.csv
        echo "$kind: $(last broken.e broken_bonds mean_stress_xx_Pa)"
        [ "$(last broken.e broken_bonds)" -gt 5 ]
        solve broken sphere -j 4
        hspost -q --columns broken.e | grep -v '^#' | cmp - one.csv
        hssolve -q --restart run.cp -j 2 --history again.e
        hspost -q --columns again.e | grep -v '^#' | cmp - one.csv
    done
}
