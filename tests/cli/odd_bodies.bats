# Bodies at the edge of what can be run: one layer, nothing that pulls, everything broken, far apart.

bats_require_minimum_version 1.5.0
load ../ranks

load ../columns
setup() {
    cd "$BATS_TEST_TMPDIR"
    cat >layer.yaml <<'DECK'
title: A layer
domain:
  dimensions: 2
  specimen: plate
  size: [12 spacings, 8 spacings, 0.1 mm]
  spacing: 0.1 mm
  topology: homogeneous
  phase: A
materials:
  A: {model: ordinary, density: 8000, youngs_modulus: 200 GPa, poissons_ratio: 0.3}
initial:
  - {block: A, direction: x, displacement: "1e-3*x + 2e-4*y"}
  - {block: A, direction: y, displacement: "-5e-4*y"}
solver:
  type: explicit
  plane: strain
  horizon: 3.015
  end_steps: 40
  safety: 0.1
output:
  history: 4
  quantities:
    - {name: xx, quantity: stress_xx, reduce: mean, block: A}
    - {name: yy, quantity: stress_yy, reduce: mean, block: A}
    - {name: zz, quantity: stress_zz, reduce: mean, block: A}
DECK
    hsgen -q layer.yaml -o layer.g
}

# change SED: the deck with something changed, and its domain
change() {
    sed "$1" layer.yaml >changed.yaml
    run ! cmp -s layer.yaml changed.yaml
    hsgen -q changed.yaml -o changed.g
}

# Correspondence in one layer has no strain across it: what it would call plane stress would be plane strain.
@test "correspondence has no plane stress" {
    change 's/model: ordinary/model: correspondence_elastic/; s/plane: strain/plane: stress/; s/end_steps/stabilisation: {law: capped}\n  end_steps/'
    run hssolve -q -H out.e -i changed.g
    [ "$status" -eq 2 ]
    [ "${#lines[@]}" -eq 1 ]
    [[ "$output" == "hssolve: changed.yaml:10:14: correspondence_elastic has no plane stress"* ]]
    sed -i 's/plane: stress/plane: strain/' changed.yaml
    hssolve -q -H out.e -i changed.g -d changed.yaml
}

# What is held across a layer has the stress nu (xx + yy), to the rounding of means of 96 nodes.
@test "plane strain has a stress across the layer, plane stress has none" {
    for model in "ordinary 0.3" "madenci_oterkus 0.3" "bond_based 0.25"; do
        read -ra model <<<"$model"
        set -- "${model[@]}"
        change "s/model: ordinary/model: $1/; s/poissons_ratio: 0.3/poissons_ratio: $2/
                s/plane: strain/plane: strain /"
        [ "$1" != bond_based ] || change "s/model: ordinary/model: $1/; s/, poissons_ratio: 0.3//"
        hssolve -q -H out.e -i changed.g
        paste <(values out.e xx) <(values out.e yy) <(values out.e zz) | awk -v nu="$2" '
            { wrong = $3 - nu*($1 + $2); if (wrong*wrong > 1e-24*$1*$1) exit 1; n += $1 != 0 }
            END { if (n < 4) exit 1 }'
        sed -i 's/plane: strain/plane: stress/' changed.yaml
        [ "$1" != bond_based ] || sed -i 's/youngs_modulus: 200 GPa/&, poissons_ratio: 0.33333/' changed.yaml
        hssolve -q -H out.e -i changed.g -d changed.yaml
        values out.e zz | awk '$1 != 0 { exit 1 } END { if (NR < 4) exit 1 }'
    done
}

@test "a body in which nothing pulls is refused in words" {
    change 's/size: .*/size: [1 spacings, 1 spacings, 0.1 mm]/'
    run hssolve -q -H out.e -i changed.g
    [ "$status" -eq 2 ]
    [ "${#lines[@]}" -eq 1 ]
    [[ "$output" == *"no node acts on another"* ]]
    change 's/horizon: 3.015/horizon: 1/' # where the linear influence function is zero
    run own_words hssolve -q -H out.e -j 2 -i changed.g
    [ "$status" -eq 2 ]
    [[ "${lines[0]}" == *"no node acts on another"* ]]
    [ "${#lines[@]}" -eq 1 ]
}

@test "fragments of which nothing holds together fly on" {
    change 's/^initial:/damage: [{pair: [A, A], law: critical_stretch, value: 1e-12}]\n&/'
    hssolve -q -H out.e -i changed.g
    [ "$(values out.e stored_energy_J | tail -1)" = 0 ]
    hssolve -q -H two.e -j 2 -i changed.g
    cmp <(values out.e energy_drift) <(values two.e energy_drift)
}

# In a room of some GB: cells as wide as a spacing between the two would be 1e15.
@test "particles far apart take no room between them" {
    awk 'BEGIN { srand(3)
        for (i = 0; i < 125; i++)
            printf "%g %g %g 1 1e-9\n", (i%5 + 0.1*rand())*1e-3, (int(i/5)%5 + 0.1*rand())*1e-3, int(i/25)*1e-3
        print "100 100 100 1 1e-9" }' >far.txt
    sed '/plane:/d; /^domain/,/phase: A/d; s/spacings/mm/g' layer.yaml >far.yaml
    [[ "$HS_BUILD" == *sanitize* ]] || ulimit -v 4000000 # sanitizers reserve terabytes
    hssolve -q -H out.e -i far.txt -d far.yaml
}

@test "what cracks and damage give a warning for is told once, on two ranks, too" {
    change 's/model: ordinary/model: correspondence_elastic/; s/end_steps: 40/stabilisation: {law: capped}\n  end_steps: 2/
            s/^materials:/damage: [{pair: [A, A], law: critical_stretch, value: 9}]\n&/
            s/^solver:/cracks: [{disc: {centre: [1 m, 0, 0], normal: [1, 0, 0], radius: 1 mm}}]\n&/'
    run hssolve -q -H out.e -j 2 -i changed.g
    [ "$status" -eq 0 ]
    [ "$(grep -c 'hardly unload' <<<"$output")" -eq 1 ]
    [ "$(grep -c 'cut no bond' <<<"$output")" -eq 1 ]
}
