/* Fractions: rank selection, attainable fractions, and the analytic ones of lattice spheres. */
#include "check.h"

#include "fill.h"
#include "structure.h"
#include "topology.h"

#include "memory.h"

#include <stdlib.h>

/* One cubic cell of the core lattice, divided into n^3 nodes. */
static struct recipe cell_of(enum core_lattice lattice, enum core_shape shape, int64_t n,
                             double ufg_fraction)
{
    const double edge_over_distance[] = {1, 2 / sqrt(3), sqrt(2)};
    double edge = 2e-4;
    return (struct recipe){
        .specimen = {.size = {edge, edge, edge},
                     .spacing = {edge / (double)n, edge / (double)n, edge / (double)n},
                     .count = {n, n, n}},
        .topology = &topology_harmonic,
        .grip_phase = -1,
        .n_phases = 2,
        .lattice = lattice,
        .shape = shape,
        .distance = edge / edge_over_distance[lattice],
        .ufg_fraction = ufg_fraction,
        .seed = 7,
    };
}

struct outcome {
    struct threshold threshold;
    double reach;
};

static struct outcome make(const struct recipe *recipe)
{
    struct sites sites = fill_sites(&recipe->specimen);
    struct cores cores = recipe->topology->place(recipe);
    struct structure structure = structure_new(recipe, &sites, &cores);
    int64_t coarse = 0;
    for (int64_t node = 0; node < sites.n_nodes; node++)
        coarse += structure.phase[node] == PHASE_CG;
    assert_int_equal(coarse, structure.threshold.coarse);
    struct outcome outcome = {structure.threshold, structure_reach(&structure)};
    structure_free(&structure);
    cores_free(&cores);
    sites_free(&sites);
    return outcome;
}

/* Fine fraction of equal spheres of radius r on a cubic lattice of edge a = 1: spheres less the
 * lenses of pairs that overlap; exact while no three share a point. */
static double lens(double r, double d)
{
    return 2 * r > d ? M_PI * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12 : 0;
}

static double analytic(enum core_lattice lattice, double r)
{
    const double spheres[] = {1, 2, 4};
    const double near[][2] = {{6, 1}, {8, sqrt(3) / 2}, {12, sqrt(0.5)}};
    const double next[][2] = {{12, sqrt(2)}, {6, 1}, {6, 1}};
    return 1 - spheres[lattice] *
                   (4 * M_PI / 3 * r * r * r - near[lattice][0] / 2 * lens(r, near[lattice][1]) -
                    next[lattice][0] / 2 * lens(r, next[lattice][1]));
}

static double analytic_radius(enum core_lattice lattice, double fraction)
{
    double low = 0, high = 0.75;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        if (analytic(lattice, middle) > fraction)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void the_formula_gives_the_fractions_of_touching_spheres(void **state)
{
    (void)state;
    assert_near(analytic(LATTICE_SC, 0.5), 1 - M_PI / 6, 1e-12);
    assert_near(analytic(LATTICE_BCC, sqrt(3) / 4), 1 - M_PI * sqrt(3) / 8, 1e-12);
    assert_near(analytic(LATTICE_FCC, sqrt(0.125)), 1 - M_PI / sqrt(18), 1e-12);
}

/* The number of lattice points in a ball of R spacings is off its volume by about R^(3/2) at most
 * for these R (the theorem: R^(21/16), Heath-Brown 1999); here R >= 18, so that a radius is off by
 * R^(3/2) / (4 pi R^2) = 0.02 spacings or 1e-3 of itself, with overlaps some more: 2e-3. */
static void diameters_agree_with_the_analytic_fractions(void **state)
{
    (void)state;
    const double fractions[] = {0.2, 0.3, 0.4, 0.5, 0.6};
    for (int lattice = LATTICE_SC; lattice <= LATTICE_FCC; lattice++)
        for (int f = 0; f < 5; f++) {
            struct recipe recipe =
                cell_of((enum core_lattice)lattice, CORE_SPHERE, 64, fractions[f]);
            double radius = analytic_radius((enum core_lattice)lattice, fractions[f]);
            assert_relative(make(&recipe).reach / recipe.specimen.size[0], radius, 2e-3);
        }
}

/* Cells of the simple cubic and the face-centred lattice keep their shape when all faces move in:
 * shell = (1 - cbrt(1 - phi)) distance.  The error is a layer's share of the cell's surface: half a
 * spacing of 32 (fcc) in position at most, 0.5/64 of the edge. */
static void cells_have_the_uniform_shell_of_their_fraction(void **state)
{
    (void)state;
    const enum core_lattice lattices[] = {LATTICE_SC, LATTICE_FCC};
    for (int l = 0; l < 2; l++) {
        struct recipe recipe = cell_of(lattices[l], CORE_CELL, 64, 0.4);
        double shell = -2 * make(&recipe).reach;
        assert_near(shell, (1 - cbrt(0.6)) * recipe.distance, recipe.specimen.spacing[0]);
    }
}

static void exact_fractions_miss_by_half_a_node_at_most(void **state)
{
    (void)state;
    const int64_t sizes[] = {8, 16, 20, 31}; /* commensurate ones have large shells of equal rank */
    for (int s = 0; s < 4; s++)
        for (int lattice = LATTICE_SC; lattice <= LATTICE_FCC; lattice++)
            for (int shape = CORE_CELL; shape <= CORE_SPHERE; shape++) {
                struct recipe recipe =
                    cell_of((enum core_lattice)lattice, (enum core_shape)shape, sizes[s], 0.4);
                struct threshold threshold = make(&recipe).threshold;
                double wanted = 0.6 * (double)(sizes[s] * sizes[s] * sizes[s]);
                assert_near((double)threshold.coarse, wanted, 0.5);
            }
}

/* Whole spheres on commensurate lattices, counted by hand: 2 centres on cell corners of 8 nodes an
 * edge; squared distances (in half spacings) 3, 11, 19, 27, 35, 43 hold 8, 24, 24, 32, 48, 24
 * nodes: 2 x 136 = 272 or 2 x 160 = 320 of 512 are coarse. */
static void geometric_fractions_keep_whole_shells(void **state)
{
    (void)state;
    struct recipe recipe = cell_of(LATTICE_BCC, CORE_SPHERE, 8, 0.4);
    recipe.geometric = true;
    struct threshold threshold = make(&recipe).threshold;
    assert_near(1 - threshold.below, 0.46875, 1e-12);
    assert_near(1 - threshold.above, 0.375, 1e-12);
    assert_int_equal(threshold.coarse, 320);
    assert_int_equal(threshold.split, 0);
}

static void ties_are_split_by_the_seed(void **state)
{
    (void)state;
    enum { N = 1000 };
    int64_t score[N], site[N];
    uint8_t counted[N];
    for (int i = 0; i < N; i++) {
        score[i] = i < 100 ? -1 : 5;
        site[i] = i;
        counted[i] = i < 900;
    }
    const struct ranks ranks = {N, score, site, counted, NULL};
    struct threshold one = fraction_exact(&ranks, 0.5, 1);
    struct threshold two = fraction_exact(&ranks, 0.5, 2);
    assert_int_equal(one.counted, 900);
    assert_int_equal(one.coarse, 450);
    assert_int_equal(one.split, 800);
    int coarse = 0, different = 0;
    for (int i = 0; i < 900; i++) {
        bool is_coarse = fraction_is_coarse(&one, score[i], site[i]);
        coarse += is_coarse;
        different += is_coarse != fraction_is_coarse(&two, score[i], site[i]);
    }
    assert_int_equal(coarse, 450);
    /* 800 nodes of which 350 are drawn twice: 394 +- 14 differ, and never none. */
    assert_in_range(different, 394 - 70, 394 + 70);
}

/* Nodes of different volumes: the fraction is of the volume, within half of the largest node's;
 * without ties the coarse ones are those of the lowest scores. */
static void fractions_are_of_the_volume(void **state)
{
    (void)state;
    enum { N = 1000 };
    int64_t score[N], site[N];
    uint8_t counted[N];
    double weight[N], total = 0;
    for (int i = 0; i < N; i++) {
        score[i] = i / 10 * 7 % 100; /* ten nodes of each score */
        site[i] = i;
        counted[i] = i % 17 != 0;
        weight[i] = 1e-9 * (0.05 + i * 37 % 100 / 100.0);
        total += counted[i] ? weight[i] : 0;
    }
    const struct ranks ranks = {N, score, site, counted, weight};
    for (double wanted = 0.0005; wanted < 1; wanted += 0.0371) {
        const struct threshold threshold = fraction_exact(&ranks, wanted, 3);
        double coarse = 0;
        int64_t most = -1, least = 100, count = 0;
        for (int i = 0; i < N; i++) {
            if (!counted[i]) continue;
            const bool is_coarse = fraction_is_coarse(&threshold, score[i], site[i]);
            coarse += is_coarse ? weight[i] : 0;
            count += is_coarse;
            if (is_coarse && score[i] > most) most = score[i];
            if (!is_coarse && score[i] < least) least = score[i];
        }
        assert_near(coarse / total, wanted, 0.5 * 1.05e-9 / total);
        assert_relative(threshold.share, coarse / total, 1e-12);
        assert_int_equal(threshold.coarse, count);
        assert_true(most <= least);
        const struct threshold whole = fraction_geometric(&ranks, wanted);
        assert_true(whole.below <= wanted + 1e-12 && wanted <= whole.above + 1e-12);
        assert_near(whole.share, wanted, 0.5 * (whole.above - whole.below) + 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_formula_gives_the_fractions_of_touching_spheres),
        cmocka_unit_test(diameters_agree_with_the_analytic_fractions),
        cmocka_unit_test(cells_have_the_uniform_shell_of_their_fraction),
        cmocka_unit_test(exact_fractions_miss_by_half_a_node_at_most),
        cmocka_unit_test(geometric_fractions_keep_whole_shells),
        cmocka_unit_test(ties_are_split_by_the_seed),
        cmocka_unit_test(fractions_are_of_the_volume),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
