# Error against time of the processor: awk -F, -f cost.awk table.csv; docs/bench/truths.md.
#
# A row a truth and a number of particles, per cent and, in brackets, seconds.

BEGIN {
    who[++columns] = "corner_flowing"; who[++columns] = "mix"; who[++columns] = "capped"
    who[++columns] = "C3D8I"; who[++columns] = "C3D20R"
    split("stiffness|torsion of a square bar|series 1:10|bar at 26.6 degrees|bar at 26.6 degrees cut|hole displacements|plate|sc POW at 0.02|random_1 POW at 0.02", wanted, "|")
    for (k in wanted) is_wanted[wanted[k]] = 1
    print "# Error against time where stress varies\n"
    print "Written by `make truths`: errors in per cent and, in brackets, seconds of the processor of the run, one rank, of the bodies of"
    print "[errors](../errors.md#where-stress-varies); n: particles or elements as in the tables there. CalculiX' seconds are those of `pipelines/truths/calculix.csv`.\n"
    line = "| | n |"; rule = "|---|---|"
    for (k = 1; k <= columns; k++) { line = line " " who[k] " |"; rule = rule "---|" }
    print line "\n" rule
}

$2 in is_wanted {
    if (!(($2, $4) in seen)) { seen[$2, $4] = 1; rows[$2] = rows[$2] " " $4 }
    value[$2, $4, $3] = sprintf("%+.2f (%.2g)", $5, $6)
}

END {
    for (k = 1; k in wanted; k++) {
        count = split(rows[wanted[k]], n, " ")
        for (i = 2; i <= count; i++)
            for (j = i; j > 1 && n[j - 1] + 0 > n[j] + 0; j--) { t = n[j]; n[j] = n[j - 1]; n[j - 1] = t }
        for (i = 1; i <= count; i++) {
            line = "| " (i == 1 ? wanted[k] : "") " | " n[i] " |"
            for (c = 1; c <= columns; c++) line = line " " value[wanted[k], n[i], who[c]] " |"
            print line
        }
    }
}
