# What the sources promise about themselves: equations in docs/theory.md, who includes whom.

setup() { cd "$BATS_TEST_DIRNAME/../.."; }

# Labels such as (mix.2); numbers in brackets such as (0.5) have no letters.
labels() { grep -rhoE '\([a-z][a-z0-9]*\.[0-9]+\)' "$@" | sort -u; }

@test "every equation label of the code is in docs/theory.md, and the reverse" {
    labels --include='*.[ch]' lib gen solve post >"$BATS_TEST_TMPDIR/code"
    labels docs/theory.md >"$BATS_TEST_TMPDIR/theory"
    [ -s "$BATS_TEST_TMPDIR/code" ]
    diff "$BATS_TEST_TMPDIR/code" "$BATS_TEST_TMPDIR/theory"
}

# includes DIRECTORY: names in its #include "..." lines.
includes() { grep -rhoE '^#include "[^"]+"' --include='*.[ch]' "$1" | sed 's/.*"\(.*\)"/\1/; s:.*/::' | sort -u; }
headers() { find "$@" -name '*.h' -printf '%f\n' | sort -u; }

@test "lib includes none of the tools, and the tools none of each other" {
    for part in lib gen solve post; do
        others=$(printf '%s\n' gen solve post | grep -vx "$part")
        # names that only other tools have
        comm -23 <(headers $others) <(headers lib "$part") >"$BATS_TEST_TMPDIR/foreign"
        [ -s "$BATS_TEST_TMPDIR/foreign" ]
        found=$(comm -12 "$BATS_TEST_TMPDIR/foreign" <(includes "$part"))
        [ -z "$found" ] || { echo "$part includes $found"; return 1; }
    done
}

# only_in 'HEADER' FILES...: no other source includes it, and one does.
only_in() {
    local header=$1 found
    shift
    found=$(grep -rlE "^ *# *include <$header>" --include='*.[ch]' lib gen solve post)
    [ -n "$found" ]
    for file in $found; do
        for allowed in "$@"; do
            # shellcheck disable=SC2053 # a pattern
            [[ $file == $allowed ]] && continue 2
        done
        echo "<$header> in $file"
        return 1
    done
}

@test "each library is known to few files" {
    only_in 'mpi\.h' 'solve/body/*' 'solve/run/*'
    only_in 'metis\.h' solve/body/partition.c
    only_in 'yaml\.h' 'lib/deck*.c'
    only_in '(exodusII|netcdf)\.h' 'lib/exodus*'
    only_in 'udunits2\.h' lib/units.c
    only_in 'muParser.*\.h' lib/expression.c
    only_in 'cairo.*\.h' lib/canvas.c
}

@test "the material laws know nothing of MPI" {
    ! grep -rn 'MPI_\|mpi\.h' solve/material
}
