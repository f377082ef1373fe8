# Small bodies that the tests pull at: parts of decks.

elastic='youngs_modulus: 210 GPa, poissons_ratio: 0.31'
# Nickel annealed, and after torsion.
soft='hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}'
hard='hardening: {law: voce, yield: 1259.8 MPa, saturation: 564.5 MPa, rate: 238.5}'

# even LENGTH WIDTH HEIGHT GRIP [GAUGE]: domain of one phase, M; all in spacings of 25 um
even() {
    cat <<END
domain:
  specimen: plate
  size: [$1 spacings, $2 spacings, $3 spacings]
  spacing: 25 um
  topology: homogeneous
  phase: M
  grips: {length: $4 spacings, phase: M}
${5:+  gauge: {length: $5 spacings\}}
END
}

# grains GRIP [SHAPE]: domain of random cells, three spacings wide, of two phases; SHAPE: lines of the specimen
# FLAT=yes: of one layer
grains() {
    cat <<END
domain:
${2:-  specimen: plate
  dimensions: $([ -n "${FLAT:-}" ] && echo 2 || echo 3)
  size: [0.6 mm, 0.2 mm, 0.15 mm]
  gauge: {length: 0.3 mm\}}
  spacing: 25 um
  topology: random
  phases: {cg: CG, ufg: UFG}
  core: cell
  core_distance: 75 um
  ufg_fraction: 0.40
  override: true
  seed: 3
  grips: {length: $1 spacings, phase: structure}
END
}

# small_plate: domain of random spheres, 24 by 6 by 4 spacings, of two phases
small_plate() {
    cat <<END
domain:
  specimen: plate
  size: [24 spacings, 6 spacings, 4 spacings]
  spacing: 25 um
  topology: random
  phases: {cg: CG, ufg: UFG}
  core_distance: 2 spacings
  ufg_fraction: 0.40
  override: true
  seed: 1
  grips: {length: 3 spacings, phase: structure}
  gauge: {length: 12 spacings}
END
}

# nickel MODEL: materials CG, annealed, and UFG, after torsion
nickel() {
    echo materials:
    printf '  %s:\n    model: %s\n    density: 8900 kg/m3\n    youngs_modulus: 210 GPa\n    poissons_ratio: 0.31\n    %s\n' \
        CG "$1" "$soft" UFG "$1" "$hard"
}

# scatter LENGTH JITTER: a text domain of points 1 mm apart, each off its place, 5 by 5 across
scatter() {
    awk -v count="$1" -v jitter="$2" 'BEGIN {
        srand(1); print "# blocks: 1 A"
        for (z = 0; z < 5; z++) for (y = 0; y < 5; y++) for (x = 0; x < count; x++)
            printf "%.9e %.9e %.9e 1 1e-9\n", (x + jitter * (rand() - 0.5)) * 1e-3,
                   (y + jitter * (rand() - 0.5)) * 1e-3, (z + jitter * (rand() - 0.5)) * 1e-3
    }'
}

# pulled SPEED: by both grips
pulled() {
    cat <<END
boundary:
  - {set: grip_left, direction: x, velocity: -$1}
  - {set: grip_right, direction: x, velocity: $1}
END
}

# solve NAME: history NAME.e of the domain NAME.g; what it says, which is shown where it fails, in NAME.log
solve() { hssolve -q -i "$1.g" -H "$1.e" 2>"$1.log" || { cat "$1.log" && false; }; }
