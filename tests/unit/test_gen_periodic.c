/* Periodic bodies: distances, clusters and statistics that go around them. */
#include "made.h"

#include "forest.h"

static struct made *make(const char *keys)
{
    return made_new(domain_deck("plate", keys));
}
static const char two_phases[] = "phases: {cg: CG, ufg: UFG}, ufg_fraction: 0.4";

/* --- cells and supercells -----------------------------------------------------------------------
 */

static void compare_clusters(const struct clusters *cell, const struct clusters *super, int64_t n)
{
    assert_int_equal(super->nodes, n * cell->nodes);
    for (int axis = 0; axis < 3; axis++)
        assert_int_equal(super->percolates[axis], cell->percolates[axis]);
}

/* Tolerance: rounding of sums of up to 1e5 equal terms. */
static void compare_statistics(const struct made *cell, const struct made *super, int64_t n)
{
    enum { MOST = 200000 };
    const struct findings *one = &cell->findings, *many = &super->findings;
    const bool sheet = specimen_is_sheet(&cell->recipe.specimen);
    assert_int_equal(super->sites.n_nodes, n * cell->sites.n_nodes);
    assert_true(one->ufg_fraction == many->ufg_fraction);
    compare_clusters(&one->cg, &many->cg, n);
    compare_clusters(&one->ufg, &many->ufg, n);
    /* Pieces that go around are one in the cell and in the supercell; those that do not are as many
     * as there are cells. */
    if (!one->cg_26.percolates[0] && !one->cg_26.percolates[1] && !one->cg_26.percolates[2])
        assert_int_equal(many->cg_26.count, n * one->cg_26.count);
    assert_int_equal(many->contact.touching, n * one->contact.touching);
    if (isfinite(one->contact.film) || isfinite(many->contact.film))
        assert_near(many->contact.film, one->contact.film, 1e-12);
    if (cell->recipe.topology->cores_apart) assert_relative(many->core_film, one->core_film, 1e-9);
    struct interface small = statistics_interface(&cell->structure, sheet);
    struct interface large = statistics_interface(&super->structure, sheet);
    assert_relative(large.crofton, small.crofton, 1e-12);
    assert_relative(large.faces, small.faces, 1e-12);
    for (int axis = 0; axis < (sheet ? 2 : 3); axis++)
        for (int64_t lag = 0; lag < cell->sites.count[axis]; lag++)
            assert_near(statistics_two_point(&super->structure, PHASE_UFG, axis, lag),
                        statistics_two_point(&cell->structure, PHASE_UFG, axis, lag), 1e-12);
    double *thickness = memory_new(MOST, sizeof *thickness), mean[2] = {0};
    int64_t found[2] = {statistics_shell(&cell->structure, MOST, thickness), 0};
    for (int64_t i = 0; i < found[0]; i++) mean[0] += thickness[i] / (double)found[0];
    found[1] = statistics_shell(&super->structure, MOST, thickness);
    for (int64_t i = 0; i < found[1]; i++) mean[1] += thickness[i] / (double)found[1];
    assert_int_equal(found[1], n * found[0]);
    if (found[0]) assert_relative(mean[1], mean[0], 1e-9);
    free(thickness);
}

static void compare_phases(const struct made *cell, const struct made *super)
{
    for (int64_t node = 0; node < super->sites.n_nodes; node++) {
        int64_t at[3];
        sites_index(&super->sites, node, at);
        const int64_t *count = cell->sites.count;
        int64_t there =
            sites_at(&cell->sites, at[0] % count[0], at[1] % count[1], at[2] % count[2]);
        assert_int_equal(super->structure.phase[node], cell->structure.phase[there]);
    }
}

/* One cubic cell and 3 x 3 x 3 of them are the same material, to the node: of every lattice, as
 * cells and as spheres. An odd number, as the lattice has a site in the middle of the body.
 * (geometric: ties are not split.) */
static void supercells_are_their_cells(void **state)
{
    static const char *const lattices[] = {"sc", "bcc", "fcc"}, *const cores[] = {"cell", "sphere"};
    const double edge[] = {1, 2 / sqrt(3), sqrt(2)};
    (void)state;
    for (int l = 0; l < 3; l++)
        for (int c = 0; c < 2; c++) {
            struct made *body[2];
            for (int i = 0; i < 2; i++) {
                char *keys =
                    memory_print("size: [%d um, %d um, %d um], spacing: 1 um, periodic: [x, y, z], "
                                 "topology: harmonic, lattice: %s, core: %s, core_distance: "
                                 "%.12g um, match: geometric, %s",
                                 i ? 48 : 16, i ? 48 : 16, i ? 48 : 16, lattices[l], cores[c],
                                 16 / edge[l], two_phases);
                body[i] = make(keys);
                free(keys);
            }
            assert_int_equal(body[1]->cores.own, 27 * body[0]->cores.own);
            compare_phases(body[0], body[1]);
            compare_statistics(body[0], body[1], 27);
            assert_true(body[0]->findings.ufg.percolates[0]);
            made_free(body[0]);
            made_free(body[1]);
        }
}

/* The same along two axes of a body that ends along the third, and of sheets. */
static void they_are_along_some_axes(void **state)
{
    static const char *const bodies[2][2] = {
        {"size: [20 um, 16 um, 16 um], spacing: 1 um, periodic: [z, y]",
         "size: [20 um, 48 um, 48 um], spacing: 1 um, periodic: [y, z]"},
        {"size: [16 um, 16 um, 3 um], spacing: 1 um, dimensions: 2, periodic: [x, y]",
         "size: [48 um, 48 um, 9 mm], spacing: 1 um, dimensions: 2, periodic: [x, y]"},
    };
    (void)state;
    for (int b = 0; b < 2; b++) {
        struct made *body[2];
        for (int i = 0; i < 2; i++) {
            char *keys =
                memory_print("%s, topology: harmonic, lattice: fcc, core_distance: 11.314 um, "
                             "match: geometric, %s",
                             bodies[b][i], two_phases);
            body[i] = make(keys);
            free(keys);
        }
        compare_phases(body[0], body[1]);
        compare_statistics(body[0], body[1], 9);
        assert_false(body[0]->cores.image[body[0]->cores.count - 1][b ? 2 : 0]);
        made_free(body[0]);
        made_free(body[1]);
    }
}

/* --- which cell is cut --------------------------------------------------------------------------
 */

/* The same cores, moved by whole spacings: what leaves the body on one side comes in on the other.
 */
static struct made *moved(const struct made *from, const char *keys, const int64_t by[3])
{
    struct made *made = memory_new(1, sizeof *made);
    const struct cores *cores = &from->cores;
    made->deck = domain_deck("plate", keys);
    made->recipe = recipe_read(made->deck);
    made->cores = (struct cores){
        .shape = cores->shape, .box = cores->box, .distance = cores->distance, .count = cores->own};
    made->cores.centre = memory_new((size_t)cores->own, sizeof *cores->centre);
    made->cores.order = memory_new((size_t)cores->own, sizeof *cores->order);
    for (int64_t c = 0; c < cores->own; c++) {
        made->cores.order[c] = cores->order[c];
        for (int axis = 0; axis < 3; axis++)
            made->cores.centre[c][axis] =
                cores->centre[c][axis] + (double)by[axis] * from->sites.spacing[axis];
    }
    cores_finish(&made->cores, cores->reach);
    made_fill(made);
    return made;
}

static void compare_moved(const struct made *one, const struct made *other, const int64_t by[3])
{
    for (int64_t node = 0; node < one->sites.n_nodes; node++) {
        int64_t at[3];
        sites_index(&one->sites, node, at);
        int64_t there = sites_at(&other->sites, at[0] + by[0], at[1] + by[1], at[2] + by[2]);
        assert_int_equal(one->structure.phase[node], other->structure.phase[there]);
    }
    const struct findings *a = &one->findings, *b = &other->findings;
    assert_int_equal(a->cg.count, b->cg.count);
    assert_int_equal(a->cg.largest, b->cg.largest);
    assert_int_equal(a->ufg.count, b->ufg.count);
    assert_int_equal(a->cg_26.count, b->cg_26.count);
    assert_int_equal(a->contact.touching, b->contact.touching);
    compare_statistics(one, other, 1);
}

/* Nothing tells where a periodic body was cut out of its material: not the nodes, not one of the
 * statistics.  The fraction is exact: half a node at most. */
static void any_cell_may_be_cut(void **state)
{
    static const char *const structures[] = {
        "size: [24 um, 20 um, 16 um], spacing: 1 um, topology: random, core_distance: 7 um",
        "size: [24 um, 20 um, 16 um], spacing: 1 um, topology: random, core: sphere, "
        "core_diameter: 6 um",
        "size: [24 um, 24 um, 24 um], spacing: 1 um, topology: harmonic, lattice: sc, "
        "core_distance: 12 "
        "um, jitter: 0.1",
        "size: [24 um, 24 um, 24 um], spacing: [1 um, 2 um, 1.5 um], topology: harmonic, lattice: "
        "bcc, core: "
        "sphere, core_distance: 20.785 um, jitter: 0.05",
    };
    const int64_t by[3] = {7, -11, 29};
    (void)state;
    for (int s = 0; s < 4; s++) {
        char *keys =
            memory_print("%s, periodic: [x, y, z], %s, seed: 4", structures[s], two_phases);
        struct made *one = make(keys), *other = moved(one, keys, by);
        assert_near(one->findings.ufg_fraction, 0.4, 0.5 / (double)one->sites.n_nodes);
        assert_int_equal(one->structure.threshold.split, 0);
        compare_moved(one, other, by);
        made_free(one);
        made_free(other);
        free(keys);
    }
}

/* An offset of whole spacings moves the structure.  One of parts of them leaves fewer nodes equal
 * by symmetry, to be split by the seed: those of one face in place of those of all six.  The
 * fraction is met all the same, and the interface is that of the geometry.  Cells of sc are cubes
 * of 0.6 of the volume, faces along those of nodes, whose area is then counted exactly but for t
 * = 5.01 spacings that are made 5 and for what is split of one face: 4 %. */
static void offsets_move_the_lattice(void **state)
{
    const int64_t by[3] = {7, -11, 29};
    (void)state;
    static const char keys[] =
        "size: [32 um, 32 um, 32 um], spacing: 1 um, periodic: [x, y, z], topology: "
        "harmonic, lattice: sc, core_distance: 32 um, %s, %s";
    char *text = memory_print(keys, two_phases, "match: geometric");
    struct made *one = make(text);
    free(text);
    text = memory_print(keys, two_phases, "match: geometric, offset: [7 um, -11 um, 29 um]");
    struct made *other = make(text);
    free(text);
    compare_moved(one, other, by);
    made_free(other);
    text =
        memory_print(keys, two_phases, "offset: [0.137 spacings, 0.291 spacings, 0.413 spacings]");
    other = make(text);
    assert_near(other->findings.ufg_fraction, 0.4, 0.5 / 32768);
    assert_int_equal(other->findings.cg.count, 1);
    const double area = 6 * pow(0.6, 2.0 / 3) / 32e-6; /* 1/m */
    assert_relative(statistics_interface(&other->structure, false).faces, area, 0.04);
    made_free(one);
    free(text);
    text = memory_print(keys, two_phases, "match: exact");
    one = make(text);
    assert_true(one->structure.threshold.split > 5 * other->structure.threshold.split);
    /* What is split of all faces is rough: twice the area. */
    assert_true(statistics_interface(&one->structure, false).faces > 1.9 * area);
    made_free(one);
    made_free(other);
    free(text);
}

/* Distances to the nearest image by looking at all of them, 5 x 5 x 5 images.  Tolerance: rounding
 * of squares of lengths of up to 1e-4 m. */
static void images_are_searched(void **state)
{
    (void)state;
    const struct cores_box box = {.size = {2e-5, 1.5e-5, 1e-5}, .periodic = {true, true, true}};
    struct cores cores = cores_random(CORE_CELL, 1e16, 0, &box, 3);
    assert_int_equal(cores.own, 30);
    for (int n = 0; n < 1000; n++) {
        const double point[3] = {(n % 10 - 4.5) * 2e-6, (n / 10 % 10 - 4.5) * 1.5e-6,
                                 (n / 100 - 4.5) * 1e-6};
        struct core_place found = cores_place(&cores, point, 1);
        double nearest = INFINITY, centre[3] = {0}, depth = INFINITY;
        for (int pass = 0; pass < 2; pass++)
            for (int64_t i = 0; i < 125 * cores.own; i++) {
                const int64_t image[3] = {i % 5 - 2, i / 5 % 5 - 2, i / 25 % 5 - 2};
                double at[3], square = 0, between = 0;
                for (int axis = 0; axis < 3; axis++) {
                    at[axis] = cores.centre[i / 125][axis] + (double)image[axis] * box.size[axis];
                    square += pow(at[axis] - point[axis], 2);
                    between += pow(at[axis] - centre[axis], 2);
                }
                if (pass == 0 && sqrt(square) < nearest) {
                    nearest = sqrt(square);
                    memcpy(centre, at, sizeof centre);
                }
                if (pass == 1 && between > 1e-18)
                    depth = fmin(depth, (square - nearest * nearest) / (2 * sqrt(between)));
            }
        assert_near(found.distance, nearest, 1e-17);
        assert_near(found.depth, depth, 1e-16);
    }
    cores_free(&cores);
}

/* --- clusters -----------------------------------------------------------------------------------
 */

static bool anywhere(const void *specimen, int64_t site, const double point[3])
{
    (void)specimen, (void)site, (void)point;
    return true;
}

/* Drawn by hand: '.' fine, else coarse. */
static struct clusters clusters_of(const int64_t count[3], const char *text, bool periodic)
{
    static const double cube[3] = {1, 1, 1};
    struct sites sites = sites_new(count, cube, anywhere, NULL);
    struct structure structure = {.sites = &sites};
    const size_t n = (size_t)sites.n_nodes;
    assert_int_equal(strlen(text), n);
    for (int axis = 0; axis < 3; axis++) sites.periodic[axis] = periodic && axis < 2;
    structure.counted = memory_new(n, 1);
    structure.phase = memory_new(n, 1);
    structure.core = memory_new(n, sizeof *structure.core);
    for (size_t node = 0; node < n; node++) {
        structure.counted[node] = 1;
        structure.phase[node] = text[node] == '.' ? PHASE_UFG : PHASE_CG;
    }
    struct clusters clusters = clusters_find(&structure, PHASE_CG, NEIGHBOURS_6);
    structure_free(&structure);
    sites_free(&sites);
    return clusters;
}

static void clusters_close_around_the_body(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int count;
        bool x, y;
    } cases[] = {
        {"....."
         "#####"
         "....."
         ".....",
         1, true, false},
        /* Both ends are reached, and nothing goes around. */
        {"##..."
         ".#..."
         ".####"
         ".....",
         1, false, false},
        /* Two pieces of the open body, one that goes around along x. */
        {"##.##"
         ".#.#."
         ".###."
         ".....",
         1, true, false},
        /* Around along the diagonal: connected along both axes. */
        {"##..."
         ".##.."
         "..##."
         "#..##",
         1, true, true},
        /* Corners are one piece. */
        {"#...#"
         "....."
         "....."
         "#...#",
         1, false, false},
        /* A plus. */
        {"..#.."
         "#####"
         "..#.."
         "..#..",
         1, true, true},
    };
    const int64_t count[3] = {5, 4, 1};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct clusters clusters = clusters_of(count, cases[c].text, true);
        assert_int_equal(clusters.count, cases[c].count);
        assert_int_equal(clusters.percolates[0], cases[c].x);
        assert_int_equal(clusters.percolates[1], cases[c].y);
        assert_true(clusters.percolates[2]);
    }
    assert_true(clusters_of(count, cases[1].text, false).percolates[0]);
    assert_int_equal(clusters_of(count, cases[4].text, false).count, 4);
}

/* A ring of n nodes, joined in any order, that goes twice around along x and once back along z: it
 * closes when its last pair is joined, not before. */
static void rings_close_with_their_last_pair(void **state)
{
    enum { N = 60 };
    static const int strides[] = {1, 7, 23, 59}; /* no common divisor with N */
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct forest forest = forest_new(N, true);
        for (int i = 0; i < N; i++) {
            const int node = i * strides[s] % N;
            const int32_t around[3] = {node == 10 || node == 40, 0, node == 40 ? -1 : 0};
            forest_join(&forest, node, (node + 1) % N, around);
            bool closed[3] = {false, false, false};
            for (int n = 0; n < N; n++)
                for (int axis = 0; axis < 3; axis++) closed[axis] |= forest.closed[n][axis];
            assert_int_equal(closed[0], i == N - 1);
            assert_false(closed[1]);
            assert_int_equal(closed[2], i == N - 1);
        }
        for (int n = 0; n < N; n++) assert_int_equal(forest_root(&forest, n), 0);
        forest_free(&forest);
    }
}

/* One core a body: its neighbours are images of itself, which do not count as one with it. */
static void images_of_a_core_are_others(void **state)
{
    (void)state;
    struct made *made =
        make("size: [8 um, 8 um, 8 um], spacing: 1 um, periodic: [x, y, z], topology: harmonic, "
             "lattice: sc, core_distance: 8 spacings, match: geometric, phases: {cg: CG, "
             "ufg: UFG}, ufg_fraction: 0.58");
    /* A cube of 6^3 nodes in 8^3, two layers between it and its images. */
    assert_int_equal(made->cores.own, 1);
    assert_int_equal(made->findings.cg.nodes, 216);
    assert_near(made->findings.contact.film, 2, 1e-12);
    assert_int_equal(made->findings.contact.touching, 0);
    double thickness[512];
    const int64_t found = statistics_shell(&made->structure, 512, thickness);
    assert_int_equal(found, 512 - 216);
    double least = INFINITY;
    for (int64_t i = 0; i < found; i++) least = fmin(least, thickness[i]);
    assert_near(least, 2, 1e-12);
    made_free(made);
}

/* --- against geometry ---------------------------------------------------------------------------
 */

/* One sphere a cube: radius from the fraction, interface 4 pi R^2 / a^3.  R is 33 spacings: that of
 * the outermost node is within a spacing's diagonal, and chords of less than a spacing are some
 * 1e-3 of the interface (the 13 directions of a sphere: below 1 %). */
static void a_sphere_has_its_interface(void **state)
{
    (void)state;
    struct made *made =
        make("size: [64 um, 64 um, 64 um], spacing: 1 um, periodic: [x, y, z], topology: "
             "harmonic, lattice: sc, core: sphere, core_distance: 64 um, ufg_fraction: 0.5, "
             "phases: {cg: CG, ufg: UFG}");
    const double a = 64e-6, radius = a * cbrt(0.5 * 3 / (4 * M_PI));
    assert_near(made->findings.reach, radius, 0.2e-6);
    assert_near(made->findings.core_film, a - 2 * made->findings.reach, 1e-12);
    struct interface interface = statistics_interface(&made->structure, false);
    assert_relative(interface.crofton, 4 * M_PI * radius * radius / (a * a * a), 0.01);
    assert_relative(interface.faces, 1.5 * 4 * M_PI * radius * radius / (a * a * a), 0.01);
    made_free(made);
}

/* --- the file -----------------------------------------------------------------------------------
 */

static void domains_say_after_what_they_repeat(void **state)
{
    (void)state;
    struct made *made =
        make("size: [40 um, 30 um, 20 um], spacing: 10 um, periodic: [z, x], topology: "
             "homogeneous, phase: Ni");
    struct domain domain = assemble_domain(&made->recipe, &made->structure, &made->findings, NULL);
    assert_string_equal(attributes_text(&domain.attributes, "periodic"), "xz");
    assert_true(attributes_number(&domain.attributes, "period_x_m", 0) == 40e-6);
    assert_true(attributes_number(&domain.attributes, "period_y_m", 0) == 0);
    assert_true(attributes_number(&domain.attributes, "period_z_m", 0) == 20e-6);
    assert_int_equal(domain.n_sets, 0);
    assert_int_equal(domain.n_nodes, 24);
    domain_free(&domain);
    made_free(made);
}

static void try_recipe(const void *keys)
{
    struct deck *deck = domain_deck("plate", keys);
    struct recipe recipe = recipe_read(deck);
    struct cores cores = recipe_cores(&recipe);
    cores_free(&cores);
    deck_free(deck);
}

static void what_cannot_be_is_told(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *said;
    } cases[] = {
        {"size: [9, 9, 9], spacing: 1, periodic: [x, y, z], topology: harmonic, lattice: sc, "
         "core_distance: "
         "5, phases: {cg: a, ufg: b}, ufg_fraction: 0.4",
         "9 m along x are 1.800000 of them; use the core_distance 9 m (1 cells) or 4.5 m (2), or "
         "the size 5 "
         "m or 10 m"},
        {"size: [10, 10, 12], spacing: 1, periodic: [x, z], topology: harmonic, lattice: sc, "
         "core_distance: "
         "5, phases: {cg: a, ufg: b}, ufg_fraction: 0.4",
         "12 m along z are 2.400000 cells of 5 m; use 10 m or 15 m"},
        {"size: [4, 4, 4], spacing: 1, periodic: [x, y, z], topology: random, core_distance: 5, "
         "phases: {cg: "
         "a, ufg: b}, ufg_fraction: 0.4",
         "so small that it holds 0.512 of a random core"},
        {"size: [10, 10, 1], dimensions: 2, spacing: 1, topology: harmonic, lattice: sc, "
         "core_distance: 5, offset: [1, 0, 0.5], phases: {cg: a, ufg: b}, ufg_fraction: 0.4",
         "its offset along z is 0"},
        {"size: [4, 4, 4.5], spacing: 1, periodic: [z], topology: homogeneous, phase: a",
         "the lattice fills the size exactly"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        assert_dies(EXIT_USER, cases[c].said, try_recipe, cases[c].keys);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(supercells_are_their_cells),
        cmocka_unit_test(they_are_along_some_axes),
        cmocka_unit_test(any_cell_may_be_cut),
        cmocka_unit_test(offsets_move_the_lattice),
        cmocka_unit_test(images_are_searched),
        cmocka_unit_test(clusters_close_around_the_body),
        cmocka_unit_test(rings_close_with_their_last_pair),
        cmocka_unit_test(images_of_a_core_are_others),
        cmocka_unit_test(a_sphere_has_its_interface),
        cmocka_unit_test(domains_say_after_what_they_repeat),
        cmocka_unit_test(what_cannot_be_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
