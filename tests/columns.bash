# columns FILE NAME...: of each record of a history, in this order; nothing where it has no such column
columns() {
    local file=$1
    shift
    hspost -q --columns "$file" | awk -F, -v names="$*" '/^#/ { next }
        !n { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i
            for (k = 1; k <= n; k++) if (!(name[k] in at)) { print "no column " name[k] > "/dev/stderr"; exit 1 }
            next }
        { for (k = 1; k <= n; k++) printf "%.12g%s", $at[name[k]], k < n ? " " : "\n" }'
}

# numbers FILE: what a history or fields hold, to the last bit, but for the command that made them and the file's own length
numbers() { ncdump -p 9,17 "$1" | sed 1d | grep -v 'hs_solver_command\|hs_file_bytes'; }
