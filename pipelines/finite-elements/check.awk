# Both codes side by side: awk -f check.awk fe.csv hstools.csv.  The limit of hstools is extrapolated from its two finest,
# with errors that fall with the square of the spacing: the order that its three at 2 % of strain show.

function must(holds, what) {
    if (holds) return
    print "finite-elements: " what > "/dev/stderr"
    failed = 1
}

BEGIN { FS = ","; split("0.5 1 2 3 5", percent, " ") }
FNR == 1 { next }
{ for (k = 1; k <= 5; k++) stress[$1, $2, k] = $(k + 2); known[$1, $2] = 1 }
END {
    for (k = 1; k <= 5; k++) {
        limit = stress["hstools", 3, k] - 0.8 * (stress["hstools", 2, k] - stress["hstools", 3, k])
        fine = stress["hstools", 3, k]
        for (name in known) {
            split(name, part, SUBSEP)
            if (part[1] !~ /^C3D(20R|8I)$/ || part[2] < 2) continue
            off = 100 * (fine / stress[part[1], part[2], k] - 1)
            printf "%s refined %d times, %g %%: %.2f MPa, hstools refined 3 times %.2f (%+.2f %%), its limit %.2f (%+.2f %%)\n", part[1], part[2], \
                percent[k], stress[part[1], part[2], k], fine, off, limit, 100 * (limit / stress[part[1], part[2], k] - 1)
            must(off < 2 && off > -2, "off by " off " % at " percent[k] " % of strain against " part[1])
            compared++
        }
    }
    must(compared >= 5, "nothing to compare with")
    if (failed) exit 1
    print "finite-elements: all checks hold"
}
