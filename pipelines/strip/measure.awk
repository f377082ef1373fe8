# A row of the table: awk -v name=MODEL,LAW,HORIZON,INFLUENCE,ANGLE -v whole=G/level -f columns.awk -f measure.awk slow.csv running.csv...
# whole: G that the strip without a crack holds at level 1, over the deck's.  running: of growing levels, from the file names
# NAME-LEVEL.csv; the first in which half of the ligament breaks counts.

BEGIN {
    FS = ","
    split(name, is, ",")
    reach = int(is[3])
    area = 12 * reach * 1e-6                # m2, ahead of the tip
    angle = is[5] * atan2(0, -1) / 180
    for (x = -reach; x <= reach; x++)
        for (y = -reach; y <= reach; y++) {
            across = cos(angle) * y - sin(angle) * x
            if (x * x + y * y <= is[3] ^ 2 && across > 0) bonds += across * 1e6   # through a m2 of the crack
        }
}

function end_of_file() {
    if (!rows) return
    if (!is_slow && speed == "" && share > 0.5) {
        running = level * whole
        of_bonds = energy / (share * area) / 100
        speed = (late - half_early) > 0 ? 0.25 * area * 1e3 / (late - half_early) : 0
    }
    rows = 0
}

FNR == 1 {
    end_of_file()
    is_slow = FILENAME ~ /slow/
    level = FILENAME
    sub(/.*-/, "", level)
    sub(/.csv$/, "", level)
    split("", column)
    half_early = late = ""
}
/^#/ { next }
/^[a-z]/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    rows++
    time = $col("time_s")
    share = $col("broken_bonds") / (bonds * area)
    energy = $col("fracture_energy_J")
    if (is_slow && share > 0 && first == "") first = whole * (0.4 + 0.02 * time)
    if (is_slow && share > 0.5 && slow == "") slow = whole * (0.4 + 0.02 * time)
    if (is_slow && share > 0) { released = energy / area / 100; broken = share }
    if (share < 0.25) half_early = time
    if (share < 0.5) late = time
}
END {
    end_of_file()
    printf "%s,%.3f,%s,%s,%s,%s,%s,%s,%s\n", name, whole, n(first), n(slow), n(released), n(broken), n(running), n(of_bonds), speed == "" ? "" : sprintf("%.0f", speed)
}
function n(x) { return x == "" ? "" : sprintf("%.3f", x) }
