# columns FILE NAME...: of each record of a history, in this order
columns() {
    local file=$1
    shift
    hspost -q --columns "$file" | awk -F, -v names="$*" '/^#/ { next }
        !n { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
        { for (k = 1; k <= n; k++) printf "%.12g%s", $at[name[k]], k < n ? " " : "\n" }'
}
