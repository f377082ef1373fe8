/* Bodies that cells fill in part: round, notched, holed, waisted and turned ones, their volumes,
 * nodes and sets. */
#include "dies.h"

#include "assemble.h"
#include "fill.h"
#include "memory.h"
#include "outline.h"
#include "polygon.h"
#include "random.h"
#include "topology.h"

#include <stdlib.h>

/* --- a circle and a polygon ------------------------------------------------------------------- */

/* Segments, sectors and whole figures that everybody knows. */
static void discs_cut_polygons_by_their_formulas(void **state)
{
    (void)state;
    static const double origin[2] = {0, 0}, aside[2] = {0.3, -0.2};
    const struct polygon square = polygon_box(-1, 1, -1, 1), corner = polygon_box(0, 9, 0, 9),
                         half = polygon_box(0.5, 9, -9, 9), distant = polygon_box(3, 4, 3, 4);
    assert_relative(polygon_in_disc(&square, aside, 0.5), M_PI * 0.25, 1e-15);
    assert_relative(polygon_in_disc(&square, aside, 5), 4, 1e-14);
    assert_relative(polygon_in_disc(&corner, origin, 2), M_PI, 1e-15);
    /* x > 1/2 of the unit disc: acos(1/2) - sqrt(3)/4. */
    assert_relative(polygon_in_disc(&half, origin, 1), M_PI / 3 - sqrt(3) / 4, 1e-14);
    assert_near(polygon_in_disc(&distant, origin, 2), 0, 1e-15);
    /* The square of side 2 in the circle of radius 1.2: circle less four segments. */
    const double angle = acos(1 / 1.2);
    assert_relative(polygon_in_disc(&square, origin, 1.2),
                    1.44 * (M_PI - 4 * (angle - sin(angle) * cos(angle))), 1e-14);
    /* A triangle: half of the square. */
    struct polygon triangle = {3, {{-1, -1}, {1, -1}, {1, 1}}};
    assert_relative(polygon_in_disc(&triangle, origin, 0.5), M_PI / 8, 1e-14);
}

static void polygons_are_cut_by_lines(void **state)
{
    (void)state;
    const struct polygon box = polygon_box(-2, 2, -1, 1);
    struct polygon part = polygon_below(&box, 0, 1, 0.5);
    assert_relative(polygon_area(&part), 5, 1e-15);
    part = polygon_below(&part, 1, -1, 0.25);
    assert_relative(polygon_area(&part), 2.5 * 0.75, 1e-15);
    struct polygon diamond = {4, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    part = polygon_below(&diamond, 0, 1, 0.5);
    assert_int_equal(part.count, 5);
    assert_relative(polygon_area(&part), 2 - 0.25, 1e-15);
    part = polygon_below(&diamond, 0, 1, -2);
    assert_near(polygon_area(&part), 0, 0);
}

/* --- bodies ----------------------------------------------------------------------------------- */

static struct deck *parse(const char *keys)
{
    char *text = memory_print("domain: {topology: homogeneous, phase: CG, %s}", keys);
    struct deck *deck = deck_parse(text, strlen(text), "test");
    free(text);
    return deck;
}

/* Of half a pocket of a round body, volume over pi: integral of (b + r - sqrt(r^2 - x^2))^2 over
 * the arc, 0 to a. */
static double round_arc(double b, double r, double a)
{
    const double under = 0.5 * (a * sqrt(r * r - a * a) + r * r * asin(a / r));
    return (b + r) * (b + r) * a - 2 * (b + r) * under + r * r * a - a * a * a / 3;
}

/* Of half a pocket of a flat body, half its area. */
static double flat_arc(double b, double r, double a)
{
    return (b + r) * a - 0.5 * (a * sqrt(r * r - a * a) + r * r * asin(a / r));
}

struct body {
    const char *keys;
    double volume;
};

/* Exact volumes; arcs rise by 1.85 (heads), 0.7 (shallow notch), and the deep notches have walls.
 */
static struct body body_of(int i)
{
    const double heads = sqrt(1.85 * (2 * 3 - 1.85)), shallow = sqrt(0.7 * (2 * 1.1 - 0.7));
    const struct body bodies[] = {
        {"specimen: rod, size: 12, diameter: 6.413", M_PI / 4 * 6.413 * 6.413 * 12},
        {"specimen: plate, size: [12, 8, 2]", 12 * 8 * 2},
        {"specimen: plate, size: [12, 8, 2], hole: {centre: [1, 0.3], diameter: 3.3}",
         2 * (12 * 8 - M_PI / 4 * 3.3 * 3.3)},
        {"specimen: plate, size: [12, 8, 2], notch: {radius: 1.1, depth: 0.7}",
         2 * (2 * (6 - shallow) * 8 + 4 * flat_arc(3.3, 1.1, shallow))},
        {"specimen: plate, size: [12, 8, 2], notch: {radius: 0.6, depth: 1.3}",
         2 * (12 * 8 - 2 * (M_PI / 2 * 0.36 + 1.2 * 0.7))},
        {"specimen: dogbone, size: [18, 8, 2], gauge: {length: 6, width: 4.3, fillet: 3}",
         2 * (6 * 4.3 + 4 * flat_arc(2.15, 3, heads) + 2 * (6 - heads) * 8)},
        {"specimen: dogbone, size: [18, 8, 2], gauge: {length: 6, width: 4.3, fillet: 3}, "
         "notch: {radius: 0.5, depth: 0.5}, hole: {centre: [-6.5, 0], diameter: 2}",
         2 * (6 * 4.3 + 4 * flat_arc(2.15, 3, heads) + 2 * (6 - heads) * 8 - M_PI * 0.25 - M_PI)},
        {"specimen: rod, size: 12, diameter: 6.4, notch: {radius: 1.1, depth: 0.7}",
         M_PI * (2 * (6 - shallow) * 3.2 * 3.2 + 2 * round_arc(2.5, 1.1, shallow))},
        {"specimen: rod, size: 12, diameter: 6.4, notch: {radius: 0.6, depth: 1.3}",
         M_PI * (2 * (6 - 0.6) * 3.2 * 3.2 + 2 * round_arc(1.9, 0.6, 0.6))},
        {"specimen: round_dogbone, size: 18, diameter: 8, gauge: {length: 6, width: 4.3, fillet: "
         "3}",
         M_PI * (6 * 2.15 * 2.15 + 2 * round_arc(2.15, 3, heads) + 2 * (6 - heads) * 16)},
    };
    return i < (int)(sizeof bodies / sizeof *bodies) ? bodies[i] : (struct body){NULL, 0};
}

static const char *const lattices[] = {
    "spacing: 0.5",
    "spacing: [0.25, 1, 0.5]",
    "spacing: 0.5, angle: 18.43494882292201 degree",
    "spacing: 0.5, angle: -45 degree",
    "spacing: [1, 0.5, 0.4], angle: 0.3",
};
enum { N_LATTICES = sizeof lattices / sizeof *lattices };

struct filled {
    struct deck *deck;
    struct specimen specimen;
    struct sites sites;
};

static struct filled read_body(const char *body, const char *lattice, const char *volumes)
{
    struct filled filled = {0};
    char *keys = memory_print("%s, %s, volumes: %s", body, lattice, volumes);
    filled.deck = parse(keys);
    filled.specimen = recipe_read(filled.deck).specimen;
    free(keys);
    return filled;
}

static struct filled fill(const char *body, const char *lattice, const char *volumes)
{
    struct filled filled = read_body(body, lattice, volumes);
    filled.sites = fill_sites(&filled.specimen);
    return filled;
}

static void empty(struct filled *filled)
{
    sites_free(&filled->sites);
    deck_free(filled->deck);
}

/* The goal: volumes of bodies to 1e-10 wherever there is a formula. */
static void cut_cells_sum_to_the_body(void **state)
{
    (void)state;
    for (int i = 0; body_of(i).keys; i++)
        for (int l = 0; l < N_LATTICES; l++) {
            const struct body body = body_of(i);
            struct filled filled = fill(body.keys, lattices[l], "cut");
            assert_relative(sites_whole_volume(&filled.sites, NULL), body.volume, 1e-10);
            /* Without grips all of it counts, nodes whose centres are outside, too. */
            uint8_t *counted = specimen_counted(&filled.specimen, &filled.sites);
            assert_relative(sites_whole_volume(&filled.sites, counted), body.volume, 1e-10);
            free(counted);
            assert_relative(outline_between(&filled.specimen, filled.specimen.size[0]), body.volume,
                            1e-10);
            empty(&filled);
        }
}

/* Each cell by points: those of a grid of 24 x 24 x 24 in a random cell that are inside.  A surface
 * passes through 24^2 to 2 x 24^2 columns of points, which are off by half a point at random and by
 * one at most. */
static void cells_own_what_is_inside_them(void **state)
{
    enum { POINTS = 24, CELLS = 60 };
    (void)state;
    struct random_stream *stream = random_new(5, "cells");
    int cut = 0;
    for (int i = 0; body_of(i).keys; i++)
        for (int n = 0; n < CELLS; n++) {
            struct filled filled = read_body(body_of(i).keys, lattices[n % N_LATTICES], "whole");
            const struct specimen *s = &filled.specimen;
            double centre[3];
            for (int axis = 0; axis < 3; axis++)
                centre[axis] =
                    (random_uniform(stream) - 0.5) * (double)s->count[axis] * s->spacing[axis];
            int inside = 0;
            for (int p = 0; p < POINTS * POINTS * POINTS; p++) {
                const int at[3] = {p % POINTS, p / POINTS % POINTS, p / POINTS / POINTS};
                double point[3];
                for (int axis = 0; axis < 3; axis++)
                    point[axis] =
                        centre[axis] + s->spacing[axis] * ((at[axis] + 0.5) / POINTS - 0.5);
                /* Flat bodies go on along z here. */
                if (!specimen_is_round(s)) point[2] = 0;
                inside += outline_holds(s, point);
            }
            const double share = inside / (double)(POINTS * POINTS * POINTS);
            assert_near(outline_of_cell(s, centre) / specimen_node_volume(s), share, 1.5 / POINTS);
            cut += share > 0 && share < 1;
            empty(&filled);
        }
    assert_true(cut > 100);
    random_free(stream);
}

/* Volume over the cell's of the cells without a node up to two steps away: parts may be handed on.
 */
static double empty_nearby(const struct filled *filled, const int64_t at[3])
{
    double sum = 0;
    for (int k = 0; k < 125; k++) {
        const int64_t to[3] = {at[0] + k % 5 - 2, at[1] + k / 5 % 5 - 2, at[2] + k / 25 - 2};
        double centre[3];
        for (int axis = 0; axis < 3; axis++)
            centre[axis] = sites_coordinate(&filled->sites, axis, to[axis]);
        if (sites_at(&filled->sites, to[0], to[1], to[2]) < 0)
            sum += outline_of_cell(&filled->specimen, centre);
    }
    return sum / specimen_node_volume(&filled->specimen);
}

/* A node owns what its cell holds, at least a twentieth, and what it was given, which cells nearby
 * without a node hold. */
static void small_parts_go_to_a_neighbour(void **state)
{
    (void)state;
    int given = 0;
    for (int i = 0; body_of(i).keys; i++)
        for (int l = 0; l < N_LATTICES; l += 2) {
            struct filled filled = fill(body_of(i).keys, lattices[l], "cut");
            const struct sites *sites = &filled.sites;
            const double cell = specimen_node_volume(&filled.specimen);
            for (int64_t node = 0; node < sites->n_nodes; node++) {
                double centre[3];
                int64_t at[3];
                sites_position(sites, node, centre);
                sites_index(sites, node, at);
                const double own = outline_of_cell(&filled.specimen, centre) / cell;
                const double more = sites_volume(sites, node) / cell - own;
                assert_true(own >= FILL_LEAST);
                assert_true(more > -1e-10);
                if (more < 1e-10) continue;
                given++;
                assert_true(more < empty_nearby(&filled, at) + 1e-10);
            }
            empty(&filled);
        }
    assert_true(given > 100);
}

/* A node and its image in the middle own the same; where nothing is turned or aside, images in the
 * planes, too. */
static void volumes_are_symmetric(void **state)
{
    (void)state;
    static const int symmetric[] = {0, 3, 4, 5, 7, 8, 9};
    for (int i = 0; i < 7; i++)
        for (int l = 0; l < N_LATTICES; l++) {
            struct filled filled = fill(body_of(symmetric[i]).keys, lattices[l], "cut");
            const struct sites *sites = &filled.sites;
            const int64_t *n = sites->count;
            for (int64_t node = 0; node < sites->n_nodes; node++) {
                int64_t at[3];
                sites_index(sites, node, at);
                int64_t image = sites_at(sites, n[0] - 1 - at[0], n[1] - 1 - at[1], at[2]);
                assert_true(image >= 0);
                assert_relative(sites_volume(sites, image), sites_volume(sites, node), 1e-9);
                if (l > 1) continue;
                image = sites_at(sites, n[0] - 1 - at[0], at[1], at[2]);
                assert_true(image >= 0);
                assert_relative(sites_volume(sites, image), sites_volume(sites, node), 1e-9);
            }
            empty(&filled);
        }
}

/* Whole cells: those whose centres are inside, each with its volume; the staircase is within two
 * per cent. */
static void whole_cells_have_their_centres_inside(void **state)
{
    (void)state;
    for (int i = 0; body_of(i).keys; i++) {
        const struct body body = body_of(i);
        struct filled filled = fill(body.keys, "spacing: 0.1", "whole");
        assert_null(filled.sites.volume);
        assert_relative(sites_whole_volume(&filled.sites, NULL), body.volume, 0.02);
        empty(&filled);
    }
}

/* --- domains ---------------------------------------------------------------------------------- */

static struct domain domain_of(const char *keys)
{
    struct deck *deck = parse(keys);
    struct recipe recipe = recipe_read(deck);
    struct sites sites = fill_sites(&recipe.specimen);
    struct cores none = {0};
    struct structure structure = structure_new(&recipe, &sites, &none);
    struct findings findings = findings_of(&recipe, &structure, &none);
    struct domain domain = assemble_domain(&recipe, &structure, &findings, NULL);
    structure_free(&structure);
    sites_free(&sites);
    deck_free(deck);
    return domain;
}

/* A block that its cells fill has nothing to cut, and its file says nothing of it. */
static void blocks_are_not_cut(void **state)
{
    (void)state;
    struct domain block = domain_of("specimen: plate, size: [4, 3, 2], spacing: 0.5, volumes: cut");
    struct domain rod =
        domain_of("specimen: rod, size: 4, diameter: 3, spacing: 0.5, volumes: cut");
    assert_null(attributes_text(&block.attributes, "volumes"));
    assert_string_equal(attributes_text(&rod.attributes, "volumes"), "cut");
    for (int64_t n = 0; n < block.n_nodes; n++) assert_true(block.volume[n] == 0.125);
    assert_relative(attributes_number(&rod.attributes, "section_m2", 0), M_PI * 2.25, 1e-10);
    domain_free(&block);
    domain_free(&rod);
}

/* Grips and gauge planes lie across the body, not across the lattice: their nodes are where its
 * axis says, and a set is the image of the other in the middle. */
static void sets_follow_the_body(void **state)
{
    (void)state;
    struct domain domain =
        domain_of("specimen: plate, size: [20, 5, 1], spacing: 0.5, angle: 0.4636476090008061, "
                  "grips: {length: 3, phase: structure}, gauge: {length: 8}, volumes: cut");
    const double c = 2 / sqrt(5), s = 1 / sqrt(5);
    static const char *const names[] = {"grip_left", "grip_right", "gauge_left", "gauge_right"};
    int64_t in_grip = 0;
    for (int64_t n = 0; n < domain.n_nodes; n++)
        in_grip += fabs(c * domain.x[n] + s * domain.y[n]) >= 7;
    assert_int_equal(domain_set(&domain, "grip_left")->count +
                         domain_set(&domain, "grip_right")->count,
                     in_grip);
    for (int i = 0; i < 4; i++) {
        const struct node_set *set = domain_set(&domain, names[i]),
                              *other = domain_set(&domain, names[i ^ 1]);
        assert_int_equal(set->count, other->count);
        const double sign = i % 2 ? 1 : -1, plane = i < 2 ? 8.75 : 4, half = i < 2 ? 1.75 : 0.25;
        for (int64_t k = 0; k < set->count; k++) {
            const int64_t a = set->nodes[k], b = other->nodes[set->count - 1 - k];
            assert_near(sign * (c * domain.x[a] + s * domain.y[a]), plane, half + 1e-9);
            assert_near(domain.x[a], -domain.x[b], 1e-12);
            assert_near(domain.y[a], -domain.y[b], 1e-12);
        }
    }
    /* Planes of nodes lie 0.5/sqrt(5) apart along the body, of which the 17th to the 19th are
     * within 0.25 of 4; in each, nodes 0.5 sqrt(5) apart over a width of 5, with those of cut cells
     * 4 to 6, in two layers. */
    assert_near((double)domain_set(&domain, "gauge_left")->count, 30, 6);
    assert_near(attributes_number(&domain.attributes, "gauge_length_m", 0), 8, 0.1);
    assert_relative(attributes_number(&domain.attributes, "section_m2", 0), 5, 1e-10);
    assert_relative(attributes_number(&domain.attributes, "angle_rad", 0), atan(0.5), 1e-15);
    domain_free(&domain);
}

/* --- what cannot be --------------------------------------------------------------------------- */

static void try_deck(const void *keys)
{
    recipe_read(parse(keys));
}

static void what_cannot_be_is_told(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"specimen: rod, spacing: 1, size: [9, 9, 9], diameter: 9", "its length alone"},
        {"specimen: rod, spacing: 1, size: 9", "key 'diameter' is missing"},
        {"specimen: rod, spacing: 1, size: 9.5, diameter: 9", "the lattice fills the size exactly"},
        {"specimen: rod, spacing: 1, size: 9, diameter: 9, dimensions: 2", "has three dimensions"},
        {"specimen: rod, spacing: 1, size: 9, diameter: 9, hole: {diameter: 2}", "has no hole"},
        {"specimen: plate, spacing: 1, size: [9, 9, 9], diameter: 9", "a plate has no diameter"},
        {"specimen: plate, spacing: 1, size: [9, 9, 9], hole: {centre: [3, 0], diameter: 4}",
         "the hole leaves the body"},
        {"specimen: plate, spacing: 1, size: [9, 9, 9], notch: {radius: 1, depth: 5}",
         "5 m is out of range"},
        {"specimen: plate, spacing: 1, size: [9, 9, 9], notch: {radius: 5, depth: 4}",
         "the notch is wider"},
        {"specimen: round_dogbone, spacing: 1, size: 9, diameter: 9", "key 'gauge' is missing"},
        {"specimen: plate, spacing: 1, size: [9, 9, 9], angle: 2", "2 rad is out of range"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_dies(EXIT_USER, wrong[i][1], try_deck, wrong[i][0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(discs_cut_polygons_by_their_formulas),
        cmocka_unit_test(polygons_are_cut_by_lines),
        cmocka_unit_test(cut_cells_sum_to_the_body),
        cmocka_unit_test(cells_own_what_is_inside_them),
        cmocka_unit_test(small_parts_go_to_a_neighbour),
        cmocka_unit_test(volumes_are_symmetric),
        cmocka_unit_test(whole_cells_have_their_centres_inside),
        cmocka_unit_test(blocks_are_not_cut),
        cmocka_unit_test(sets_follow_the_body),
        cmocka_unit_test(what_cannot_be_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
