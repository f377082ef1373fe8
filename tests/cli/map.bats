# The design and the indices of the map of cells (pipelines/map).

bats_require_minimum_version 1.5.0

setup() {
    map=$BATS_TEST_DIRNAME/../../pipelines/map
    cd "$BATS_TEST_TMPDIR"
}

# sample EXPRESSION: 400 points of a and c in [0, 1] and b of 1, 2, 3, and y of them; noise is uniform in [-1, 1]
sample() {
    awk 'function h(i, base,   part, sum) { for (part = 1 / base; i > 0; part /= base) { sum += part * (i % base); i = int(i / base) } return sum }
        BEGIN { print "run,a,b,c,y"
            for (i = 1; i <= 400; i++) {
                a = h(i, 2); b = 1 + int(3 * h(i, 3)); c = h(i, 5); noise = 2 * h(i, 7) - 1
                printf "%d,%.9g,%d,%.9g,%.9g\n", i, a, b, c, '"$1"' } }' >sample.csv
}

# indices FACTORS: of the sample
indices() { awk -v factors=3 -v degree=2 -v names=b -f "$map/sobol.awk" sample.csv; }

# a: variance 1/3; b: 3 where it is 3, variance 2; with c, where b is 2: 1/27 of c alone, 2/27 of both.  The sample's own are 0.3 %
# off.
@test "the indices of a function of two numbers and a name are those of its variances, and nothing is left to predict" {
    sample '(2 * a - 1) + (b == 2) * (2 * c - 1) + 3 * (b == 3)'
    indices | awk -F, '
        BEGIN { all = 1 / 3 + 2 + 1 / 9; first["a"] = total["a"] = 1 / 3 / all
            first["b"] = 2 / all; total["b"] = (2 + 2 / 27) / all; first["c"] = 1 / 27 / all; total["c"] = 1 / 9 / all }
        $2 in first { looked++; for (k = 3; k <= 4; k++) { off = $k - (k == 3 ? first[$2] : total[$2]); if (off * off > 1e-4) bad = 1 } }
        $2 == "error" { looked++; if ($3 > 1e-8) bad = 1 }
        { print }
        END { exit bad || looked != 4 }'
}

# A third of either variance: half of it is noise, which 12 terms take in part for their own at 400 points, and miss at those left out.
@test "the error is the share of the variance that no factor explains" {
    sample '(2 * a - 1) + noise'
    indices | awk -F, '{ print } $2 == "error" { found = 1; exit !($3 > 0.49 && $3 < 0.56) } END { if (!found) exit 1 }'
}

@test "more terms than runs are refused" {
    sample a
    head -10 sample.csv >few.csv
    run -1 awk -v factors=3 -v degree=3 -v names=b -f "$map/sobol.awk" few.csv
    [[ "$output" == *'terms are too many for 9 runs' ]]
}

@test "the design fills the ranges of all factors evenly, and its first points are those of a shorter one" {
    awk -v runs=900 -f "$map/design.awk" >design.csv
    awk -v runs=30 -f "$map/design.awk" | cmp - <(head -31 design.csv)
    awk -F, 'NR > 1 {
            lattice[$6]++; size[$9 + 0]++; third[int(($2 - 0.2) / 0.5 * 3)]++; jitter[int($8 / 0.05)]++; yield += $3; seed[$10]++
            if ($2 < 0.2 || $2 > 0.7 || $3 + 0 < 273 || $3 + 0 > 1275 || $8 < 0 || $8 > 0.15) exit 1 }
        END { for (k in lattice) { n++; if (lattice[k] < 290 || lattice[k] > 310) exit 1 }
            for (k in size) { m++; if (size[k] < 170 || size[k] > 215) exit 1 }
            for (k = 0; k < 3; k++) if (third[k] < 290 || third[k] > 310 || jitter[k] < 285 || jitter[k] > 315) exit 1
            for (k in seed) s++
            exit !(n == 3 && m == 5 && s == 900 && yield / 900 > 770 && yield / 900 < 778) }' design.csv
}
