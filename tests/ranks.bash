# What tests of the same bits share: runs whose recorded command does not tell the number of ranks.

# solve_on RANKS [OPTION...]: history.e and fields.e in a folder of that name; else of ../domain.g
solve_on() {
    local ranks=$1
    shift
    mkdir "$ranks"
    [ $# -gt 0 ] || set -- -i ../domain.g
    (cd "$ranks" && hssolve -q -j "$ranks" "$@" -o fields.e -H history.e) 2>messages || { cat messages && false; }
    LC_ALL=C sed -i "s/ -j $ranks / -j N /g" "$ranks/fields.e" "$ranks/history.e"
}

# same_as_one RANKS [OPTION...]: solves, and finds the bits of one
same_as_one() {
    solve_on "$@"
    cmp 1/history.e "$1/history.e"
    cmp 1/fields.e "$1/fields.e"
}

# own_words COMMAND...: what it says on either output, without what Open MPI 5 says of the end of ranks, between lines of dashes,
# which nothing turns off
own_words() {
    local code=0
    "$@" >said 2>&1 || code=$?
    sed '/^---*$/,/^---*$/d' said
    return "$code"
}

# none_left PATTERN: waits for the processes of this folder whose command has it; others' may be alike
none_left() {
    while pgrep -f "$1" | while read -r pid; do [ "$(readlink "/proc/$pid/cwd")" != "$PWD" ] || echo "$pid"; done | grep -q .; do
        sleep 0.1
    done
}
