# awk -F, -f table.awk runs.csv: the costs as Markdown, evaluations of the force (CPU seconds) a step.

function number(value) { return sprintf(value < 9.95 ? "%.2g" : "%.0f", value) }

$1 == "material" { next }
{
    row = $1 "," $3 "," $4 "," $5
    if (!(row in seen)) {
        seen[row] = 1
        order[++rows] = row
        label[row] = "| " ($1 == "cg" ? "CG" : "HS40") " | " $2 " | " $3 " | " $4 " | " $5
    }
    cell[row, $6] = sprintf("%.0f (%s)", $7, number($8))
}

END {
    print "| | nodes | plate | horizon | method | elastic, 0.04 % | plastic, 0.2 % | plastic, 0.5 % |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= rows; i++)
        print label[order[i]] " | " cell[order[i], "0.0004"] " | " cell[order[i], "0.002"] " | " cell[order[i], "0.005"] " |"
}
