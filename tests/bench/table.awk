# A CSV as a table in Markdown: awk -f table.awk file.csv
{
    line = "|"
    while (match($0, /^("[^"]*"|[^,]*)(,|$)/) && RLENGTH > 0) {
        field = substr($0, 1, RLENGTH)
        $0 = substr($0, RLENGTH + 1)
        last = sub(/,$/, "", field) ? 0 : 1
        gsub(/"/, "", field)
        line = line " " field " |"
        columns++
        if (last) break
    }
    print line
    if (NR == 1) { line = "|"; for (i = 1; i <= columns; i++) line = line "---|"; print line }
}
