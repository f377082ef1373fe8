#!/usr/bin/env bats
# A deck that is a study of several: its decks, its Makefile, and what hspost gathers.

bats_require_minimum_version 1.5.0
load ../bodies
load ../columns
load ../curves

# Makes of the tests have no jobs to share with them.
setup() {
    cd "$BATS_TEST_TMPDIR" || return 1
    unset MAKEFLAGS MFLAGS MAKELEVEL
}

# deck [VARY...]: study.yaml, a plate of two phases, small, and what varies, a line each.
deck() {
    cat >study.yaml <<DECK
# A small harmonic plate
title: Nickel
domain:
  specimen: plate
  size: [0.8 mm, 0.2 mm, 0.2 mm] # 16 x 4 x 4
  spacing: 50 um
  topology: harmonic
  phases: {cg: CG, ufg: UFG}
  lattice: fcc
  core: cell
  core_distance: 0.3 mm          # of the cores
  ufg_fraction: 0.40
  minimum_shell: 1 spacings
  override: true
  seed: 1
  grips: {length: 2 spacings, phase: structure}
  gauge: {length: 0.4 mm}
$(nickel corner)
$(pulled '2 m/s')
solver:
  type: quasi_static
  end_strain: 0.01
DECK
    printf '%s\n' "$@" 'post: {title: HS}' >>study.yaml
}

# refused WORDS VARY...: hsgen --study says the words, and makes nothing.
refused() {
    local words=$1
    shift
    deck "$@"
    run -2 --separate-stderr hsgen --study study.yaml -o out
    [[ "$stderr" == *"$words"* ]] || { echo "$stderr"; return 1; }
    [ ! -e out ]
}

# column NAME FILE: its values
column() { sed 's/"[^"]*"/quoted/g' "$2" | awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i; next } { print $k }'; }

# property NAME FILE: its value in a run's table, which says first what varied
property() { sed 's/"[^"]*"/quoted/g' "$2" | awk -F, -v name="$1" '{ for (i = 1; i < NF; i++) if ($i == name) print $(i + 2) }'; }

@test "decks are the study's text with the values in it, comments kept" {
    deck 'vary: # what varies' '  ufg_fraction: [0.3, 0.40]' '  domain.seed: 1..3' '  scatter: domain.seed'
    hsgen -q --study study.yaml -o out
    [ "$(cat out/study.csv)" = "run,ufg_fraction,domain.seed
0001,0.3,1
0002,0.3,2
0003,0.3,3
0004,0.40,1
0005,0.40,2
0006,0.40,3" ]
    sed -e 's/^title:.*/title: "Nickel, ufg_fraction 0.3"/' -e 's/ufg_fraction: 0.40/ufg_fraction: 0.3/' -e 's/seed: 1/seed: 2/' \
        -e 's/title: HS/title: "HS, ufg_fraction 0.3"/' -e 's/^  \(ufg_fraction: .0\|domain.seed\|scatter\).*//' \
        -e 's/^vary.*/varied: {values: {"ufg_fraction": "0.3", "domain.seed": "2"}, scatter: ["domain.seed"]}/' study.yaml >expected
    diff expected out/0002/deck.yaml
    hsgen -q out/0002/deck.yaml -o domain.g
    # it is the deck as far as hssolve and hspost are concerned
    hssolve --check -i domain.g
    cmp study.yaml out/study.yaml
}

@test "vary in each of its forms: ranges, names of values, a table, zipped, items of lists, quotes" {
    printf '# heats\nname, CG.hardening.yield, UFG.youngs_modulus\nsoft, 182.1 MPa, 210 GPa\n"hard, old", 250 MPa, 205 GPa\n' >heats.csv
    deck 'vary:' '  heat: {csv: heats.csv}' '  pull:' '    boundary.1.velocity: [-2 m/s, -4 m/s]' '    boundary.2.velocity: [2 m/s, "4 m/s"]'
    hsgen -q --study study.yaml -o out
    [ "$(wc -l <out/study.csv)" -eq 5 ]
    grep -q '^0004,"hard, old",250 MPa,205 GPa,-4 m/s,4 m/s$' out/study.csv
    grep -q 'direction: x, velocity: "4 m/s"}' out/0004/deck.yaml
    [ "$(grep -c 'youngs_modulus: 205 GPa' out/0004/deck.yaml)" -eq 1 ]
    grep -q '^title: "Nickel, heat hard, old, boundary.1.velocity -4 m/s, boundary.2.velocity 4 m/s"$' out/0004/deck.yaml
    deck 'vary: {seed: [1..2, 7], ufg_fraction: [0.3, 0.4, 0.5], size: ["[0.8 mm, 0.2 mm, 0.2 mm]"], combine: crossed}'
    run -2 --separate-stderr hsgen --study study.yaml -o wrong
    [[ "$stderr" == *"study.yaml"* || "$stderr" == *deck.yaml* ]]
    deck 'vary: {seed: [1..2, 7], ufg_fraction: [0.3, 0.4, 0.5], combine: zipped}'
    hsgen -q --study study.yaml -o zip
    [ "$(cut -d, -f2- zip/study.csv | tr '\n' ' ')" = "seed,ufg_fraction 1,0.3 2,0.4 7,0.5 " ]
    deck 'vary: {size: [[0.8 mm, 0.2 mm, 0.2 mm], [0.9 mm, 0.2 mm, 0.2 mm]]}'
    hsgen -q --study study.yaml -o sizes
    grep -q 'size: \[0.9 mm, 0.2 mm, 0.2 mm\] # 16' sizes/0002/deck.yaml
}

@test "refine keeps the body: lengths in spacings, and the cores of the coarsest" {
    deck 'refine: [2, 4]'
    hsgen -q --study study.yaml -o out
    [ "$(column spacing out/study.csv | tr '\n' ' ')" = "50 um 25 um 12.5 um " ]
    grep -q 'grips: {length: 8 spacings, phase: structure}' out/0003/deck.yaml
    grep -q 'minimum_shell: 4 spacings' out/0003/deck.yaml
    run ! grep -E '^ *(lattice|core|core_distance):' out/0003/deck.yaml
    # comments stay where they were
    grep -q '# of the cores' out/0003/deck.yaml
    run ! grep -q cores: out/0001/deck.yaml
    make -s -C out runs
    for run in 0001 0002 0003; do hsgen -q "out/$run/deck.yaml" --cores "cores$run" -o "$run.g" 2>/dev/null || (cd out && hsgen -q "$run/deck.yaml" --cores "../cores$run" -o "../$run.g"); done
    # The same centres, and the same half of the length held.
    diff cores0001 cores0003
    for run in 0001 0003; do ncdump -h "$run.g" >"$run.h"; done
    run -1 diff -q 0001.h 0003.h
    # the same study, said by hand; scaled from the deck's own spacing
    deck 'vary: {spacing: [50 um, 25 um], resolution: spacing}'
    hsgen -q --study study.yaml -o hand
    deck 'refine: 2'
    hsgen -q --study study.yaml -o short
    diff hand/0002/deck.yaml short/0002/deck.yaml
    # lengths within a value that varies as a whole are scaled once
    deck 'vary: {grips: [{length: 1 spacings, phase: CG}, {length: 2 spacings, phase: structure}]}' 'refine: 2'
    hsgen -q --study study.yaml -o whole
    [ "$(grep -h 'grips:' whole/0001/deck.yaml whole/0002/deck.yaml whole/0003/deck.yaml whole/0004/deck.yaml | tr -s ' ' | sort -u | wc -l)" -eq 4 ]
    grep -q 'grips: {length: 4 spacings, phase: structure}' whole/0004/deck.yaml
}

@test "a study of a body without grips has columns" {
    deck 'vary: {initial.1.velocity: [1 m/s, 2 m/s]}' 'initial: [{where: "1", direction: x, velocity: 1 m/s}]' 'output: {quantities: [{name: u, quantity: displacement_x, nearest: [0, 0, 0]}]}'
    sed -i -e '/^  grips:/d' -e '/^boundary:/,/grip_right/d' -e 's/quasi_static/explicit/' -e 's/end_strain: 0.01/end_steps: 4/' study.yaml
    hsgen -q --study study.yaml -o out
    make -s -C out columns >said
    grep -q '2 runs done, 0 not run, 0 stopped, 0 failed' said
    for run in 0001 0002; do grep -v '^#' "out/$run/columns.csv" >"$run.csv"; done
    awk '{exit !($1 > 0 && $2 > 1.9*$1)}' <<<"$(column u 0001.csv | tail -n 1) $(column u 0002.csv | tail -n 1)"
}

@test "what cannot be varied is refused, and nothing is written" {
    refused "study.yaml:37:8: this deck has no key 'ufg_fracton' (did you mean domain.ufg_fraction?)" 'vary: {ufg_fracton: [0.3]}'
    refused "'velocity' may mean boundary.1.velocity, boundary.2.velocity" 'vary: {velocity: [1 m/s]}'
    refused "seed has no values here" 'vary: {seed: []}'
    refused "expected the values of seed" 'vary: {seed: 5}'
    refused "from 5 down to 1" 'vary: {seed: 5..1}'
    refused "stands over lines of its own" 'vary: {domain: [1]}'
    refused "2 values, expected 3" 'vary: {seed: 1..3, ufg_fraction: [0.3, 0.4], combine: zipped}'
    refused "2 values, expected 3" 'vary: {a: {seed: 1..3, ufg_fraction: [0.3, 0.4]}}'
    refused "'sed' does not vary here" 'vary: {seed: 1..3, scatter: sed}'
    refused "'seed' is named twice" 'vary: {seed: 1..3, scatter: seed, resolution: seed}'
    refused "'run' is what the tables call the number of a run" 'vary: {run: {name: [a, b], seed: [1, 2]}}'
    refused "varies already as 'seed'" 'vary: {seed: 1..3, domain.seed: 1..3}'
    refused "lies within another value" 'vary: {phases: [{cg: A, ufg: B}], cg: [C]}'
    refused "more than 100000 decks" 'vary: {seed: 1..1000, ufg_fraction: [0.3, 0.4], core_distance: [0.3 mm], end_strain: [0.01, 0.02], CG.hardening.rate: 1..26}'
    refused "nothing varies here" 'vary: {}'
    refused "no.csv" 'vary: {a: {csv: no.csv}}'
    refused "study.yaml with ufg_fraction 40:12:17: 40 is out of range" 'vary: {ufg_fraction: [0.3, 40]}'
    refused "32 is out of range" 'refine: 32'
    refused "is a resolution of its own" 'refine: 2' 'vary: {seed: 1..2, resolution: seed}'
    printf 'seed, ufg_fraction\n1, 0.3\n2\n' >short.csv
    refused "short.csv:3: 1 fields, expected 2" 'vary: {a: {csv: short.csv}}'
    printf 'seed\n1\n"2\n' >short.csv
    refused "short.csv:3: a quote that does not end" 'vary: {a: {csv: short.csv}}'
    printf 'ufg_fraction\n0.3: 4\n' >short.csv
    refused "study.yaml with ufg_fraction 0.3: 4:" 'vary: {a: {csv: short.csv}}'
}

@test "a body that is there twice is refused with its place" {
    refused "study.yaml:37:34: ufg_fraction 0.40 is there twice (values 1 and 3), expected once" \
        'vary: {ufg_fraction: [0.40, 0.3, 0.40]}'
    refused "ufg_fraction 0.50 is there twice (values 1 and 2), expected once" 'vary: {ufg_fraction: [0.5, 0.50, 0.4]}'
    refused "ufg_fraction 50 % is there twice (values 1 and 2), expected once" 'vary: {ufg_fraction: [0.5, 50 %]}'
    refused "core_distance 100 um is there twice" 'vary: {core_distance: [0.10 mm, 100 um]}'
    refused "core_distance \"4.0 spacings\" is there twice" 'vary: {core_distance: [4 spacings, "4.0 spacings"]}'
    refused "is there twice (values 1 and 2)" 'vary: {size: [[0.8 mm, 0.4 mm, 0.2 mm], [800 um,0.4 mm,  200 um]]}'
    refused "sensitivity end_strain 2 % is there twice (values 2 and 3)" 'sensitivity: {end_strain: [0.02, 2 %]}'
    refused "sensitivity end_strain 1 % is there twice (values 1 and 2)" 'sensitivity: {end_strain: [1 %]}'
    refused "spacing 25 um is there twice (values 2 and 3)" 'refine: [2, 2]'
    refused "is there twice (values 1 and 3)" 'vary: {set: {ufg_fraction: [0.3, 0.4, 0.3], domain.seed: [1, 1, 1]}}'
    refused "is there twice (values 1 and 3)" 'vary: {combine: zipped, ufg_fraction: [0.3, 0.4, 0.3], domain.seed: [1, 1, 1]}'
    deck 'vary: {combine: zipped, ufg_fraction: [0.3, 0.4, 0.3], domain.seed: [1, 1, 2]}'
    hsgen -q --study study.yaml --check
}

@test "what is not a study's is not replaced, and nothing is written beside it" {
    deck 'vary: {ufg_fraction: [0.3, 0.40]}'
    mkdir -p makes tables decks/0001 here
    echo 'all:' >makes/Makefile
    echo 'a,b' >tables/study.csv
    echo mine >decks/0001/deck.yaml
    for file in makes/Makefile tables/study.csv decks/0001/deck.yaml; do
        find "${file%%/*}" -type f -exec cksum {} + >before
        run -2 --separate-stderr hsgen --study study.yaml -o "${file%%/*}"
        [[ "$stderr" == *"$file is there, in a folder without a Makefile of hsgen --study"* ]]
        find "${file%%/*}" -type f -exec cksum {} + | cmp - before
    done
    # into the folder that the deck is in, and once more
    cp study.yaml here/study.yaml
    for time in first second; do (cd here && hsgen -q --study study.yaml -o .); done
    cmp study.yaml here/study.yaml
    [ -e here/0002/deck.yaml ]
    # one that was left half done is gone on with
    rm -r here/0002 here/study.csv here/study.yaml
    hsgen -q --study study.yaml -o here
    [ -e here/0002/deck.yaml ]
}

@test "a study is no deck of a body, and says what to do" {
    for section in 'vary: {seed: 1..3}' 'refine: 2'; do
        deck "$section"
        run -2 --separate-stderr hsgen study.yaml -o domain.g
        [[ "$stderr" == *"study.yaml:37:"*"hsgen --study study.yaml -o FOLDER"* ]]
        [ ! -e domain.g ]
    done
    hsgen --study --check study.yaml
    [ ! -e 0001 ]
    [ ! -e Makefile ]
    run -2 --separate-stderr hsgen --study study.yaml
    [[ "$stderr" == *"-o FOLDER"* ]]
    # wherever it lies
    hsgen -q --study study.yaml -o "Anna's study"
    mkdir "Anna's study/gathered"
    touch "Anna's study/gathered/tidy.csv"
    make -s -C "Anna's study" status | grep -q "not run.*gathered in $PWD/Anna's study/gathered$"
    # hssolve and hspost pass over it
    deck
    hsgen -q study.yaml -o domain.g
    deck 'vary: {seed: 1..3}'
    hssolve -q -i domain.g -d study.yaml -H history.e
    hspost -q history.e -d study.yaml -o curve.csv
}

@test "--slurm writes a sound script with a task a run, and up to a thousand" {
    deck 'vary: {seed: 1..3}'
    hsgen -q --study study.yaml --slurm -o out
    shellcheck out/slurm.sh
    grep -qx '#SBATCH --array=0-2' out/slurm.sh
    deck 'vary: {seed: 1..1200}'
    hsgen -q --study study.yaml --slurm -o many
    grep -qx '#SBATCH --array=0-999' many/slurm.sh
    grep -qx 'tasks=1000' many/slurm.sh
    run -2 --separate-stderr hsgen study.yaml --slurm -o domain.g
    [[ "$stderr" == *"--slurm belongs to --study"* ]]
}

@test "make runs what is missing, once; a study that grows keeps what it has" {
    deck 'vary: {seed: 1..2, scatter: seed}'
    hsgen -q --study study.yaml -o out
    make -s -C out -j2 >said
    grep -q '2 runs done, 0 not run, 0 stopped, 0 failed' said
    stat -c '%n %y' out/*/history.e out/gathered/tidy.csv >before
    make -s -C out -j2
    diff before <(stat -c '%n %y' out/*/history.e out/gathered/tidy.csv)
    # one more in front of them, and one gone
    deck 'vary: {seed: [5, 2], scatter: seed}'
    hsgen --study study.yaml -o out 2>said
    grep -q '1 runs are no longer of this study' said
    [ "$(tr '\n' ' ' <out/study.csv)" = "run,seed 0003,5 0002,2 " ]
    [ ! -e out/0001/deck.yaml ]
    make -s -C out >said
    grep -q '^0003$' said
    run ! grep -q '^0002$' said
    grep -q 0002/history.e before
    diff <(grep 0002 before) <(stat -c '%n %y' out/0002/history.e)
    # A deck that changes where nothing has been run takes no new number.
    deck 'vary: {seed: [5, 2, 8], scatter: seed}'
    hsgen -q --study study.yaml -o out
    deck 'vary: {seed: [5, 2, 9], scatter: seed}'
    hsgen -q --study study.yaml -o out
    grep -q '^0004,9$' out/study.csv
}

@test "a run that fails is told at the end, and the others are done and gathered" {
    deck 'vary: {core_distance: [0.3 mm, 0.06 mm, 0.31 mm]}'
    sed -i 's/override: true/override: false/; s/ufg_fraction: 0.40/ufg_fraction: 0.9/' study.yaml
    hsgen -q --study study.yaml -o out
    run -2 --separate-stderr make -s -C out -j2
    [[ "$stderr" == *"0002 failed: exit status 2 hsgen: not a harmonic structure"* ]]
    [[ "$output" == *"2 runs done, 0 not run, 0 stopped, 1 failed"* ]]
    [ "$(column core_distance_mm out/gathered/tidy.csv | sort -u | tr '\n' ' ')" = "0.3 0.31 " ]
    run -2 --separate-stderr make -s -C out status
    [[ "$stderr" == *"0002 failed"* ]]
    # mended, it is run and gathered with the others
    sed -i 's/0.06 mm/0.32 mm/' study.yaml
    hsgen -q --study study.yaml -o out
    make -s -C out -j2
    [ "$(column core_distance_mm out/gathered/tidy.csv | sort -u | tr '\n' ' ')" = "0.3 0.31 0.32 " ]
}

@test "what a signal stops goes on from its checkpoint, with the same bits" {
    deck 'vary: {seed: [1]}' 'output: {checkpoint: {every: 500 steps}}'
    # explicit steps, some seconds of them
    sed -i 's/quasi_static/explicit/; s/end_strain: 0.01/end_strain: 0.02/; s/velocity: \(-*\)2/velocity: \10.05/' study.yaml
    hsgen -q --study study.yaml -o whole
    hsgen -q --study study.yaml -o cut
    make -s -C whole
    make -s -C cut >said 2>&1 3>&- &
    maker=$!
    until [ -e cut/0001/checkpoint ] || [ -e cut/0001/curve.csv ]; do sleep 0.05; done
    kill -TERM "$maker"
    status=0
    wait "$maker" || status=$?
    [ "$status" -ne 0 ]
    [ ! -e cut/0001/history.e ]
    [ -e cut/0001/checkpoint ]
    [ -s cut/0001/stopped ]
    run -2 --separate-stderr make -s -C cut status
    [[ "$stderr" == *"0001 stopped: goes on with the next make"* ]]
    make -s -C cut >said
    grep -q '0001: goes on from its checkpoint' said
    [ ! -e cut/0001/checkpoint ]
    diff <(numbers whole/0001/history.e) <(numbers cut/0001/history.e)
    # A checkpoint of another deck is not gone on from.
    touch -d '1 hour ago' cut/0001/checkpoint
    rm cut/0001/history.e
    make -s -C cut runs >said
    run ! grep -q 'goes on' said
}

@test "what is gathered is what hspost says of each run" {
    deck 'vary: {ufg_fraction: [0.3, 0.4], seed: 1..3, scatter: seed}'
    hsgen -q --study study.yaml -o out
    make -s -C out -j2
    cd out
    # Properties and points of each run as of its own call.
    for run in 0001 0005; do
        hspost -q "$run/history.e" -o own.csv --properties own.prop
        diff own.prop "$run/properties.csv"
        fraction=$(awk -F, -v run="$run" '$1 == run {print $2}' study.csv) seed=$(awk -F, -v run="$run" '$1 == run {print $3}' study.csv)
        diff <(grep -v '^#' own.csv | sed 1d | cut -d, -f5,6) \
            <(awk -F, -v file="$run/history.e" -v OFS=, '{ k = NF; for (i = 1; i <= NF; i++) if (NR == 1 && $i ~ /^engineering_strain$/) at = i }
                index($0, file) { match($0, /history.e,seed [0-9],/); rest = substr($0, RSTART + RLENGTH); split(rest, part, ",");
                    print part[7], part[8] }' gathered/tidy.csv)
        grep -q "^\"HS, ufg_fraction $fraction (seed $seed)\"" gathered/tidy.csv
        strength=$(property tensile_strength own.prop)
        [ -n "$strength" ]
        grep -q "$run/history.e,seed $seed,$fraction,$seed,tensile_strength,Rm,$strength," gathered/properties.csv
    done
    # Mean and deviation over the seeds, by hand.
    for k in 1 2 3; do property tensile_strength "000$k/properties.csv"; done >strengths
    awk '{ s += $1; q[NR] = $1 } END { m = s / 3; for (i in q) d += (q[i] - m) ^ 2; printf "%.9f %.9f\n", m, sqrt(d / 2) }' strengths >by_hand
    read -r mean deviation <by_hand
    grep '^"HS, ufg_fraction 0.3",0.3,tensile_strength,Rm,MPa,3,' gathered/statistics.csv >row
    IFS=, read -r _ _ _ _ _ _ _ found_mean found_deviation _ <row
    near "$found_mean" "$mean" 1e-6
    near "$found_deviation" "$deviation" 1e-6
    [ "$(awk 'NR > 1' gathered/mean.csv | sed 's/^"[^"]*",//' | cut -d, -f1,2 | sort -u | tr '\n' ' ')" = "0.3,3 0.4,3 " ]
    grep -q 'ufg_fraction 0.4' gathered/curves.svg
    [ ! -e gathered/extrapolated.csv ]
}

@test "over the resolution: the extrapolation of what the runs have, and its error" {
    deck 'vary: {seed: 1..2, scatter: seed}' 'refine: 2'
    hsgen -q --study study.yaml -o out
    make -s -C out -j2
    cd out
    # f0 = f1 - (f2 - f1) of the means over the seeds, at order 1 and a ratio of 2; thrice the difference is the error.
    for run in 0001 0002 0003 0004; do property tensile_strength "$run/properties.csv"; done | tr '\n' ' ' >strengths
    awk '{ c = ($1 + $3) / 2; f = ($2 + $4) / 2; printf "%.9f %.9f %.9f\n", f, 2 * f - c, 3 * (f > c ? f - c : c - f) }' strengths >by_hand
    read -r finest limit error <by_hand
    IFS=, read -r group _ _ _ curves left_out spacings a b c order from <<<"$(grep ',tensile_strength,' gathered/extrapolated_properties.csv)"
    [ "$group $curves $left_out $spacings $order $from" = "HS 2 0 2 1 assumed" ]
    near "$a" "$finest" 1e-6
    near "$b" "$limit" 1e-6
    near "$c" "$error" 1e-6
    [ "$(head -1 gathered/extrapolated.csv)" = group,curves,left_out,spacings,engineering_strain,finest_stress_MPa,extrapolated_stress_MPa,error_MPa,order,order_from ]
    # the same numbers on the page
    make -s report
    for number in "$a" "$b" "$c"; do grep -q "<data value=\"$number\">" gathered/report.html; done
    grep -q '<section id="varied">' gathered/report.html
    awk -F, 'NR > 1 { d = $7 - $6; e = $8 - 3 * (d < 0 ? -d : d); if (e * e > 1e-12) exit 1 } END { if (NR != 402) exit 1 }' gathered/extrapolated.csv
    grep -q '<svg' gathered/extrapolated.svg
    # Errors of the second order, where somebody knows that.
    hspost -q --files-from gathered/files --resolution-order 2 --extrapolate-properties second.csv
    IFS=, read -r _ _ _ _ _ _ _ _ b _ order _ <<<"$(grep ',tensile_strength,' second.csv)"
    [ "$order" = 2 ]
    near "$b" "$(awk '{ c = ($1 + $3) / 2; f = ($2 + $4) / 2; printf "%.9f", f - (c - f) / 3 }' strengths)" 1e-6
    # Without the fine run of seed 2, its coarse one is left out; without a seed in common nothing is extrapolated.
    hspost 0001/history.e 0002/history.e 0003/history.e --extrapolate-properties third.csv --extrapolate third_curve.csv -p /dev/null 2>said
    grep -q '1 of 3 curves left out' said
    IFS=, read -r _ _ _ _ curves left_out _ _ b _ <<<"$(grep ',tensile_strength,' third.csv)"
    [ "$curves $left_out" = "1 1" ]
    near "$b" "$(awk '{ printf "%.9f", 2 * $2 - $1 }' strengths)" 1e-6
    hspost 0001/history.e 0002/history.e --extrapolate pair_curve.csv -p /dev/null
    diff <(cut -d, -f5- third_curve.csv) <(cut -d, -f5- pair_curve.csv)
    hspost 0001/history.e 0004/history.e --extrapolate-properties third.csv -p /dev/null 2>said
    grep -q 'no scatter (seed) that all spacings have' said
    [ "$(wc -l <third.csv)" -eq 1 ]
}

@test "sensitivity changes one key at a time, and says what that does to each property" {
    deck 'sensitivity: {horizon: [1.5, 2], share: [0.2]}' 'refine: 2'
    sed -i -e 's/model: corner/model: correspondence/' -e 's/^  type: quasi_static/&\n  horizon: 1\n  stabilisation: {law: mix, share: 0.1}/' study.yaml
    hsgen --study study.yaml -o out 2>said
    grep -q 'sensitivity: 4 values, one at a time' said
    # at one spacing and at the other: as it is, two horizons, a share
    [ "$(cut -d, -f2- out/study.csv | tr '\n' ' ')" = "sensitivity,horizon,share,spacing none,1,0.1,50 um none,1,0.1,25 um horizon 1.5,1.5,0.1,50 um horizon 1.5,1.5,0.1,25 um \
horizon 2,2,0.1,50 um horizon 2,2,0.1,25 um share 0.2,1,0.2,50 um share 0.2,1,0.2,25 um " ]
    grep -q '^title: "Nickel, spacing 50 um"$' out/0001/deck.yaml
    grep -q '^title: "Nickel, horizon 2, spacing 25 um"$' out/0006/deck.yaml
    make -s -C out -j2 >said
    # Rp0.2 of the run of each change at the finest spacing against that of the run as it is, and the error of the latter's spacing
    rp() { property proof_strength_0.2 "out/$1/properties.csv" | head -n 1; }
    row() { sed 's/"[^"]*"/quoted/g' out/gathered/sensitivities.csv | grep ",Rp0.2,[^,]*,$1,"; }
    error=$(sed -n 's/^HS,.*,Rp0.2,.*,\([^,]*\),1,assumed$/\1/p' out/gathered/extrapolated_properties.csv)
    awk -F, -v rp="$(rp 0002)" -v error="$error" '{exit !($6 == rp && $7 == "" && $9 == error && error > 0)}' <<<"$(row none)"
    for pair in '0004 horizon 1.5' '0006 horizon 2' '0008 share 0.2'; do
        awk -F, -v before="$(rp 0002)" -v after="$(rp "${pair%% *}")" '{
            off = after - before - $7
            exit !($6 == after && after != before && off*off < 1e-12*after*after && (100*$7/before - $8)^2 < 1e-12 && $9 == "")}' <<<"$(row "${pair#* }")"
    done
    # What has lost its coarse run is not extrapolated, and mixes with no other; the rest is gathered.
    rm out/0001/history.e out/0001/curve.csv out/gathered/*
    make -s -C out gathered 2>said
    grep -q 'HS: one spacing alone' said
    for run in 3 5 7; do echo "$(rp "000$run") $(rp "000$((run + 1))")"; done | awk '{ printf "%.6f\n", 2 * $2 - $1 }' >limits
    diff limits <(sed -n 's/^"HS, .*,Rp0.2,MPa,1,0,2,[^,]*,\([^,]*\),.*/\1/p' out/gathered/extrapolated_properties.csv | awk '{ printf "%.6f\n", $1 }')
    [ -s out/gathered/tidy.csv ]
    [ -s out/gathered/extrapolated.svg ]
    rm -r out
    refused 'expected keys and the values' 'sensitivity: [1, 2]'
    refused "crossed with all else" 'vary: {seed: [1, 2], ufg_fraction: [0.3, 0.4], combine: zipped}' 'sensitivity: {core_distance: [0.31 mm]}'
}
