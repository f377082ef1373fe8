# A row from the history (hspost --columns) and the nodes at the end (hspost --frames --csv) of a quarter:
#   name, particles, length and radius of the foot at the end [mm], largest plastic strain, least push of the wall before the end [kN], kinetic over
#   internal energy and drift of the energy in per cent, evaluations of the force, seconds
# Particles are moved as the mean of their corners: what is asked of a surface is what two layers, a half and one and a half cells below it, say by a
# straight line; of the foot's layers the radius is that of the straight line through the particles beyond 3/4 of it.
#   awk -F, -f pipelines/columns.awk -v name=NAME -v cpu=S -f measure.awk history.csv nodes.csv

/^#/ { next }
header() { next }
tables == 1 {
    plastic = $col("largest_plastic_strain")
    kinetic = 100 * $col("kinetic_to_internal")
    drift = 100 * $col("energy_drift")
    forces = $col("force_evaluations")
    # What the wall gives is what the bar has of momentum more, 9.308 g of it; over 2 us, in which waves cross the foot.
    if (t == "") { t = $col("time_s"); speed = $col("speed") }
    if ($col("time_s") - t < 2e-6) next
    push = 9.308e-6 * ($col("speed") - speed) / ($col("time_s") - t)
    if (least == "" || push < least) least = push
    t = $col("time_s"); speed = $col("speed")
    next
}
{
    n++
    x[n] = $col("x_m"); y[n] = $col("y_m"); z[n] = $col("z_m")
    u[n] = $col("DisplacementX"); v[n] = $col("DisplacementY"); w[n] = $col("DisplacementZ")
    if (n == 1 || x[n] < low) low = x[n]
    if (n == 1 || x[n] > high) high = x[n]
}
# How far the foot of layer k from below has spread.
function spread(at,   i, r0, d, r, m, a, b, c, e, slope) {
    for (i = 1; i <= n; i++) {
        if (size(x[i] - at) > 1e-9) continue
        r0 = sqrt(y[i] ^ 2 + z[i] ^ 2)
        if (r0 < 2.4e-3) continue
        d = r0 - 3.2e-3
        r = sqrt((y[i] + v[i]) ^ 2 + (z[i] + w[i]) ^ 2)
        m++; a += d; b += r; c += d * d; e += d * r
    }
    slope = (m * e - a * b) / (m * c - a * a)
    return (b - slope * a) / m
}
function mean_motion(at,   i, m, sum) {
    for (i = 1; i <= n; i++) if (size(x[i] - at) < 1e-9) { m++; sum += u[i] }
    return sum / m
}
function size(a) { return a < 0 ? -a : a }
END {
    if (broke) exit 1
    next_low = high; next_high = low
    for (i = 1; i <= n; i++) {
        if (x[i] > low + 1e-9 && x[i] < next_low) next_low = x[i]
        if (x[i] < high - 1e-9 && x[i] > next_high) next_high = x[i]
    }
    length_now = 32.4e-3 + 1.5 * mean_motion(high) - 0.5 * mean_motion(next_high)
    foot = 1.5 * spread(low) - 0.5 * spread(next_low)
    printf "%s,%d,%.3f,%.3f,%.3f,%.2f,%.4f,%.3f,%s,%s\n", name, n, 1e3 * length_now, 1e3 * foot, plastic, least, kinetic, drift, forces, cpu
}
