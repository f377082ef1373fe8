# What the bars must show: awk -f check.awk table.csv

function must(holds, what) {
    if (holds) return
    print "necking: " what > "/dev/stderr"
    failed = 1
}
function size(a) { return a < 0 ? -a : a }

BEGIN { FS = "," }
FNR > 1 {
    # The load maximum is the law's own, whatever the discretisation.
    must(size($6) < 0.1, $1 ": largest stress off by " $6 " %")
    must(size($7) < 2, $1 ": strain there off by " $7 " %")
    must($9 < 0.98, $1 ": no neck, " $9 " of the largest load is left")
    if ($1 ~ /^(cg-12um|linear)$/) must($11 > 1, $1 ": local plastic strain of " $11 " only")
    rows++
}
END {
    must(rows == 9, rows " rows")
    if (failed) exit 1
    print "necking: all checks hold"
}
