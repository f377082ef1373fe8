/* Oblong cells: lattices with three spacings. */
#include "made.h"

#include "random.h"
#include "steps.h"

static struct made *make(const char *keys)
{
    return made_with_domain(domain_deck("plate", keys));
}

/* --- the body --------------------------------------------------------------------------------- */

static void plates_are_filled_by_their_cells(void **state)
{
    (void)state;
    struct made *made = make(
        "topology: homogeneous, phase: CG, spacing: [10 um, 20 um, 50 um], "
        "size: [0.8 mm, 0.2 mm, 2 spacings], grips: {length: 3 spacings, phase: structure}, "
        "gauge: {length: 0.4 mm}, sets: [{name: box, box: [[-2 spacings, -2 spacings, -50 um], "
        "[2 spacings, 2 spacings, 0]]}]");
    const struct domain *domain = &made->domain;
    double sum = 0;
    assert_int_equal(domain->n_nodes, 80 * 10 * 2);
    for (int64_t n = 0; n < domain->n_nodes; n++) sum += domain->volume[n];
    assert_relative(sum, 0.8e-3 * 0.2e-3 * 1e-4, 1e-12);
    assert_near(domain->x[0], -395e-6, 1e-18);
    assert_near(domain->y[80], -70e-6, 1e-18);
    assert_near(domain->z[800], 25e-6, 1e-18);
    const struct attributes *facts = &domain->attributes;
    assert_true(attributes_number(facts, "spacing_m", 0) == 10e-6);
    assert_true(attributes_number(facts, "spacing_y_m", 0) == 20e-6);
    assert_true(attributes_number(facts, "spacing_z_m", 0) == 50e-6);
    assert_relative(attributes_number(facts, "section_m2", 0), 0.2e-3 * 1e-4, 1e-12);
    assert_relative(attributes_number(facts, "gauge_length_m", 0), 0.41e-3, 1e-12);
    assert_int_equal(domain_set(domain, "grip_left")->count, 3 * 10 * 2);
    /* Spacings of its own axis: 4 x 4 nodes, of two layers the lower one. */
    assert_int_equal(domain_set(domain, "box")->count, 4 * 4);
    made_free(made);
}

/* Facts that a cube or a sheet does not have are not in the file. */
static void cubes_and_sheets_say_no_more_than_before(void **state)
{
    (void)state;
    struct made *cubes =
        make("topology: homogeneous, phase: CG, spacing: [1, 1, 1], size: [4, 4, 4]");
    struct made *sheet = make("topology: homogeneous, phase: CG, dimensions: 2, "
                              "spacing: [1, 2, 0.5], size: [4, 4, 0.5]");
    assert_true(attributes_number(&cubes->domain.attributes, "spacing_y_m", -1) == -1);
    assert_true(attributes_number(&cubes->domain.attributes, "spacing_z_m", -1) == -1);
    assert_true(attributes_number(&sheet->domain.attributes, "spacing_y_m", -1) == 2);
    assert_true(attributes_number(&sheet->domain.attributes, "spacing_z_m", -1) == -1);
    assert_int_equal(sheet->domain.n_nodes, 8);
    assert_near(sheet->domain.volume[0], 1, 1e-15);
    made_free(cubes);
    made_free(sheet);
}

static void try_deck(const void *keys)
{
    recipe_read(domain_deck("plate", keys));
}

static void what_does_not_fit_is_told(void **state)
{
    (void)state;
    const char ragged[] = "topology: homogeneous, phase: CG, spacing: [1, 2, 1], size: [4, 5, 4]";
    assert_dies(EXIT_USER, "5 m is 2.500000 spacings of 2 m", try_deck, ragged);
    const char two[] = "topology: homogeneous, phase: CG, spacing: [1, 2], size: [4, 4, 4]";
    assert_dies(EXIT_USER, "'spacing' is a list of 3 lengths", try_deck, two);
    const char thick[] = "topology: homogeneous, phase: CG, dimensions: 2, spacing: [1, 2, 3], "
                         "size: [4, 4, 1]";
    assert_dies(EXIT_USER, "the thickness 1 m is not the third spacing, 3 m", try_deck, thick);
}

/* --- lengths on the lattice ------------------------------------------------------------------- */

/* Layers between two nodes are as thick as they are, along each axis; cubes have distance less one.
 */
static void films_are_lengths(void **state)
{
    (void)state;
    const double oblong[] = {1, 2, 5}, cube[] = {3, 3, 3};
    const int along[3][3] = {{4, 0, 0}, {0, 4, 0}, {0, 0, -4}}, slanted[] = {2, -1, 2};
    for (int axis = 0; axis < 3; axis++) {
        struct step step = steps_to(oblong, along[axis]);
        assert_near(steps_film(&step), 3 * oblong[axis], 1e-14);
    }
    struct step step = steps_to(cube, slanted);
    assert_true(steps_film(&step) == 2);
}

/* In films of n layers of cells between two cores, the local thickness is that of the layers
 * everywhere. */
static void shells_are_lengths(void **state)
{
    enum { LAYERS = 3 };
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        struct made *made = make("topology: homogeneous, phase: CG, spacing: [1, 2, 1.5], "
                                 "size: [30, 60, 45]");
        struct structure *structure = &made->structure;
        int64_t fine = 0;
        for (int64_t node = 0; node < made->sites.n_nodes; node++) {
            int64_t at[3];
            sites_index(&made->sites, node, at);
            const bool film = at[axis] >= 14 && at[axis] < 14 + LAYERS;
            structure->phase[node] = film ? PHASE_UFG : PHASE_CG;
            structure->core[node] = at[axis] < 14;
            fine += film;
        }
        double *thickness = memory_new((size_t)fine, sizeof *thickness);
        assert_int_equal(statistics_shell(structure, fine, thickness), fine);
        for (int64_t n = 0; n < fine; n++)
            assert_near(thickness[n], LAYERS * made->sites.spacing[axis], 1e-12);
        struct contact contact = clusters_contact(structure, 12);
        assert_near(contact.film, LAYERS * made->sites.spacing[axis], 1e-12);
        assert_int_equal(contact.touching, 0);
        free(thickness);
        made_free(made);
    }
}

/* --- structures ------------------------------------------------------------------------------- */

/* Cells of fcc, 0.25 mm apart, leave a shell of (1 - cbrt(0.6)) core distances whatever the
 * lattice: within half an edge along x.  The film on nodes is not thinner than the shell by more
 * than the longest edge. */
static void harmonic_structures_keep_their_shell(void **state)
{
    static const char *const spacings[] = {
        "[12.5 um, 12.5 um, 12.5 um]", "[6.25 um, 12.5 um, 12.5 um]", "[12.5 um, 6.25 um, 10 um]",
        "[12.5 um, 6.25 um, 12.5 um]"};
    (void)state;
    for (int i = 0; i < 4; i++) {
        char *keys = memory_print("topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: fcc, "
                                  "core_distance: 0.25 mm, ufg_fraction: 0.4, spacing: %s, "
                                  "size: [1 mm, 0.5 mm, 0.25 mm]",
                                  spacings[i]);
        struct made *made = make(keys);
        const double shell = (1 - cbrt(0.6)) * 250e-6;
        assert_near(made->findings.core_film, shell, 5e-6);
        assert_near(made->findings.ufg_fraction, 0.4, 0.5 / (double)made->sites.n_nodes);
        assert_null(made->recipe.topology->fault(&made->recipe, &made->findings));
        assert_true(made->findings.contact.film * made->sites.spacing[0] > shell - 12.5e-6 - 5e-6);
        for (int axis = 0; axis < 3; axis++) assert_true(made->findings.ufg.percolates[axis]);
        made_free(made);
        free(keys);
    }
}

/* One layer of long cells between two cores is a shell by default; asked for as a length it is
 * measured. */
static void the_least_shell_is_a_layer_or_a_length(void **state)
{
    (void)state;
    const char keys[] = "topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: sc, "
                        "core_distance: 8 spacings, ufg_fraction: 0.5, spacing: [2, 1, 1], "
                        "size: [64, 32, 32]%s";
    char *usual = memory_print(keys, ""), *length = memory_print(keys, ", minimum_shell: 4");
    struct made *made = make(usual), *asked = make(length);
    assert_null(made->recipe.topology->fault(&made->recipe, &made->findings));
    assert_true(asked->findings.contact.film * 2 < 4);
    char *fault = asked->recipe.topology->fault(&asked->recipe, &asked->findings);
    assert_non_null(strstr(fault, "minimum_shell"));
    free(fault);
    made_free(made);
    made_free(asked);
    free(usual);
    free(length);
}

/* Turned by a right angle, with the edges exchanged, a body is the same one: node for node its
 * phases, and the structure is judged alike. */
static void structures_turn_with_the_body(void **state)
{
    (void)state;
    const char keys[] =
        "topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: bcc, "
        "core_distance: 0.25 mm, jitter: 0.05, ufg_fraction: 0.41, size: [1 mm, 0.5 mm, 0.25 mm], "
        "grips: {length: 0.1 mm, phase: UFG}, gauge: {length: 0.6 mm}, spacing: %s";
    char *lying = memory_print(keys, "[10 um, 12.5 um, 12.5 um]");
    char *standing = memory_print(keys, "[12.5 um, 10 um, 12.5 um], angle: 90 degree");
    struct made *one = make(lying), *other = make(standing);
    const int64_t *count = one->sites.count;
    assert_int_equal(other->sites.n_nodes, one->sites.n_nodes);
    int64_t different = 0;
    for (int64_t node = 0; node < one->sites.n_nodes; node++) {
        int64_t at[3];
        sites_index(&one->sites, node, at);
        const int64_t there = sites_at(&other->sites, count[1] - 1 - at[1], at[0], at[2]);
        assert_true(there >= 0);
        different += one->structure.phase[node] != other->structure.phase[there];
    }
    /* Those of equal rank alone, which a hash of the site splits. */
    assert_true(different <= one->structure.threshold.split);
    assert_int_equal(one->structure.threshold.coarse, other->structure.threshold.coarse);
    for (int axis = 0; axis < 3; axis++)
        assert_true(one->findings.ufg.percolates[axis] == other->findings.ufg.percolates[axis]);
    assert_true(one->findings.ufg.percolates[0]);
    assert_int_equal(domain_set(&one->domain, "grip_left")->count,
                     domain_set(&other->domain, "grip_left")->count);
    /* Its planes lie between two layers here: the outer one lying, both standing. */
    assert_int_equal(2 * domain_set(&one->domain, "gauge_left")->count,
                     domain_set(&other->domain, "gauge_left")->count);
    assert_relative(attributes_number(&other->domain.attributes, "gauge_length_m", 0), 0.6e-3,
                    1e-12);
    made_free(one);
    made_free(other);
    free(lying);
    free(standing);
}

/* A share p drawn n = 2e5 times has the standard deviation sqrt(p (1 - p) / n) < 0.0008; four of
 * them. */
static void direction_shares_are_those_of_the_cells(void **state)
{
    enum { DRAWN = 200000 };
    static const double spacings[][3] = {{1, 1 + 1e-12, 1}, {1, 2, 3}, {6, 1, 1}};
    (void)state;
    for (int i = 0; i < 3; i++) {
        const double *spacing = spacings[i];
        struct random_stream *stream = random_new(3, "directions");
        double share[NEIGHBOURS_26], drawn[NEIGHBOURS_26] = {0}, sum = 0;
        statistics_direction_shares(spacing, share);
        for (int n = 0; n < DRAWN; n++) {
            double at[3], best = 0;
            int nearest = 0;
            for (int axis = 0; axis < 3; axis++) at[axis] = random_gaussian(stream);
            for (int o = 0; o < NEIGHBOURS_26; o++) {
                double dot = 0, square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    const double part = clusters_offset[o][axis] * spacing[axis];
                    dot += at[axis] * part;
                    square += part * part;
                }
                if (fabs(dot) / sqrt(square) > best) nearest = o;
                best = fmax(best, fabs(dot) / sqrt(square));
            }
            drawn[nearest] += 1.0 / DRAWN;
        }
        for (int o = 0; o < NEIGHBOURS_26; o++) {
            assert_near(2 * share[o], drawn[o], 0.0032);
            sum += 2 * share[o];
        }
        assert_near(sum, 1, 1e-12);
        /* Nearly cubes: counting against the closed form. */
        for (int o = 0; i == 0 && o < NEIGHBOURS_26; o++) {
            const int *offset = clusters_offset[o];
            const int kind = abs(offset[0]) + abs(offset[1]) + abs(offset[2]) - 1;
            assert_near(share[o], statistics_direction_share[kind], 1e-4);
        }
        random_free(stream);
    }
}

/* A sphere and, in a sheet, a disc, of 15 of the longest edges in radius: their surface and
 * circumference have all directions, for which the weights are made.  The whole interface lies
 * inside, so that its crossings are all found, but a box of n nodes along an axis has n - 1 pairs:
 * that much too many a pair.  Chords below an edge are lost, and nodes decide by their centres: 0.5
 * % is allowed (0.04 and 0.06 % measured). */
static void round_interfaces_have_their_area(void **state)
{
    (void)state;
    static const char *const cells[] = {"spacing: [0.5, 1, 0.8], size: [40, 40, 40]",
                                        "dimensions: 2, spacing: [0.5, 1, 3], size: [40, 40, 3]"};
    for (int i = 0; i < 2; i++) {
        char *keys = memory_print("topology: homogeneous, phase: CG, %s", cells[i]);
        struct made *made = make(keys);
        double share[NEIGHBOURS_26], excess = 0;
        statistics_direction_shares(made->sites.spacing, share);
        for (int64_t node = 0; node < made->sites.n_nodes; node++) {
            double at[3];
            sites_position(&made->sites, node, at);
            const double square = at[0] * at[0] + at[1] * at[1] + at[2] * at[2];
            made->structure.phase[node] = (uint8_t)(square < 15 * 15 ? PHASE_CG : PHASE_UFG);
        }
        /* In the plane: half of the angles between a direction and the next ones, over the half
         * turn. */
        const double plane[] = {atan(2) / M_PI, 0.5 - atan(2) / M_PI, 0, 0.25, 0.25};
        for (int o = 0; o < NEIGHBOURS_26; o++) {
            double pairs = 1; /* of those that an endless lattice would have */
            for (int axis = 0; axis < 3; axis++)
                if (clusters_offset[o][axis] && made->sites.count[axis] > 1)
                    pairs *= 1 - 1 / (double)made->sites.count[axis];
            excess += (i == 0 ? 2 * share[o] : o < 5 ? plane[o] : 0) / pairs;
        }
        const struct interface found = statistics_interface(&made->structure, i == 1);
        const double exact = i == 0 ? 4 * M_PI * 15 * 15 / pow(40, 3) : 2 * M_PI * 15 / (40.0 * 40);
        assert_relative(found.crofton, exact * excess, 0.005);
        made_free(made);
        free(keys);
    }
}

/* A straight interface across x or y of a sheet: per length, the directions find their cosines to
 * its normal.  With a cell half as long along x the diagonals lie at atan 2, the sectors of x, y
 * and each diagonal are atan 2, pi/2 - atan 2 and pi/4 of the half turn: pi/2 (0.352 + 0.5/sqrt 5)
 * = 0.905 and pi/2 (0.148 + 1/sqrt 5) = 0.934 of the length. */
static void straight_interfaces_weigh_directions_by_their_sectors(void **state)
{
    (void)state;
    for (int axis = 0; axis < 2; axis++) {
        struct made *made = make("topology: homogeneous, phase: CG, dimensions: 2, "
                                 "spacing: [0.5, 1, 3], size: [100, 200, 3]");
        for (int64_t node = 0; node < made->sites.n_nodes; node++) {
            double at[3];
            sites_position(&made->sites, node, at);
            made->structure.phase[node] = (uint8_t)(at[axis] < 0 ? PHASE_CG : PHASE_UFG);
        }
        const double sector = axis == 0 ? atan(2) : M_PI / 2 - atan(2);
        const double cosine = axis == 0 ? 1 / sqrt(5) : 2 / sqrt(5);
        /* 200 nodes have 199 pairs. */
        const double exact = M_PI / 2 * (sector / M_PI + 0.5 * cosine) / (axis == 0 ? 100 : 200);
        const struct interface found = statistics_interface(&made->structure, true);
        assert_relative(found.crofton, exact * 200 / 199, 1e-12);
        made_free(made);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plates_are_filled_by_their_cells),
        cmocka_unit_test(cubes_and_sheets_say_no_more_than_before),
        cmocka_unit_test(what_does_not_fit_is_told),
        cmocka_unit_test(films_are_lengths),
        cmocka_unit_test(shells_are_lengths),
        cmocka_unit_test(harmonic_structures_keep_their_shell),
        cmocka_unit_test(the_least_shell_is_a_layer_or_a_length),
        cmocka_unit_test(structures_turn_with_the_body),
        cmocka_unit_test(direction_shares_are_those_of_the_cells),
        cmocka_unit_test(straight_interfaces_weigh_directions_by_their_sectors),
        cmocka_unit_test(round_interfaces_have_their_area),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
