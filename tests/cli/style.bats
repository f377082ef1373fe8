# What the sources promise about themselves: equations in docs/theory.md, who includes whom.

bats_require_minimum_version 1.5.0

setup() { cd "$BATS_TEST_DIRNAME/../.."; }

# Labels such as (mix.2); numbers in brackets such as (0.5) have no letters.
labels() { grep -rhoE '\([a-z][a-z0-9_]*\.[0-9]+\)' "$@" | sort -u; }

# same_labels THEORY DIRECTORY...: the directories' sources have the labels of that file, and no others.
same_labels() {
    local theory=$1
    shift
    labels --include='*.[ch]' "$@" >"$BATS_TEST_TMPDIR/code"
    labels "$theory" >"$BATS_TEST_TMPDIR/theory"
    [ -s "$BATS_TEST_TMPDIR/code" ] || return
    diff "$BATS_TEST_TMPDIR/code" "$BATS_TEST_TMPDIR/theory"
}

@test "every equation label of the code is in docs/theory.md, and the reverse" {
    same_labels docs/theory.md lib gen solve post
}

@test "a label that is on one side alone is found, with underscores and digits, too" {
    for label in planted.1 planted_law.12 j2_planted.3; do
        mkdir -p "$BATS_TEST_TMPDIR/src"
        echo "/* by ($label) */" >"$BATS_TEST_TMPDIR/src/planted.c"
        run ! same_labels docs/theory.md lib gen solve post "$BATS_TEST_TMPDIR/src"
        [[ $output == *"< ($label)"* ]]
        { cat docs/theory.md; echo "| ($label) | planted |"; } >"$BATS_TEST_TMPDIR/planted.md"
        run ! same_labels "$BATS_TEST_TMPDIR/planted.md" lib gen solve post
        [[ $output == *"> ($label)"* ]]
    done
}

# wide FILE...: lines of more than 100 columns, comments among them.
wide() { LC_ALL=C.UTF-8 awk 'length($0) > 100 { print FILENAME ":" FNR; found = 1 } END { exit !found }' "$@"; }

@test "no line of C is wider than 100 columns" {
    mapfile -t sources < <(find lib gen solve post tests -name '*.[ch]')
    [ "${#sources[@]}" -gt 400 ]
    run ! wide "${sources[@]}"
    printf '/* %098d */\n' 0 >"$BATS_TEST_TMPDIR/planted.c"
    wide "$BATS_TEST_TMPDIR/planted.c"
}

# includes DIRECTORY: names in its #include "..." lines.
includes() { grep -rhoE '^#include "[^"]+"' --include='*.[ch]' "$1" | sed 's/.*"\(.*\)"/\1/; s:.*/::' | sort -u; }
headers() { find "$@" -name '*.h' -printf '%f\n' | sort -u; }

@test "lib includes none of the tools, and the tools none of each other" {
    for part in lib gen solve post; do
        mapfile -t others < <(printf '%s\n' gen solve post | grep -vx "$part")
        # names that only other tools have
        comm -23 <(headers "${others[@]}") <(headers lib "$part") >"$BATS_TEST_TMPDIR/foreign"
        [ -s "$BATS_TEST_TMPDIR/foreign" ]
        found=$(comm -12 "$BATS_TEST_TMPDIR/foreign" <(includes "$part"))
        [ -z "$found" ] || { echo "$part includes $found"; return 1; }
    done
}

# edges FOLDER: lines "from to" of modules (a header and its source are one) of which one includes the other.
edges() {
    find "$1"/lib "$1"/gen "$1"/solve "$1"/post -name '*.[ch]' | sed 's/\.[ch]$//' | sort -u >"$BATS_TEST_TMPDIR/modules"
    grep -rE '^#include "' --include='*.[ch]' "$1"/lib "$1"/gen "$1"/solve "$1"/post |
        sed 's/^\(.*\)\.[ch]:#include "\(.*\)\.h".*/\1 \2/' |
        awk -v folder="$1/" 'NR == FNR { name = $1; sub(/.*\//, "", name); at[name] = $1; next }
            at[$2] && at[$2] != $1 { print substr($1, length(folder) + 1), substr(at[$2], length(folder) + 1) }' \
            "$BATS_TEST_TMPDIR/modules" - | sort -u
}

# circles FOLDER: says which modules include each other in a circle, and fails where there are any.
circles() { [ -z "$(edges "$1" | tsort 2>&1 >/dev/null | tee /dev/stderr)" ]; }

# Rooms, each of which may include those before it (docs/contributing.md).
rooms='lib run body material damage observe input integrate output solve'
upwards() {
    edges "$1" | awk -v rooms="$rooms" '
        function room(module,   part) { split(module, part, "/"); return part[1] == "solve" && part[3] ? part[2] : part[1] }
        BEGIN { n = split(rooms, name, " "); for (i = 1; i <= n; i++) order[name[i]] = i }
        { from = room($1); to = room($2) }
        from in order && to in order && order[to] > order[from] { print $1 " includes " $2; found = 1 }
        END { exit found }'
}

@test "no module includes itself through others, and no room one that comes later" {
    circles .
    upwards .
    [ "$(edges . | wc -l)" -gt 500 ]
    for room in $rooms; do grep -q "$room" docs/contributing.md; done
    # Planted, both are found.
    mkdir "$BATS_TEST_TMPDIR/tree"
    cp -r lib gen solve post "$BATS_TEST_TMPDIR/tree"
    echo '#include "recorder.h"' >>"$BATS_TEST_TMPDIR/tree/solve/body/lattice.h"
    run ! circles "$BATS_TEST_TMPDIR/tree"
    run ! upwards "$BATS_TEST_TMPDIR/tree"
    [[ $output == *"solve/body/lattice includes solve/output/recorder"* ]]
}

# long_functions FOLDER: those of more than 60 lines, from the line of the name to the brace; fails where there are any.
long_functions() {
    find "$1"/lib "$1"/gen "$1"/solve "$1"/post -name '*.[ch]' -exec awk '
        FNR == 1 { start = 0 }
        /^[A-Za-z_].*\(/ && !/;$/ { start = FNR; name = $0 }
        /^}/ { if (start && FNR - start + 1 > 60) { print FILENAME ": " name " " FNR - start + 1; found = 1 } start = 0 }
        END { exit found }' {} +
}

@test "no function is longer than 60 lines" {
    long_functions .
    mkdir -p "$BATS_TEST_TMPDIR"/tree/{lib,gen,solve,post}
    { printf 'static int sum(int a)\n{\n'; yes '    a++;' 2>/dev/null | head -n 60; printf '    return a;\n}\n'; } >"$BATS_TEST_TMPDIR/tree/lib/long.c"
    run ! long_functions "$BATS_TEST_TMPDIR/tree"
    [[ $output == *"long.c: static int sum(int a) 64"* ]]
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
    only_in 'jansson\.h' post/properties.c post/crate.c
    only_in 'zlib\.h' gen/scalars.c
    only_in 'png\.h' gen/image_png.c
    only_in 'tiffio\.h' gen/image_tiff.c
    only_in 'hdf5\.h' gen/image_dream3d.c
    only_in 'expat\.h' gen/xml_deck.c
    only_in 'gsl/gsl_roots\.h' post/root.c
}

@test "the material laws know nothing of MPI" {
    [ -d solve/material ]
    run ! grep -rn 'MPI_\|mpi\.h' solve/material
}

# In a test `! command` and the first half of `a && b` stop nothing: bash leaves both out of `set -e`.
no_assertion() { grep -nE '^ *(! |(\[.*\]|\[\[.*\]\]) && (\[|run |grep |cmp ))' "$@"; }

@test "no line of the tests is an assertion that cannot fail" {
    run ! no_assertion tests/*/*.bats tests/*.bash tests/*/*.bash
    echo "$output"
    printf '    [ -s a ] && [ -s b ]\n' >"$BATS_TEST_TMPDIR/planted"
    no_assertion "$BATS_TEST_TMPDIR/planted"
    printf '        ! grep -q a b\n' >"$BATS_TEST_TMPDIR/planted"
    no_assertion "$BATS_TEST_TMPDIR/planted"
}

# Every script of the tree: what shellcheck knows by its first line, and what is loaded into tests.
scripts() {
    { git ls-files .ci tests pipelines 2>/dev/null || find .ci tests pipelines -type f; } | while read -r file; do
        case $file in
        *.bats | *.bash) echo "$file" ;;
        *) if head -n 1 "$file" | grep -qE '^#!.*[ /](ba)?sh'; then echo "$file"; fi ;;
        esac
    done
}

@test "shellcheck has nothing to say, assertions that cannot fail (SC2314, SC2315) included" {
    command -v shellcheck >/dev/null || skip "no shellcheck"
    mapfile -t files < <(scripts)
    [ "${#files[@]}" -gt 30 ]
    shellcheck -s bash -f gcc "${files[@]}"
    printf '@test "planted" {\n    ! true\n    true\n}\n' >"$BATS_TEST_TMPDIR/planted.bats"
    run ! shellcheck -f gcc "$BATS_TEST_TMPDIR/planted.bats"
    [[ $output == *SC2314* ]]
}

@test "every mutation fits the code" {
    tests/mutate -l >"$BATS_TEST_TMPDIR/list" || { grep -v '\.[ch]$' "$BATS_TEST_TMPDIR/list"; false; }
    [ "$(wc -l <"$BATS_TEST_TMPDIR/list")" -gt 200 ]
}
