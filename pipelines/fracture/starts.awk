# Where a body starts to break, from its frames (hspost --frames --csv --variables Damage,Phase, one behind the other): of the
# first frame in which nodes are gone their number, mean x in mm, share of those of phase 1 (UFG in a mixture); and the
# first phase to degrade.
#   awk -f pipelines/columns.awk -f starts.awk

BEGIN { FS = "," }
/^# time_s: / { if (gone > 0 && !done) { done = 1; print row } gone = x = fine = 0 }
/^x/ { header_ends("Damage,Phase") }
/^[#x]/ { next }
done { next }
$4 > 0 && !degraded { degraded = $5 }
$4 > 0.999 {
    gone++
    x += $1
    fine += $5 == 1
    row = sprintf("%d,%.2f,%.2f,%d", gone, 1e3 * x / gone, fine / gone, degraded)
}
END { if (!done && row != "") print row; else if (!done) print ",,," }
