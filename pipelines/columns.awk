# Columns of a table by their names: awk -f pipelines/columns.awk -f SCRIPT TABLE...  The script fills column[name] from the header.
# What is not there ends the script: a name without a column, a header that is another, a table without rows.

function broken_off(why) {
    print FILENAME ": " why > "/dev/stderr"
    broke = 1
    exit 1
}

# The number of a column of the row at hand: $col("time_s").
function col(name) {
    if (!(name in column)) broken_off("no column " name)
    read_rows++
    return column[name]
}

# The first line of a table that is called for: its names become the columns, and nothing else is done with it.
# tables: how many have begun.
#   /^#/ { next }
#   header() { next }
function header(   i) {
    if (tables && FILENAME == table) return 0
    table = FILENAME
    tables++
    split("", column)
    for (i = 1; i <= NF; i++) column[$i] = i
    return 1
}

# The header of a table of nodes (hspost --frames FILE --csv) ends with these names.
function header_ends(names) {
    if (substr($0, length($0) - length(names)) != "," names) broken_off("columns " $0 ", expected ..." names)
    read_rows++
}

END {
    if (!broke && !read_rows) print FILENAME ": no rows" > "/dev/stderr"
    if (broke || !read_rows) exit 1
}
