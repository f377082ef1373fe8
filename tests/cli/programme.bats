#!/usr/bin/env bats
# Loading programmes: unloading, reloading, cycles, and motions from tables.

bats_require_minimum_version 1.5.0
load ../curves

setup() { cd "$BATS_TEST_TMPDIR" || return 1; }

# deck SOLVER [MATERIAL]: a homogeneous plate, E 100 GPa, yield 200 MPa, modulus 1 GPa
deck() {
    cat <<DECK
title: looped
domain:
  {specimen: plate, size: [0.4 mm, 0.1 mm, 0.1 mm], spacing: 25 um, topology: homogeneous, phase: M,
   grips: {length: 50 um, phase: M}, gauge: {length: 0.2 mm}}
materials:
  M: {model: corner, density: 7800, youngs_modulus: 100 GPa, poissons_ratio: 0.3,
      hardening: {law: linear, yield: 200 MPa, modulus: 1 GPa}}
boundary:
  - {set: grip_left, direction: x, velocity: -1 m/s}
  - {set: grip_right, direction: x, velocity: 1 m/s}
solver: {type: quasi_static, $1}
${2-}
DECK
}

# turns HISTORY: strain [%] and stress [MPa] where the strain of the gauge turns, and at the end
turns() {
    hspost -q "$1" -o - | grep -v '^[#t]' | awk -F, '{d = $5 - e; if (d * before < 0) printf "%.3f %.0f\n", 100 * e, s; before = d; e = $5; s = $6}
        END {printf "%.3f %.0f\n", 100 * e, s}'
}

@test "to a strain, unloaded to a stress, reloaded: the grips turn where the gauge says" {
    deck 'programme: [{to_strain: 1 %}, {unload_to: 0 MPa}, {reload}, {to_strain: 2 %}, {unload_to: 50 MPa}, reload, {to_strain: 3 %}, {unload_to: 100 MPa}, {reload}]' 'output: {fields: {frames: 1, variables: [displacement]}}' >deck.yaml
    hsgen -q deck.yaml | hssolve -q -H h.e -o fields.e
    turns h.e >turns
    # a frame of the start, and one of the end
    [ "$(hspost --frames fields.e | grep -c '^[0-9]')" -eq 2 ]
    # strains exactly, stresses within a thousandth of the change
    [ "$(cut -d' ' -f1 turns | sed -n '1p;3p;5p;7p' | tr '\n' ' ')" = '1.000 2.000 3.000 3.000 ' ]
    [ "$(cut -d' ' -f2 turns | sed -n '2p;4p;6p' | tr '\n' ' ' | tr -d -)" = '0 50 100 ' ]
    # flow stress (200 MPa + 1 GPa p)/(1 + e), p = ln(1 + e) - sigma/E; the plate is short, the grips within a width of its middle
    awk '{e = $1 / 100; for (k = 0; k < 20; k++) p = log(1 + e) - (200 + 1000 * p) / 1e5; s = (200 + 1000 * p) / (1 + e)}
        NR % 2 && ($2 < 0.99 * s || $2 > 1.01 * s) {exit 1} END {exit NR != 7}' turns
    # at least 30 steps of each unloading; its slope is E
    hspost h.e --loops loops.csv -o /dev/null 2>said
    [ "$(wc -l <loops.csv)" -eq 4 ]
    near "$(awk -F, 'NR == 2 {print $6}' loops.csv)" 100 1
    grep -q 'loop 2 at 1.98 %' said
}

@test "loops at strains, down into compression: isotropic hardening has no back stress" {
    deck 'programme: [{loops_at: [0.9 %], unload_to: -212 MPa}, {loops_at: [1.2 %], unload_to: -222 MPa}, {to_strain: 1.5 %}]' >deck.yaml
    hsgen -q deck.yaml | hssolve -q -H h.e
    hspost -q h.e --loops loops.csv -o /dev/null
    # half of what it hardens by in the reverse flow, which is 0.5 % long at most: 2.5 MPa
    awk -F, 'NR > 1 {if ($10 == "" || $10 ^ 2 > 2.5 ^ 2) exit 1; n++} END {exit n != 2}' loops.csv || { cat loops.csv; return 1; }
}

@test "an unloading that would load on stops where it begins" {
    deck 'programme: [{to_strain: 0.4 %}, {unload_to: 700 MPa}, {to_strain: 3 %}]' >deck.yaml
    hsgen -q deck.yaml >domain.g
    for ranks in 1 2; do
        run -1 --separate-stderr hssolve -q -j $ranks -i domain.g -H h.e
        [[ "$stderr" == *"leg 2 of 3 of the programme would unload from 20"*" MPa to 700 MPa, which is to load on"* ]]
        near "$(turns h.e.failed | tail -1 | cut -d' ' -f1)" 0.4 1e-3
    done
    # 4 (0.004 + 0.01 + 0.026) = 0.16 of plastic strain at the most: 360 MPa, twice of which on a section e^0.16 as large is 845 MPa
    for stress in -1000 850; do
        deck "programme: [{to_strain: 0.4 %}, {unload_to: $stress MPa}, {to_strain: 3 %}]" | hsgen -q >domain.g
        run -2 hssolve --check -i domain.g
        [[ "$output" == *":11:74: $stress MPa is out of reach: 'M', the strongest phase, flows at 360 MPa"* ]] || { echo "$output"; return 1; }
    done
    # sides that are held may be under any pressure
    deck "programme: [{to_strain: 0.4 %}, {unload_to: -1000 MPa}]" | sed 's/^solver/  - {set: grip_left, direction: y, velocity: 0}\n&/' | hsgen -q >domain.g
    hssolve -q --check -i domain.g
    # a second unloading goes on from the first
    deck 'programme: [{to_strain: 0.4 %}, {unload_to: 100 MPa}, {unload_to: 50 MPa}]' >deck.yaml
    hsgen -q deck.yaml | hssolve -q -H h.e
    [ "$(turns h.e | tail -1 | cut -d' ' -f2)" = 50 ]
}

@test "what begins with compression has no tensile curve, and is told so" {
    for programme in '{to_strain: -0.4 %}' '{to_strain: -0.4 %}, {to_strain: 0.8 %}'; do
        deck "programme: [$programme]" >deck.yaml
        hsgen -q deck.yaml | hssolve -q -H h.e
        run -2 --separate-stderr hspost h.e -o curve.csv
        [[ "$stderr" == *"begins with compression (stress down to -20"* ]]
        [ ! -e curve.csv ]
        hspost -q --columns h.e -o columns.csv
    done
}

@test "cycles between strains; the same bits on two ranks and after a restart" {
    deck 'programme: [{cycles: 2, between: [-0.4 %, 0.6 %]}]' 'output: {checkpoint: {every: 50 steps, keep: 9}}' >deck.yaml
    hsgen -q deck.yaml >domain.g
    hssolve -q -H h.e -i domain.g
    [ "$(turns h.e | cut -d' ' -f1 | tr '\n' ' ')" = '0.600 -0.400 0.600 -0.400 ' ]
    hssolve -q -j 2 -H two.e -i domain.g
    hssolve -q --restart h.e.checkpoint.2 -H again.e
    for file in h two again; do hspost --columns $file.e | grep -v '^#' >$file.csv; done
    cmp h.csv two.csv
    cmp h.csv again.csv
}

@test "a displacement from a table is the expression that it stands for, in the deck and from a file" {
    deck 'end_time: 1 s' | sed 's/velocity: -1 m\/s/displacement: 0/; s/velocity: 1 m\/s/displacement: WAY/' >deck.yaml
    printf 'time,way\n0,0\n0.3,3e-7\n1,-4e-7\n' >way.csv
    for way in '"t < 0.3 ? 1e-6*t : 6e-7 - 1e-6*t"' '[[0, 0], [0.3, 0.3 um], [1, -0.4 um]]' '{table: way.csv}'; do
        sed "s#WAY#$way#" deck.yaml | hsgen -q | hssolve -q -H h.e
        hspost --columns h.e | grep -v '^#' >>all.csv
    done
    # 102 lines each: 0.3 s is a multiple of the step, where the expression can turn, too
    awk -F, '{row = (NR - 1) % 102} NR <= 102 {for (i = 1; i <= 4; i++) a[row, i] = $i; next}
        row > 0 {for (i = 1; i <= 4; i++) if (($i - a[row, i]) ^ 2 > 1e-12 * (a[row, i] ^ 2 + 1e-12)) exit 1} END {exit NR != 306}' all.csv
    # a row between the steps is met
    sed 's#WAY#[[0, 0], [0.2537, 1 um], [1, 0]]#' deck.yaml | hsgen -q | hssolve -q -H h.e
    hspost --columns h.e | grep -qE '^0.253(7|69999)'
}

# fails PATTERN SOLVER
fails() {
    deck "$2" >deck.yaml
    hsgen -q deck.yaml >domain.g
    run -2 hssolve --check -i domain.g
    [[ $output == *"$1"* ]] || { echo "$output"; return 1; }
}

@test "what is wrong is told by line and column" {
    fails ':11:42: expected one of to_strain, unload_to, reload, loops_at' 'programme: [{to_strain: 1 %, unload_to: 0 MPa}]'
    fails ':11:60: reload follows nothing that unloads' 'programme: [{to_strain: 1 %}, {reload}]'
    fails ':11:41: no strain to go to' 'programme: [{unload_to: 0 MPa}]'
    fails ':11:59: 0.01 is not above the strain before it' 'programme: [{loops_at: [2 %, 1 %]}]'
    fails "'between' is missing" 'programme: [{cycles: 2}]'
    fails "unknown key 'to_stran' (did you mean to_strain?" 'programme: [{to_stran: 1 %}]'
    fails 'expected a stress in Pa' 'programme: [{to_strain: 1 %}, {unload_to: 3 %}]'
    fails 'give one of end_strain, end_time, end_steps and programme' 'end_strain: 1 %, programme: [{to_strain: 1 %}]'
    deck 'programme: [{to_strain: 1 %}]' | sed 's/quasi_static/explicit/' | hsgen -q >domain.g
    run -2 hssolve --check -i domain.g
    [[ $output == *"'programme' belongs to type: quasi_static, not to type: explicit"* ]]
    deck 'programme: [{to_strain: 1 %}]' | sed 's/velocity: 1 m.s/displacement: "t"/' | hsgen -q >domain.g
    run -2 hssolve --check -i domain.g
    [[ $output == *'programme needs grips that move apart'* ]]
}
