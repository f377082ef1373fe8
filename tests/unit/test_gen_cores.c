/* Cores: where points stand among them, the file that keeps them, and cost linear in nodes. */
#include "check.h"
#include "taken.h"

#include "fill.h"
#include "findings.h"
#include "memory.h"
#include "random.h"
#include "topology.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const double size[3] = {1e-3, 5e-4, 2e-4};
static const struct cores_box body = {.size = {1e-3, 5e-4, 2e-4}};

/* Nearest centre and nearest face of its cell, by looking at all of them. */
static struct core_place look_at_all(const struct cores *cores, const double point[3])
{
    struct core_place place = {.distance = INFINITY, .depth = INFINITY};
    for (int pass = 0; pass < 2; pass++)
        for (int64_t c = 0; c < cores->count; c++) {
            double to_point = 0, to_nearest = 0;
            for (int axis = 0; axis < 3; axis++) {
                to_point += pow(cores->centre[c][axis] - point[axis], 2);
                to_nearest += pow(cores->centre[c][axis] - cores->centre[place.core][axis], 2);
            }
            if (pass == 0 && sqrt(to_point) < place.distance)
                place = (struct core_place){c, sqrt(to_point), INFINITY};
            if (pass == 1 && c != place.core)
                place.depth = fmin(place.depth, (to_point - place.distance * place.distance) /
                                                    (2 * sqrt(to_nearest)));
        }
    return place;
}

/* Tolerance: rounding of squares of lengths below 2 mm. */
static void search_finds_what_looking_at_all_finds(void **state)
{
    (void)state;
    struct cores sets[] = {
        cores_lattice(LATTICE_SC, CORE_CELL, 9e-5, 0, &body, 1),
        cores_lattice(LATTICE_BCC, CORE_CELL, 7e-5, 0.3, &body, 2),
        cores_lattice(LATTICE_FCC, CORE_CELL, 1.1e-4, 0.05, &body, 3),
        cores_random(CORE_CELL, 2e12, 3e-4, &body, 4),
        cores_random(CORE_SPHERE, 5e11, 0, &body, 5),
    };
    struct random_stream *stream = random_new(1, "points");
    for (int s = 0; s < 5; s++) {
        for (int n = 0; n < 300; n++) {
            double point[3];
            for (int axis = 0; axis < 3; axis++)
                point[axis] = (random_uniform(stream) - 0.5) * size[axis];
            struct core_place found = cores_place(&sets[s], point, 1);
            struct core_place expected = look_at_all(&sets[s], point);
            assert_int_equal(found.core, expected.core);
            assert_near(found.distance, expected.distance, 1e-15);
            assert_near(found.depth, expected.depth, 1e-14);
        }
        cores_free(&sets[s]);
    }
    random_free(stream);
}

static void lattices_have_their_neighbours(void **state)
{
    (void)state;
    const double per_cell[] = {1, 2, 4}, edge[] = {1, 2 / sqrt(3), sqrt(2)};
    const struct cores_box block = {.size = {1e-3, 1e-3, 1e-3}};
    for (int lattice = 0; lattice < 3; lattice++) {
        struct cores cores =
            cores_lattice((enum core_lattice)lattice, CORE_SPHERE, 1e-4, 0, &block, 1);
        assert_near(cores_nearest_pair(&cores, 1e-4), 1e-4, 1e-15);
        /* Centres inside a cube of 1 mm: its volume times the density, give or take half a cell's
         * layer on each of the six faces. */
        double cells = 1e-3 / (edge[lattice] * 1e-4);
        int64_t in_body = 0;
        for (int64_t c = 0; c < cores.count; c++)
            in_body += fabs(cores.centre[c][0]) < 5e-4 && fabs(cores.centre[c][1]) < 5e-4 &&
                       fabs(cores.centre[c][2]) < 5e-4;
        assert_near((double)in_body, per_cell[lattice] * cells * cells * cells,
                    per_cell[lattice] * 3 * cells * cells);
        cores_free(&cores);
    }
}

static void orders_are_permutations(void **state)
{
    (void)state;
    struct cores cores = cores_random(CORE_CELL, 1e12, 1e-4, &body, 9);
    uint8_t *seen = memory_new((size_t)cores.count, 1);
    int64_t fixed = 0;
    for (int64_t c = 0; c < cores.count; c++) {
        assert_in_range(cores.order[c], 0, cores.count - 1);
        assert_int_equal(seen[cores.order[c]]++, 0);
        fixed += cores.order[c] == c;
    }
    /* A random permutation has one fixed point on average, Poisson: 12 has the odds 1e-9. */
    assert_in_range(fixed, 0, 12);
    free(seen);
    cores_free(&cores);
}

static struct recipe plate_of(const struct topology *topology, double spacing)
{
    struct recipe recipe = {
        .specimen = {.spacing = {spacing, spacing, spacing}},
        .topology = topology,
        .grip_phase = -1,
        .n_phases = 2,
        .lattice = LATTICE_FCC,
        .distance = 1.3e-4,
        .jitter = 0.05,
        .ufg_fraction = 0.4,
        .minimum_shell = 1,
        .seed = 11,
    };
    for (int axis = 0; axis < 3; axis++) {
        recipe.specimen.size[axis] = size[axis];
        recipe.specimen.count[axis] = (int64_t)llround(size[axis] / spacing);
    }
    return recipe;
}

/* Cores that went through a file give the very same nodes, at twice the resolution too. */
static void files_keep_the_structure_at_any_spacing(void **state)
{
    (void)state;
    char path[] = "/tmp/hstools-cores-XXXXXX";
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    close(descriptor);
    const struct topology *kinds[] = {&topology_harmonic, &topology_random};
    for (int k = 0; k < 2; k++) {
        struct recipe coarse = plate_of(kinds[k], 2e-5), fine = plate_of(kinds[k], 1e-5);
        struct cores written = coarse.topology->place(&coarse);
        taken_forget();
        cores_write(&written, kinds[k]->deck.name, path);
        struct cores read = cores_read(path, kinds[k]->deck.name);
        assert_int_equal(read.count, written.count);
        assert_memory_equal(read.centre, written.centre, (size_t)read.count * sizeof *read.centre);
        assert_memory_equal(read.order, written.order, (size_t)read.count * sizeof *read.order);
        struct cores placed = fine.topology->place(&fine);
        struct sites sites = fill_sites(&fine.specimen);
        struct structure direct = structure_new(&fine, &sites, &placed);
        struct structure through = structure_new(&fine, &sites, &read);
        assert_memory_equal(direct.phase, through.phase, (size_t)sites.n_nodes);
        structure_free(&direct);
        structure_free(&through);
        sites_free(&sites);
        cores_free(&placed);
        cores_free(&read);
        cores_free(&written);
    }
    unlink(path);
}

/* The same structure at half the spacing: most of a coarse node's eight parts have its phase.  A
 * node of the surface between phases is right to a part only; those are S_V spacing of all, a third
 * to a half here. */
static void half_the_spacing_is_the_same_structure(void **state)
{
    (void)state;
    struct recipe coarse = plate_of(&topology_harmonic, 1e-5);
    struct recipe fine = plate_of(&topology_harmonic, 5e-6);
    struct cores cores = coarse.topology->place(&coarse);
    struct sites coarse_sites = fill_sites(&coarse.specimen);
    struct sites fine_sites = fill_sites(&fine.specimen);
    struct structure one = structure_new(&coarse, &coarse_sites, &cores);
    struct structure two = structure_new(&fine, &fine_sites, &cores);
    int64_t same = 0;
    for (int64_t node = 0; node < fine_sites.n_nodes; node++) {
        int64_t at[3];
        sites_index(&fine_sites, node, at);
        int64_t parent = sites_at(&coarse_sites, at[0] / 2, at[1] / 2, at[2] / 2);
        same += two.phase[node] == one.phase[parent];
    }
    assert_true((double)same > 0.85 * (double)fine_sites.n_nodes);
    /* The shell is a property of the geometry: the same within a coarse spacing. */
    assert_near(structure_reach(&one), structure_reach(&two), 0.5e-5);
    structure_free(&one);
    structure_free(&two);
    sites_free(&coarse_sites);
    sites_free(&fine_sites);
    cores_free(&cores);
}

static double seconds_of(double spacing, int64_t *n_nodes)
{
    struct recipe recipe = plate_of(&topology_harmonic, spacing);
    double least = INFINITY;
    for (int run = 0; run < 2; run++) {
        clock_t start = clock();
        struct cores cores = recipe.topology->place(&recipe);
        struct sites sites = fill_sites(&recipe.specimen);
        struct structure structure = structure_new(&recipe, &sites, &cores);
        *n_nodes = sites.n_nodes;
        structure_free(&structure);
        sites_free(&sites);
        cores_free(&cores);
        least = fmin(least, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

/* A million nodes against an eighth of them: the processor's time grows by 8 where the work is
 * linear, by 64 where it is quadratic; between them 20, for a machine that is shared. */
static void cost_is_linear_in_nodes(void **state)
{
    (void)state;
    int64_t few, many;
    double short_run = seconds_of(1e-5, &few), long_run = seconds_of(5e-6, &many);
    assert_int_equal(many, 8 * few);
    if (long_run > 20 * short_run)
        fail_msg("%lld nodes took %g s, %lld took %g s", (long long)few, short_run, (long long)many,
                 long_run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(search_finds_what_looking_at_all_finds),
        cmocka_unit_test(lattices_have_their_neighbours),
        cmocka_unit_test(orders_are_permutations),
        cmocka_unit_test(files_keep_the_structure_at_any_spacing),
        cmocka_unit_test(half_the_spacing_is_the_same_structure),
        cmocka_unit_test(cost_is_linear_in_nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
