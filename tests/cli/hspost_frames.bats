#!/usr/bin/env bats
# hspost --frames: particle fields as lists, tables and pictures.

load ../bodies
setup_file() {
    cd "$BATS_FILE_TMPDIR" || return 1
    cat >study.yaml <<DECK
$(small_plate)
materials:
  CG: {model: correspondence, density: 8900 kg/m3, $elastic, hardening: {law: linear, yield: 100 MPa, modulus: 1 GPa}}
  UFG: {model: correspondence, density: 8900 kg/m3, $elastic, hardening: {law: linear, yield: 500 MPa, modulus: 1 GPa}}
$(pulled '10 m/s')
solver: {type: explicit, horizon: 1, stabilisation: {law: mix, share: 0.1}, end_strain: 0.005}
output:
  history: 20
  fields: {frames: 3, variables: [displacement, von_mises, phase]}
DECK
    hsgen -q study.yaml | hssolve -q -o fields.e > history.e
}

# fills SVG: colour and outline of each area, as cairo 1.16 writes them, and 1.18
fills() {
    sed '/<defs>/,/<\/defs>/d; s/, /,/g' "$1" |
        sed -n 's/.*<path.*fill-rule\(:\|="\)nonzero.*fill\(:\|="\)\(rgb([^)]*)\).* d="\([^"]*\)".*/\3 \4/p'
}

setup() {
    cd "$BATS_TEST_TMPDIR" || return 1
    fields="$BATS_FILE_TMPDIR/fields.e"
}

refused() {
    local said="$1"
    shift
    run --separate-stderr hspost --frames "$fields" "$@"
    [ "$status" -eq 2 ]
    [ -z "$output" ]
    [[ $stderr == *"$said"* ]] || { echo "$stderr"; return 1; }
}
bats_require_minimum_version 1.5.0

rows() { grep -v '^#' "$1" | sed 1d; }

@test "without more, what the file holds" {
    hspost --frames "$fields" > list
    grep -q '^# nodes: 576$' list
    grep -q '^# variables: DisplacementX DisplacementY DisplacementZ VonMises Phase$' list
    [ "$(rows list | wc -l)" -eq 4 ]
    [ "$(rows list | head -1)" = 1,0 ]
    hspost --frames - < "$fields" | grep -v '^# command' | cmp - <(grep -v '^# command' list)
}

@test "values are those that another reader finds" {
    command -v ncdump > /dev/null || skip "no ncdump"
    hspost --frames "$fields" --csv --frame 3 > all.csv
    [ "$(grep -v '^#' all.csv | head -1)" = x_m,y_m,z_m,DisplacementX,DisplacementY,DisplacementZ,VonMises,Phase ]
    # vals_nod_var4 is VonMises; 576 values a frame, all digits
    ncdump -p 9,17 -v vals_nod_var4 "$fields" | sed '1,/vals_nod_var4 =$/d' | tr -d ' ;}\n' | tr ',' '\n' |
        sed -n 1153,1728p > dumped
    rows all.csv | cut -d, -f7 | paste - dumped | awk '$1 != $2 {exit 1} END {exit NR != 576}'
}

@test "a vector's name is its magnitude, a slice one layer of particles" {
    hspost --frames "$fields" --csv --variables DisplacementX,DisplacementY,DisplacementZ,Displacement \
        --slice x=0.2mm -o slice.csv
    # 6 x 4 particles; 0.2 mm lies between 187.5 and 212.5 um, the upper one counts.  Square root and sum
    # are rounded four times: 1e-15
    rows slice.csv | awk -F, '
        $1 < 0.0002124 || $1 > 0.0002126 {exit 1}
        {d = $7 - sqrt($4 ^ 2 + $5 ^ 2 + $6 ^ 2); if (d > 1e-15 * $7 || d < -1e-15 * $7) exit 1}
        END {exit NR != 24}'
}

@test "a time chooses the nearest frame" {
    time=$(hspost --frames "$fields" | grep '^2,' | cut -d, -f2)
    before=$(awk -v t="$time" 'BEGIN {print 0.7 * t " s"}')
    for shown in "$time" "$before" "$(awk -v t="$time" 'BEGIN {print 1.3 * t " s"}')"; do
        hspost --frames "$fields" --csv --time "$shown" | grep -q '^# frame: 2$'
    done
    hspost --frames "$fields" --csv --frame last | grep -q '^# frame: 4$'
    hspost --frames "$fields" --csv | grep -q "^# time_s: $(hspost --frames "$fields" | tail -1 | cut -d, -f2)\$"
}

@test "a particle of the layer is a square of its colour" {
    hspost --frames "$fields" --picture phase.svg --variables Phase
    hspost --frames "$fields" --csv --variables Phase --slice z > phase.csv
    # the second phase's colour, 0.00, 0.45, 0.70, which its name has, too
    squares=$(($(fills phase.svg | grep -c '^rgb(0%,45%,70%)') - 1))
    [ "$squares" -gt 0 ]
    [ "$squares" -eq "$(rows phase.csv | grep -c ',1$')" ]
}

@test "the same fields give the same picture, deformed ones another" {
    for format in png svg pdf; do
        hspost --frames "$fields" --picture first.$format --variables VonMises,Displacement,Phase
        hspost --frames "$fields" --picture second.$format --variables VonMises,Displacement,Phase
        cmp first.$format second.$format
        hspost --frames "$fields" --picture other.$format --variables VonMises,Displacement,Phase --deformed 20
        run ! cmp -s first.$format other.$format
    done
    [ "$(head -c 4 first.png | tail -c 3)" = PNG ]
    [ "$(head -c 4 first.pdf)" = %PDF ]
}

@test "all frames have one picture each, the same size, and one range of colours" {
    hspost --frames "$fields" --picture film.png --variables VonMises --deformed 5 --frame all
    [ "$(echo film-?.png)" = "film-1.png film-2.png film-3.png film-4.png" ]
    # the last one alone, with the bounds and colours of all
    hspost --frames "$fields" --picture last.png --variables VonMises --deformed 5 --range all
    cmp last.png film-4.png
    hspost --frames "$fields" --picture first.svg --variables VonMises --frame 1 --range all
    hspost --frames "$fields" --csv --variables VonMises --slice z | rows - | cut -d, -f4 | sort -g | tail -1 >most
    # which the first frame, without a stress, does not reach: all its cells have the colour of the least
    [ "$(fills first.svg | grep -c '^rgb(19.2%,7.6%,36.2%)')" -ge 144 ]
    refused "is for pictures" --frame all
}

@test "grips and gauge are marked below a layer along the axis" {
    black() { fills "$1" | grep -c '^rgb(0%,0%,0%) M [0-9.]* [0-9.]* L'; }
    hspost --frames "$fields" --picture along.svg --variables Phase
    hspost --frames "$fields" --picture across.svg --variables Phase --slice x
    # a line with two ends for each of the grips and for the gauge, beside the scale bar
    [ "$(black across.svg)" -eq 1 ]
    [ "$(black along.svg)" -eq 10 ]
}

@test "the body cut open shows as many faces as one that is whole" {
    hspost --frames "$fields" --picture body.svg --variables Phase --isometric
    # seen along a diagonal a corner cut out hides nothing and adds nothing: 24 x 6 + 24 x 4 + 6 x 4 faces; two names
    [ "$(fills body.svg | grep -vc 'rgb(0%,0%,0%)\|rgb(100%,100%,100%)')" -eq $((264 + 2)) ]
    refused "at rest" --picture body.svg --variables Phase --isometric --deformed 2
    refused "one variable" --picture body.svg --variables Phase,VonMises --isometric
}

@test "ranges may be given for all variables or for each" {
    hspost --frames "$fields" --picture one.svg --variables VonMises,Phase --range ,0:1
    hspost --frames "$fields" --picture two.svg --variables VonMises,Phase
    cmp one.svg two.svg
    hspost --frames "$fields" --picture three.svg --variables VonMises,VonMises --range '0 MPa:0.2 GPa'
    hspost --frames "$fields" --picture four.svg --variables VonMises,VonMises --range 0:2e8,0:2e8
    cmp three.svg four.svg
    run ! cmp -s one.svg three.svg
}

@test "what is not there is named with what is" {
    refused "no variable 'Stress'; there are DisplacementX, DisplacementY, DisplacementZ, VonMises, Phase;" \
        --csv --variables Stress
    refused "no variable ''" --csv --variables VonMises,
    refused "--frame 5: $fields has 4 frames" --csv --frame 5
    refused "has frames from 0 s to" --csv --time '1 s'
    refused "no particle at z = 0.009 m; the body reaches from" --csv --slice z=9mm
}

@test "what does not go together is refused" {
    refused "expected a name that ends in" --picture a.gif --variables Phase
    refused "needs --variables" --picture a.png
    refused "expected a number from 1" --csv --frame 0
    refused "both choose the frame" --csv --frame 1 --time 0
    refused "expected x, y or z" --csv --slice w=1
    refused "is a length, expected a time" --csv --time 1m
    refused "the first must be below the second" --picture a.png --variables Phase --range 1:0
    refused "expected A:B" --picture a.png --variables Phase --range 1
    refused "'m' is a length, expected a stress" --picture a.png --variables VonMises --range 0m:1m
    refused "2 ranges for 3 variables" --picture a.png --variables Phase,Phase,Phase --range 0:1,0:1
    refused "more ranges than variables" --picture a.png --variables Phase --range 0:1,0:1
    refused "give --picture" --csv --deformed 2
    refused "about curves" --plot a.svg
    refused "for another call" history.csv
    refused "the picture has its own name" --picture a.png --variables Phase -o b.png
    [ ! -e a.png ]
    run hspost --picture a.png --variables Phase history.e
    [ "$status" -eq 2 ]
    [[ $output == *"--frames FILE"* ]]
}

@test "files that hold no frames are refused" {
    fields="$BATS_FILE_TMPDIR/history.e"
    refused "no frames of fields in it" --csv
    head -c 10000 "$BATS_FILE_TMPDIR/fields.e" > cut.e
    fields=cut.e
    refused "truncated or damaged" --csv
}

@test "a disk that is full is told" {
    [ -e /dev/full ] || skip "no /dev/full"
    run hspost --frames "$fields" --csv -o /dev/full
    [ "$status" -eq 1 ]
    run hspost --frames "$fields" --picture /nowhere/a.png --variables Phase
    [ "$status" -ne 0 ]
}
