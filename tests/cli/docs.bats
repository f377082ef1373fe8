# The manuals and the programs say the same.

bats_require_minimum_version 1.5.0

setup() {
    docs=$BATS_TEST_DIRNAME/../../docs
    cd "$BATS_TEST_TMPDIR" || return 1
}

@test "deck.md, formats.md and hsdeck(5) have the keys and columns that the programs know: make docs changes nothing" {
    cp "$docs/deck.md" "$docs/formats.md" "$docs/man/hsdeck.5" .
    "$docs/keys" deck.md formats.md hsdeck.5
    diff "$docs/deck.md" deck.md
    diff "$docs/formats.md" formats.md
    diff "$docs/man/hsdeck.5" hsdeck.5
    # and it is these blocks that are compared
    sed '/^| `ufg_fraction`/d' deck.md >old.md
    run ! diff -q old.md deck.md
    "$docs/keys" old.md
    diff old.md deck.md
    sed '/^| `broken_bonds`/d; /: damage`/d' formats.md >old.md
    run ! diff -q old.md formats.md
    "$docs/keys" old.md
    diff old.md formats.md
}

@test "a section without a block and a block without a section are told, and the file is kept" {
    sed 's/keys: cracks/keys: crack/' "$docs/deck.md" >wrong.md
    cp wrong.md before.md
    run ! --separate-stderr "$docs/keys" wrong.md
    [[ "$stderr" == *"no program has the section crack"* ]]
    [[ "$stderr" == *"no block for the section cracks"* ]]
    diff before.md wrong.md
    [ ! -e wrong.md.new ]
}

@test "every key and every section has words" {
    for program in hsgen hssolve hspost; do
        "$program" --keys=mdoc >keys
        grep -q '^\.It Cm ' keys
        run ! grep -n '^$' keys
        # In text each key is followed by its words, deeper than the next key.
        "$program" --keys | awk '/^  [a-zA-Z]/ { if (key) { print "no words for " key; wrong = 1 } key = $1; next }
            key { if (!/^      [^ ]/) { print "no words for " key; wrong = 1 } key = "" } END { exit wrong }'
    done
}

@test "the pages are set without warnings" {
    command -v groff >/dev/null || skip "no groff"
    for page in "$docs"/man/*.[15]; do
        groff -mandoc -ww -z -Tutf8 "$page" >said 2>&1
        cat said
        [ ! -s said ]
    done
}

# Options by their long names, of a program's help and of its page.
of_help() { "$1" --help | sed -n 's/^  \(-., \|    \)\(--[a-z-]*\).*/\2/p' | sort -u; }
of_page() { sed 's/\\-/-/g; s/Fl -\([a-z]\)/--\1/g' "$docs/man/$1.1" | grep -E '^\.(It|Op|B|BR|BI|RB) ' | grep -oE -- '--[a-z][a-z-]*' | sort -u; }

@test "each option of --help is in the manual page, and the reverse" {
    for program in hsgen hssolve hspost; do
        of_help "$program" >help
        of_page "$program" >page
        [ "$(wc -l <help)" -ge 8 ]
        diff help page
    done
}

@test "each flag of a property has a line in the manual" {
    cd "$docs/.."
    # words of flags in the sources: flag = "...", and both sides of ? and :
    grep -hoE '(flag =|[?:]) *"[a-z]+(_[a-z]+)*"' post/report*.c post/strength.c post/law_fit.c post/loops.c |
        grep -oE '"[a-z_]+"' | tr -d '"' | grep -vx loop | sort -u >"$BATS_TEST_TMPDIR/flags"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/flags")" -ge 18 ]
    while read -r flag; do grep -q "\`$flag\`" docs/tensile.md || { echo "$flag"; return 1; }; done <"$BATS_TEST_TMPDIR/flags"
}
