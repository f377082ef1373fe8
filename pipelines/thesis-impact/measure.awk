# One row of the table of the impacts: awk -v name=elastic-450 -f measure.awk curve.csv frames.csv
# The speed of the wave is that between the first frame at which it is beyond x = -2.1 mm and the last before -0.2 mm;
# broken: thirty nodes of the middle layer.

BEGIN {
    FS = ","
    split(name, is, "-")
}

/^# solver_step_s: / { step = substr($0, 18) }
/^# solver_steps: / { steps = substr($0, 17) }
/^#/ || FILENAME ~ /curve/ { next }

{
    if (first != "" && ($4 == "" || $4 > -0.2 || $4 <= last)) passed = 1
    if ($4 != "" && $4 > -2.1 && !passed) {
        if (first == "") {
            first = $4
            first_time = $1
        }
        last = $4
        last_time = $1
    }
    if ($2 >= 30 && middle == "") middle = $1
    if ($3 >= 30 && ends == "") ends = $1
}

END {
    speed = last_time > first_time ? 1e6 * (last - first) / (last_time - first_time) : 0
    printf "%s,%s,%.3g,%d,%.0f,%.0f,%s,%s\n", is[1], is[2], step, steps, speed, last_time + 1e6 * (0 - last) / (speed > 0 ? speed : 1), middle, ends
}
