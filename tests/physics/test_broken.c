/* Bodies with broken bonds: correspondence leaves them out, exactly; what is free flies on. */
#include "check.h"

#include "broken.h"
#include "memory.h"
#include "random.h"
#include "small_body.h"
#include "verlet.h"

#include <stdlib.h>

static uint8_t rugged(const int size[3], const int at[3])
{
    (void)size;
    bool notch = at[0] > 3 && at[0] < 6 && at[1] < 3;
    return notch ? ABSENT : (uint8_t)((at[0] / 3 + at[1] / 2 + at[2]) % 2);
}

static void start(struct small_body *small, const char *stabilisation, double horizon,
                  const char *breaking)
{
    small_body_new(small, &(struct small_case){.size = {10, 7, 6},
                                               .horizon = horizon,
                                               .stabilisation = stabilisation,
                                               .materials = small_two_phases,
                                               .n_phases = 2,
                                               .phase = rugged,
                                               .breaking = breaking});
}

/* Breaks a share of all bonds at random, and all of one node. */
static void tear(struct small_body *small, double share)
{
    struct random_stream *stream = random_new(3, "tear");
    const int64_t alone = grid_site(&small->body.grid, (int[]){7, 4, 3});
    for (int64_t s = 0; s < small->bonds->count; s++)
        for (int k = 0; k < small->bonds->strips[s].count; k++) {
            struct bond_strip *strip = &small->bonds->strips[s];
            const struct bond_view view = bonds_view(small->bonds, strip);
            if (random_uniform(stream) < share || bond_lower(&view, k) == alone ||
                bond_upper(&view, k) == alone)
                broken_add(&small->body, small->bonds, strip, k);
        }
    random_free(stream);
    broken_shapes(&small->body, true);
}

/* An affine motion gives its exact gradient in whatever family is left, as long as it spans space;
 * the others have none.  Displacements of up to 0.5 spacings, differences of 1e-16 of them. */
static void test_gradient_of_torn_families(void **state)
{
    (void)state;
    const double H[9] = {0.03, 0.01, 0.002, 0.02, -0.012, 0, 0.004, 0, -0.015};
    for (int horizon = 1; horizon <= 3; horizon++) {
        struct small_body small;
        start(&small, small_mix, horizon, NULL);
        tear(&small, 0.3);
        small_body_deform(&small, H);
        small_body_force(&small, false, false);
        int64_t lost = 0, whole = 0;
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            if (!small_body_has(&small, site)) continue;
            const bool gone = broken_lost(small.body.broken, site);
            for (int k = 0; k < 9; k++) assert_near(small.body.H[k][site], gone ? 0 : H[k], 1e-12);
            *(gone ? &lost : &whole) += 1;
        }
        assert_true(lost >= 1 && whole > 100);
        assert_near(small.body.broken->n_lost, (double)lost, 0);
        small_body_free(&small);
    }
}

/* Momentum and moments balance beside and at torn families, in plastic flow: the balance of
 * test_conservation.c, and its tolerance. */
static void check_balance(const char *law, int horizon)
{
    static const double stretch[9] = {0.03, 0.01, 0, 0.002, -0.012, 0, 0.004, 0, -0.015};
    struct small_body small;
    start(&small, law, horizon, NULL);
    small_body_deform(&small, stretch);
    small_body_shake(&small, 0.003, 1);
    small_body_force(&small, true, false);
    tear(&small, 0.1);
    small_body_shake(&small, 0.003, 2);
    small_body_force(&small, true, false);
    double sum[3] = {0}, moment[3] = {0}, all = 0, all_moments = 0;
    for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
        double x[3], f[3];
        int at[3];
        if (!small_body_has(&small, site)) continue;
        small_body_position(&small, site, at);
        for (int a = 0; a < 3; a++) {
            x[a] = at[a] * SMALL_SPACING + small.body.u[a][site];
            f[a] = small.body.f[a][site];
        }
        for (int a = 0; a < 3; a++) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            sum[a] += f[a];
            moment[a] += x[b] * f[c] - x[c] * f[b];
            all += fabs(f[a]);
            all_moments += fabs(x[b] * f[c]) + fabs(x[c] * f[b]);
        }
    }
    for (int a = 0; a < 3; a++) assert_near(sum[a], 0, 1e-13 * all);
    for (int a = 0; a < 3; a++) assert_near(moment[a], 0, 1e-13 * all_moments);
    small_body_free(&small);
}

static void test_forces_of_torn_bodies_cancel(void **state)
{
    (void)state;
    for (int horizon = 1; horizon <= 3; horizon++) {
        check_balance(small_mix, horizon);
        check_balance(small_capped, horizon);
    }
}

/* The force is minus the derivative of the energy, with whatever bonds are left: central
 * differences along a random direction, (1e-6 spacings)^2 off by curvature, 1e-16 of the energy by
 * rounding over 1e-6. */
static void check_derivative(const char *law, int horizon)
{
    struct small_body small;
    start(&small, law, horizon, NULL);
    const size_t sites = (size_t)small.body.grid.n_sites;
    double *way[3], *rest[3];
    small_body_shake(&small, 1e-4, 5);
    tear(&small, 0.2);
    struct random_stream *stream = random_new(1, "way");
    for (int a = 0; a < 3; a++) {
        way[a] = memory_new(sites, sizeof(double));
        rest[a] = memory_new(sites, sizeof(double));
        memcpy(rest[a], small.body.u[a], sites * sizeof(double));
        for (size_t i = 0; i < sites; i++)
            if (small_body_has(&small, (int64_t)i))
                way[a][i] = 1e-6 * SMALL_SPACING * (2 * random_uniform(stream) - 1);
    }
    random_free(stream);
    small_body_force(&small, false, true);
    const double work = small_body_product(&small, small.body.f, way) * small.body.volume;
    double energy[2];
    for (int side = 0; side < 2; side++) {
        for (int a = 0; a < 3; a++)
            for (size_t i = 0; i < sites; i++)
                small.body.u[a][i] = rest[a][i] + (side ? 1 : -1) * way[a][i];
        energy[side] = small_body_elastic_energy(&small);
    }
    assert_relative(0.5 * (energy[0] - energy[1]), work, 1e-5);
    for (int a = 0; a < 3; a++) {
        free(way[a]);
        free(rest[a]);
    }
    small_body_free(&small);
}

static void test_force_of_torn_bodies_derives_from_energy(void **state)
{
    (void)state;
    for (int horizon = 1; horizon <= 3; horizon++) {
        check_derivative(small_mix, horizon);
        check_derivative(small_capped, horizon);
    }
}

/* A record of broken bonds in which none is broken changes no bit, and neither do broken bonds far
 * away: nodes two horizons from the tear keep their forces. */
static void test_far_nodes_keep_their_bits(void **state)
{
    (void)state;
    static const char *const laws[] = {small_mix, small_capped};
    for (int k = 0; k < 2; k++) {
        struct small_body whole, torn;
        start(&whole, laws[k], 2, NULL);
        start(&torn, laws[k], 2, NULL);
        struct bond_strip *strip = &torn.bonds->strips[0];
        const struct bond_view view = bonds_view(torn.bonds, strip);
        int from[3];
        small_body_position(&torn, bond_lower(&view, 0), from);
        broken_add(&torn.body, torn.bonds, strip, 0);
        broken_shapes(&torn.body, true);
        small_body_shake(&whole, 1e-3, 9);
        small_body_shake(&torn, 1e-3, 9);
        small_body_force(&whole, true, false);
        small_body_force(&torn, true, false);
        int far = 0, changed = 0;
        for (int64_t site = 0; site < whole.body.grid.n_sites; site++) {
            int at[3], distance = 0;
            if (!small_body_has(&whole, site)) continue;
            small_body_position(&whole, site, at);
            for (int a = 0; a < 3; a++) distance = (int)fmax(distance, abs(at[a] - from[a]));
            for (int a = 0; a < 3; a++) {
                /* bond, its end's gradient, the bond to a neighbour's, that one's force */
                if (distance > 8) assert_near(whole.body.f[a][site], torn.body.f[a][site], 0);
                changed += whole.body.f[a][site] != torn.body.f[a][site];
            }
            far += distance > 8;
        }
        assert_true(far > 10);
        assert_true(changed > 10);
        small_body_free(&whole);
        small_body_free(&torn);
    }
}

/* One particle cut off by six cracks, and a body cut in two: each part has its own momentum. */
static void test_fragments_fly_on(void **state)
{
    (void)state;
    static const char *const laws[] = {small_mix, small_capped};
    static const char cracks[] =
        "cracks: [{rectangle: [[4.5 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}, "
        "{rectangle: [[6.5 spacings, 3.5 spacings, 2.5 spacings], [1 spacings, 0, 0], [0, 1 "
        "spacings, 0]]}, "
        "{rectangle: [[6.5 spacings, 3.5 spacings, 3.5 spacings], [1 spacings, 0, 0], [0, 1 "
        "spacings, 0]]}, "
        "{rectangle: [[6.5 spacings, 3.5 spacings, 2.5 spacings], [1 spacings, 0, 0], [0, 0, 1 "
        "spacings]]}, "
        "{rectangle: [[6.5 spacings, 4.5 spacings, 2.5 spacings], [1 spacings, 0, 0], [0, 0, 1 "
        "spacings]]}, "
        "{rectangle: [[6.5 spacings, 3.5 spacings, 2.5 spacings], [0, 1 spacings, 0], [0, 0, 1 "
        "spacings]]}, "
        "{rectangle: [[7.5 spacings, 3.5 spacings, 2.5 spacings], [0, 1 spacings, 0], [0, 0, 1 "
        "spacings]]}]";
    for (int k = 0; k < 2; k++) {
        struct small_body small;
        struct boundary nothing = small_free_boundary();
        start(&small, laws[k], 2, cracks);
        assert_true(small.cut > 0);
        assert_near(small.body.broken->n_lost, 1, 0);
        const int64_t alone = grid_site(&small.body.grid, (int[]){7, 4, 3});
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&small, site)) continue;
            small_body_position(&small, site, at);
            small.body.v[0][site] = at[0] < 4.5 ? -20 : 5;
            small.body.v[1][site] = sin(at[0] + at[1]);
        }
        small.body.v[2][alone] = 100;
        const double gone_x = small.body.v[0][alone], gone_y = small.body.v[1][alone];
        struct integration integration =
            integration_new(true, 1e-9, 0, &small.materials, &small.body, &nothing, small.model);
        double before[2][3] = {{0}}, after[2][3] = {{0}}, all = 0;
        for (int n = 0; n <= 200; n++) {
            for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
                int at[3];
                if (!small_body_has(&small, site) || (n > 0 && n < 200)) continue;
                small_body_position(&small, site, at);
                const double rho = small.materials.items[small.body.grid.phase[site]].density;
                for (int a = 0; a < 3; a++) {
                    const double momentum = rho * small.body.v[a][site];
                    (n ? after : before)[at[0] > 4][a] += momentum;
                    all += fabs(momentum);
                }
            }
            if (n < 200) verlet_step(&integration, &small.body, &nothing, small.model, true, false);
        }
        assert_near(small.body.v[0][alone], gone_x, 0);
        assert_near(small.body.v[1][alone], gone_y, 0);
        assert_near(small.body.v[2][alone], 100, 0);
        /* rounding of 200 steps */
        for (int part = 0; part < 2; part++)
            for (int a = 0; a < 3; a++) assert_near(after[part][a], before[part][a], 1e-13 * all);
        assert_near(energy_drift(&integration.balance), 0, 2e-3);
        integration_free(&integration);
        boundary_free(&nothing);
        small_body_free(&small);
    }
}

struct cut {
    const char *cracks;
    double horizon;
    int64_t bonds;
    bool flat;
};

/* Counted by hand on a body of 6 x 5 x 4 sites. */
static void test_cracks_cut_what_they_cross(void **state)
{
    (void)state;
    static const struct cut cases[] = {
        /* the whole section: 5 x 4 bonds along x */
        {"{rectangle: [[2.5 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}", 1, 20, false},
        /* two columns by three: its rim on nodes counts */
        {"{rectangle: [[2.5 spacings, 1 spacings, 0], [0, 1 spacings, 0], [0, 0, 2 spacings]]}", 1,
         6, false},
        /* on a layer of nodes, which belongs to one side: again 20, of horizon 2 sixty more
           diagonal ones */
        {"{rectangle: [[3 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}", 1, 20, false},
        /* both ways of the normal */
        {"{rectangle: [[3 spacings, -1, -1], [0, 0, 2], [0, 2, 0]]}", 1, 20, false},
        /* horizon 1.5: along x 20, (1, +-1, 0) 2 x 16, (1, 0, +-1) 2 x 15 */
        {"{rectangle: [[2.5 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}", 1.5, 82, false},
        /* a disc about the middle of a bond, of less than a spacing, and of one: four neighbours
           more */
        {"{disc: {centre: [2.5 spacings, 2 spacings, 1 spacings], normal: [2, 0, 0], radius: 0.9 "
         "spacings}}",
         1, 1, false},
        {"{disc: {centre: [2.5 spacings, 2 spacings, 1 spacings], normal: [1, 0, 0], radius: 1 "
         "spacings}}",
         1, 5, false},
        /* beside the body */
        {"{disc: {centre: [2.5 spacings, 2 spacings, 9 spacings], normal: [1, 0, 0], radius: 1 "
         "spacings}}",
         1, 0, false},
        /* one layer of 6 x 5: a line across, whatever its edge along z; a disc as a line of 3 bonds
         */
        {"{rectangle: [[2.5 spacings, 0.5 spacings, 7], [0, 2 spacings, 0], [0, 0, 1]]}", 1, 2,
         true},
        {"{disc: {centre: [2.5 spacings, 2 spacings, 5], normal: [1, 0, 0], radius: 1.2 spacings}}",
         1, 3, true},
        /* two cracks that overlap cut a bond once */
        {"{rectangle: [[2.5 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}, {rectangle: [[2.4 spacings, "
         "-1, -1], [0, 2, 0], [0, 0, 2]]}",
         1, 20, false},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const struct cut *one = &cases[k];
        struct small_body small;
        char *text = memory_print("cracks: [%s]", one->cracks);
        small_body_new(&small,
                       &(struct small_case){.size = {6, 5, one->flat ? 1 : 4},
                                            .horizon = one->horizon,
                                            .materials = "{A: {model: bond_based, density: 1, "
                                                         "youngs_modulus: 1 GPa}}",
                                            .plane = one->flat ? PLANE_STRESS : SPACE,
                                            .breaking = text});
        int64_t zero = 0;
        for (int64_t s = 0; s < small.bonds->count; s++) {
            const struct bond_view view = bonds_view(small.bonds, &small.bonds->strips[s]);
            for (int b = 0; b < view.count; b++) zero += view.weight[b * view.weight_step] == 0;
        }
        assert_int_equal(small.cut, one->bonds);
        assert_int_equal(zero, one->bonds);
        small_body_free(&small);
        free(text);
    }
}

/* Nodes on the plane belong to the side that the normal points to, the first edge times the second.
 */
static void test_nodes_on_a_crack_belong_to_the_side_of_its_normal(void **state)
{
    (void)state;
    static const char *const edges[] = {"[0, 2, 0], [0, 0, 2]", "[0, 0, 2], [0, 2, 0]"};
    for (int reversed = 0; reversed < 2; reversed++) {
        struct small_body small;
        char *text =
            memory_print("cracks: [{rectangle: [[3 spacings, -1, -1], %s]}]", edges[reversed]);
        small_body_new(&small,
                       &(struct small_case){.size = {6, 3, 3},
                                            .horizon = 1,
                                            .materials = "{A: {model: bond_based, density: 1, "
                                                         "youngs_modulus: 1 GPa}}",
                                            .breaking = text});
        for (int64_t s = 0; s < small.bonds->count; s++) {
            const struct bond_view view = bonds_view(small.bonds, &small.bonds->strips[s]);
            for (int b = 0; b < view.count; b++) {
                int at[3], to[3];
                small_body_position(&small, bond_lower(&view, b), at);
                small_body_position(&small, bond_upper(&view, b), to);
                const bool cut = at[0] != to[0] && at[0] == (reversed ? 3 : 2);
                assert_int_equal(cut, !(view.weight[b * view.weight_step] > 0));
            }
        }
        assert_int_equal(small.cut, 9);
        small_body_free(&small);
        free(text);
    }
}

/* A cut counts as damage, as the share of the family's volume. */
static void test_damage_index(void **state)
{
    (void)state;
    struct small_body small;
    start(&small, small_mix, 1,
          "cracks: [{rectangle: [[6.5 spacings, -1, -1], [0, 2, 0], [0, 0, 2]]}]");
    double *index = memory_new((size_t)small.body.grid.n_sites, sizeof *index);
    damage_index(small.damage, index);
    for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&small, site)) continue;
        small_body_position(&small, site, at);
        int family = 6;
        for (int a = 0; a < 3; a++)
            for (int sign = -1; sign <= 1; sign += 2)
                family -= !small_body_has(&small, site + sign * small.body.grid.step[a]);
        assert_near(index[site], at[0] == 6 || at[0] == 7 ? 1.0 / family : 0, 1e-15);
    }
    free(index);
    small_body_free(&small);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gradient_of_torn_families),
        cmocka_unit_test(test_forces_of_torn_bodies_cancel),
        cmocka_unit_test(test_force_of_torn_bodies_derives_from_energy),
        cmocka_unit_test(test_far_nodes_keep_their_bits),
        cmocka_unit_test(test_fragments_fly_on),
        cmocka_unit_test(test_cracks_cut_what_they_cross),
        cmocka_unit_test(test_nodes_on_a_crack_belong_to_the_side_of_its_normal),
        cmocka_unit_test(test_damage_index),
    };
    return cmocka_run_group_tests_name("broken", tests, small_ranks_start, small_ranks_stop);
}
