# The same bits on any number of ranks, more than there are cores among them: histories and fields
# compared with cmp, in plastic flow.  The files differ in one place, the recorded command's number of
# ranks, which is made equal first.

load ../bodies
load ../ranks
setup() { cd "$BATS_TEST_TMPDIR"; }

# study SPECIMEN HORIZON STABILISATION [LAW OF UFG]: domain.g; torn at 50 m/s, so that grips, waves, gauge, damping
# and both phases take part within some hundred steps.
study() {
    cat >study.yaml <<END
title: Ranks
$(grains 2 "$1")
materials:
  CG: {model: correspondence, density: 8900 kg/m3, $elastic, $soft}
  UFG: {model: correspondence, density: 8800 kg/m3, youngs_modulus: 190 GPa, poissons_ratio: 0.30, ${4:-$hard}}
$(pulled '50 m/s')
solver:
  type: explicit
  horizon: $2
  stabilisation: {law: $3}
  end_time: 0.4 us
  damping: 1e5 1/s
output:
  history: 40
  fields:
    frames: 2
    variables: [displacement, velocity, force, stress, von_mises, equivalent_plastic_strain, phase]
END
    hsgen -q study.yaml -o domain.g
}

# Kinks within what a step can add: Newton's method then takes more steps at some points than at others.
kinked='hardening: {law: tabulated, points: [[0, 600 MPa], [0.0001, 900 MPa], [0.0002, 901 MPa], [0.001, 902 MPa],
      [0.0011, 1300 MPa], [0.01, 1310 MPa], [0.0101, 1600 MPa], [1, 1700 MPa]]}'
plate='  specimen: plate
  size: [0.6 mm, 0.3 mm, 0.2 mm]
  gauge: {length: 0.3 mm}'
dogbone='  specimen: dogbone
  size: [1 mm, 0.4 mm, 0.1 mm]
  gauge: {length: 0.3 mm, width: 0.2 mm, fillet: 0.1 mm}'

# Largest mean plastic strain of a phase in the history, in per cent.
plastic() {
    hspost -q "$1" | awk -F, -v name="$2_plastic_strain" '
        /^#/ { next }
        !column { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        $column > most { most = $column }
        END { printf "%d\n", 100 * most }'
}

# compare RANKS...: each with one rank, where much of both phases has flowed.
compare() {
    solve_on 1
    [ "$(plastic 1/history.e CG)" -ge 2 ]
    [ "$(plastic 1/history.e UFG)" -ge 1 ]
    compare_with_one "$@"
}

compare_with_one() {
    for ranks in "$@"; do
        same_as_one "$ranks"
    done
}

@test "plate, mix, horizon 1: 2, 3, 4 and 8 ranks give the bits of one" {
    study "$plate" 1 mix
    compare 2 3 4 8
}

@test "dog-bone, capped, horizon 2: 3 and 8 ranks give the bits of one" {
    study "$dogbone" 2 capped
    compare 3 8
}

@test "plate, mix, horizon 3, steep influence: 2 ranks give the bits of one" {
    study "$plate" '3
  influence: steep' mix
    sed -i 's/grips: {length: 2/grips: {length: 3/' study.yaml
    hsgen -q study.yaml -o domain.g
    compare 2
}

@test "plate, mix, horizon 1, a tabulated law with kinks: 3 ranks give the bits of one" {
    study "$plate" 1 mix "$kinked"
    compare 3
}

# along_bonds SOLVER: the plate, its materials changed by a sed script on standard input; three spacings a horizon
along_bonds() {
    study "$plate" 3.015 mix
    sed -i -f - -e "s/  stabilisation: .*/  $1/" -e "s/length: 2 spacings/length: 3 spacings/" study.yaml
    hsgen -q study.yaml -o domain.g
}

@test "plate, bond-based, surface correction: 2 and 3 ranks give the bits of one" {
    along_bonds 'surface_correction: energy' <<'END'
s/model: correspondence/model: bond_based/
s/, poissons_ratio.*/}/
END
    solve_on 1
    compare_with_one 2 3
}

@test "plate, ordinary plastic, surface correction: 2 and 3 ranks give the bits of one" {
    along_bonds 'surface_correction: volume' <<'END'
s/model: correspondence/model: ordinary_plastic/
END
    compare 2 3
}

@test "bar longer than a strip of bonds, ordinary plastic: 2 and 3 ranks give the bits of one" {
    plate='  specimen: plate
  size: [13.5 mm, 0.1 mm, 0.1 mm]
  gauge: {length: 0.3 mm}' along_bonds '' <<'END'
s/model: correspondence/model: ordinary_plastic/
s/stabilisation.*//
END
    solve_on 1
    compare_with_one 2 3
}

# corner SPECIMEN [RESIDUAL]: the study with particles between corners
corner() {
    study "$1" 1 mix
    sed -i -e 's/model: correspondence/model: corner/' -e '/horizon:/d' -e 's/50 m/60 m/' \
        -e "s/  stabilisation: .*/  residual: {form: ${2:-flowing}}/" study.yaml
    hsgen -q study.yaml -o domain.g
}

@test "dog-bone, corner: 2, 3, 4 and 8 ranks give the bits of one" {
    corner "$dogbone"
    compare 2 3 4 8
}

@test "plate, corner, the law at four points more: 3 ranks give the bits of one" {
    corner "$plate" four_points
    compare 3
}

# corner_sheet PLANE RANKS...
corner_sheet() {
    corner '  specimen: plate
  dimensions: 2
  size: [0.6 mm, 0.3 mm, 25 um]
  gauge: {length: 0.3 mm}'
    sed -i "s/  type: explicit/&\n  plane: $1/" study.yaml
    hsgen -q study.yaml -o domain.g
    solve_on 1
    [ "$(plastic 1/history.e CG)" -ge 1 ]
    compare_with_one "${@:2}"
}

@test "sheet, corner, plane strain: 3 ranks give the bits of one" {
    corner_sheet strain 3
}

@test "sheet, corner, plane stress: 2, 3 and 8 ranks give the bits of one" {
    corner_sheet stress 2 3 8
}

@test "dog-bone, corner, at rest: 2, 3 and 8 ranks give the bits of one" {
    corner "$dogbone"
    at_rest lbfgs
    compare 2 3 8
}

# at_rest METHOD [MORE]: the study by load steps
at_rest() {
    sed -i -e "s/  type: explicit/  type: quasi_static\n  method: $1\n  step: 0.1 us\n${2:-}/" -e '/damping/d' -e '/velocity, /s///' study.yaml
    hsgen -q study.yaml -o domain.g
}

@test "plate at rest by L-BFGS: 2, 3, 4 and 8 ranks give the bits of one" {
    study "$plate" 1 mix
    at_rest lbfgs
    compare 2 3 4 8
}

@test "dog-bone at rest by L-BFGS: 2, 3, 4 and 8 ranks give the bits of one" {
    study "$dogbone" 1 mix
    at_rest lbfgs
    compare 2 3 4 8
}

@test "dog-bone at rest by Newton's method and by relaxation: 3 ranks give the bits of one" {
    for method in newton relaxation; do
        study "$dogbone" 1 capped
        at_rest $method '  tolerance: 1e-3\n'
        compare 3
        rm -r 1 3
    done
}

@test "under mpirun as well" {
    study "$plate" 1 capped
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    for ranks in 1 2; do
        mpirun --oversubscribe --bind-to none -n $ranks \
            hssolve -q -i domain.g -o fields.e --history history.e
        mkdir $ranks
        mv fields.e history.e $ranks
    done
    cmp 1/history.e 2/history.e
    cmp 1/fields.e 2/fields.e
}

@test "through the pipe, on several ranks" {
    study "$plate" 1 mix
    mkfifo frames
    for ranks in 1 3; do # frames, too, which all ranks write
        cat frames >$ranks.f &
        hssolve -q -j $ranks -o frames <domain.g >$ranks.e || { kill $!; return 1; }
        wait
    done
    cmp 1.f 3.f
    hspost -q 1.e | grep -v '^#' >one.csv
    hspost -q 3.e | grep -v '^#' >three.csv
    [ "$(wc -l <one.csv)" -gt 30 ]
    cmp one.csv three.csv
}
