# What the checks of the studies share: awk -v study=NAME [-v rows=N] -f pipelines/must.awk -f CHECK TABLE...
#
# Of each table, whatever the check asks: it has rows (N where given), each with as many cells as the header, and no cell is empty,
# nan or inf; cells of the columns named in `blank` may be empty (all: any).  A comparison with what is no number would hold as often as not.
# The check calls complete() for its own arrays, and finish() at its end.

function must(holds, what) {
    checks++
    if (holds) return
    print study ": " what > "/dev/stderr"
    failed++
}

function size(a) { return a < 0 ? -a : a }
function off(a, b) { return size(a - b) }

# No entry was asked for that no row has given.
function complete(array, what,   key, name) {
    for (key in array) {
        if (array[key] != "") continue
        name = key
        gsub(SUBSEP, " ", name)
        must(0, "no " what " of " name)
    }
}

# The end of END.
function finish() {
    must(tables == ARGC - 1, tables + 0 " tables instead of " ARGC - 1)
    if (rows != "") must(table_rows == rows, table_rows " rows instead of " rows)
    if (failed) exit 1
    print study ": " checks " checks hold" > "/dev/stderr"
    exit 0
}

function look_at_cells(   i) {
    if (NF != width) must(0, FILENAME ": " NF " cells instead of " width " in row " FNR)
    for (i = 1; i <= NF; i++) {
        if ($i == "" && (blank == "all" || index(" " blank " ", " " head[i] " "))) continue
        if ($i == "" || tolower($i) ~ /^[-+]?(nan|inf)/) must(0, FILENAME ": " head[i] " is '" $i "' in row " FNR)
    }
}

BEGIN { FS = "," }
!/^#/ && FILENAME == table_name {
    rows_of_table++
    table_rows++
    look_at_cells()
}
!/^#/ && FILENAME != table_name {
    if (table_name != "" && !rows_of_table) must(0, table_name ": no rows")
    table_name = FILENAME
    tables++
    rows_of_table = 0
    width = NF
    for (i = 1; i <= NF; i++) head[i] = $i
}
END { if (table_name != "" && !rows_of_table) must(0, table_name ": no rows") }
