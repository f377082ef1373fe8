/* Bonds through two phases: layers across the load have one stress, layers along it are a known bit
 * too soft. */
#include "check.h"

#include "interface.h"
#include "small_body.h"

#include <stdlib.h>

#define PHASES(model, ratio)                                                                       \
    "{A: {model: " model ", density: 8000, youngs_modulus: 200 GPa" ratio "}, "                    \
    "B: {model: " model ", density: 8000, youngs_modulus: 20 GPa" ratio "}}"

struct kind {
    const char *name, *materials, *influence;
    enum plane plane;
    double stress; /* relative error of the stress of any node */
};

/* Where there is no force of the dilatation (bond-based, and ordinary with k = 0, as at nu = 1/4 in
 * space), all nodes have the stress; with it, those near an interface miss it, since their families
 * lie partly in the other phase. */
static const struct kind kinds[] = {
    {"bond-based", PHASES("bond_based", ""), "constant", SPACE, 1e-5},
    {"bond-based, plane stress", PHASES("bond_based", ""), "inverse", PLANE_STRESS, 1e-5},
    {"ordinary, k = 0", PHASES("ordinary", ", poissons_ratio: 0.25"), "linear", SPACE, 1e-5},
    {"ordinary", PHASES("ordinary", ", poissons_ratio: 0.3"), "linear", PLANE_STRAIN, 0.05},
    {"madenci_oterkus", PHASES("madenci_oterkus", ", poissons_ratio: 0.3"), "inverse", PLANE_STRAIN,
     0.05},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static int layer; /* nodes */
static int axis;  /* along which layers follow each other */

static uint8_t layers(const int size[3], const int at[3])
{
    (void)size;
    return (uint8_t)(at[axis] / layer % 2);
}

static void body_of(struct small_body *small, const struct kind *kind, bool two, const char *more)
{
    small_body_new(small, &(struct small_case){{28, 28, kind->plane ? 1 : 13},
                                               3.015,
                                               family_influence(kind->influence),
                                               .materials = kind->materials,
                                               .n_phases = 2,
                                               .phase = two ? layers : NULL,
                                               .plane = kind->plane,
                                               .breaking = more});
}

/* u_x for a strain along x that is e in phase A and stretch e in phase B. */
static void deform(struct small_body *small, double e, double stretch)
{
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        double u = 0;
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        for (int x = 0; x <= at[0]; x++)
            u += (x < at[0] ? 1 : 0.5) *
                 (layers(small->lattice.size, (int[]){x, at[1], at[2]}) ? stretch * e : e);
        small->body.u[0][site] = u * SMALL_SPACING;
    }
}

static bool inside(const struct small_body *small, const int at[3])
{
    for (int a = 0; a < small->lattice.dimensions; a++) {
        const int margin = a == 2 ? 6 : 7;
        if (at[a] < margin || at[a] >= small->lattice.size[a] - margin) return false;
    }
    return true;
}

/* Extremes of P_xx, and its mean, of the nodes inside. */
static void stress(struct small_body *small, double range[2], double *mean)
{
    double sum = 0;
    int count = 0;
    range[0] = INFINITY;
    range[1] = -INFINITY;
    small_body_force(small, false, false);
    model_prepare(small->model, &small->body, 3);
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        if (!inside(small, at)) continue;
        const double P = small->body.S[0][site];
        range[0] = fmin(range[0], P);
        range[1] = fmax(range[1], P);
        sum += P;
        count++;
    }
    *mean = sum / count;
}

/* P_xx that phase A alone has at a strain along x of 1e-7. */
static double alone(const struct kind *kind)
{
    struct small_body small;
    double range[2], mean;
    layer = 64;
    body_of(&small, kind, true, NULL);
    deform(&small, 1e-7, 1);
    stress(&small, range, &mean);
    small_body_free(&small);
    return mean;
}

/* Strains of 1e-7 and ten times that, so that phase B is under the stress of phase A: so is every
 * node, and all forces inside vanish.  1e-5: more than the strain itself. */
static void test_layers_across_the_load_have_one_stress(void **state)
{
    (void)state;
    axis = 0;
    for (int n = 0; n < KINDS; n++) {
        const double wanted = alone(&kinds[n]);
        for (layer = 1; layer <= 4; layer++) {
            struct small_body small;
            double range[2], mean;
            body_of(&small, &kinds[n], true, NULL);
            deform(&small, 1e-7, 10);
            stress(&small, range, &mean);
            print_message("%s, layers of %d: %.5f to %.5f, mean %.5f\n", kinds[n].name, layer,
                          range[0] / wanted, range[1] / wanted, mean / wanted);
            assert_near(range[0], wanted, kinds[n].stress * wanted);
            assert_near(range[1], wanted, kinds[n].stress * wanted);
            assert_near(mean, wanted, 0.5 * kinds[n].stress * wanted);
            small_body_free(&small);
        }
    }
}

/* Mean stress of layers of four under one strain along them, over that of the mean of the moduli:
 * the mean of the moduli gives it, bonds in series do not.  The sum of (interface.1) over a family
 * in a plane, w = 1, is -9.7 %. */
static void test_layers_along_the_load(void **state)
{
    (void)state;
    const struct kind *kind = &kinds[1];
    struct kind constant = *kind;
    constant.influence = "constant";
    axis = 1;
    const double wanted = 0.55 * alone(&constant);
    double error[2];
    layer = 4;
    for (int mean_law = 0; mean_law < 2; mean_law++) {
        struct small_body small;
        double mean = 0;
        body_of(&small, &constant, true, mean_law ? "interfaces: mean" : NULL);
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            int at[3];
            small_body_position(&small, site, at);
            small.body.u[0][site] = 1e-7 * SMALL_SPACING * at[0];
        }
        small_body_force(&small, false, false);
        model_prepare(small.model, &small.body, 3);
        for (int y = 10; y < 18; y++) {
            const int at[3] = {14 - small.body.grid.origin[0], y - small.body.grid.origin[1],
                               -small.body.grid.origin[2]};
            mean += small.body.S[0][grid_shift(&small.body.grid, at)] / 8;
        }
        error[mean_law] = mean / wanted - 1;
        small_body_free(&small);
    }
    print_message("along: series %.2f %%, mean %.2f %%\n", 100 * error[0], 100 * error[1]);
    assert_near(error[0], -0.097, 0.0005);
    assert_near(error[1], 0, 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layers_across_the_load_have_one_stress),
        cmocka_unit_test(test_layers_along_the_load),
    };
    return cmocka_run_group_tests_name("interface", tests, small_ranks_start, small_ranks_stop);
}
