#!/usr/bin/env bats
# What README.md says is so: its commands, its files, its pipe.

bats_require_minimum_version 1.5.0

setup() {
    root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    readme=$root/README.md
    cd "$BATS_TEST_TMPDIR" || return 1
}

# Lines of indented code.
commands() { sed -n 's/^    //p' "$readme"; }

@test "the first command installs, builds and runs the first study" {
    [ "$(commands | head -1)" = "./.ci/packages && make -j2 && make first" ]
    [ -x "$root/.ci/packages" ]
    bash -n "$root/.ci/packages"
}

@test "the second command is the tests, and continuous integration calls it" {
    [ "$(commands | sed -n 2p)" = "make check" ]
    grep -q '^make .*check' "$root/.ci/run"
}

@test "every make target of the README exists" {
    { commands; grep -o '`make [^`]*`' "$readme" | tr -d '`'; } | grep -o '^make [a-z][a-z0-9-]*' | sort -u >targets
    [ "$(wc -l <targets)" -ge 5 ]
    while read -r make target; do
        # prove's jobs are of no interest here: what make would do, without doing it
        env -u MAKEFLAGS make -n -C "$root" BUILD="$BATS_TEST_TMPDIR/build" "$target" >steps 2>&1 ||
            { echo "$target"; tail -3 steps; false; }
        [ -s steps ]
    done <targets
}

@test "every file and folder that the README links to exists" {
    grep -o '](\([^)#]*\))' "$readme" | sed 's/](\(.*\))/\1/' | grep -v '^http' | sort -u >links
    [ "$(wc -l <links)" -ge 8 ]
    while read -r link; do
        [ -e "$root/$link" ] || { echo "no $link"; false; }
    done <links
}

@test "every pipeline has a deck that hsgen takes and a README" {
    for folder in "$root"/pipelines/*/; do
        [ -s "$folder/README.md" ] || { echo "$folder"; false; }
        for deck in "$folder"*.yaml; do
            study=()
            if grep -q '^vary:' "$deck"; then study=(--study --check); fi
            hsgen -q "${study[@]}" "$deck" >domain.g 2>messages || { echo "$deck"; cat messages; false; }
        done
    done
}

@test "decks that share a material give it the same numbers" {
    for phase in CG UFG; do
        for deck in "$root"/pipelines/*/*.yaml; do
            sed -n "/^  $phase: /,/hardening/p" "$deck" | grep -v 'model: co' | tr '\n' ' '
            echo
        done | grep . | sort -u >kinds
        [ "$(wc -l <kinds)" -eq 1 ] || { cat kinds; false; }
    done
}

@test "the pipe of the first study makes a curve and a figure" {
    # to a tenth of its strain: the chain is what is looked at
    sed 's/end_strain: 0.04 /end_strain: 0.004 /' "$root/pipelines/first/study.yaml" >study.yaml
    run -1 cmp -s study.yaml "$root/pipelines/first/study.yaml"
    hsgen -q study.yaml | hssolve -q -j 2 | hspost -q --plot curve.svg >curve.csv
    grep -q '<svg' curve.svg
    grep -v '^#' curve.csv >table
    [ "$(wc -l <table)" -gt 20 ]
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        END { exit !($column["engineering_strain"] >= 0.004 && $column["engineering_stress_MPa"] > 200) }' table
}

@test "the deck of the README is ten lines that all three programs take" {
    sed -n '/^```yaml$/,/^```$/p' "$readme" | sed '1d;$d' >study.yaml
    [ "$(wc -l <study.yaml)" -le 10 ]
    hsgen -q study.yaml | hssolve -q | hspost -q --plot curve.svg >curve.csv
    # harder than the coarse phase alone, softer than the fine one
    awk -F, '/^[0-9]/ { last = $6 } END { exit !(last > 380 && last < 740) }' curve.csv
    [ "$(wc -l <"$readme")" -lt 180 ]
}
