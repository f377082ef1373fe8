/* Specimens: volumes, the dog-bone's outline, grips and gauge planes. */
#include "check.h"

#include "fill.h"
#include "outline.h"
#include "recipe.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static struct specimen read_specimen(const char *text, struct deck **deck)
{
    *deck = deck_parse(text, strlen(text), "test");
    return recipe_read(*deck).specimen;
}

static const char plate_text[] = "domain:\n"
                                 "  specimen: plate\n"
                                 "  topology: homogeneous\n  phase: CG\n"
                                 "  size: [5 mm, 1 mm, 0.2 mm]\n"
                                 "  spacing: 25 um\n"
                                 "  grips: {length: 3 spacings, phase: structure}\n"
                                 "  gauge: {length: 2.5 mm}\n"
                                 "  sets:\n"
                                 "    - {name: centre, box: [[-25 um, -25 um, -25 um], "
                                 "[25 um, 25 um, 25 um]]}\n";

static void plates_fill_their_size(void **state)
{
    (void)state;
    struct deck *deck;
    struct specimen specimen = read_specimen(plate_text, &deck);
    struct sites sites = fill_sites(&specimen);
    assert_int_equal(sites.n_nodes, 200 * 40 * 8);
    double cube = pow(25e-6, 3), position[3];
    assert_relative(cube * (double)sites.n_nodes, 5e-3 * 1e-3 * 0.2e-3, 1e-12);
    sites_position(&sites, 0, position);
    assert_near(position[0], -2.5e-3 + 12.5e-6, 1e-15);
    assert_near(position[1], -0.5e-3 + 12.5e-6, 1e-15);
    assert_near(position[2], -0.1e-3 + 12.5e-6, 1e-15);
    /* x fastest, then y, then z */
    sites_position(&sites, 200 * 40 + 200 + 1, position);
    assert_near(position[0], -2.5e-3 + 37.5e-6, 1e-15);
    assert_near(position[1], -0.5e-3 + 37.5e-6, 1e-15);
    assert_near(position[2], -0.1e-3 + 37.5e-6, 1e-15);
    assert_relative(outline_section(&specimen, &sites), 0.2e-6, 1e-12);
    sites_free(&sites);
    deck_free(deck);
}

/* Every node of one set has its mirror image, to the last bit, in the other. */
static void assert_mirrored(const struct sites *sites, const struct node_set *left,
                            const struct node_set *right, int64_t count)
{
    assert_non_null(left);
    assert_non_null(right);
    assert_int_equal(left->count, count);
    assert_int_equal(right->count, count);
    for (int64_t i = 0; i < count; i++) {
        int64_t at[3];
        sites_index(sites, left->nodes[i], at);
        int64_t mirror = sites_at(sites, sites->count[0] - 1 - at[0], at[1], at[2]);
        bool found = false;
        for (int64_t j = 0; j < count && !found; j++) found = right->nodes[j] == mirror;
        assert_true(found);
        double here[3], there[3];
        sites_position(sites, left->nodes[i], here);
        sites_position(sites, mirror, there);
        assert_true(here[0] == -there[0] && here[1] == there[1] && here[2] == there[2]);
    }
}

static void grips_and_gauge_planes_are_symmetric(void **state)
{
    (void)state;
    struct deck *deck;
    struct specimen specimen = read_specimen(plate_text, &deck);
    struct sites sites = fill_sites(&specimen);
    struct domain domain = {0};
    struct deck_node section = deck_get(deck_root(deck), "domain");
    specimen_add_sets(&specimen, &sites, deck_find(section, "sets"), &domain);
    assert_mirrored(&sites, domain_set(&domain, "grip_left"), domain_set(&domain, "grip_right"),
                    3 * 40 * 8);
    assert_mirrored(&sites, domain_set(&domain, "gauge_left"), domain_set(&domain, "gauge_right"),
                    40 * 8);
    /* The nearest layers to +-1.25 mm are the two at half a spacing from it; the outer one is
     * taken. */
    int64_t layer[2];
    specimen_gauge_layers(&specimen, layer);
    assert_near(sites_coordinate(&sites, 0, layer[1]), 1.25e-3 + 12.5e-6, 1e-15);
    assert_int_equal(domain_set(&domain, "centre")->count, 8);
    uint8_t *counted = specimen_counted(&specimen, &sites);
    int64_t count = 0;
    for (int64_t node = 0; node < sites.n_nodes; node++) count += counted[node];
    assert_int_equal(count, 194 * 40 * 8);
    free(counted);
    domain_free(&domain);
    sites_free(&sites);
    deck_free(deck);
}

static const char dogbone_text[] = "domain:\n"
                                   "  specimen: dogbone\n"
                                   "  topology: homogeneous\n  phase: CG\n"
                                   "  size: [100 mm, 12 mm, 2.5 mm]\n"
                                   "  spacing: 0.1 mm\n"
                                   "  grips: {length: 20 mm, phase: structure}\n"
                                   "  gauge: {length: 24.8 mm, width: 5.7 mm, fillet: 12 mm}\n";

/* Layers of the dog-bone hold as many nodes as its outline says, widen outwards only, and the whole
 * has the volume of the outline.  A row is off by one node (half a spacing on each side) at most;
 * the volume, where these errors cancel, by 0.5 %. */
static void dogbones_follow_their_outline(void **state)
{
    (void)state;
    struct deck *deck;
    struct specimen specimen = read_specimen(dogbone_text, &deck);
    struct sites sites = fill_sites(&specimen);
    assert_int_equal(sites.count[0], 1000);
    assert_int_equal(sites.count[1], 120);
    assert_int_equal(sites.count[2], 25);
    double area = 0;
    int64_t before = 0;
    for (int64_t i = 500; i < 1000; i++) {
        int64_t row = 0, mirrored = 0;
        for (int64_t j = 0; j < 120; j++) {
            row += sites_at(&sites, i, j, 12) >= 0;
            mirrored += sites_at(&sites, 999 - i, 119 - j, 12) >= 0;
        }
        double width = 2 * specimen_half_width(&specimen, sites_coordinate(&sites, 0, i));
        assert_near((double)row * 1e-4, width, 1.0001e-4);
        assert_true(row >= before);
        assert_int_equal(row, mirrored);
        before = row;
        area += 2 * width * 1e-4;
    }
    assert_int_equal(before, 120);
    assert_relative((double)sites.n_nodes * 1e-12, area * 2.5e-3, 0.005);
    /* 57 nodes would fill 5.7 mm, but a symmetric lattice of 120 has even rows only: 56 or 58. */
    assert_near(outline_section(&specimen, &sites), 5.7e-3 * 2.5e-3, 1.0001e-4 * 2.5e-3);
    sites_free(&sites);
    deck_free(deck);
}

/* The fillet: tangential where the gauge ends, on its circle, and full width after the arc. */
static void fillets_are_arcs(void **state)
{
    (void)state;
    struct deck *deck;
    struct specimen specimen = read_specimen(dogbone_text, &deck);
    double end = 12.4e-3, radius = 12e-3, step = 0.5 * (12e-3 - 5.7e-3);
    assert_near(specimen_half_width(&specimen, 0), 2.85e-3, 1e-15);
    assert_near(specimen_half_width(&specimen, end), 2.85e-3, 1e-15);
    assert_near(specimen_half_width(&specimen, -end - 1e-6), 2.85e-3, 1e-9);
    for (double beyond = 1e-3; beyond < 7e-3; beyond += 1e-3) {
        double up = specimen_half_width(&specimen, end + beyond) - 2.85e-3;
        assert_near(pow(radius - up, 2) + beyond * beyond, radius * radius, 1e-15);
    }
    double arc = sqrt(step * (2 * radius - step));
    assert_near(specimen_half_width(&specimen, end + arc), 6e-3, 1e-12);
    assert_near(specimen_half_width(&specimen, 49e-3), 6e-3, 1e-15);
    deck_free(deck);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plates_fill_their_size),
        cmocka_unit_test(grips_and_gauge_planes_are_symmetric),
        cmocka_unit_test(dogbones_follow_their_outline),
        cmocka_unit_test(fillets_are_arcs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
