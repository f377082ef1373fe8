/* Materials whose forces act along the bonds, bond-based and ordinary: conservation, energy, and
 * the moduli of a node deep inside a body against direct sums over its family, written out here. */
#include "check.h"

#include "dies.h"
#include "small_body.h"
#include "verlet.h"

#include <stdlib.h>
#include <string.h>

#define ELASTIC "density: 7800, bulk_modulus: 130 GPa, shear_modulus: 78 GPa"
#define OTHER   "density: 7800, bulk_modulus: 100 GPa, shear_modulus: 26 GPa"
#define CENTRAL "density: 7800, youngs_modulus: 210 GPa"
static const char ordinary[] =
    "{A: {model: ordinary, " ELASTIC "}, B: {model: ordinary, " OTHER "}}";
static const char madenci_oterkus[] =
    "{A: {model: madenci_oterkus, " ELASTIC "}, B: {model: madenci_oterkus, " OTHER "}}";
static const char bond_based[] =
    "{A: {model: bond_based, " CENTRAL
    "}, B: {model: bond_based, density: 7800, youngs_modulus: 70 GPa}}";
static const char plastic[] =
    "{A: {model: ordinary_plastic, " ELASTIC
    ", hardening: {law: voce, yield: 200 MPa, saturation: 500 MPa, rate: 5}}, "
    "B: {model: ordinary, " OTHER "}}";

static uint8_t rugged(const int size[3], const int at[3])
{
    bool notch = at[0] > 3 && at[0] < 6 && at[1] < 3;
    bool step = at[2] > size[2] - 3 && at[1] > size[1] - 4 && size[2] > 1;
    return notch || step ? ABSENT : (uint8_t)((at[0] / 3 + at[1] / 2 + at[2]) % 2);
}

static const char ordinary_alone[] = "{A: {model: ordinary, " ELASTIC "}}";
static const char madenci_oterkus_alone[] = "{A: {model: madenci_oterkus, " ELASTIC "}}";
static const char bond_based_alone[] = "{A: {model: bond_based, " CENTRAL "}}";

/* Every material, each dimension it has, each surface correction. */
struct kind {
    const char *name, *materials, *correction, *influence;
    enum plane plane;
};
static const struct kind kinds[] = {
    {"bond-based", bond_based, NULL, "constant", SPACE},
    {"bond-based, volume", bond_based, "volume", "constant", SPACE},
    {"bond-based, energy", bond_based, "energy", "linear", SPACE},
    {"bond-based, plane stress", bond_based, "energy", "constant", PLANE_STRESS},
    {"ordinary", ordinary, NULL, "linear", SPACE},
    {"ordinary, volume", ordinary, "volume", "linear", SPACE},
    {"ordinary, energy", ordinary, "energy", "constant", SPACE},
    {"ordinary, plane stress", ordinary, NULL, "linear", PLANE_STRESS},
    {"ordinary, plane strain", ordinary, "energy", "linear", PLANE_STRAIN},
    {"madenci_oterkus", madenci_oterkus, NULL, "inverse", SPACE},
    {"madenci_oterkus, energy", madenci_oterkus, "energy", "inverse", SPACE},
    {"madenci_oterkus, plane stress", madenci_oterkus, NULL, "inverse", PLANE_STRESS},
    {"ordinary_plastic", plastic, NULL, "linear", SPACE},
    {"ordinary_plastic, energy", plastic, "energy", "constant", SPACE},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void body_of(struct small_body *small, const struct kind *kind)
{
    small_body_new(small, &(struct small_case){{13, 9, kind->plane ? 1 : 8},
                                               3.015,
                                               family_influence(kind->influence),
                                               NULL,
                                               kind->materials,
                                               .n_phases = 2,
                                               .phase = rugged,
                                               .plane = kind->plane,
                                               .surface_correction = kind->correction});
}

static const double stretch[9] = {0.03, 0.01, 0, 0.002, -0.012, 0, 0.004, 0, -0.015};
static const double flat_stretch[9] = {0.03, 0.01, 0, 0.002, -0.012, 0, 0, 0, 0};

/* Keeps a body of one layer in its plane. */
static void flatten(struct small_body *small)
{
    if (small->lattice.dimensions == 2)
        for (int64_t i = 0; i < small->body.grid.n_sites; i++) small->body.u[2][i] = 0;
}

/* A large strain with noise of half a per cent of the spacing, twice, so that plastic bonds have a
 * past. */
static void load(struct small_body *small)
{
    for (int step = 0; step < 2; step++) {
        if (step == 0)
            small_body_deform(small, small->lattice.dimensions == 2 ? flat_stretch : stretch);
        small_body_shake(small, 0.005, step + 1);
        flatten(small);
        small_body_force(small, true, false);
    }
}

/* Sums of forces and moments are rounding: 1e-16 of some 120 terms a node, of either sign. */
static void test_forces_and_moments_cancel(void **state)
{
    (void)state;
    for (int n = 0; n < KINDS; n++) {
        struct small_body small;
        double force[3] = {0}, moment[3] = {0}, all_force = 0, all_moment = 0;
        body_of(&small, &kinds[n]);
        load(&small);
        for (int64_t i = 0; i < small.body.grid.n_sites; i++) {
            double x[3], f[3];
            if (!small_body_has(&small, i)) continue;
            body_position(&small.body, i, x);
            for (int a = 0; a < 3; a++) {
                x[a] += small.body.u[a][i];
                f[a] = small.body.f[a][i];
            }
            for (int a = 0; a < 3; a++) {
                const int b = (a + 1) % 3, c = (a + 2) % 3;
                force[a] += f[a];
                moment[a] += x[b] * f[c] - x[c] * f[b];
                all_force += fabs(f[a]);
                all_moment += fabs(x[b] * f[c]) + fabs(x[c] * f[b]);
            }
        }
        assert_true(all_force > 0);
        for (int a = 0; a < 3; a++) {
            assert_near(force[a], 0, 1e-13 * all_force);
            assert_near(moment[a], 0, 1e-13 * all_moment);
        }
        small_body_free(&small);
    }
}

/* A turn by 40 degrees, in space about an axis askew: what is left of a force is the rounding of u,
 * 1e-16 of the body's size, as a strain of some 1e-15, over the spacing. */
static void test_rotation_makes_no_force(void **state)
{
    (void)state;
    for (int n = 0; n < KINDS; n++) {
        struct small_body small;
        double H[9];
        body_of(&small, &kinds[n]);
        const bool flat = small.lattice.dimensions == 2;
        const double angle = 0.7, c = cos(angle), s = sin(angle);
        const double axis[3] = {flat ? 0 : 2.0 / 7, flat ? 0 : 3.0 / 7, flat ? 1 : 6.0 / 7};
        const double cross[9] = {0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0};
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                H[3 * a + b] =
                    (a == b) * (c - 1) + s * cross[3 * a + b] + (1 - c) * axis[a] * axis[b];
        small_body_deform(&small, H);
        flatten(&small);
        small_body_force(&small, false, false);
        assert_true(small_body_largest(&small, small.body.f) <
                    1e-13 * 210e9 / small.lattice.spacing);
        small_body_free(&small);
    }
}

/* Central difference of the energy along a random motion against -f.b V: its error is h^2 of the
 * step's second order, and the rounding of the energy, 1e-16, over h: with h = 1e-6 spacings
 * against strains of a per cent both are below 1e-8 of the sum of |f||b|. */
static double gradient_error(struct small_body *small)
{
    const double h = 1e-6;
    double *start[3], *way[3], energy[2], rest = 0, scale = 0;
    const size_t n = (size_t)small->body.grid.n_sites;
    for (int a = 0; a < 3; a++) {
        start[a] = malloc(n * sizeof(double));
        way[a] = malloc(n * sizeof(double));
        memcpy(start[a], small->body.u[a], n * sizeof(double));
    }
    small_body_shake(small, 1, 9);
    flatten(small);
    for (int a = 0; a < 3; a++)
        for (size_t i = 0; i < n; i++) way[a][i] = small->body.u[a][i] - start[a][i];
    for (int side = 0; side < 2; side++) {
        for (int a = 0; a < 3; a++)
            for (size_t i = 0; i < n; i++)
                small->body.u[a][i] = start[a][i] + (side ? -h : h) * way[a][i];
        energy[side] = small_body_potential(small);
    }
    for (int a = 0; a < 3; a++) memcpy(small->body.u[a], start[a], n * sizeof(double));
    small_body_force(small, false, false);
    for (int a = 0; a < 3; a++)
        for (size_t i = 0; i < n; i++) {
            rest += small->body.f[a][i] * way[a][i] * small->body.volume;
            scale += fabs(small->body.f[a][i] * way[a][i]) * small->body.volume;
        }
    for (int a = 0; a < 3; a++) {
        free(start[a]);
        free(way[a]);
    }
    return (rest + (energy[0] - energy[1]) / (2 * h)) / scale;
}

/* With a crack through the body, too, that opens after plastic flow. */
static void test_force_is_gradient_of_energy(void **state)
{
    (void)state;
    for (int n = 0; n < KINDS; n++) {
        struct small_body small;
        body_of(&small, &kinds[n]);
        load(&small);
        small_body_shake(&small, 0.002, 5);
        flatten(&small);
        assert_near(gradient_error(&small), 0, 1e-7);
        for (int64_t s = 0; s < small.bonds->count; s += 3) {
            double *weight = bonds_own_weights(small.bonds, &small.bonds->strips[s]);
            for (int k = 0; k < small.bonds->strips[s].count; k += 2) weight[k] = 0;
        }
        assert_near(gradient_error(&small), 0, 1e-7);
        small_body_force(&small, true, false);
        small_body_shake(&small, 0.002, 6);
        flatten(&small);
        assert_near(gradient_error(&small), 0, 1e-7);
        small_body_free(&small);
    }
}

/* Bars of particles that fly at each other, cases Compression_2x1x1 and 3x1x1 of Peridigm's
 * verification: there with a spacing of 2 m and of 1 m, here of 25 um, the times and displacements
 * being so much less. */
static void fly_together(int nodes, double spacing, double displacement, double velocity)
{
    struct small_body small;
    struct boundary nothing = small_free_boundary();
    const double scale = SMALL_SPACING / spacing;
    small_body_new(
        &small,
        &(struct small_case){
            {nodes, 1, 1}, 1.1, 0, NULL, "{A: {model: ordinary, " ELASTIC "}}", .n_phases = 1});
    const int64_t first = grid_site(&small.body.grid, (const int[]){0, 0, 0}),
                  last = grid_site(&small.body.grid, (const int[]){nodes - 1, 0, 0});
    small.body.v[0][first] = 1;
    small.body.v[0][last] = -1;
    struct integration integration = integration_new(true, 1e-5 * scale, 0, &small.materials,
                                                     &small.body, &nothing, small.model);
    for (int n = 0; n < 5; n++)
        verlet_step(&integration, &small.body, &nothing, small.model, true, false);
    /* The figures have thirteen digits. */
    assert_relative(small.body.u[0][first], displacement * scale, 1e-10);
    assert_relative(small.body.v[0][first], velocity, 1e-10);
    assert_relative(small.body.u[0][last], -displacement * scale, 1e-10);
    if (nodes == 3) assert_near(small.body.u[0][first + 1], 0, 1e-15 * SMALL_SPACING);
    integration_free(&integration);
    boundary_free(&nothing);
    small_body_free(&small);
}

static void test_two_and_three_particles(void **state)
{
    (void)state;
    fly_together(2, 2, 4.704698050625e-5, 0.818066190245);
    fly_together(3, 1, 4.560540381290e-5, 0.731208192625);
}

/* A finite change of volume: every bond, at surfaces and corners, has e = strain |xi|, and the mean
 * stress of each node is K theta to round-off: 100 terms. */
static void test_bulk_modulus_is_exact(void **state)
{
    (void)state;
    static const enum plane planes[] = {SPACE, PLANE_STRESS, PLANE_STRAIN};
    static const char *const corrections[] = {NULL, "volume", "energy"};
    for (int n = 0; n < 3; n++)
        for (int c = 0; c < 3; c++) {
            struct small_body small;
            const double e = 0.1, K = 130e9, mu = 78e9, lambda = K - 2 * mu / 3;
            const bool flat = planes[n] != SPACE;
            const double area = planes[n] == PLANE_STRAIN
                                    ? lambda + mu
                                    : mu * (3 * lambda + 2 * mu) / (lambda + 2 * mu);
            small_body_new(&small, &(struct small_case){{9, 8, flat ? 1 : 7},
                                                        3.015,
                                                        family_influence("linear"),
                                                        NULL,
                                                        ordinary_alone,
                                                        .plane = planes[n],
                                                        .surface_correction = corrections[c]});
            small_body_deform(&small, (const double[]){e, 0, 0, 0, e, 0, 0, 0, e});
            flatten(&small);
            model_prepare(small.model, &small.body, 3);
            for (int64_t i = 0; i < small.body.grid.n_sites; i++) {
                if (!small_body_has(&small, i)) continue;
                double *const *S = small.body.S, mean = flat ? (S[0][i] + S[4][i]) / 2
                                                             : (S[0][i] + S[4][i] + S[8][i]) / 3;
                assert_relative(mean, flat ? 2 * area * e : 3 * K * e, 1e-13);
            }
            small_body_free(&small);
        }
}

/* C11, C12, C44 of the node in the middle: small strains, so that what is of second order is 1e-7
 * of it, and rounding 1e-9. */
struct stiffness {
    double c11, c12, c44;
};

static struct stiffness measure(struct small_body *small)
{
    const double e = 1e-7;
    const int64_t middle = small_body_middle(small);
    double P[9];
    struct stiffness c;
    small_body_deform(small, (const double[]){e, 0, 0, 0, 0, 0, 0, 0, 0});
    small_body_stress(small, middle, P);
    c.c11 = P[0] / e;
    c.c12 = P[4] / e;
    small_body_deform(small, (const double[]){0, e, 0, e, 0, 0, 0, 0, 0});
    small_body_stress(small, middle, P);
    c.c44 = P[1] / (2 * e);
    return c;
}

static struct stiffness stiffness_of(const char *materials, double horizon, const char *influence,
                                     bool partial, enum plane plane)
{
    struct small_body small;
    const int width = 2 * (int)floor(horizon) + 1;
    small_body_new(&small, &(struct small_case){{width, width, plane ? 1 : width},
                                                horizon,
                                                family_influence(influence),
                                                NULL,
                                                materials,
                                                .partial = partial,
                                                .plane = plane});
    struct stiffness c = measure(&small);
    small_body_free(&small);
    return c;
}

/* Sums over a full family, in spacings: w r^2, w r^power n_x^4, w r^power n_x^2 n_y^2; w r^(power -
 * 2). */
struct moments {
    double m, quartic, mixed, count;
};

static struct moments family_sums(double horizon, double (*w)(double), int power, bool flat)
{
    const int reach = (int)floor(horizon);
    struct moments sum = {0, 0, 0, 0};
    for (int z = flat ? 0 : -reach; z <= (flat ? 0 : reach); z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                const double r = sqrt(x * x + y * y + z * z);
                if (r == 0 || r > horizon) continue;
                sum.m += w(r) * r * r;
                sum.quartic += w(r) * pow(r, power - 4) * pow(x, 4);
                sum.mixed += w(r) * pow(r, power - 4) * x * x * y * y;
                sum.count += w(r) * pow(r, power - 2);
            }
    return sum;
}
static double one(double r)
{
    (void)r;
    return 1;
}
static double inverse(double r)
{
    return 1 / r;
}
static double linear_at_three(double r)
{
    return 1 - r / 3.015;
}

static void check_stiffness(struct stiffness c, double c11, double c12, double c44)
{
    assert_relative(c.c11, c11, 1e-6);
    assert_relative(c.c12, c12, 1e-6);
    assert_relative(c.c44, c44, 1e-6);
}

/* psi = k theta^2/2 + (b/2) sum w e^2 V with e = |xi| n.eps.n, b = 15 mu/m. */
static void test_ordinary_moduli_are_the_sums(void **state)
{
    (void)state;
    const double K = 130e9, mu = 78e9, lambda = K - 2 * mu / 3;
    static const struct {
        const char *name;
        double (*w)(double);
    } functions[] = {{"constant", one}, {"inverse", inverse}, {"linear", linear_at_three}};
    for (int n = 0; n < 3; n++) {
        const struct moments s = family_sums(3.015, functions[n].w, 2, false),
                             f = family_sums(3.015, functions[n].w, 2, true);
        const double k = K - 5 * mu / 3, b = 15 * mu / s.m, flat = 8 * mu / f.m;
        check_stiffness(stiffness_of(ordinary_alone, 3.015, functions[n].name, false, SPACE),
                        k + b * s.quartic, k + b * s.mixed, b * s.mixed);
        const double strain = lambda + mu - 2 * mu,
                     stress = mu * (3 * lambda + 2 * mu) / (lambda + 2 * mu) - 2 * mu;
        check_stiffness(stiffness_of(ordinary_alone, 3.015, functions[n].name, false, PLANE_STRAIN),
                        strain + flat * f.quartic, strain + flat * f.mixed, flat * f.mixed);
        check_stiffness(stiffness_of(ordinary_alone, 3.015, functions[n].name, false, PLANE_STRESS),
                        stress + flat * f.quartic, stress + flat * f.mixed, flat * f.mixed);
    }
}

/* Of many spacings a horizon the sums become integrals, and the moduli those of the material: in
 * the plane lambda + 2 mu, or E/(1 - nu^2).  At eight spacings the sums of the linear function are
 * 0.4 % off. */
static void test_plane_moduli_are_those_of_the_material(void **state)
{
    (void)state;
    const double K = 130e9, mu = 78e9, lambda = K - 2 * mu / 3, E = 9 * K * mu / (3 * K + mu),
                 nu = E / (2 * mu) - 1;
    struct stiffness strain = stiffness_of(ordinary_alone, 8.015, "linear", false, PLANE_STRAIN),
                     stress = stiffness_of(ordinary_alone, 8.015, "linear", false, PLANE_STRESS);
    assert_relative(strain.c11, lambda + 2 * mu, 5e-3);
    assert_near(strain.c12, lambda, 5e-3 * mu);
    assert_relative(strain.c44, mu, 5e-3);
    assert_relative(stress.c11, E / (1 - nu * nu), 5e-3);
    assert_near(stress.c12, nu * E / (1 - nu * nu), 5e-3 * mu);
    assert_relative(stress.c44, mu, 5e-3);
}

/* A sheet in plane stress, stretched by e along x and -nu e along y, grows thinner by nu e, and its
 * true stress is the nominal one over the section that this leaves: P_xx/(1 - nu e)^2. */
static void test_sheets_grow_thinner(void **state)
{
    (void)state;
    const double e = 0.01, nu = (3 * 130e9 - 2 * 78e9) / (2 * (3 * 130e9 + 78e9));
    struct small_body small;
    struct node_state node;
    small_body_new(&small, &(struct small_case){{25, 25, 1},
                                                3.015,
                                                family_influence("linear"),
                                                .materials = ordinary_alone,
                                                .plane = PLANE_STRESS});
    small_body_deform(&small, (double[9]){e, 0, 0, 0, -nu * e});
    small_body_force(&small, false, false);
    model_prepare(small.model, &small.body, 3);
    const int64_t middle = small_body_middle(&small);
    const int i = small_body_observe(&small, middle, &node);
    const double section = (1 - nu * e) * (1 - nu * e);
    /* rounding of strains of a per cent from displacements of tenths of a spacing */
    assert_relative(node.H[8][i], -nu * e, 1e-12);
    assert_relative(node.cauchy[0][i], small.body.S[0][middle] / section, 1e-12);
    small_body_free(&small);
}

/* Young's modulus along a lattice axis over its nominal value, at nu = 0.3: sums of an independent
 * program over the same families, to the last digit given; partial volumes of the nodes within the
 * horizon alone. */
static void test_youngs_modulus_on_the_lattice(void **state)
{
    (void)state;
    static const char steel[] =
        "{A: {model: ordinary, density: 7800, youngs_modulus: 200 GPa, poissons_ratio: 0.3}}";
    static const struct {
        double horizon;
        const char *influence;
        bool partial;
        double ratio;
    } expected[] = {
        {2.015, "constant", false, 1.131}, {3.015, "constant", false, 0.854},
        {4.015, "constant", false, 0.975}, {5.015, "constant", false, 0.962},
        {3.015, "constant", true, 0.888},  {2.015, "inverse", false, 1.118},
        {3.015, "inverse", false, 0.886},  {2.015, "linear", false, 0.920},
        {3.015, "linear", false, 0.998},   {4.015, "linear", false, 0.989},
        {5.015, "linear", false, 0.996},   {3.015, "linear", true, 1.005},
        {3.015, "gaussian", false, 0.992}, {3.015, "spline", false, 1.073},
    };
    for (size_t n = 0; n < sizeof expected / sizeof *expected; n++) {
        struct stiffness c = stiffness_of(steel, expected[n].horizon, expected[n].influence,
                                          expected[n].partial, SPACE);
        const double E = c.c11 - 2 * c.c12 * c.c12 / (c.c11 + c.c12);
        assert_near(E / 200e9, expected[n].ratio, 6e-4);
    }
}

/* c of the continuum, with the lattice's sums: C11 = (c/2) sum w r n_x^4 V, C12 = C44 = (c/2) sum w
 * r n_x^2 n_y^2 V.  With w = 1 the micromoduli are those of the literature. */
static void test_bond_based_moduli_are_the_sums(void **state)
{
    (void)state;
    const double E = 210e9, K = E / 1.5, pi = acos(-1), delta = 3.015 * SMALL_SPACING,
                 h = SMALL_SPACING;
    const struct moments s = family_sums(3.015, one, 1, false),
                         f = family_sums(3.015, one, 1, true);
    const double lattice = pow(SMALL_SPACING, 4),
                 c[3] = {18 * K / (pi * pow(delta, 4)), 9 * E / (pi * h * pow(delta, 3)),
                         48 * E / (5 * pi * h * pow(delta, 3))};
    static const enum plane planes[] = {SPACE, PLANE_STRESS, PLANE_STRAIN};
    for (int n = 0; n < 3; n++) {
        const struct moments *sums = n ? &f : &s;
        const double half = c[n] / 2 * lattice;
        check_stiffness(stiffness_of(bond_based_alone, 3.015, "constant", false, planes[n]),
                        half * sums->quartic, half * sums->mixed, half * sums->mixed);
    }
    /* Young's modulus and Poisson's ratio of the material with many spacings a horizon. */
    struct stiffness stress = stiffness_of(bond_based_alone, 8.015, "linear", false, PLANE_STRESS),
                     strain = stiffness_of(bond_based_alone, 8.015, "linear", false, PLANE_STRAIN);
    assert_relative(stress.c11, E / (1 - 1.0 / 9), 0.02);
    assert_relative(stress.c12, E / 3 / (1 - 1.0 / 9), 0.02);
    assert_relative(strain.c11, 1.2 * E, 0.02);
    assert_relative(strain.c12, 0.4 * E, 0.02);
}

/* Errors of the energy of a uniform strain with the micromodulus of the continuum, w = 1, as an
 * independent program has summed them up, to the last digit given. */
static void test_bond_based_energy_of_uniform_strain(void **state)
{
    (void)state;
    const double E = 210e9, K = E / 1.5, mu = E / 2.5;
    struct stiffness c = stiffness_of(bond_based_alone, 3.015, "constant", false, SPACE);
    assert_near((c.c11 + 2 * c.c12) / (3 * K), 1.0987, 1e-4);
    assert_near(c.c44 / mu, 1.194, 6e-4);
    assert_near(c.c11 / (K + 4 * mu / 3), 1.036, 6e-4);
    c = stiffness_of(bond_based_alone, 2.015, "constant", false, SPACE);
    assert_near((c.c11 + 2 * c.c12) / (3 * K), 0.943, 6e-4);
    assert_near(c.c44 / mu, 0.855, 6e-4);
    assert_near(c.c11 / (K + 4 * mu / 3), 1.001, 6e-4);
}

/* The a, b, d form: the sums of its own constants; and, the horizon growing, the linear solid with
 * the inverse function: bulk and shear modulus come nearer to the material's. */
static void test_madenci_oterkus_moduli(void **state)
{
    (void)state;
    const double K = 130e9, mu = 78e9, pi = acos(-1), H = 3.015;
    const struct moments s = family_sums(H, inverse, 2, false);
    /* theta = d delta sum s V for e = r n.eps.n: two thirds of it lie across. */
    const double third = 9 / (4 * pi * pow(H, 3)) * family_sums(H, one, 2, false).count / 3;
    const double k = (K - 5 * mu / 3) * third * third, b = 15 * mu / (pi * pow(H, 4));
    check_stiffness(stiffness_of(madenci_oterkus_alone, H, "inverse", false, SPACE),
                    k + b * s.quartic, k + b * s.mixed, b * s.mixed);
    double error[2][2];
    for (int n = 0; n < 2; n++) {
        struct stiffness far =
            stiffness_of(madenci_oterkus_alone, n ? 10.015 : 3.015, "inverse", false, SPACE);
        error[n][0] = fabs((far.c11 + 2 * far.c12) / (3 * K) - 1);
        error[n][1] = fabs(far.c44 / mu - 1);
    }
    for (int k2 = 0; k2 < 2; k2++) {
        assert_true(error[1][k2] < error[0][k2] / 3);
        assert_true(error[1][k2] < 0.02);
    }
}

/* Force density in the middle of a sheet under u_x = A sin(kappa x). */
static double wave_force(const char *materials, double horizon, double length)
{
    struct small_body small;
    const int size[3] = {(int)(4 * horizon) + 1, (int)(4 * horizon) + 1, 1};
    small_body_new(&small, &(struct small_case){{size[0], size[1], 1},
                                                horizon,
                                                family_influence("inverse"),
                                                NULL,
                                                materials,
                                                .plane = PLANE_STRAIN});
    const int64_t middle = small_body_middle(&small);
    int centre[3];
    small_body_position(&small, middle, centre);
    const double kappa = 2 * acos(-1) / (length * SMALL_SPACING);
    for (int64_t i = 0; i < small.body.grid.n_sites; i++) {
        int at[3];
        if (!small_body_has(&small, i)) continue;
        small_body_position(&small, i, at);
        small.body.u[0][i] =
            1e-7 * SMALL_SPACING * cos(kappa * (at[0] - centre[0]) * SMALL_SPACING);
    }
    small_body_force(&small, false, false);
    const double force = small.body.f[0][middle] / (1e-7 * SMALL_SPACING * kappa * kappa);
    small_body_free(&small);
    return -force;
}

/* Long waves move alike, with lambda + 2 mu; waves of two horizons do not, since the two weigh the
 * dilatation differently: with a bulk modulus far above the shear modulus that is what matters. */
static void test_madenci_oterkus_and_linear_solid_part_in_short_waves(void **state)
{
    (void)state;
    static const char a[] = "{A: {model: madenci_oterkus, density: 7800, bulk_modulus: 200 GPa, "
                            "shear_modulus: 20 GPa}}";
    static const char b[] =
        "{A: {model: ordinary, density: 7800, bulk_modulus: 200 GPa, shear_modulus: 20 GPa}}";
    const double horizon = 10.3;
    const double long_a = wave_force(a, horizon, 30 * horizon),
                 long_b = wave_force(b, horizon, 30 * horizon),
                 short_a = wave_force(a, horizon, 2 * horizon),
                 short_b = wave_force(b, horizon, 2 * horizon);
    /* The lattice's sums of w, which the constants of the continuum meet, are 4 % off at ten
     * spacings. */
    assert_relative(long_a, 200e9 + 4.0 / 3 * 20e9, 0.05);
    assert_relative(long_b, 200e9 + 4.0 / 3 * 20e9, 0.01);
    assert_true(fabs(short_a / long_a - short_b / long_b) > 0.15 * short_b / long_b);
}

/* Energy of a bar of 40 x 8 x 8 nodes under uniform uniaxial stress, over that of as much of its
 * inside. */
static double energy_ratio(const char *materials, const char *influence, const char *correction)
{
    struct small_body small;
    const double e = 1e-6;
    small_body_new(&small, &(struct small_case){{40, 8, 8},
                                                3.015,
                                                family_influence(influence),
                                                NULL,
                                                materials,
                                                .n_phases = 1,
                                                .surface_correction = correction});
    const double nu = small.materials.items[0].poissons_ratio;
    const struct stiffness c = stiffness_of(materials, 3.015, influence, false, SPACE);
    const double inside = 0.5 * e * e *
                          (c.c11 * (1 + 2 * nu * nu) + 2 * c.c12 * (nu * nu - 2 * nu)) *
                          small.body.volume * (double)small.lattice.n_nodes;
    small_body_deform(&small, (const double[]){e, 0, 0, 0, -nu * e, 0, 0, 0, -nu * e});
    const double energy = small_body_elastic_energy(&small);
    small_body_free(&small);
    return energy / inside;
}

/* The surfaces take a fifth of the stiffness of a bond-based bar 8 nodes wide, and of one with
 * constants a, b, d. The volume method, blind to the direction of the missing bonds, which are
 * those across the load, gives back too much; the energy method leaves less than half of the error.
 * An ordinary bar is too stiff under a strain that does not give way at its surfaces, less so with
 * the energy method. */
static void test_surface_corrections(void **state)
{
    (void)state;
    static const char *const materials[] = {bond_based_alone, madenci_oterkus_alone, ordinary_alone,
                                            ordinary_alone},
                             *const influences[] = {"constant", "inverse", "linear", "constant"};
    for (int n = 0; n < 4; n++) {
        const double none = energy_ratio(materials[n], influences[n], NULL),
                     volume = energy_ratio(materials[n], influences[n], "volume"),
                     energy = energy_ratio(materials[n], influences[n], "energy");
        assert_true(fabs(energy - 1) < 0.8 * fabs(none - 1));
        if (n >= 2) continue;
        assert_true(none < 0.85);
        assert_true(volume > 1 && volume - 1 < 1 - none);
        assert_true(fabs(energy - 1) < (1 - none) / 2);
    }
}

/* Deep inside the body nothing is corrected, to the last bit. */
static void test_correction_leaves_the_inside(void **state)
{
    (void)state;
    static const char *const corrections[] = {"volume", "energy"};
    for (int c = 0; c < 2; c++) {
        struct small_body small, plain;
        struct small_case wanted = {{15, 15, 15}, 3.015, 0, NULL, bond_based_alone, .n_phases = 1};
        small_body_new(&plain, &wanted);
        wanted.surface_correction = corrections[c];
        small_body_new(&small, &wanted);
        small_body_deform(&small, stretch);
        small_body_deform(&plain, stretch);
        double P[9], Q[9];
        small_body_stress(&small, small_body_middle(&small), P);
        small_body_stress(&plain, small_body_middle(&plain), Q);
        for (int k = 0; k < 9; k++) assert_true(P[k] == Q[k]);
        small_body_free(&small);
        small_body_free(&plain);
    }
}

static void build(const void *wanted)
{
    struct small_body small;
    small_body_new(&small, wanted);
}

static void test_errors(void **state)
{
    (void)state;
    struct small_case wanted = {{3, 3, 3}, 1.1, 0, NULL, madenci_oterkus_alone, .n_phases = 1};
    wanted.surface_correction = "none, influence: linear";
    assert_dies(EXIT_USER, "'inverse'", build, &wanted);
    wanted.materials = "{A: {model: ordinary_plastic, " ELASTIC
                       ", hardening: {law: linear, yield: 1 MPa, modulus: 0 Pa}}}";
    wanted.surface_correction = NULL;
    wanted.size[2] = 1;
    wanted.plane = PLANE_STRESS;
    assert_dies(EXIT_USER, "three dimensions", build, &wanted);
    wanted.materials = ordinary_alone;
    wanted.surface_correction = "half";
    assert_dies(EXIT_USER, "energy", build, &wanted);
    wanted.surface_correction = NULL;
    wanted.materials = "{A: {model: ordinary, density: 1, bulk_modulus: 1 GPa}}";
    assert_dies(EXIT_USER, "needs two of", build, &wanted);
    wanted.n_phases = 2;
    wanted.materials =
        "{A: {model: ordinary, " ELASTIC "}, B: {model: madenci_oterkus, " ELASTIC "}}";
    assert_dies(EXIT_USER, "share one formulation", build, &wanted);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forces_and_moments_cancel),
        cmocka_unit_test(test_rotation_makes_no_force),
        cmocka_unit_test(test_force_is_gradient_of_energy),
        cmocka_unit_test(test_two_and_three_particles),
        cmocka_unit_test(test_bulk_modulus_is_exact),
        cmocka_unit_test(test_ordinary_moduli_are_the_sums),
        cmocka_unit_test(test_plane_moduli_are_those_of_the_material),
        cmocka_unit_test(test_youngs_modulus_on_the_lattice),
        cmocka_unit_test(test_bond_based_moduli_are_the_sums),
        cmocka_unit_test(test_bond_based_energy_of_uniform_strain),
        cmocka_unit_test(test_madenci_oterkus_moduli),
        cmocka_unit_test(test_madenci_oterkus_and_linear_solid_part_in_short_waves),
        cmocka_unit_test(test_surface_corrections),
        cmocka_unit_test(test_correction_leaves_the_inside),
        cmocka_unit_test(test_sheets_grow_thinner),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests_name("ordinary", tests, small_ranks_start, small_ranks_stop);
}
