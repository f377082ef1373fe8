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

# values FILE NAME: a column of a history, a line each, by a reader that is not ours
values() {
    local names
    names=$(ncdump -v name_glo_var "$1" | sed -n '/^ name_glo_var =/,$s/^ *"\(.*\)"[,; ]*$/\1/p')
    ncdump -p 9,17 -v vals_glo_var "$1" | sed '1,/^ vals_glo_var =/d; /}/d' | tr -d ' \n;' | tr ',' '\n' |
        awk -v n="$(wc -l <<<"$names")" -v k="$(grep -nx "$2" <<<"$names" | cut -d: -f1)" '(NR - 1) % n == k - 1; END { print "" }' | grep .
}

# holds EXPRESSION: true in awk's arithmetic
holds() { awk "BEGIN { exit !($1) }"; }

# numbers FILE: what a history or fields hold, to the last bit, but for the command that made them and the file's own length
numbers() { ncdump -p 9,17 "$1" | sed 1d | grep -v 'hs_solver_command\|hs_file_bytes'; }
