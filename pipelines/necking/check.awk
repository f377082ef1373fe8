# What the bars must show: awk -v study=necking -v rows=9 -f pipelines/must.awk -f check.awk table.csv

FNR > 1 {
    # The load maximum is the law's own, whatever the discretisation.
    must(size($6) < 0.1, $1 ": largest stress off by " $6 " %")
    must(size($7) < 2, $1 ": strain there off by " $7 " %")
    must($9 < 0.98, $1 ": no neck, " $9 " of the largest load is left")
    if ($1 ~ /^(cg-12um|linear)$/) must($11 > 1, $1 ": local plastic strain of " $11 " only")
}
END {
    finish()
}
