# Tables of a study of hsgen --study: study.csv, whose cells may be quoted, and what its runs left in NNNN/columns.csv.

# Fields of a row; commas within quotes belong to them.
function cut(row, field,   n, i, c, quoted) {
    n = 1
    split("", field)
    for (i = 1; i <= length(row); i++) {
        c = substr(row, i, 1)
        if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) n++
        else field[n] = field[n] c
    }
}

function stop(why) { print why > "/dev/stderr"; exit 1 }

# value[row, name] of the columns named (separated by blanks), rows from 0; returns the last row.
function read_columns(file, names, value,   row, field, head, wanted, n, i, last) {
    n = split(names, wanted, " ")
    last = -1
    while ((getline row < file) > 0) {
        if (row ~ /^#/) continue
        cut(row, field)
        if (!(wanted[1] in head)) {
            for (i in field) head[field[i]] = i
            for (i = 1; i <= n; i++) if (!(wanted[i] in head)) stop(file ": no column " wanted[i])
            continue
        }
        last++
        for (i = 1; i <= n; i++) value[last, wanted[i]] = field[head[wanted[i]]] + 0
    }
    close(file)
    if (last < 8) stop(file ": " last + 1 " records")
    return last
}

# The number of the run, and in is[name] what varied.
function read_run(   field, i) {
    cut($0, field)
    for (i in field) is[names[i]] = field[i]
    return field[1]
}

FNR == 1 { cut($0, names); next }
