# Periodic bodies whose particles have bonds, on a lattice and off it: lattice sums, laminates, cells against cells of them, explicit steps, ranks, restart
# and damage in every formulation but corner, which periodic.bats has.

bats_require_minimum_version 1.5.0

load ../cells
setup() { cd "$BATS_TEST_TMPDIR"; }

tension='{component: xx, rate: 1 1/s}'
# The strain of 1e-6 is what is left of geometry.
@test "a uniform body has the modulus of its lattice's sums, that of correspondence the given one, to 2e-6" {
    body cube 6 5 4 1
    for kind in mix capped ordinary bonds; do
        take "$kind"
        [ "$model" = correspondence ] && one="law: elastic, $steel" two=$one
        [ "$model" = bond_based ] && one='youngs_modulus: 200 GPa'
        read -r uniform _ < <(moduli "$kind")
        [ "$model" = correspondence ] && uniform=200e9
        near_share "$(modulus "$kind" cube xx)" "$uniform" 2e-6
    done
}

# A family that sees both layers errs by the horizon over their thickness: twice the finer less the coarser is the limit, to the square
# of it.  Off the lattice, at a horizon between two of its shells, particles err by the shift besides.
@test "elastic laminates at contrast 10, across and along, on a lattice and off it: errors of first order, in the limit Backus' moduli" {
    for n in 8 16 32; do
        body layers$n $n 4 4 "i >= $n * 3 / 8"
        body wide$n $n 6 6 "i >= $n * 3 / 8"
        cloud cloud$n wide$n 0.05 $n 6 6
    done
    for case in {mix,capped,ordinary,bonds}:layers {capped,ordinary,bonds}:cloud; do
        kind=${case%:*} cell=${case#*:}
        take "$kind"
        coarse=8 fine=16 most=5e-4 horizon=2.015
        [ "$cell" = cloud ] && most=5e-3 horizon=2.12 keys=${keys/2.015/2.12}
        if [ "$model" = correspondence ]; then
            one="law: elastic, $steel" two='law: elastic, youngs_modulus: 20 GPa, poissons_ratio: 0.2'
            coarse=16 fine=32 most=4e-3
        fi
        read -r _ across along < <(moduli "$kind")
        for way in xx:$across yy:$along; do
            read -r first second < <(echo "$(modulus "$kind" "$cell$coarse" "${way%:*}") $(modulus "$kind" "$cell$fine" "${way%:*}")")
            echo "$case $way: $first $second"
            near_share "$(awk "BEGIN { printf \"%.12g\", 2 * $second - $first }")" "${way#*:}" $most
            near_share "$second" "${way#*:}" 0.04
        done
    done
}

@test "a cell, three times three times three of it, and one cut elsewhere carry the same stress to 1e-8, on a lattice or off it" {
    cells_of_a_sphere
    for kind in mix capped plastic ordinary bonds; do
        take "$kind"
        cells_are_alike "$one" "$two" "end_steps: 3, step: 0.001, tolerance: 1e-10, most_evaluations: 20000, $keys" 1e-8
    done
    cells_of_a_cloud 0.4
    for kind in capped bonds; do
        take "$kind"
        cells_are_alike "$one" "$two" "end_steps: 3, step: 0.001, tolerance: 1e-10, most_evaluations: 20000, $keys" 1e-7
    done
}

# Bonds and families across a face see the flaw's nearest image.
@test "a flaw at the corner of a periodic cell is that in its middle, to 1e-8, on 1 rank or 2" {
    body cube 6 6 6 1
    for kind in mix capped plastic corner; do
        take "$kind"
        [ "$kind" != corner ] || model=corner keys='accuracy: 1e-3'
        for place in 30:1 0:1 60:2; do
            centre="${place%:*} um"
            deck cube 'x, y, z' "$linear_1, flaw: {centre: [$centre, $centre, $centre], radius: 15 um, reduction: 0.6}" '' "$tension" \
                "end_steps: 3, step: 0.0005, tolerance: 1e-10, most_evaluations: 20000, $keys"
            sed -i /block_2/d cube.yaml
            solve cube cube -j "${place#*:}"
            echo "$kind $place $(last cube.e mean_stress_xx_Pa mean_gradient_yy plastic_energy_J)"
        done >found
        cat found
        awk '{ for (k = 3; k <= 5; k++) if (NR == 1) first[k] = $k; else if (($k / first[k] - 1) ^ 2 > 1e-16) bad = 1 } END { exit bad || !(NR == 3) }' found
    done
}

# Between two phases lattice and cloud differ: a bond on a lattice knows how much of it lies in either cell.
@test "particles a little off a lattice, around a hole: the stresses of the lattice to 2e-5, of a shift that falls with it" {
    body cube 8 8 8 1
    awk '($1 - 4e-5) ^ 2 + ($2 - 4e-5) ^ 2 + ($3 - 4e-5) ^ 2 > 7e-10' cube.txt >hole.txt
    cloud off hole 1e-3 8 8 8
    cloud near_share hole 1e-4 8 8 8
    [ "$(wc -l <hole.txt)" -lt 512 ]
    for kind in capped plastic ordinary bonds; do
        take "$kind"
        echo "$kind"
        for cell in hole off near_share; do
            deck $cell 'x, y, z' "$one" "$two" "$tension, {component: xy, strain: {ramp: 1 s, to: 1}}" \
                "end_steps: 3, step: 0.001, tolerance: 1e-9, most_evaluations: 20000, $keys"
            sed -i /block_2/d $cell.yaml
            hssolve --deck $cell.yaml -i $cell.txt --history $cell.e 2>log
            [ $cell = hole ] || grep -q 'list of neighbours' log
            last $cell.e mean_stress_xx_Pa mean_stress_xy_Pa mean_gradient_yy mean_gradient_zz >$cell
        done
        paste hole off near_share | awk '{
            for (k = 1; k <= 4; k++) {
                size = k < 3 ? $1 : $3; far = ($(k + 4) - $k) / size; close_by = ($(k + 8) - $k) / size
                print far, close_by
                if (far < 0) far = -far; if (close_by < 0) close_by = -close_by
                if (!(close_by < 2e-5 && (far < 1e-6 || close_by < far / 5))) bad = 1
            } exit bad }'
    done
}

# The work of the mean stress is the energy that is stored, by other sums; its conjugate pulls at the unknown components.
@test "explicit steps follow the curve of load steps within 0.5 %, and keep the energy to 1e-6" {
    body sphere 8 8 8 '(i - 3.5) ^ 2 + (j - 3.5) ^ 2 + (k - 3.5) ^ 2 < 7'
    cloud cloud sphere 0.4 8 8 8
    for case in {mix,capped,plastic,ordinary,bonds}:sphere {capped,plastic}:cloud; do
        cell=${case#*:}
        take "${case%:*}"
        deck moving 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}' "end_strain: 0.003, type: explicit, $keys" "$cell"
        deck resting 'x, y, z' "$one" "$two" "$tension" "end_strain: 0.003, accuracy: 1e-4, $keys" "$cell"
        solve moving "$cell"
        solve resting "$cell"
        columns resting.e mean_gradient_xx mean_stress_xx_Pa >resting
        echo "$case"
        columns moving.e mean_gradient_xx mean_stress_xx_Pa energy_drift | awk '
            NR == FNR { e[NR] = $1; s[NR] = $2; n = NR; next }
            $1 > 0.0015 { for (k = 1; k < n - 1 && e[k + 1] < $1;) k++
                off = $2 / (s[k] + (s[k + 1] - s[k]) * ($1 - e[k]) / (e[k + 1] - e[k])) - 1; looked++
                if (off > most) most = off; if (-off > most) most = -off
                if ($3 > drift) drift = $3; if (-$3 > drift) drift = -$3 }
            END { printf "off by %g, drift %g\n", most, drift
                exit !(looked > 10 && most < 5e-3 && drift < 1e-6) }' resting -
    done
}

@test "a crack in the face of a cell is the one in its middle, to 1e-8 of the stress" {
    body cube 8 7 6 1
    for kind in capped bonds; do
        take "$kind"
        for at in 0.2 40.2; do
            deck crack$at 'x, y, z' "$one" "$two" "$tension" "end_steps: 2, step: 0.0005, tolerance: 1e-10, most_evaluations: 20000, $keys"
            sed -i /block_2/d crack$at.yaml
            echo "cracks: [{rectangle: [[$at um, 11 um, 11 um], [0 um, 30 um, 0 um], [0 um, 0 um, 30 um]]}]" >>crack$at.yaml
            solve crack$at cube
        done
        whole=$(awk 'BEGIN { print 0.001 * 200e9 }') cut=$(last crack40.2.e mean_stress_xx_Pa)
        echo "$kind $cut"
        awk "BEGIN { exit !($cut < 0.95 * $whole) }"
        near_share "$(last crack0.2.e mean_stress_xx_Pa)" "$cut" 1e-8
    done
}

# Leapfrog's error is of second order in the step.
@test "free swinging keeps the energy, to an error that falls by 4 with half the step" {
    body cube 8 6 4 'i < 3'
    for kind in capped bonds; do
        take "$kind"
        [ "$model" = correspondence ] && one="law: elastic, $steel" two='law: elastic, youngs_modulus: 20 GPa, poissons_ratio: 0.2'
        for safety in 0.4 0.2; do
            deck swing 'x, y, z' "$one" "$two" '' "end_time: 2e-7, type: explicit, safety: $safety, $keys"
            cat >>swing.yaml <<END
initial:
  - {where: 1, direction: x, velocity: "5*sin(78539.8*x+1e5*y)"}
  - {where: 1, direction: y, velocity: "5*cos(78539.8*x)"}
output: {history: 40}
END
            solve swing cube
            drift[${safety#0.}]=$(columns swing.e kinetic_energy_J stored_energy_J energy_drift | awk '
                NR == 1 { all = $1 } $2 > stored { stored = $2 } { d = $3 < 0 ? -$3 : $3; if (d > most) most = d }
                END { if (stored < 0.3 * all) exit 1; print most }')
        done
        echo "$kind: ${drift[4]} ${drift[2]}"
        awk -v coarse="${drift[4]}" -v fine="${drift[2]}" 'BEGIN { exit !(coarse < 5e-5 && fine < coarse / 2.5 && fine > coarse / 6) }'
    done
}

# Without the work of the mean gradient in the half step the balance would be off by 3e-4.
@test "bonds that break in explicit steps of a cell: their energy closes the balance to 2e-6" {
    body sphere 8 7 6 '(i - 1) ^ 2 + (j - 4.5) ^ 2 + (k - 5) ^ 2 < 12'
    cloud cloud sphere 0.4 8 7 6
    take bonds
    for cell in sphere cloud; do
        deck breaking 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}' \
            "end_strain: 0.0015, type: explicit, safety: 0.4, accept: true, $keys" $cell
        printf 'damage:\n  - {pair: [block_1, block_1], law: critical_stretch, value: 0.0004}\n' >>breaking.yaml
        solve breaking $cell
        last breaking.e broken_bonds fracture_energy_J stored_energy_J energy_drift | tee /dev/stderr |
            awk '{ exit !($1 > 100 && $2 > 0.1 * $3 && $4 < 2e-6 && $4 > -2e-6) }'
    done
}

@test "load steps, explicit ones and load steps again, under a mean stress across: the stress of load steps to 1e-3, the energy to 2e-6" {
    body sphere 6 6 6 '(i - 2.5) ^ 2 + (j - 2.5) ^ 2 + (k - 2.5) ^ 2 < 5'
    for kind in mix corner; do
        take mix
        [ $kind = corner ] && model=corner keys='residual: {form: flowing}'
        for type in quasi_static 'hybrid, explicit_strain: 0.002, static_when: {quiet: 0.2 us, kinetic_to_internal: 1e-2}'; do
            deck hybrid 'x, y, z' "$one" "$two" '{component: xx, rate: 1e3 1/s}, {component: yy, stress: 20 MPa}' \
                "end_strain: 0.004, accuracy: 1e-4, type: $type, $keys"
            hssolve --deck hybrid.yaml -i sphere.txt --history hybrid.e 2>log
            [ "$type" = quasi_static ] && exact=$(last hybrid.e mean_stress_xx_Pa)
        done
        grep -q 'explicit from' log
        grep -q 'load steps from strain' log
        near_share "$(last hybrid.e mean_stress_xx_Pa)" "$exact" 1e-3 # waves that the way into explicit steps sends out
        last hybrid.e energy_drift | tee /dev/stderr | awk '{ exit !($1 < 2e-6 && $1 > -2e-6) }'
    done
}

@test "the same bits on 1, 2 and 4 ranks and after a restart, with what flows and breaks across the faces" {
    body sphere 8 7 6 '(i - 1) ^ 2 + (j - 4.5) ^ 2 + (k - 5) ^ 2 < 12'
    cloud cloud sphere 0.4 8 7 6
    for case in {mix,capped,plastic,bonds}:sphere {capped,plastic,bonds}:cloud; do
        kind=${case%:*} cell=${case#*:}
        take "$kind"
        rate=1 end=0.005 type=quasi_static ends=(0.001 0.004)
        [ "$kind" = bonds ] && rate=1e3 end=0.0015 type=explicit
        deck broken 'x, y, z' "$one" "$two" "{component: xx, rate: $rate 1/s}" "end_strain: $end, type: $type, accept: true, $keys" "$cell"
        if [ "$kind" = bonds ]; then
            printf 'damage:\n  - {pair: [block_1, block_1], law: critical_stretch, value: 0.0004}\n'
        else
            printf 'damage:\n  - {phase: block_1, law: ductile, onset: %s, full: %s}\n' "${ends[@]}"
        fi >>broken.yaml
        echo 'output: {checkpoint: {every: 11 steps, keep: 1}}' >>broken.yaml
        rm -f run.cp
        solve broken "$cell" --checkpoint run.cp
        hspost -q --columns broken.e | grep -v '^#' >one.csv
        echo "$case: $(last broken.e broken_bonds mean_stress_xx_Pa)"
        [ "$(last broken.e broken_bonds)" -gt 5 ]
        solve broken "$cell" -j 4
        hspost -q --columns broken.e | grep -v '^#' | cmp - one.csv
        hssolve -q --restart run.cp -j 2 --history again.e
        hspost -q --columns again.e | grep -v '^#' | cmp - one.csv
    done
}
