# The same bits for any vector width: the solver with its copies for AVX2 and AVX-512, of which the
# loader takes the widest that the processor has, against one that is built for the baseline alone.

bats_require_minimum_version 1.5.0

load ../bodies
setup() {
    root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    narrow=$HS_BUILD/narrow
    cd "$BATS_TEST_TMPDIR"
    [ -x "$HS_BUILD/bin/hssolve" ]
    clones "$HS_BUILD/bin/hssolve" || skip "this compiler or sanitizer makes one width only"
    grep -qw avx2 /proc/cpuinfo || skip "this processor has the baseline's width only"
    env -u MAKEFLAGS make -C "$root" BUILD="$narrow" CPPFLAGS=-DHS_NARROW "$narrow/bin/hssolve"
    run ! clones "$narrow/bin/hssolve"
}

# clones PROGRAM: it has functions for AVX2 beside those of the baseline.
clones() { nm "$1" | grep -q x86_64_v3; }

# Harmonic structure, torn at 50 m/s: waves, damping, grips and much plastic flow within 0.4 us.
study() {
    cat >study.yaml <<END
title: Vector width
domain:
  specimen: plate
  size: [0.6 mm, 0.225 mm, 0.2 mm]
  spacing: 25 um
  topology: harmonic
  phases: {cg: CG, ufg: UFG}
  lattice: fcc
  core: cell
  core_distance: 0.2 mm
  ufg_fraction: 0.40
  override: true
  grips: {length: 2 spacings, phase: structure}
  gauge: {length: 0.3 mm}
materials:
  CG: {model: correspondence, density: 8900 kg/m3, $elastic, $soft}
  UFG: {model: correspondence, density: 8800 kg/m3, youngs_modulus: 190 GPa, poissons_ratio: 0.30,
        hardening: {law: tabulated, points: [[0, 1200 MPa], [0.001, 1320 MPa], [0.01, 1800 MPa], [1, 1830 MPa]]}}
$(pulled '50 m/s')
solver:
  type: explicit
  horizon: $1
  stabilisation: {law: $2}
  end_time: 0.4 us
  damping: 1e5 1/s
output:
  history: 40
  fields: {frames: 2, variables: [displacement, velocity, force, stress, equivalent_plastic_strain]}
END
    [ "$1" != corner ] || sed -i -e 's/correspondence/corner/' -e '/horizon:/d' -e '/stabilisation:/d' study.yaml
    hsgen -q study.yaml -o domain.g
}

# compare HORIZON STABILISATION, or: compare corner
compare() {
    study "$1" "${2:-}"
    mkdir wide narrow
    (cd wide && hssolve -q -i ../domain.g -o fields.e -H history.e)
    (cd narrow && PATH=$narrow/bin:$PATH hssolve -q -i ../domain.g -o fields.e -H history.e)
    cmp wide/history.e narrow/history.e
    cmp wide/fields.e narrow/fields.e
    # and it has flowed
    hspost -q wide/history.e | awk -F, '
        /^#/ { next }
        !head { for (i = 1; i <= NF; i++) column[$i] = i; head = 1; next }
        $column["CG_plastic_strain"] > most { most = $column["CG_plastic_strain"] }
        END { exit !(most >= 0.02) }'
}

@test "mix, horizon 1" { compare 1 mix; }
@test "mix, horizon 2" { compare 2 mix; }
@test "capped, horizon 1" { compare 1 capped; }
@test "capped, horizon 2" { compare 2 capped; }
@test "corner" { compare corner; }
