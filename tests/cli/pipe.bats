# The three programs together, and the examples of the manual.

bats_require_minimum_version 1.5.0

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    # The deck of hsdeck(5) is the study of these tests.
    sed -n '/^\.Sh EXAMPLES/,/^\.Ed/p' "$BATS_TEST_DIRNAME/../../docs/man/hsdeck.5" | grep -v '^\.' >study.yaml
}

setup() {
    cd "$BATS_TEST_TMPDIR"
    cp "$BATS_FILE_TMPDIR/study.yaml" .
}

# Rows of a curve without what names commands and inputs.
rows() { grep -v '^#' "$1"; }

@test "hsgen | hssolve | hspost makes a curve of the deck in the manual" {
    hsgen study.yaml 2>hsgen.log | hssolve 2>hssolve.log | hspost >curve.csv 2>hspost.log
    grep -q '^# title: Random bimodal nickel, 40 % UFG$' curve.csv
    [ "$(rows curve.csv | wc -l)" -gt 30 ] # 50 records asked, fewer steps than that at the start
    # At 0.5 % strain CG flows at 182 + 513 (1 - exp(-5.3 * 0.0043)) = 194 MPa and UFG is elastic, 1050 MPa:
    # the mixture lies between CG alone and iso-strain, 0.6 * 194 + 0.4 * 1050 = 536 MPa.
    rows curve.csv | awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        { e = $column["engineering_strain"]; s = $column["engineering_stress_MPa"] }
        END { print e, s; exit !(e >= 0.005 && s > 194 && s < 536) }'
}

@test "files and pipes, one rank and two, give the same curve" {
    hsgen -q study.yaml | hssolve -q | hspost -q >pipe.csv
    hsgen -q study.yaml -o domain.g
    hssolve -q -i domain.g -H history.e -o fields.e
    hspost -q history.e -o files.csv
    hssolve -q -j 2 <domain.g | hspost -q >ranks.csv
    diff <(rows pipe.csv) <(rows files.csv)
    diff <(rows pipe.csv) <(rows ranks.csv)
}

@test "what fails upstream is told downstream, and no program ends with 0" {
    sed -i 's/topology: random/topology: rnadom/' study.yaml
    for ranks in 1 2; do
        set +e
        hsgen -q study.yaml 2>hsgen.err | hssolve -q -j "$ranks" 2>hssolve.err | hspost -q >curve.csv 2>hspost.err
        status=("${PIPESTATUS[@]}")
        set -e
        [ "${status[*]}" = "2 2 2" ]
        grep -q '^hsgen: study.yaml:6:13: .*did you mean random' hsgen.err
        grep -q '^hssolve: standard input is empty (did the program before it fail?)$' hssolve.err
        grep -q '^hspost: .*empty' hspost.err
        [ ! -s curve.csv ]
        [ "$(cat ./*.err | wc -l)" -eq 3 ]
    done
}

@test "a fraction out of reach and a run that fails end the chain the same way" {
    sed 's/40 %/140 %/' study.yaml >high.yaml
    run -2 hsgen -q high.yaml -o domain.g
    [[ "$output" == *"high.yaml:9:17: 1.4 is out of range, expected 1e-06 to 0.999999"* ]]
    [ ! -e domain.g ]
    sed 's/  horizon: 1/&\n  safety: 3\n  least_steps: 1\n  strain_step: 1/' study.yaml >long.yaml
    set +e
    hsgen -q long.yaml | hssolve -q 2>hssolve.err | hspost -q >curve.csv
    status=("${PIPESTATUS[@]}")
    set -e
    [ "${status[*]}" = "0 1 2" ]
    [ ! -s curve.csv ]
    [ -s hssolve-history.failed ]
    grep -q 'kept in hssolve-history.failed' hssolve.err
}

@test "the deck travels: every file of the chain holds it" {
    hsgen -q study.yaml -o domain.g
    hssolve -q -i domain.g -H history.e -o fields.e
    for file in domain.g history.e fields.e; do
        # ncdump writes a text with its line ends as \n, in quotes
        ncdump -h "$file" | sed -n '/:hs_deck = /,/;$/p' | sed 's/^[^"]*"//; s/"[^"]*$//; s/\\n$//' >deck
        diff study.yaml <(sed '${/^$/d}' deck)
    done
    [[ "$(ncdump -h history.e)" == *'hs_command = "hsgen -q -o domain.g study.yaml"'* ]] ||
        [[ "$(ncdump -h history.e)" == *'hs_command = "hsgen -q study.yaml -o domain.g"'* ]]
    [[ "$(ncdump -h history.e)" == *'hs_solver_command = "hssolve -q -i domain.g -H history.e -o fields.e"'* ]]
}

@test "the examples of hssolve(1) run" {
    sed 's/0.5 %/0.3 %/' study.yaml >other.yaml
    sed -n '/^\.Sh EXAMPLES/,/^\.Sh SEE/p' "$BATS_TEST_DIRNAME/../../docs/man/hssolve.1" |
        sed -n 's/^\.Dl //; /^hs/p' | grep -v '\$from' >examples # of a batch script
    [ "$(wc -l <examples)" -eq 6 ]
    bash -o pipefail -e examples
    for file in curve.csv plate.g fields.e history.e other.csv text.e; do [ -s "$file" ]; done
}

@test "a hspost that fails keeps the history it has read through the pipe, under a name it tells" {
    hsgen -q study.yaml | hssolve -q -H history.e
    mkdir empty
    printf '#!/bin/sh\nexit 3\n' >empty/gnuplot
    chmod +x empty/gnuplot
    program=$(command -v hspost)
    for expected in hspost-history.e hspost-history-2.e; do
        run -1 bash -c "PATH=$PWD/empty '$program' -q --plot f.png -o c.csv <&0" < <(cat history.e)
        [[ $output == *"the history that was read is kept: $expected"* ]]
        cmp history.e "$expected"
    done
    # what the user can mend, and a damaged history, too
    run -2 hspost -q --modulus-rows 1:9999 < <(cat history.e)
    [[ $output == *"kept: hspost-history-3.e"* ]]
    cmp history.e hspost-history-3.e
    # stopped by a signal, here from the program that draws
    mkdir stops
    printf '#!/bin/sh\nkill -TERM $PPID\n' >stops/gnuplot
    chmod +x stops/gnuplot
    run bash -c "PATH=$PWD/stops:$PATH '$program' -q --plot f.png -o c.csv <&0" < <(cat history.e)
    [ "$status" -eq 143 ]
    [[ $output == *"kept: hspost-history-4.e"* ]]
    cmp history.e hspost-history-4.e
    rm hspost-history-4.e
    # a file that was read is there, and success leaves none
    run -2 hspost -q --modulus-rows 1:9999 <history.e
    [[ $output != *kept* ]]
    hspost -q < <(cat history.e) >/dev/null
    [ ! -e hspost-history-4.e ]
    # where the working directory cannot be written
    mkdir away locked
    if [ "$(id -u)" -ne 0 ]; then
        chmod a-w locked
        run -2 bash -c "cd locked && TMPDIR=$PWD/away '$program' -q --modulus-rows 1:9999 <&0" < <(cat history.e)
        cmp history.e away/hspost-history.e
    fi
}
