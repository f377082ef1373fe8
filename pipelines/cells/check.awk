# What the cells must show: awk -v study=cells [-v small=yes] -f pipelines/must.awk -f check.awk table.csv

FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    at2[$1, $2] = $column["MPa_at_2"]
    runs[$1, $2] = $column["runs"]
    # Of uniform phases with one modulus the mean stress lies between those of the phases alone at the same strain: 297 and 1787 MPa.
    if ($column["MPa_at_1"] != "") must($column["MPa_at_1"] > 180 && $column["MPa_at_1"] < 1830, $1 " " $2 ": " $column["MPa_at_1"] " MPa at 1 %")
    rows_of[$1]++
}
END {
    split(small ? "0.4 0.7" : "0.1 0.3 0.4 0.5 0.7 0.9", fraction, " ")
    split("bcc fcc sc jitter random interface", structure, " ")
    for (s in structure)
        for (f in fraction) must((structure[s], fraction[f]) in runs, structure[s] " has no row at " fraction[f])
    if (small) finish()
    for (f in fraction) must(runs["random", fraction[f]] == 10, "ten seeds of random cells at " fraction[f])
    for (s in structure)
        for (i = 2; i <= 6; i++)
            must(at2[structure[s], fraction[i]] > at2[structure[s], fraction[i - 1]], structure[s] ": no rise from " fraction[i - 1] " to " fraction[i])
    # Walls along the load: the arrangement counts more than that there is one.
    must(at2["sc", "0.4"] > 1.15 * at2["bcc", "0.4"], "sc carries " at2["sc", "0.4"] " MPa, bcc " at2["bcc", "0.4"])
    finish()
}
