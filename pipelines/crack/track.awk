# The crack of a plate through its frames: tables of damage (hspost --frames ... --csv) one behind the
# other on standard input, a row for each on standard output.
#   awk -f pipelines/columns.awk -v spacing=0.5 -f track.awk       # lengths in mm
#
# A node is cracked where more than 0.35 of its bonds are broken or were never made; beside a plane crack
# it is about 0.4.  What happens within 5 mm of the loaded edges is left out.  tip: the foremost cracked node.
# branching: the rearmost column of nodes whose cracked nodes are in two groups, three or more rows apart.
# asymmetry: root mean square of the difference of damage at mirrored nodes, over that of damage.

function number(length_m) { return int(length_m * 1e3 / spacing + 10000) - 10000 }

function finish(   x, y, apart, branching, k, sum, difference, other) {
    if (time == "") return
    branching = ""
    for (x in upper) {
        apart = 0
        for (y = lower[x]; y <= upper[x]; y++) {
            apart = ((x, y) in cracked) ? 0 : apart + 1
            if (apart == 2 && (branching == "" || x + 0 < branching)) branching = x + 0
        }
    }
    for (k in damage) {
        split(k, other, SUBSEP)
        sum += damage[k] ^ 2
        difference += (damage[k] - damage[other[1], -1 - other[2]]) ^ 2   # rows -1 and 0 are the middle ones
    }
    printf "%.4f,%s,%s,%d,%.3g\n", 1e6 * time, tip == "" ? "" : (tip + 0.5) * spacing,
           branching == "" ? "" : (branching + 0.5) * spacing, count, (sum > 0 ? sqrt(difference / sum) : 0)
}

BEGIN {
    FS = ","
    print "time_us,tip_mm,branching_mm,cracked_nodes,asymmetry"
}

/^# time_s: / {
    finish()
    time = substr($0, 11)
    tip = ""
    count = 0
    split("", cracked)
    split("", upper)
    split("", lower)
    split("", damage)
}
/^x/ { header_ends("Damage") }
/^[#x]/ { next }
$4 > 0 {
    x = number($1)
    y = number($2)
    damage[x, y] = $4
    if ($2 * $2 > 0.015 ^ 2) next
    if ($4 <= 0.35) next
    cracked[x, y]
    count++
    if (tip == "" || x > tip) tip = x
    if (!(x in upper) || y > upper[x]) upper[x] = y
    if (!(x in lower) || y < lower[x]) lower[x] = y
}
END { finish() }
