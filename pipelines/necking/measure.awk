# A row from a history (hspost --columns) beside the exact answer of the law:
#   name, largest engineering stress in MPa, gauge strain there, Considere's stress and strain, both errors in per cent, gauge strain,
#   share of that load, section ratio and largest plastic strain at the end, evaluations of the force
# The largest stress is that of the parabola through the highest record and its neighbours.
#   awk -f pipelines/columns.awk -v name=cg -v section=0.04 -v law=voce -v a=182.1 -v b=513.0 -v c=5.320 -f measure.awk history.csv

function stress(p) {
    if (law == "voce") return a + b * (1 - exp(-c * p))
    if (law == "linear") return a + b * p
    return b * ((a / b) ^ (1 / c) + p) ^ c # swift: yield a, strength b, exponent c
}

# There the stress is its own slope by logarithmic strain, of which s/E is elastic; the law's stress is Kirchhoff's, so that
# force over first section is stress over stretch.
function considere(   p, h, s) {
    h = 1e-6
    for (p = 1e-4; p < 3 && 1 / (h / (stress(p + h) - stress(p)) + 1 / E) > stress(p); p += 2e-5);
    s = stress(p)
    exact_strain = exp(p + s / E) - 1
    exact = s * exp(-p - s / E)
}

BEGIN { FS = ","; E = 210e3; considere() }
/^# gauge_length_m/ { split($0, word, ": "); gauge = word[2] }
/^#/ { next }
header() { next }
{
    records++
    x[records] = $col("extension_m") / gauge
    f[records] = 1e-6 * $col("force_right_N") / (section * 1e-6)
    if (f[records] > f[top]) top = records
    ratio = $col("minimum_section_ratio")
    p_most = $col("largest_plastic_strain")
    evaluations = $col("force_evaluations")
}
END {
    u = x[top - 1] - x[top]; v = x[top + 1] - x[top]
    d = f[top - 1] - f[top]; e = f[top + 1] - f[top]
    curvature = (d / u - e / v) / (u - v); slope = d / u - curvature * u
    strain = x[top] - slope / (2 * curvature)
    most = f[top] - slope * slope / (4 * curvature)
    printf "%s,%.2f,%.4f,%.2f,%.4f,%.3f,%.2f,%.4f,%.3f,%.3f,%.2f,%d\n", name, most, strain, exact, exact_strain, \
        100 * (most / exact - 1), 100 * (strain / exact_strain - 1), x[records], f[records] / most, ratio, p_most, evaluations
}
