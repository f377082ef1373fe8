/* Every material, in space and in a plane, on a lattice and scattered, whole, cracked and torn: the
 * body exerts no force and no moment on itself. */
#include "check.h"

#include "broken.h"
#include "random.h"
#include "small_body.h"

#include <stdio.h>
#include <stdlib.h>

#define ELASTIC "density: 7800, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
#define OTHER   "density: 7800, youngs_modulus: 70 GPa, poissons_ratio: 0.2"
#define VOCE    "hardening: {law: voce, yield: 200 MPa, saturation: 500 MPa, rate: 5}"

static const struct kind {
    const char *name, *materials, *stabilisation, *influence;
    bool flat, scattered; /* what it is for, besides lattices in space */
    bool flows;
} kinds[] = {
    {"bond_based",
     "{A: {model: bond_based, density: 7800, youngs_modulus: 210 GPa}, B: {model: bond_based, "
     "density: 7800, youngs_modulus: 70 GPa}}",
     NULL, "constant", true, true, false},
    {"ordinary", "{A: {model: ordinary, " ELASTIC "}, B: {model: ordinary, " OTHER "}}", NULL,
     "linear", true, true, false},
    {"madenci_oterkus",
     "{A: {model: madenci_oterkus, " ELASTIC "}, B: {model: madenci_oterkus, " OTHER "}}", NULL,
     "inverse", true, true, false},
    {"ordinary_plastic",
     "{A: {model: ordinary_plastic, " ELASTIC ", " VOCE "}, B: {model: ordinary, " OTHER "}}", NULL,
     "linear", false, true, true},
    {"correspondence, mix",
     "{A: {model: correspondence, " ELASTIC ", " VOCE "}, B: {model: correspondence, " OTHER
     ", " VOCE "}}",
     small_mix, "constant", true, false, true},
    {"correspondence, capped",
     "{A: {model: correspondence, " ELASTIC ", " VOCE "}, B: {model: correspondence, " OTHER
     ", " VOCE "}}",
     small_capped, "constant", true, true, true},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static uint8_t rugged(const int size[3], const int at[3])
{
    bool notch = at[0] > 3 && at[0] < 6 && at[1] < 3;
    bool step = size[2] > 1 && at[2] > size[2] - 3 && at[1] > size[1] - 4;
    return notch || step ? ABSENT : (uint8_t)((at[0] / 3 + at[1] / 2 + at[2]) % 2);
}

/* A tenth of the bonds. */
static void tear(struct small_body *small)
{
    struct random_stream *stream = random_new(3, "tear");
    for (int64_t s = 0; s < small->bonds->count; s++)
        for (int k = 0; k < small->bonds->strips[s].count; k++)
            if (random_uniform(stream) < 0.1)
                broken_add(&small->body, small->bonds, &small->bonds->strips[s], k);
    random_free(stream);
    broken_shapes(&small->body, small->model->formulation->stress_of == STRESS_OF_NODES);
}

static void shake(struct small_body *small, long seed)
{
    small_body_shake(small, 0.004, seed);
    if (small->lattice.dimensions == 2)
        for (int64_t i = 0; i < small->body.grid.n_sites; i++) small->body.u[2][i] = 0;
    small_body_force(small, true, false);
}

/* Each bond gives equal and opposite forces; their sum is rounding, 1e-16 of some 120 terms a node,
 * in correspondence of products of stress and inverse shape. */
static void check_balance(const struct small_body *small)
{
    double force[3] = {0}, moment[3] = {0}, all = 0, all_moments = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        double x[3], f[3];
        if (!small_body_has(small, site)) continue;
        body_position(&small->body, site, x);
        for (int a = 0; a < 3; a++) {
            x[a] += small->body.u[a][site];
            f[a] = small->body.f[a][site] * body_volume(&small->body, site);
        }
        for (int a = 0; a < 3; a++) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            force[a] += f[a];
            moment[a] += x[b] * f[c] - x[c] * f[b];
            all += fabs(f[a]);
            all_moments += fabs(x[b] * f[c]) + fabs(x[c] * f[b]);
        }
    }
    assert_true(all > 0);
    for (int a = 0; a < 3; a++) {
        if (getenv("HS_SHOW"))
            printf("#   %.1e %.1e\n", fabs(force[a]) / all, fabs(moment[a]) / all_moments);
        assert_near(force[a], 0, 1e-14 * all);
        assert_near(moment[a], 0, 1e-14 * all_moments);
    }
}

static void check(const struct kind *kind, bool flat, bool scattered, const char *crack)
{
    static const double stretch[9] = {0.03, 0.01, 0, 0.002, -0.012, 0, 0.004, 0, -0.015},
                        flat_stretch[9] = {0.03, 0.01, 0, 0.002, -0.012, 0, 0, 0, 0};
    struct small_body small;
    double range[2];
    if (getenv("HS_SHOW"))
        printf("# %s, %s, %s%s\n", kind->name, flat ? "plane" : "space",
               scattered ? "scattered" : "lattice", crack ? ", cracked" : "");
    small_body_new(&small, &(struct small_case){{12, 9, flat ? 1 : 7},
                                                2.515,
                                                family_influence(kind->influence),
                                                kind->stabilisation,
                                                kind->materials,
                                                .n_phases = 2,
                                                .phase = rugged,
                                                .plane = flat ? PLANE_STRAIN : SPACE,
                                                .partial = scattered,
                                                .scattered = scattered,
                                                .jitter = 0.15,
                                                .breaking = crack});
    assert_true(!crack || small.cut > 0);
    small_body_deform(&small, flat ? flat_stretch : stretch);
    shake(&small, 1);
    check_balance(&small);
    if (kind->flows) {
        small_body_plastic_range(&small, range);
        assert_true(range[1] > 0.01);
    }
    tear(&small);
    shake(&small, 2);
    check_balance(&small);
    small_body_free(&small);
}

static void test_no_force_and_no_moment(void **state)
{
    (void)state;
    static const char crack[] = "cracks: [{rectangle: [[6.3 spacings, -1 m, -1 m], [0, 1.0001 m, "
                                "0], [0, 0, 2 m]]}]";
    for (int k = 0; k < KINDS; k++)
        for (int n = 0; n < 8; n++) {
            const bool flat = n & 1, scattered = n & 2;
            if ((flat && !kinds[k].flat) || (scattered && !kinds[k].scattered)) continue;
            check(&kinds[k], flat, scattered, n & 4 ? crack : NULL);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_force_and_no_moment),
    };
    return cmocka_run_group_tests_name("third_law", tests, small_ranks_start, small_ranks_stop);
}
