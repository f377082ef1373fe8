# A crack in a long strip with clamped edges, where G is W H (Rivlin, Thomas): what the energies of a run say of it.

bats_require_minimum_version 1.5.0

setup() {
    cd "$BATS_TEST_DIRNAME/../.."
    what=(-v model=bond_based -v law=critical_stretch -v horizon=3.015 -v influence=constant -v angle=0)
}

# run_strip HOW LEVEL: history.csv
run_strip() {
    awk "${what[@]}" -v how="$1" -v level="$2" -f pipelines/strip/deck.awk >"$BATS_TEST_TMPDIR/deck.yaml"
    hsgen -q "$BATS_TEST_TMPDIR/deck.yaml" | hssolve -q -H "$BATS_TEST_TMPDIR/history.e"
    hspost -q --columns "$BATS_TEST_TMPDIR/history.e" >"$BATS_TEST_TMPDIR/history.csv"
}

# columns NAME...: of the records
columns_of() {
    awk -F, -v names="$*" '
        /^#/ { next }
        !n { n = NF; for (i = 1; i <= NF; i++) column[$i] = i; k = split(names, name, " "); next }
        { for (i = 1; i <= k; i++) printf "%s ", $column[name[i]]; print "" }' "$BATS_TEST_TMPDIR/history.csv"
}

# The ligament is 36 mm2, 18 bonds through a spacing of it; the deck's G 100 J/m2.
@test "a running crack: the bonds it breaks hold the deck's fracture energy, at 1.15 of it put in" {
    run_strip running 1.2
    cmp "$BATS_TEST_TMPDIR/deck.yaml" pipelines/strip/study.yaml # the one to look at
    columns_of broken_bonds fracture_energy_J energy_drift |
        awk '{ share = $1 / (18 * 36); G = share > 0 ? $2 / (share * 36e-6) : 0; drift = $3 }
             END { print share, G, drift; exit !(share > 0.5 && (G / 100 - 1) ^ 2 < 0.1 ^ 2 && drift ^ 2 < 0.02 ^ 2) }'
}

@test "below the deck's fracture energy a crack does not run" {
    run_strip running 0.95
    columns_of broken_bonds | awk '{ share = $1 / (18 * 36) } END { print share; exit !(NR > 10 && share < 0.2) }'
}

# By load steps the crack waits until the last bond of the next row gives way: 1.55.  Then it runs through, and what the strip
# loses is what it held, W H for each unit of area.
@test "a slow crack: the strip loses W H" {
    run_strip whole 1
    whole=$(columns_of stress_yy | awk '{ s = $1 } END { print s * sqrt(2 * 100 * 8 / 9 * 24e-3 / 70e9) / 2 }')
    run_strip slow 1
    columns_of time_s broken_bonds fracture_energy_J | awk -v whole="$whole" '
        $2 > 0.5 * 18 * 36 && !level { level = 0.4 + 0.02 * $1 }
        { G = $3 / 36e-6 }
        END { print level * whole, G; exit !(level * whole > 130 && (G / (level * whole) - 1) ^ 2 < 0.08 ^ 2) }'
}
