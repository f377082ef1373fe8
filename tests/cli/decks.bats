# The decks of every study: what a target of the README makes is read by the programs as they are.

bats_require_minimum_version 1.5.0

setup_file() {
    cd "$BATS_TEST_DIRNAME/../.."
    env -u MAKEFLAGS make -s decks BUILT= BUILD="$BATS_FILE_TMPDIR" 2>&1
    env -u MAKEFLAGS make -s decks BUILT= SMALL=yes BUILD="$BATS_FILE_TMPDIR" 2>&1
}

setup() { cd "$BATS_TEST_DIRNAME/../.."; }

# check_deck DECK: --check of hsgen, of hssolve where the domain is quickly made, and so of the section of hspost.
check_deck() {
    local said nodes
    said=$(hsgen --check "$1" 2>&1) || { echo "$said"; return 1; }
    nodes=$(sed -n 's/.* \([0-9]*\) nodes, [0-9]* cores\(, .*\)\{0,1\}$/\1/p' <<<"$said")
    [ "$nodes" -gt 0 ] || return
    # Larger bodies differ from smaller ones in their numbers of nodes alone.
    [ "$nodes" -le 70000 ] || return 0
    hsgen -q "$1" -o "$BATS_TEST_TMPDIR/domain.g" || return
    said=$(hssolve --check -i "$BATS_TEST_TMPDIR/domain.g" 2>&1) || { echo "$1: $said"; return 1; }
}

# check_decks FOLDER LEAST: all that lie below but studies, whose decks are there, and that they are as many.
check_decks() {
    local deck failed=0
    find "$1" -name '*.yaml' -exec grep -L '^vary:' {} + | sort >"$BATS_TEST_TMPDIR/decks"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/decks")" -ge "$2" ]
    while read -r deck; do check_deck "$deck" || failed=1; done <"$BATS_TEST_TMPDIR/decks"
    [ "$failed" -eq 0 ]
}

@test "every target of a study has decks" {
    make -pn decks 2>/dev/null >"$BATS_TEST_TMPDIR/rules" || true
    sed -n 's/^STUDIES := //p' "$BATS_TEST_TMPDIR/rules" | tr ' ' '\n' | grep . >"$BATS_TEST_TMPDIR/studies"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/studies")" -ge 22 ]
    # The README's targets of studies are those of `make studies`, but for two that only add curves to hs40's.
    sed -n '/^## Studies/,/^## /p' README.md | grep -o '`[^`]*`' | tr -d '`' | sed -n 's/^make \(.* \)\{0,1\}\([a-z0-9-]*\)$/\2/p; s/^hs40-.*/&/p' |
        sort -u >"$BATS_TEST_TMPDIR/named"
    while read -r target; do
        case $target in hs40-* | faults | fuzz | fuzz-runs | bench | stress | check | decks | studies) continue ;; esac
        grep -qx "$target" "$BATS_TEST_TMPDIR/studies" || { echo "make $target is not among STUDIES"; false; }
    done <"$BATS_TEST_TMPDIR/named"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/named")" -ge 20 ]
    while read -r folder; do
        ls "$BATS_FILE_TMPDIR"/results/"$folder"*/ >/dev/null
    done < <(find pipelines -mindepth 1 -maxdepth 1 -type d -printf '%f\n')
}

@test "every deck of a study is one that the programs take" {
    check_decks "$BATS_FILE_TMPDIR/results" 300
}

@test "so is every deck that small forms alone have" {
    find "$BATS_FILE_TMPDIR/studies" -name '*.yaml' -printf '%P\n' >"$BATS_TEST_TMPDIR/all"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/all")" -ge 100 ]
    while read -r deck; do
        if cmp -s "$BATS_FILE_TMPDIR"/{studies,results}/"$deck"; then rm "$BATS_FILE_TMPDIR/studies/$deck"; fi
    done <"$BATS_TEST_TMPDIR/all"
    check_decks "$BATS_FILE_TMPDIR/studies" 3
}

@test "studies that compare arrangements run in the corner form as well" {
    for deck in ni-hs40 study/hs40-25um study/r40-seed2-25um fracture/r40 loops/hs40 spacings/25um; do
        env -u MAKEFLAGS make -s BUILT= FORMULATION=corner BUILD="$BATS_TEST_TMPDIR" "$BATS_TEST_TMPDIR/results-corner/$deck/deck.yaml"
        grep -q 'model: corner$' "$BATS_TEST_TMPDIR/results-corner/$deck/deck.yaml"
        check_deck "$BATS_TEST_TMPDIR/results-corner/$deck/deck.yaml"
    done
}

@test "a deck with a wrong key, of hsgen, hssolve or hspost, is found" {
    for wrong in 's/^  seed:/  sead:/' 's/^  horizon:/  horizont:/' 's/^post:/&\n  modulus_range: [2, 1]/'; do
        sed "$wrong" pipelines/ni-hs40/study.yaml >"$BATS_TEST_TMPDIR/wrong.yaml"
        run -1 cmp -s "$BATS_TEST_TMPDIR/wrong.yaml" pipelines/ni-hs40/study.yaml
        run ! check_deck "$BATS_TEST_TMPDIR/wrong.yaml"
        [[ $output == *wrong.yaml:* ]]
    done
}

@test "the runs of a deck lie under the names of what varies, and keep what they have where another is added" {
    cp pipelines/first/study.yaml "$BATS_TEST_TMPDIR"
    vary='\nvary:\n  spacing: [25 um, 50 um]\n  speed: {name: [slow, fast], boundary.1.velocity: [-1 m/s, -2 m/s], boundary.2.velocity: [1 m/s, 2 m/s]}\n'
    pipelines/expand "$BATS_TEST_TMPDIR/study.yaml" "$BATS_TEST_TMPDIR/runs" "$vary"
    grep -q 'direction: x, velocity: -1 m/s' "$BATS_TEST_TMPDIR/runs/50um-slow/deck.yaml"
    grep -q 'spacing: 50 um' "$BATS_TEST_TMPDIR/runs/50um-slow/deck.yaml"
    touch "$BATS_TEST_TMPDIR/runs/50um-slow/history.e"
    pipelines/expand "$BATS_TEST_TMPDIR/study.yaml" "$BATS_TEST_TMPDIR/runs" "${vary/25 um/100 um, 25 um}"
    [ -e "$BATS_TEST_TMPDIR/runs/50um-slow/history.e" ]
    [ "$(find "$BATS_TEST_TMPDIR/runs" -type l | wc -l)" -eq 6 ]
    run -2 pipelines/expand "$BATS_TEST_TMPDIR/study.yaml" "$BATS_TEST_TMPDIR/runs" '\nvary:\n  no_such_key: [1]\n'
    run -2 env -u MAKEFLAGS make -s BUILT= BUILD="$BATS_TEST_TMPDIR" "$BATS_TEST_TMPDIR/results/crack/2mm/deck.yaml"
    make -s BUILT= BUILD="$BATS_TEST_TMPDIR" "$BATS_TEST_TMPDIR/results/crack/1mm/deck.yaml"
}

@test "a check fails on tables that are empty, cut, or hold what is no number" {
    cat >"$BATS_TEST_TMPDIR/check.awk" <<'SCRIPT'
FNR > 1 { value[$1] = $2 }
END {
    must(value["one"] < 2, "two or more")
    complete(value, "value")
    finish()
}
SCRIPT
    holds() {
        printf '%b' "$1" >"$BATS_TEST_TMPDIR/table.csv"
        awk -v study=test "${@:2}" -f pipelines/must.awk -f "$BATS_TEST_TMPDIR/check.awk" "$BATS_TEST_TMPDIR/table.csv"
    }
    run -0 holds 'name,number\none,1\n'
    [[ $output =~ ^test:\ [0-9]+\ checks\ hold$ ]]
    run -1 holds 'name,number\none,3\n'
    run -1 holds ''
    run -1 holds 'name,number\n'
    run -1 holds 'name,number\ntwo,1\n'
    run -1 holds 'name,number\none\n'
    run -1 holds 'name,number\none,\n'
    run -1 holds 'name,number\none,nan\n'
    run -1 holds 'name,number\none,-inf\n'
    run -1 holds 'name,number\none,1\n' -v rows=2
}

@test "a script that reads columns by name stops where one is missing, or all rows" {
    cat >"$BATS_TEST_TMPDIR/last.awk" <<'SCRIPT'
BEGIN { FS = "," }
header() { next }
{ last = $col("number") }
END { print last }
SCRIPT
    read_last() { printf '%b' "$1" | awk -f pipelines/columns.awk -f "$BATS_TEST_TMPDIR/last.awk"; }
    run -0 read_last 'name,number\none,1\n'
    [ "$output" = 1 ]
    run -1 read_last 'name,nummer\none,1\n'
    run -1 read_last 'name,number\n'
    run -1 read_last ''
}
