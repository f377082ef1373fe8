# From the frames of a run (tables of damage and velocity along x, one behind the other), a row each:
#   time in ns, nodes with more than 0.35 of their bonds broken in |x| < 0.5 mm, the same in |x| > 2.25 mm,
#   place in mm of the wave from the left: where the mean velocity of a cross-section first falls to the level.
#   awk -f pipelines/columns.awk -v level=22.5 -f frames.awk

function finish(   layer, x, v, x_before, v_before, place) {
    if (time == "") return
    for (layer = -99.5; layer < 0; layer++) {
        x = layer * 0.025
        v = sum[layer] / n[layer]
        v = v < 0 ? -v : v
        if (place == "" && v < level && v_before >= level && layer > -97) place = x_before + (x - x_before) * (v_before - level) / (v_before - v)
        x_before = x
        v_before = v
    }
    printf "%.1f,%d,%d,%s\n", 1e9 * time, middle, ends, place
}

BEGIN { FS = "," }
/^# time_s: / {
    finish()
    time = substr($0, 11)
    middle = ends = 0
    split("", sum)
    split("", n)
}
/^x/ { header_ends("Damage,VelocityX") }
/^[#x]/ { next }
{
    layer = sprintf("%.1f", $1 / 25e-6) + 0
    sum[layer] += $5
    n[layer]++
    if ($4 <= 0.35) next
    if ($1 * $1 < 0.5e-3 ^ 2) middle++
    if ($1 * $1 > 2.25e-3 ^ 2) ends++
}
END { finish() }
