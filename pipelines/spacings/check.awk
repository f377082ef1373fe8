# What the spacings must show: awk -v study=spacings -f pipelines/must.awk -f check.awk table.csv
# A shell of 1.2, 2.5 and 3.7 spacings: the structure itself differs from one to the next.
FNR > 1 {
    for (i = 1; i <= NF; i++) {
        if (head[i] == "25um_percent") must(size($i) < 5, "25 um is off by " $i " % at " $1 " % of strain")
        if (head[i] == "12.5um_percent") must(size($i) < 1.5, "12.5 um is off by " $i " % at " $1 " % of strain")
    }
    strains++
}
END {
    must(strains == 7, strains + 0 " strains instead of 7")
    finish()
}
