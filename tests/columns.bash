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
