# How uneven the pressure is from cell to cell: awk -F, -v spacing=1e-3 -v half=4 -f noise.awk nodes.csv
#
# Of particles within `half` spacings of x = 0, in lines x,y,z,XX,YY,ZZ,XY,YZ,ZX,phase [m, Pa]: root of the mean square of the pressure less its mean over the neighbours of the same
# phase through faces [MPa], of phase 1 and 2; then the same of pressures that are averaged, from particle to corner and back within
# the phase.

!/^-?[0-9]/ || $1 ^ 2 > (half * spacing) ^ 2 { next }
{
    n++
    for (a = 1; a <= 3; a++) at[n, a] = int($a / spacing + 1000.25)
    place[at[n, 1], at[n, 2], at[n, 3]] = n
    p[n] = -($4 + $5 + $6) / 3e6
    phase[n] = $10
    if (first == "" || $10 < first) first = $10
}

# Of the same phase at a shift, or 0.
function at_shift(i, x, y, z,    k) {
    if (!((at[i, 1] + x, at[i, 2] + y, at[i, 3] + z) in place)) return 0
    k = place[at[i, 1] + x, at[i, 2] + y, at[i, 3] + z]
    return phase[k] == phase[i] ? k : 0
}

function average(i,    x, y, z, a, b, c, k, sum, count, all) {
    for (x = -1; x <= 1; x += 2) for (y = -1; y <= 1; y += 2) for (z = -1; z <= 1; z += 2) {
        sum = count = 0
        for (a = 0; a <= 1; a++) for (b = 0; b <= 1; b++) for (c = 0; c <= 1; c++)
            if ((k = at_shift(i, a * x, b * y, c * z))) { sum += p[k]; count++ }
        all += sum / count / 8
    }
    return all
}

function print_noise(v,    i, a, k, sum, count, square, counted) {
    for (i = 1; i <= n; i++) {
        sum = count = 0
        for (a = 0; a < 6; a++) {
            k = at_shift(i, a == 0 ? 1 : a == 1 ? -1 : 0, a == 2 ? 1 : a == 3 ? -1 : 0, a == 4 ? 1 : a == 5 ? -1 : 0)
            if (k) { sum += v[k]; count++ }
        }
        if (!count) continue
        square[phase[i] != first] += (v[i] - sum / count) ^ 2
        counted[phase[i] != first]++
    }
    printf "%.1f %.1f ", sqrt(square[0] / counted[0]), sqrt(square[1] / counted[1])
}

END {
    print_noise(p)
    for (i = 1; i <= n; i++) averaged[i] = average(i)
    print_noise(averaged)
    print ""
}
