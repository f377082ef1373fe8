# What becomes of results where they cannot go to where they were sent.

bats_require_minimum_version 1.5.0

load ../columns
load ../bodies
setup() {
    cd "$BATS_TEST_TMPDIR"
    cat >s.yaml <<END
title: Outputs
$(even 16 6 4 2 8)
materials:
  M: {density: 8900 kg/m3, model: correspondence_elastic, $elastic}
$(pulled '1 m/s')
solver: {type: explicit, end_strain: 0.001}
output: {history: 20, fields: {frames: 2, variables: [displacement]}}
END
    hsgen -q s.yaml -o s.g
    hssolve -q -i s.g -H s.e
}

@test "a history that nobody reads to its end is kept under a name it tells" {
    # The reader goes when the run has begun, and long before it ends.
    sed 's/end_strain: 0.001/end_time: 40 us/' s.yaml >long.yaml
    hsgen -q long.yaml -o long.g
    hssolve -q -i long.g -H long.e
    numbers long.e >expected
    for ranks in 1 2; do
        run bash -c "{ hssolve -q -j $ranks -i long.g; echo \$? >status; } 2>said | sleep 1"
        cat status said
        [ "$(cat status)" -eq 141 ]
        grep -q 'nobody has read standard output to its end: it is kept in hssolve-history.failed' said
        numbers hssolve-history.failed | cmp - expected
        rm hssolve-history.failed
    done
}

@test "a full disk behind standard output leaves the history beside it" {
    numbers s.e >expected
    for ranks in 1 2; do
        rm -f hssolve-history.failed
        run -1 bash -c "hssolve -q -j $ranks -i s.g 2>&1 >/dev/full"
        [[ $output == *"it is kept in hssolve-history.failed"*"cannot write standard output: No space left"* ]]
        numbers hssolve-history.failed | cmp - expected
    done
}

@test "a run does not begin where nobody will read it" {
    for ranks in 1 2; do
        run bash -c "(sleep 1; exec hssolve -j $ranks -i s.g 2>said) | true; echo \"\${PIPESTATUS[0]}\""
        [ "$output" -eq 1 ]
        grep -q 'nobody reads standard output: the program behind the pipe has ended' said
        run ! grep -q 'steps in' said
    done
}

@test "names of outputs, folders and gnuplot are looked at before anything is read" {
    mkdir -p empty
    program=$(command -v hspost)
    mkfifo pipe
    exec 5<>pipe
    for wrong in '-o' '-p' '-j' '--plot' '--loops' '--tidy' '--mean' '--statistics'; do
        # Nothing comes through the pipe, and none of it is waited for.
        run -2 hspost -q "$wrong" none/c.svg <pipe
        [[ $output == *"cannot write none/c.svg: No such file or directory"* ]]
    done
    run -1 bash -c "PATH=$PWD/empty '$program' -q --plot c.svg <pipe"
    [[ $output == *"no gnuplot found"* ]]
}

@test "the curve is written before the figure, whose failure takes nothing away" {
    mkdir -p bin
    printf '#!/bin/sh\nkill -9 $$\n' >bin/gnuplot
    chmod +x bin/gnuplot
    PATH=$PWD/bin:$PATH run -1 --separate-stderr hspost -q --plot c.svg s.e
    [[ $stderr == *"c.svg: gnuplot was ended by signal 9"* ]]
    [[ $output == *"time_s,"* ]]
    [ ! -e c.svg ]
    printf '#!/bin/sh\nexit 0\n' >bin/gnuplot
    PATH=$PWD/bin:$PATH run -1 hspost -q --plot c.svg -o c.csv s.e
    [[ $output == *"gnuplot failed (status 0, 0 bytes)"* ]]
    [ -s c.csv ]
    [ ! -e c.svg ]
}

@test "figures are whole or not there, whatever their name" {
    name=$'new\nline.svg'
    hspost -q -o c.csv --plot "$name" s.e
    tail -c 8 "$name" | grep -q '</svg>'
    [ "$(find . -name '*line.svg*' -printf x)" = x ]
    hspost -q -o c.csv --plot c.png s.e
    [ "$(tail -c 8 c.png | head -c 4)" = IEND ]
    hspost -q -o c.csv --plot c.pdf s.e
    tail -n 1 c.pdf | grep -q '%%EOF'
    # 12 kB are room for the curve and too few for it.
    rm -f c.svg c.csv
    run -1 bash -c "ulimit -f 12; hspost -q -o c.csv --plot c.svg s.e"
    echo "$output"
    [[ $output == *"c.svg: File too large"* ]]
    [ ! -e c.svg ]
    [ -z "$(find . -name '*.partial-*')" ]
}

@test "no output takes the place of an input, nor of another output" {
    cp s.g x.g
    cp s.yaml x.yaml
    cp s.e x.e
    cp s.e x.svg
    mkdir folder
    refused() { # WORDS COMMAND...
        local words=$1
        shift
        run -2 "$@"
        echo "$output"
        [[ $output == *"$words"* ]]
    }
    input='is an input, which would be overwritten'
    refused "x.yaml $input" hsgen -q x.yaml -o x.yaml
    refused "$input" hsgen -q x.yaml -o folder/../x.yaml
    refused "$input" hsgen -q x.yaml -o z.g -s x.yaml
    for ranks in 1 2; do
        refused "$input" hssolve -q -j "$ranks" -i x.g -H x.g
        refused "$input" hssolve -q -j "$ranks" -i x.g -H y.e -o x.g
        refused "$input" hssolve -q -j "$ranks" -i x.g -d x.yaml -H x.yaml
    done
    refused "x.e $input" hspost -q x.e -o x.e
    ln -s x.e link.e
    refused "$input" hspost -q x.e -o link.e
    refused "$input" hspost -q x.svg -o c.csv --plot x.svg
    for pair in 's.g x.g' 's.yaml x.yaml' 's.e x.e' 's.e x.svg'; do cmp "${pair% *}" "${pair#* }"; done
    refused 'two outputs are called z' hsgen -q s.yaml -o z -s z
    refused 'two outputs are called ./z.g' hsgen -q s.yaml -o z.g -s ./z.g
    refused 'two outputs are called w.csv' hspost -q s.e -o w.csv -p w.csv
    refused 'two outputs are called ./w.csv' hspost -q s.e -o w.csv -p ./w.csv
    touch there.csv
    ln -s there.csv link.csv
    refused 'two outputs are called there.csv' hspost -q s.e -o link.csv -p there.csv
    [ ! -e w.csv ]
    [ -z "$(find . -name '*.partial-*')" ]
}

@test "of two runs onto one name the second says so" {
    sleep 100 &
    sleeper=$!
    : >out.e.partial-"$sleeper"
    for ranks in 1 2; do
        run -0 hssolve -q -j "$ranks" -i s.g -H out.e
        [[ $output == *"process $sleeper is writing out.e, too: what ends last stays"* ]]
    done
    kill "$sleeper"
    wait "$sleeper" || true
    run -0 hssolve -q -i s.g -H out.e
    [ -z "$output" ]
}

@test "names of phases that the files cannot have are refused where they stand" {
    for name in 'Ni/CG' 'M ' "$(printf 'x%.0s' {1..46})"; do
        sed "s|phase: M\$|phase: \"$name\"|; s|grips: .*|grips: {length: 2 spacings, phase: structure}|; s|  M: |  \"$name\": |" s.yaml >n.yaml
        run -2 hsgen -q n.yaml -o n.g
        echo "$output"
        [[ $output == *"n.yaml:7:10: the phase's name '$name'"*"names in the files cannot"* || $output == *"begins or ends with a blank"* ]]
        sed "s|  M: |  \"$name\": |" s.yaml >d.yaml
        { echo "# blocks: 1 $name"; ncdump -v coordx,coordy,coordz s.g >/dev/null; echo '0 0 0 1 1e-14'; echo '25e-6 0 0 1 1e-14'; } >n.txt
        run -2 hssolve -q -i n.txt -d d.yaml -H n.e
    done
}

@test "a deck with a byte order mark is the deck without" {
    { printf '\xef\xbb\xbf' && cat s.yaml; } >marked.yaml
    hsgen -q marked.yaml -o marked.g
    diff <(numbers s.g | sed '1,/^data:/d; /info_records/,/;/d') <(numbers marked.g | sed '1,/^data:/d; /info_records/,/;/d')
    sed 's/title: .*/title: [1]/' marked.yaml >wrong.yaml
    run -2 hsgen -q wrong.yaml
    [[ $output == *"wrong.yaml:1:8:"* ]]
}

@test "the same input gives the same file to the last byte, whatever memory held before" {
    for byte in 85 170; do
        mkdir "$byte"
        cp s.yaml "$byte"
        (
            cd "$byte"
            export MALLOC_PERTURB_=$byte
            hsgen -q s.yaml -o s.g
            hssolve -q -i s.g -H s.e -o f.e
            hspost -q s.e -o c.csv -p p.csv -j p.json
            hssolve -q -j 2 -i s.g -H s2.e -o f2.e
        )
    done
    [ "$(find 85 -type f | wc -l)" -eq 9 ]
    diff -r 85 170
}

@test "a language with decimal commas changes no byte" {
    localedef -i de_DE -f UTF-8 "$PWD/de_DE.UTF-8"
    export LOCPATH=$PWD
    for language in C de_DE.UTF-8; do
        mkdir "of_$language"
        cp s.yaml "of_$language"
        (
            cd "of_$language"
            export LC_ALL=$language
            locale decimal_point >>../points
            hsgen -q s.yaml -o s.g -s s.csv -p p.svg --export s.inp --peridigm p
            hssolve -q -i s.g -H s.e -o f.e
            hspost -q s.e -o c.csv -p p.csv -j p.json --plot c.svg --report r.html
            hspost -q c.csv --plot again.svg >again.csv
            hspost -q --frames f.e --csv -o f.csv
        )
    done
    [ "$(tr -d '\n' <points)" = '.,' ]
    [ "$(find of_C -type f | wc -l)" -ge 15 ]
    diff -r of_C of_de_DE.UTF-8
}

@test "too little memory is told, whatever there is of it" {
    # The sanitizers' own maps take terabytes of addresses.
    if grep -q __asan_init "$(command -v hssolve)"; then skip "of a build with sanitizers no limit can be set"; fi
    for kilobytes in {75000..77500..250} 79000 90000 100000; do
        for command in 'hsgen -q s.yaml -o l.g' 'hssolve -q -i s.g -H l.e' 'hspost -q s.e -o l.csv'; do
            rm -f l.*
            status=0
            output=$(bash -c "ulimit -v $kilobytes; $command; exit" 2>&1) || status=$?
            # 127: what loads programs has not got to ours; nor have libraries that begin before it, of which one is ended by a signal.
            [ "$status" -le 2 ] || [ "$status" -eq 127 ] || [[ "$output" == *"Error in GnuTLS initialization"* ]]
            [ "$status" -eq 0 ] || [ -n "$output" ]
            [ "$status" -ne 0 ] || [ -s "$(echo l.*)" ]
        done
    done
}

@test "Poisson's ratio at both ends of its range" {
    for nu in -0.99 0.4999; do
        sed "s/poissons_ratio: 0.31/poissons_ratio: $nu/; s/end_strain: 0.001/end_steps: 3/" s.yaml >nu.yaml
        hsgen -q nu.yaml -o nu.g
        hssolve -q -i nu.g -H nu.e
    done
}
