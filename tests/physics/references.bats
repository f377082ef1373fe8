#!/usr/bin/env bats
# The answers of other programs that tests compare with: that we know what they compute.

setup() {
    here="$BATS_TEST_DIRNAME/../lammps"
    cd "$BATS_TEST_TMPDIR" || return 1
}

@test "the figures of Peridigm and Peridynamics.jl follow from the formulas" {
    awk -f "$here/peers.awk"
}

# Positions of 5e-3 m are rounded to 9e-19 m, extensions are of 1e-5 m: 1e-13 of a bond's force.
@test "LAMMPS' peri/pmb and peri/lps are the formulas of tests/lammps" {
    awk -v n=6 -v spacing=1e-3 -v share=0.01 -v seed=1 -f "$here/lattice.awk" > particles
    # partial volumes, and whole ones
    for case in 'pmb 1e-3' 'pmb 1e-9' 'lps 1e-3' 'lps 1e-9'; do
        code=0
        read -r style spacing <<< "$case"
        "$here/forces" "$style" particles 3.015e-3 "$spacing" 130e9 50e9 > lammps 2> messages || code=$?
        [ "$code" -ne 77 ] || skip "$(cat messages)"
        [ "$code" -eq 0 ]
        awk -v style="$style" -v horizon=3.015e-3 -v spacing="$spacing" -v bulk=130e9 -v shear=50e9 \
            -f "$here/formula.awk" particles > formula
        paste lammps formula | awk '
            NF != 8 {exit 1}
            {for (i = 1; i <= 3; i++) {sum += $i ^ 2; d = ($i - $(i + 4)) ^ 2; if (d > worst) worst = d}
             d = ($4 - $8) ^ 2; if (d > theta) theta = d}
            END {exit !(NR == 216 && sum > 0 && worst <= 1e-24 * sum / NR && theta <= 1e-28)}'
    done
}

@test "LAMMPS' forces are asked for properly" {
    run "$here/forces" pmb nobody 3e-3 1e-3 1e9
    [ "$status" -eq 2 ]
    run "$here/forces" lps /dev/null 3e-3 1e-3 1e9
    [ "$status" -eq 2 ]
    printf '0 0 0 1e-9 0 0\n' > short
    LAMMPS=$(type -P true) run "$here/forces" pmb short 3e-3 1e-3 1e9
    [ "$status" -eq 77 ]
}
