# What the crack must do: awk -v study=crack [-v small=yes] -v blank="tip_mm branching_mm" -f pipelines/must.awk -f check.awk
# track-1mm.csv track-0.5mm.csv.  Writes the table.  small: of the first alone.
# Its speed is that between 2 and 20 mm from its start, before it branches.

# Of one track.
function end_of_track(   i, n, st, sx, stt, stx) {
    if (name == "") return
    for (i = 1; i <= count; i++) {
        if (tip[i] < 2 || tip[i] > 20) continue
        n++
        st += time[i]
        sx += tip[i]
        stt += time[i] ^ 2
        stx += time[i] * tip[i]
    }
    speed = 1e3 * (n * stx - st * sx) / (n * stt - st * st)
    printf "%s,%s,%s,%s,%.0f,%.3f,%.3g\n", name, start, branching, branched, speed, speed / rayleigh, asymmetry
    # The range of running cracks in brittle materials; its end is the limit of a crack in tension.
    must(speed > 0.4 * rayleigh && speed < rayleigh, name ": speed " speed " m/s, of Rayleigh's " speed / rayleigh)
    must(start != "" && tip[count] > 40, name ": the crack does not run through")
    if (name == "0.5mm") must(branching > 20, name ": no branching, or too early")
    # The lattice and the load are mirror images, and rounding is the same on either side as long as the paths are.
    must(asymmetry < 1e-6, name ": asymmetry " asymmetry)
    speeds[++runs] = speed
}

BEGIN {
    rayleigh = 0.9194 * sqrt(65e9 / 2.5 / 2235)     # nu = 1/4
    print "spacing,start_us,branching_mm,branched_us,speed_m_per_s,of_rayleigh,asymmetry"
}

FNR == 1 {
    end_of_track()
    name = FILENAME
    sub(/.*track-/, "", name)
    sub(/.csv$/, "", name)
    count = 0
    asymmetry = 0
    start = branching = branched = ""
    next
}

{
    time[++count] = $1
    tip[count] = $2
    if (start == "" && $2 > 0) start = $1
    if (branched == "" && $3 != "") {
        branched = $1
        branching = $3
    }
    if ($5 > asymmetry) asymmetry = $5
}

END {
    end_of_track()
    # Loaded alike, at half the spacing and horizon.
    if (small == "") must(speeds[1] < 1.2 * speeds[2] && speeds[2] < 1.2 * speeds[1], "speeds differ by more than a fifth: " speeds[1] " and " speeds[2] " m/s")
    finish()
}
