# A row from a history (hspost --columns) beside the finest mesh of calculix.csv, or from a mesh beside the finest:
#   name, particles, largest force [kN], half elongation there [mm], errors of the force in per cent at half elongations of 1, 2, 3, 4, 5, 6,
#   6.5 and 7 mm, radius of the neck less that of the elements in radii at 5, 6, 6.5 and 7 mm, largest plastic strain at the end, evaluations
#   of the force, seconds
# The largest force is that of the parabola through the highest record and its neighbours; in between records are straight.
#   awk -F, -f pipelines/columns.awk -v name=NAME -v particles=N -v cpu=S -f measure.awk calculix.csv history.csv
#   awk -F, -f pipelines/columns.awk -v mesh=10x40 -f measure.awk calculix.csv
# The neck's radius in particles is the root of the smallest section's ratio, a mean over the section.

BEGIN { n_at = split("1 2 3 4 5 6 6.5 7", at, " "); n_radii = split("5 6 6.5 7", radii, " ") }
/^#/ { next }
header() { next }
# Meshes one behind the other, the finest last.
tables == 1 {
    if ($col("mesh") != last) { last = $col("mesh"); meshes++; count[meshes] = 0; mesh_name[meshes] = last }
    add(meshes, $col("half_elongation_mm"), $col("force_kN"), $col("neck_radius"))
    end_strain[meshes] = $col("largest_plastic_strain")
    seconds[meshes] = $col("cpu_s")
    next
}
# A quarter of the section of half the bar.
{
    add("run", 1e3 * $col("grip_extension_m"), 4e-3 * $col("force_right_N"), sqrt($col("minimum_section_ratio")))
    end_strain["run"] = $col("largest_plastic_strain")
    evaluations = $col("force_evaluations")
}
function add(of, u, f, r,   k) {
    k = ++count[of]
    x[of, k] = u; force[of, k] = f; radius[of, k] = r
}
function value(array, of, place,   k) {
    for (k = 2; k <= count[of]; k++)
        if (x[of, k] >= place - 1e-9) return array[of, k - 1] + (array[of, k] - array[of, k - 1]) * (place - x[of, k - 1]) / (x[of, k] - x[of, k - 1])
    broken_off(of " ends before " place " mm")
}
function maximum(of,   k, top, u, v, d, e, curvature, slope) {
    top = 2
    for (k = 2; k < count[of]; k++) if (force[of, k] > force[of, top]) top = k
    u = x[of, top - 1] - x[of, top]; v = x[of, top + 1] - x[of, top]
    d = force[of, top - 1] - force[of, top]; e = force[of, top + 1] - force[of, top]
    curvature = (d / u - e / v) / (u - v); slope = d / u - curvature * u
    most = force[of, top] - slope * slope / (4 * curvature)
    place_of_most = x[of, top] - slope / (2 * curvature)
}
END {
    if (broke) exit 1
    of = "run"
    if (mesh) {
        for (of = 1; of <= meshes && mesh_name[of] != mesh; of++);
        if (of > meshes) broken_off("no mesh " mesh)
        name = "CAX8R " mesh; particles = ""; cpu = seconds[of]
    }
    maximum(of)
    printf "%s,%s,%.3f,%.3f", name, particles, most, place_of_most
    for (j = 1; j <= n_at; j++) printf ",%.2f", 100 * (value(force, of, at[j]) / value(force, meshes, at[j]) - 1)
    for (j = 1; j <= n_radii; j++) printf ",%.4f", value(radius, of, radii[j]) - value(radius, meshes, radii[j])
    printf ",%.3f,%s,%s\n", end_strain[of], evaluations, cpu
}
