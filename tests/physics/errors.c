/* errors - measured errors of the elastic constants of every material, in CSV on standard output:
 * deep inside a body, and of a plate with free surfaces in tension.  No test: make errors,
 * pipelines/errors.
 *
 * bulk: the stress of a node with its full family under small uniform strains; uniaxial stress
 * along a lattice axis. Of ordinary_plastic, stress at first yield and slope of hardening, too:
 * with r the axial stress over von Mises' measure of the node, r sigma_y and, work being the same,
 * r^2 H. plate: 64 x 8 x 8 particles, 64 x 40 x 8 (plate40), or 64 x 8 in a plane; the three layers
 * at each end are moved along x and are free across; equilibrium by conjugate gradients.  E: force
 * over section and strain between the planes at a quarter and three quarters; nu: of the outermost
 * particles of the middle layers. */
#include "check.h"

#include "small_body.h"
#include "small_static.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SPRING  "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}}"
#define ELASTIC "density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
static const double E0 = 210e9;

enum { BOND_BASED, ORDINARY, MADENCI_OTERKUS, MIX, CAPPED };
static const struct kind {
    const char *name, *materials, *stabilisation;
    double nu;
} kinds[] = {
    {"bond_based", SPRING, NULL, 0.25},
    {"ordinary", "{A: {model: ordinary, " ELASTIC "}}", NULL, 0.31},
    {"madenci_oterkus", "{A: {model: madenci_oterkus, " ELASTIC "}}", NULL, 0.31},
    {"correspondence mix", "{A: {model: correspondence_elastic, " ELASTIC "}}", small_mix, 0.31},
    {"correspondence capped",
     "{A: {model: correspondence, " ELASTIC
     ", hardening: {law: linear, yield: 185 MPa, modulus: 898 MPa}}}",
     small_capped, 0.31},
};
static const char plastic[] = "{A: {model: ordinary_plastic, " ELASTIC
                              ", hardening: {law: linear, yield: 185 MPa, modulus: 898 MPa}}}";

static const char *const planes[] = {"space", "plane stress", "plane strain"};
static const enum plane plane_of[] = {SPACE, PLANE_STRESS, PLANE_STRAIN};

/* What Young's modulus and Poisson's ratio of a tension test are: those of the plane in plane
 * strain. */
static void nominal(const struct kind *kind, int plane, double *E, double *nu)
{
    const double ratio = kind->nu == 0.25 && plane_of[plane] == PLANE_STRESS ? 1.0 / 3 : kind->nu;
    const bool strain = plane_of[plane] == PLANE_STRAIN;
    *E = strain ? E0 / (1 - ratio * ratio) : E0;
    *nu = strain ? ratio / (1 - ratio) : ratio;
}

static void print_case(const char *what, const struct kind *kind, int plane, int influence,
                       double horizon, bool partial, const char *correction)
{
    printf("%s,%s,%s,%s,%g,%s,%s", what, planes[plane], kind->name, family_influences[influence],
           horizon, partial ? "partial" : "whole", correction ? correction : "none");
}

/* Axial stress at first yield over sigma_y, of a node of the plastic material under uniaxial
 * stress. */
static double yield_ratio(struct small_case wanted, double E, double nu)
{
    struct small_body small;
    wanted.materials = plastic;
    small_body_new(&small, &wanted);
    const double e = 2 * 185e6 / E0;
    small_body_deform(&small, (const double[]){e, 0, 0, 0, -nu * e, 0, 0, 0, -nu * e});
    small_body_force(&small, true, false);
    body_need_gradient(&small.body); /* observed, though not prepared */
    const struct strips *strips = model_strips(small.model, &small.body);
    const int64_t middle = small_body_middle(&small);
    double p = NAN;
    for (int64_t s = 0; s < strips->count; s++) {
        struct node_state node;
        const int64_t k = middle - strips->items[s].site;
        if (k < 0 || k >= strips->items[s].count) continue;
        model_observe(small.model, &small.body, &strips->items[s], &node);
        p = node.plastic[k];
    }
    const double mu = small.materials.items[0].shear_modulus;
    small_body_free(&small);
    return E * e / (185e6 + (3 * mu + 898e6) * p);
}

static void bulk(int k, int plane, int influence, double horizon, bool partial)
{
    const struct kind *kind = &kinds[k];
    struct small_body small;
    const int width = 2 * (int)floor(horizon) + 1;
    const struct small_case wanted = {{width, width, plane ? 1 : width},
                                      horizon,
                                      influence,
                                      NULL,
                                      kind->materials,
                                      .n_phases = 1,
                                      .plane = plane_of[plane],
                                      .partial = partial};
    const double e = 1e-7;
    double P[9], E, nu, E_nominal, nu_nominal;
    small_body_new(&small, &wanted);
    const int64_t middle = small_body_middle(&small);
    small_body_deform(&small, (const double[9]){e});
    small_body_stress(&small, middle, P);
    const double c11 = P[0] / e, c12 = P[4] / e, mu = small.materials.items[0].shear_modulus;
    small_body_deform(&small, (const double[9]){0, e, 0, e});
    small_body_stress(&small, middle, P);
    const double c44 = P[1] / (2 * e);
    small_body_free(&small);
    nominal(kind, plane, &E_nominal, &nu_nominal);
    E = plane ? c11 - c12 * c12 / c11 : c11 - 2 * c12 * c12 / (c11 + c12);
    nu = plane ? c12 / c11 : c12 / (c11 + c12);
    print_case("bulk", kind, plane, influence, horizon, partial, NULL);
    printf(",%.4f,%.4f,%.4f,%.4f,%.4f", E / E_nominal, nu, nu_nominal, c44 / mu,
           (c11 - c12) / 2 / mu);
    if (k == ORDINARY && !plane) {
        const double r = yield_ratio(wanted, E, nu);
        printf(",%.4f,%.4f\n", r, r * r);
    } else {
        printf(",,\n");
    }
}

/* Mean of a component over a face of the middle layers, less that of the face opposite, over their
 * distance. */
static double across(const struct small_static *problem, const int size[3], int axis)
{
    const struct grid *grid = &problem->small->body.grid;
    double sum = 0;
    int count = 0;
    for (int x = size[0] / 2 - 2; x < size[0] / 2 + 2; x++)
        for (int other = 0; other < size[3 - axis]; other++) {
            int low[3] = {x, 0, 0}, high[3] = {x, 0, 0};
            low[3 - axis] = high[3 - axis] = other;
            high[axis] = size[axis] - 1;
            sum += problem->u[axis][grid_site(grid, high)] - problem->u[axis][grid_site(grid, low)];
            count++;
        }
    return sum / count / ((size[axis] - 1) * SMALL_SPACING);
}

static double layer(const struct small_static *problem, const int size[3], int x)
{
    double sum = 0;
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            sum += problem->u[0][grid_site(&problem->small->body.grid, (const int[]){x, y, z})];
    return sum / (size[1] * size[2]);
}

static void plate(int k, int plane, int width, int influence, double horizon, bool partial,
                  const char *correction)
{
    const struct kind *kind = &kinds[k];
    const int size[3] = {64, width, plane ? 1 : 8};
    struct small_body small;
    small_body_new(&small, &(struct small_case){{size[0], size[1], size[2]},
                                                horizon,
                                                influence,
                                                kind->stabilisation,
                                                kind->materials,
                                                .n_phases = 1,
                                                .plane = plane_of[plane],
                                                .partial = partial,
                                                .surface_correction = correction});
    struct small_static problem = small_static_new(&small);
    double force = 0, E_nominal, nu_nominal;
    for (int64_t i = 0; i < small.body.grid.n_sites; i++) {
        double x[3];
        if (!small_body_has(&small, i)) continue;
        body_position(&small.body, i, x);
        problem.u[0][i] = 1e-3 * x[0]; /* a start that is nearly right */
        problem.held[0][i] = x[0] < 2.5 * SMALL_SPACING || x[0] > 60.5 * SMALL_SPACING;
        if (plane) problem.held[2][i] = 1;
    }
    small_static_solve(&problem, 1e-5, 5000);
    /* The force of the left grip: that of the solved state, linear in u. */
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < small.body.grid.n_sites; i++)
            small.body.u[a][i] = small_body_has(&small, i) ? 1e-3 * problem.u[a][i] : 0;
    small_body_force(&small, false, true);
    for (int x = 0; x < 3; x++)
        for (int z = 0; z < size[2]; z++)
            for (int y = 0; y < size[1]; y++)
                force += small.body.f[0][grid_site(&small.body.grid, (const int[]){x, y, z})] * 1e3;
    const double stress = force * SMALL_SPACING / (size[1] * size[2]),
                 strain =
                     (layer(&problem, size, 48) - layer(&problem, size, 15)) / (33 * SMALL_SPACING);
    nominal(kind, plane, &E_nominal, &nu_nominal);
    print_case(width > 8 ? "plate40" : "plate", kind, plane, influence, horizon, partial,
               correction);
    printf(",%.4f,%.4f,%.4f,", stress / strain / E_nominal, -across(&problem, size, 1) / strain,
           nu_nominal);
    if (plane)
        printf(",,,\n");
    else
        printf("%.4f,,,\n", -across(&problem, size, 2) / strain);
    fflush(stdout);
    small_static_free(&problem);
    small_body_free(&small);
}

static const double horizons[] = {2.015, 3.015, 4.015};
static const char *const corrections[] = {NULL, "volume", "energy"};

/* Influence functions of a material: all but the steep one, of madenci_oterkus its own. */
static bool takes(int k, int influence)
{
    if (influence == family_influence("steep")) return false;
    return k != MADENCI_OTERKUS || influence == family_influence("inverse");
}

static void all_bulk(void)
{
    puts("# columns: of bulk C44/mu and (C11 - C12)/2 mu, of plates nu across z");
    puts("where,dimension,model,influence,horizon,volumes,correction,E,nu,nu_nominal,C44_or_nu_z,C_"
         "prime,"
         "yield,slope");
    for (int plane = 0; plane < 3; plane++)
        for (int k = BOND_BASED; k <= MADENCI_OTERKUS; k++)
            for (int influence = 0; family_influences[influence]; influence++)
                for (int h = 0; h < 3; h++)
                    for (int partial = 0; partial < 2 && takes(k, influence); partial++)
                        bulk(k, plane, influence, horizons[h], partial);
}

static void all_plates(void)
{
    for (int k = BOND_BASED; k <= MADENCI_OTERKUS; k++)
        for (int influence = 0; family_influences[influence]; influence++)
            for (int h = 0; h < 3; h++)
                for (int c = 0; c < 6 && takes(k, influence); c++) {
                    /* away from three spacings: without correction, and with that of energy */
                    if (h != 1 && c != 0 && c != 4) continue;
                    plate(k, 0, 8, influence, horizons[h], c % 2, corrections[c / 2]);
                }
    for (int k = MIX; k <= CAPPED; k++)
        for (int h = 1; h <= 3; h++) plate(k, 0, 8, 0, h, false, NULL);
    for (int plane = 1; plane < 3; plane++)
        for (int k = BOND_BASED; k <= MADENCI_OTERKUS; k++)
            for (int influence = 0; family_influences[influence]; influence++)
                for (int c = 0; c < 6 && takes(k, influence); c++)
                    plate(k, plane, 8, influence, 3.015, c % 2, corrections[c / 2]);
    /* The section of 40 x 8 of a thesis, constant and linear influence. */
    for (int influence = 0; influence <= 3; influence += 3)
        for (int c = 0; c < 6; c++)
            plate(ORDINARY, 0, 40, influence, 3.015, c % 2, corrections[c / 2]);
}

int main(void)
{
    small_ranks_start(NULL);
    all_bulk();
    all_plates();
    small_ranks_stop(NULL);
    return 0;
}
