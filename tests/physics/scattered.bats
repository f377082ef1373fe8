# Scattered particles: the same bits on any number of ranks, for every formulation, while bonds break; and
# a lattice in a file is found and runs as one.

bats_require_minimum_version 1.5.0

load ../bodies
load ../ranks
setup() { cd "$BATS_TEST_TMPDIR"; }

# particles JITTER: a bar of 24 x 5 x 5 in particles.txt
particles() { scatter 24 "$1" >particles.txt; }
files=(--deck ../study.yaml -i ../particles.txt)

# deck MODEL SOLVER DAMAGE
deck() {
    cat >study.yaml <<END
title: Scattered
domain: {dimensions: 3, spacing: 1 mm, grips: {length: 3 spacings}, gauge: {length: 8 mm}}
materials:
  A: {model: $1}
damage:
  - $3
$(pulled '60 m/s')
solver: {type: explicit, $2, start: affine, end_time: 25 us, energy_tolerance: 0.05}
output: {history: 40, fields: {frames: 2, variables: [displacement, force, stress, damage]}}
END
}

compare() {
    solve_on 1 "${files[@]}"
    ncdump -v vals_glo_var 1/history.e >dump # the run broke something
    [ "$(hspost --frames 1/fields.e --variables Damage --csv | awk -F, '$4 > 0.3 { n++ } END { print n + 0 }')" -gt 20 ]
    for ranks in "$@"; do
        same_as_one "$ranks" "${files[@]}"
    done
}

steel='density: 8000, youngs_modulus: 200 GPa'
hardening='hardening: {law: linear, yield: 200 MPa, modulus: 2 GPa}'

@test "scattered, bond-based, breaking: 2 and 3 ranks give the bits of one" {
    particles 0.3
    deck "bond_based, $steel" 'horizon: 2.6' '{pair: [A, A], law: critical_stretch, value: 0.05}'
    compare 2 3
}

@test "scattered, ordinary plastic, breaking: 3 ranks give the bits of one" {
    particles 0.3
    deck "ordinary_plastic, $steel, poissons_ratio: 0.3, $hardening" 'horizon: 2.6' \
        '{pair: [A, A], law: critical_stretch, value: 0.08}'
    compare 3
}

@test "scattered, correspondence, breaking: 3 ranks give the bits of one" {
    particles 0.3
    deck "correspondence, $steel, poissons_ratio: 0.3, $hardening" \
        'horizon: 1.6, stabilisation: {law: capped}' \
        '{phase: A, law: plastic_strain, value: 0.1}'
    compare 3
}

@test "scattered, correspondence, degrading: 3 ranks give the bits of one" {
    particles 0.3
    deck "correspondence, $steel, poissons_ratio: 0.3, $hardening" \
        'horizon: 1.6, stabilisation: {law: capped}' \
        '{phase: A, law: ductile, onset: 0.03, full: 0.1}'
    compare 3
}

@test "scattered, at rest, some sharing a place of the preconditioner's lattice: 3 ranks give the bits of one" {
    particles 0.9
    deck "bond_based, $steel" 'horizon: 2.6' '{pair: [A, A], law: critical_stretch, value: 0.5}'
    sed -i 's/type: explicit/type: quasi_static, step: 5 us/; s/start: affine, //; s/, energy_tolerance: 0.05//; s/displacement, force/force/' study.yaml
    solve_on 1 "${files[@]}"
    same_as_one 3 "${files[@]}"
}

@test "a lattice among the particles of a file, in any order, runs as one" {
    particles 0
    deck "bond_based, $steel" 'horizon: 2.6' '{pair: [A, A], law: critical_stretch, value: 0.05}'
    hssolve --deck study.yaml -i particles.txt -H lattice.e 2>messages
    run ! grep "list of neighbours" messages
    { head -1 particles.txt; tail -n +2 particles.txt | sort -R --random-source=/bin/sh; } >shuffled.txt
    run ! cmp -s particles.txt shuffled.txt
    hssolve -q --deck study.yaml -i shuffled.txt -H shuffled.e
    hspost -q lattice.e | grep -v '^#' >lattice.csv
    hspost -q shuffled.e | grep -v '^#' >shuffled.csv
    cmp lattice.csv shuffled.csv
}

# A lattice turned by 45 degrees: layers 1/sqrt(2) spacings apart, of 4 x 5 particles each, so that the section is
# 20 mm2 sqrt(2).  Counted between two planes it would be a layer too many or too few of 14: 7 %.
@test "scattered, a lattice at 45 degrees without a word of horizon or stabilisation: section, E, no node lost" {
    awk 'BEGIN {
        print "# blocks: 1 A"; s = sqrt(0.5)
        for (z = 0; z < 5; z++) for (i = -40; i < 40; i++) for (j = -40; j < 40; j++) {
            x = (i + j) * s + 0.1; y = (i - j) * s
            if (x > 0 && x < 24 && y > -0.01 && y < 5) printf "%.9e %.9e %.9e 1 1e-9\n", x * 1e-3, y * 1e-3, z * 1e-3
        }
    }' >particles.txt
    cat >study.yaml <<DECK
domain: {dimensions: 3, spacing: 1 mm, grips: {length: 3 spacings}, gauge: {length: 10 mm}}
materials:
  A: {model: correspondence_elastic, density: 8000, youngs_modulus: 210 GPa, poissons_ratio: 0.31}
$(pulled '1 m/s')
solver: {end_strain: 0.001, step: 0.001, first_step: 0.001}
DECK
    hssolve --deck study.yaml -i particles.txt -H history.e 2>messages
    run ! grep "too few neighbours" messages
    # 0.1 % of strain itself makes 0.1 % of E.
    hspost -q history.e | awk -F'[:,]' '
        /^# section_m2/ { section = $2 }
        /^#/ { next }
        !n { n = NF; for (i = 1; i <= NF; i++) column[$i] = i; next }
        { E = $column["engineering_stress_MPa"] / $column["engineering_strain"] / 210e3 }
        END { print section, E; exit !((section / (20e-6 * sqrt(2)) - 1) ^ 2 < 1e-16 && (E - 1) ^ 2 < 0.004 ^ 2) }'
    # Beside the horizon that the deck leaves out, one within which too many nodes have nobody.
    sed -i 's/solver: {/&horizon: 1, stabilisation: {law: capped}, /; s/spacing: 1 mm, /spacing: 0.9 mm, /' study.yaml
    run -2 hssolve -q --deck study.yaml -i particles.txt -H history.e
    [[ "$output" == "hssolve: study.yaml:7:19: 100 % of the nodes ("*") have too few neighbours within a horizon of 1 spacings"* ]]
}
