#!/usr/bin/env bats
# The first hour: examples, tutorial, what make install puts in place, completion, version.

bats_require_minimum_version 1.5.0
load ../curves

setup() {
    root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    cd "$BATS_TEST_TMPDIR" || return 1
    unset MAKEFLAGS MFLAGS MAKELEVEL
}

@test "each example is a file of gen/examples, is listed, and is no deck of anything but itself" {
    hsgen --examples >list
    for file in "$root"/gen/examples/*.yaml; do
        name=$(basename "$file" .yaml)
        hsgen --example "$name" | cmp - "$file"
        [ "$(sed -n "s/^$name *//p" list)" = "$(sed -n '1s/^# //p' "$file")" ]
    done
    [ "$(grep -c . list)" -eq "$(($(find "$root/gen/examples" -name '*.yaml' | wc -l) + 1))" ]
    run -2 --separate-stderr hsgen --example harmonics
    [[ "$stderr" == *"did you mean harmonic?"* ]]
}

@test "each example runs, and shows what it says it shows" {
    for name in plate harmonic random fracture; do
        hsgen --example "$name" | hsgen -q | hssolve -q 2>said | hspost -q -p "$name.prop" >"$name.csv" || { cat said; false; }
        # E of the law, and nothing that is wrong with the test
        awk -F, '$1 == "modulus_deviation" { off = $3 } END { exit !(off != "" && off ^ 2 < 0.15 ^ 2) }' "$name.prop"
        run ! grep -E 'modulus_off|not_balanced|not_quasi_static' "$name.prop"
    done
    # What went in: Rm of 250 + 220 (1 - exp(-12 p)) MPa lies where its slope is the stress, by hand at p = 0.1458: 431.8 MPa of
    # true stress, times exp(-0.1479), the strain with its elastic part
    near "$(value tensile_strength plate.prop)" 373 2
    # harder than the coarse phase, softer than Voigt's mean of 40 %
    awk -F, '$1 == "proof_strength_0.2" { exit !($3 > 190 && $3 < 0.6 * 200 + 0.4 * 1500) }' harmonic.prop
    [ -n "$(value extension_at_fracture fracture.prop)" ]
    grep -q '^plastic_extension_at_maximum_force' fracture.prop
    # the crack has run: bonds are broken, more and more
    hsgen --example crack | hsgen -q | hssolve -q 2>said | hspost -q --columns >crack.csv || { cat said; false; }
    awk -F, '/^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == "broken_bonds") at = i; next } { last = $at; if (!first) first = $at }
        END { exit !(at && last > first + 100) }' crack.csv
    # the study, to a tenth of its strain
    hsgen --example study | sed 's/end_strain: 0.02/end_strain: 0.002/; s/1\.\.3/1..2/' >study.yaml
    hsgen -q --study study.yaml -o runs
    make -s -C runs -j2 >said 2>&1 || { cat said; false; }
    grep -q '8 runs done, 0 not run, 0 stopped, 0 failed' said
    # harmonic against random: one cell, and three samples, whose fractions are equal to the particle
    hsgen --example compare | sed 's/end_strain: 0.04/end_strain: 0.002/' >compare.yaml
    hsgen -q --study compare.yaml -o cells
    make -s -C cells -j2 >said 2>&1 || { cat said; false; }
    [ "$(sed 's/"[^"]*"/quoted/g' cells/gathered/statistics.csv | awk -F, '$4 == "modulus" { print $2, $7 }' | tr '\n' ' ')" = 'harmonic 1 random 3 ' ]
    [ -s runs/gathered/extrapolated.svg ]
}

# Indented lines of the tutorial, but those that install.
commands() { sed -n 's/^    //p' "$root/docs/tutorial.md" | grep -v 'make install'; }

@test "each command of the tutorial does what it says" {
    [ "$(commands | wc -l)" -gt 25 ]
    commands >commands
    bash -e -o pipefail -x commands >said 2>&1 || { tail -20 said; false; }
    grep -q "unknown key 'youngs_modulos'" said
    # the law of the plate comes back from its curve
    law=$(grep hardening coarse.yaml)
    number() { [[ $law =~ $1:\ ([0-9.]+) ]] && echo "${BASH_REMATCH[1]}"; }
    near "$(number yield)" 250 1
    near "$(number saturation)" 220 1
    near "$(number rate)" 12 0.1
    for file in plate.svg mine.svg structure.png fractions/gathered/curves.svg fair/gathered/curves.svg error/gathered/extrapolated.svg; do [ -s "$file" ]; done
    [ "$(sed 1d fractions/gathered/properties.csv | sed 's/"[^"]*"/q/g' | cut -d, -f4 | sort -u | tr '\n' ' ')" = "0.4 0.5 0.6 " ]
    tail -1 said | grep -q 'Rp0.2,MPa,1,0,2,' # of one curve at each of two spacings, none left out
}

@test "files and links of the tutorial and of the page of studies are there" {
    for page in tutorial studies; do
        grep -o '](\([^)#]*\)' "$root/docs/$page.md" | sed 's/](//' | sort -u >links
        [ -s links ]
        while read -r link; do [ -e "$root/docs/$link" ] || { echo "$page: no $link"; false; }; done <links
    done
}

@test "the paper has the figures and the references that it names, and no others" {
    grep -o '](figures/[^)]*)' "$root/docs/paper.md" | sed 's/](\(.*\))/\1/' >figures
    [ "$(wc -l <figures)" -ge 2 ]
    while read -r figure; do [ -s "$root/docs/$figure" ]; done <figures
    grep -o '@[A-Z][A-Za-z]*[0-9]*' "$root/docs/paper.md" | tr -d @ | sort -u >cited
    sed -n 's/^@[a-z]*{\(.*\),$/\1/p' "$root/docs/paper.bib" | sort >listed
    [ "$(wc -l <listed)" -ge 8 ]
    diff cited listed
}

@test "make install puts programs, pages, examples, documents and completion in place, and uninstall takes them away" {
    make -s -C "$root" BUILD="$HS_BUILD" DESTDIR="$PWD/there" PREFIX=/usr install >said 2>&1 || { cat said; false; }
    for file in bin/hsgen bin/hssolve bin/hspost share/man/man1/hsgen.1 share/man/man5/hsdeck.5 share/doc/hstools/README.md \
        share/doc/hstools/docs/CHANGELOG.md share/doc/hstools/docs/CITATION.cff share/doc/hstools/docs/tutorial.md \
        share/doc/hstools/examples/plate.yaml share/bash-completion/completions/hspost share/zsh/site-functions/_hssolve; do
        [ -s "there/usr/$file" ] || { echo "no $file"; false; }
    done
    there/usr/bin/hsgen --check there/usr/share/doc/hstools/examples/harmonic.yaml
    if command -v mandoc >/dev/null; then
        for page in hsgen.1 hssolve.1 hspost.1 hsdeck.5; do grep -q '</html>' "there/usr/share/doc/hstools/html/$page.html"; done
    fi
    make -s -C "$root" BUILD="$HS_BUILD" DESTDIR="$PWD/there" PREFIX=/usr uninstall
    [ -z "$(find there -type f)" ]
}

@test "bash completes each option of --help, and files; zsh takes its script" {
    for program in hsgen hssolve hspost; do
        "$program" --completion bash >"$program.bash"
        # shellcheck disable=SC1090
        source "$program.bash"
        COMP_WORDS=("$program" --) COMP_CWORD=1 COMPREPLY=()
        "_$program"
        printf '%s\n' "${COMPREPLY[@]}" | sort >completed
        "$program" --help | sed -n 's/^  \(-., \|    \)\(--[a-z-]*\).*/\2/p' | sort >help
        diff help completed
        touch afile.yaml
        COMP_WORDS=("$program" -o afi) COMP_CWORD=2 COMPREPLY=()
        "_$program"
        [ "${COMPREPLY[*]}" = afile.yaml ]
        # words of which one is meant
        COMP_WORDS=("$program" --completion z) COMP_CWORD=2 COMPREPLY=()
        "_$program"
        [ "${COMPREPLY[*]}" = zsh ]
        if command -v zsh >/dev/null; then
            "$program" --completion zsh >"_$program"
            zsh -n "_$program"
            # shellcheck disable=SC2016 # zsh's
            [ "$(zsh -f -c 'autoload -U compinit; fpath=($PWD $fpath); compinit -u -D; echo $_comps['"$program"']')" = "_$program" ]
        fi
        run -2 "$program" --completion fish
    done
    # shellcheck disable=SC2034 # of the function
    COMP_WORDS=(hspost --standard '') COMP_CWORD=2 COMPREPLY=()
    _hspost
    [ "${COMPREPLY[*]}" = 'iso astm' ]
    # shellcheck disable=SC2034
    COMP_WORDS=(hsgen --example '') COMPREPLY=()
    _hsgen
    printf '%s\n' "${COMPREPLY[@]}" >completed
    hsgen --examples | sed -n 's/^\([a-z][a-z]*\)  .*/\1/p' | diff - completed
}

@test "the version is the number and the commit, and is in every output" {
    version=$(hsgen --version | sed -n '1s/hsgen //p')
    [[ "$version" =~ ^[0-9]+\.[0-9]+\.[0-9]+(\+[0-9]+\.g[0-9a-f]+)?(\.changed)?$ ]]
    for program in hssolve hspost; do "$program" --version | head -1 | grep -qx "$program $version"; done
    hsgen --example plate | sed 's/end_strain: 0.25/end_strain: 0.002/' | hsgen -q | hssolve -q | hspost -q >curve.csv
    grep -q "^# program: hspost $version\$" curve.csv
    grep -q "^# generator_program: hsgen $version\$" curve.csv
    # from a tree without a repository, the number alone
    mkdir tree
    cp "$root/Makefile" tree
    (cd tree && make -s -p -n help 2>/dev/null) | grep -qx "DESCRIBED := ${version%%+*}"
    for file in CITATION.cff codemeta.json; do grep -q "version\"*: \"*${version%%+*}" "$root/docs/$file"; done
}
