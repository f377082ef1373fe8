/* Verification cases of other peridynamics codes, each against the exact answer, or where there is
 * none against a figure recomputed in tests/lammps/peers.awk.  All here have the spacing of small
 * bodies: lengths and times are theirs times one factor, force densities over it.
 *
 * Not here: J2 points, test_j2.c; soft flaw, test_yield.c; final state of the colliding particles
 * and moduli of the lattice, test_ordinary.c; decomposition, ranks.bats; waves of correspondence,
 * test_wave.c. */
#include "check.h"

#include "small_body.h"
#include "small_static.h"
#include "verlet.h"

#include <stdio.h>
#include <stdlib.h>

static void show(const char *what, double value)
{
    if (getenv("HS_SHOW")) printf("# %s: %.6g\n", what, value);
}

static int64_t site_at(const struct small_body *small, int x, int y, int z)
{
    return grid_site(&small->body.grid, (const int[]){x, y, z});
}

#define PERIDIGM                                                                                   \
    "{A: {model: ordinary, density: 7800, bulk_modulus: 130 GPa, shear_modulus: 78 GPa}}"

/* Peridigm, Compression_2x1x1 and _3x1x1: particles that fly at each other at 1 m/s, 2 m and 1 m
 * apart.  Peridigm is right: peers.awk finds its figures from the textbook.  Half a unit of their
 * last digit, or the rounding of extensions of 1e-5 from positions of 1 m: 1e-11. */
static void fly_together(int nodes, double spacing, double volume, const double *force,
                         double energy)
{
    struct small_body small;
    struct boundary nothing = small_free_boundary();
    const double scale = SMALL_SPACING / spacing;
    small_body_new(&small, &(struct small_case){{nodes, 1, 1}, 1.1, .materials = PERIDIGM});
    small.body.v[0][site_at(&small, 0, 0, 0)] = 1;
    small.body.v[0][site_at(&small, nodes - 1, 0, 0)] = -1;
    struct integration integration = integration_new(true, 1e-5 * scale, 0, &small.materials,
                                                     &small.body, &nothing, small.model);
    for (int n = 0; n < 5; n++) {
        verlet_step(&integration, &small.body, &nothing, small.model, true, false);
        if (force)
            assert_relative(small.body.f[0][site_at(&small, 0, 0, 0)] * scale, force[n], 1e-9);
        /* first step: dilatation -3e-5, so that the mean stress is K times it, 3e-5 K and no more
         */
        if (n == 0 && force) {
            double P[9];
            small_body_stress(&small, site_at(&small, 0, 0, 0), P);
            assert_relative((P[0] + P[4] + P[8]) / 3, -3e-5 * 130e9, 1e-10);
        }
    }
    assert_relative(integration.balance.stored / nodes / small.body.volume * volume, energy, 2e-9);
    integration_free(&integration);
    boundary_free(&nothing);
    small_body_free(&small);
}

static void test_particles_that_collide(void **state)
{
    (void)state;
    static const double force[] = {-1.17e7, -2.32245e7, -3.44006325e7, -4.50607555e7,
                                   -5.50449672e7};
    fly_together(2, 2, 2, force, 2589.6995);
    fly_together(3, 1, 1, NULL, 1216.71392131);
}

/* Plastic strain and von Mises stress (Kirchhoff) of a node. */
static void look(struct small_body *small, int64_t site, double *p, double *mises, double *axial)
{
    struct node_state node;
    const int i = small_body_observe(small, site, &node);
    *p = node.plastic[i];
    *axial = (1 + node.H[4][i]) * node.cauchy[1][i];
    *mises = *axial - (1 + node.H[4][i]) * node.cauchy[0][i];
}

/* Peridigm, IsotropicHardeningPlasticFullyPrescribedTension_NoFlaw and
 * ElasticPlasticCorrespondence...: a bar of 4 x 24 x 4 particles in uniaxial strain.  Without
 * rotation the rate form is the logarithmic strain, and the answer exact, in nine and ten digits
 * here.  Peridigm's own files have 7 and 10 % less plastic strain and are wrong. Its stresses,
 * whose rate form knows no volume, are Kirchhoff stresses. */
static void check_uniaxial(const char *law, const char *materials, const double F[4],
                           const double p[4], const double mises[4], double axial)
{
    struct small_body small;
    small_body_new(&small,
                   &(struct small_case){{4, 24, 4}, 3.004, 0, law, materials, .n_phases = 1});
    for (int n = 0; n < 4; n++) {
        double strain = 0, stress = 0, along = 0;
        small_body_deform(&small, (double[9]){0, 0, 0, 0, F[n] - 1});
        small_body_force(&small, true, false);
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            if (!small_body_has(&small, site)) continue;
            look(&small, site, &strain, &stress, &along);
            assert_relative(strain, p[n], 2e-9);
            assert_relative(stress, mises[n], 2e-9);
        }
        if (n == 3) assert_relative(along, axial, 2e-9);
    }
    small_body_free(&small);
}

static void test_uniaxial_strain(void **state)
{
    (void)state;
    static const char hard[] =
        "{A: {model: correspondence, density: 7800, youngs_modulus: 211 GPa, "
        "poissons_ratio: 0, hardening: {law: linear, yield: 460 MPa, modulus: "
        "5 GPa}}}",
                      ideal[] =
                          "{A: {model: correspondence, density: 7800, youngs_modulus: 200 GPa, "
                          "poissons_ratio: 0, hardening: {law: linear, yield: 150 MPa, modulus: "
                          "0 Pa}}}";
    static const char *const laws[] = {small_mix, small_capped};
    for (int k = 0; k < 2; k++) {
        check_uniaxial(laws[k], hard, (double[]){1.025, 1.05, 1.075, 1.1},
                       (double[]){0.0147749339, 0.0305901233, 0.0460331558, 0.0611211444},
                       (double[]){533874669.6, 612950616.5, 690165779.1, 765605722.2}, 7213886461);
        check_uniaxial(laws[k], ideal, (double[]){1.002, 1.004, 1.006, 1.008},
                       (double[]){8.32001775e-4, 2.16134751e-3, 3.48804779e-3, 4.81211310e-3},
                       (double[]){150e6, 150e6, 150e6, 150e6}, 631211309.9);
    }
}

/* Peridigm, ElasticBondBased3D: the same bar, K = 200 GPa, drawn by 0.1 %; force on the upper half.
 * Peridigm is right, in 13 digits.  Local elasticity has (9/5) K 0.001 m^2 = 360 MN: 30 % are
 * missing at the surfaces of a section of 4 x 4. */
static void test_bar_of_springs(void **state)
{
    (void)state;
    struct small_body small;
    double force = 0;
    small_body_new(&small, &(struct small_case){{4, 24, 4},
                                                3.004,
                                                .materials = "{A: {model: bond_based, density: "
                                                             "7800, bulk_modulus: 200 GPa}}"});
    small_body_deform(&small, (double[9]){0, 0, 0, 0, 0.001});
    small_body_force(&small, false, false);
    for (int y = 12; y < 24; y++)
        for (int z = 0; z < 4; z++)
            for (int x = 0; x < 4; x++)
                force += small.body.f[1][site_at(&small, x, y, z)] * small.body.volume;
    /* forces over the squares of lengths; rounding of 192 x 120 terms */
    assert_relative(force * pow(0.25 / SMALL_SPACING, 2), -251257390.90063, 1e-11);
    small_body_free(&small);
}

/* Energy density of the middle node: half of each of its bonds'. */
static double middle_energy(struct small_body *small)
{
    const int64_t middle = small_body_middle(small);
    double sum = 0;
    for (int64_t s = 0; s < small->bonds->count; s++) {
        const struct bond_strip *strip = &small->bonds->strips[s];
        const struct bond_view view = bonds_view(small->bonds, strip);
        double energy[BOND_LANES];
        small->model->formulation->bond_energy(small->model->self, &small->body, strip, energy);
        for (int k = 0; k < view.count; k++)
            if (bond_lower(&view, k) == middle || bond_upper(&view, k) == middle)
                sum += energy[k] / 2 * small->body.volume;
    }
    return sum;
}

/* Peridynamics.jl, test_strain_energy_density.jl: a cube of 12^3, horizon 3.015 spacings, stretched
 * by 1.1 or sheared by 0.1.  Bond-based: the error of the lattice, for which Peridynamics.jl gives
 * bands of 1 % and peers.awk the figures; ordinary and correspondence: none, at surfaces neither.
 */
static void test_energy_of_affine_motions(void **state)
{
    (void)state;
    static const struct {
        double H[9], expected; /* energy less 1 */
    } motions[] = {
        {{0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1}, 0.0987}, {{0, 0.1}, 0.1960}, {{0.1}, 0.0679}};
    const double E = 210e9, K = E / 1.5, G = E / 2.5;
    const double density[] = {4.5 * K * 0.01, 0.5 * G * 0.01, 0.5 * (K + 4 * G / 3) * 0.01};
    struct small_body small;
    small_body_new(&small, &(struct small_case){{12, 12, 12},
                                                3.015,
                                                .materials = "{A: {model: bond_based, density: "
                                                             "7850, youngs_modulus: 210 GPa}}"});
    for (int n = 0; n < 3; n++) {
        small_body_deform(&small, motions[n].H);
        /* half a unit of the last digit */
        assert_near(middle_energy(&small) / density[n] - 1, motions[n].expected, 5.1e-5);
    }
    small_body_free(&small);

    const struct small_case ordinary = {
        {12, 12, 12},
        3.015,
        .materials = "{A: {model: ordinary, density: 7850, youngs_modulus: 210 GPa, "
                     "poissons_ratio: 0.25}}"};
    small_body_new(&small, &ordinary);
    small_body_deform(&small, motions[0].H);
    const double volume = 12 * 12 * 12 * small.body.volume;
    /* rounding of e, 1e-16 of |y|, a tenth of it */
    assert_relative(small_body_elastic_energy(&small), density[0] * volume, 1e-14);
    small_body_free(&small);

    small_body_new(&small, &(struct small_case){
                               {12, 12, 12}, 3.015, 0, small_mix, small_elastic, .n_phases = 1});
    small_body_deform(&small, motions[0].H);
    const double bulk = small.materials.items[0].bulk_modulus;
    /* the logarithm of b = 1.21 by its series to the seventh power: 0.095^8/9 of it */
    assert_relative(small_body_elastic_energy(&small), 4.5 * bulk * pow(log(1.1), 2) * volume,
                    2e-9);
    small_body_free(&small);
}

/* A body that Peridynamics.jl has. */
struct peer {
    const char *materials, *stabilisation, *correction, *influence;
    double horizon;
};

static void peer_new(struct small_body *small, const struct peer *peer, int x, int y, int z)
{
    small_body_new(small, &(struct small_case){{x, y, z},
                                               peer->horizon,
                                               family_influence(peer->influence),
                                               peer->stabilisation,
                                               peer->materials,
                                               .n_phases = 1,
                                               .surface_correction = peer->correction});
}

/* Peridynamics.jl, test_analytic_solutions.jl: a bar of 1 x 0.1 x 0.1, 200 GPa, one end held along
 * it, 2 MN on the last layer: 1e-3 of elongation.  Error of the elongation between the outermost
 * layers. */
static double elongation_error(const struct peer *peer, int across)
{
    struct small_body small;
    const int length = 10 * across;
    peer_new(&small, peer, length, across, across);
    struct small_static problem = small_static_new(&small);
    const double stress = 200e9 * 1e-3;
    for (int y = 0; y < across; y++)
        for (int z = 0; z < across; z++) {
            problem.held[0][site_at(&small, 0, y, z)] = 1;
            problem.load[0][site_at(&small, length - 1, y, z)] = stress / SMALL_SPACING;
        }
    /* An elongation to 1e-6. */
    small_static_solve(&problem, 1e-7, 4000);
    double mean = 0;
    for (int y = 0; y < across; y++)
        for (int z = 0; z < across; z++)
            mean += problem.u[0][site_at(&small, length - 1, y, z)] / (across * across);
    small_static_free(&problem);
    small_body_free(&small);
    return mean / (1e-3 * (length - 1) * SMALL_SPACING) - 1;
}

#define AXIAL "density: 7850, youngs_modulus: 200 GPa"
static const char springs[] = "{A: {model: bond_based, " AXIAL "}}",
                  solid[] = "{A: {model: ordinary, " AXIAL ", poissons_ratio: 0.25}}",
                  cauchy[] =
                      "{A: {model: correspondence_elastic, " AXIAL ", poissons_ratio: 0.25}}";

/* Bond-based with energy correction: Peridynamics.jl has errors of 13 % with 3 particles across
 * and 8.6 % with 4, its factors being those from the continuum's energy to that of the node.  Ours
 * are those from a full family's: they leave the lattice its 3.6 % of uniaxial stiffness at this
 * horizon, and within a hundredth that is the difference.  The bar is stiff here, soft by more than
 * half without correction.
 *
 * Correspondence: uniform stress needs loads on all layers within two horizons of an end, so that
 * the last layer alone gives a constant number of spacings, half of one: 1/n of the elongation.
 * Ordinary: the surfaces. */
static void test_elongation_of_a_bar(void **state)
{
    (void)state;
    static const double theirs[] = {-0.13, -0.086};
    static const struct peer uncorrected = {springs, NULL, NULL, "constant", 3.015},
                             corrected = {springs, NULL, "energy", "constant", 3.015};
    static const struct peer others[] = {{solid, NULL, NULL, "linear", 3.015},
                                         {cauchy, small_mix, NULL, "constant", 1},
                                         {cauchy, small_capped, NULL, "constant", 1},
                                         {cauchy, small_mix, NULL, "constant", 2}};
    for (int n = 0; n < 2; n++) {
        const double plain = elongation_error(&uncorrected, 3 + n),
                     energy = elongation_error(&corrected, 3 + n);
        show("bond-based, no correction", plain);
        show("bond-based, energy", energy);
        assert_near((1 + energy) * 1.036 - 1, theirs[n], 0.01);
        assert_true(plain > 3 * fabs(energy));
    }
    for (int k = 0; k < 4; k++) {
        double error[2];
        for (int n = 0; n < 2; n++) {
            error[n] = elongation_error(&others[k], 4 << n);
            show(others[k].stabilisation ? "correspondence" : "ordinary", error[n]);
        }
        assert_true(fabs(error[1]) < 0.6 * fabs(error[0]));
        if (others[k].stabilisation) assert_near(error[0] * 39, 0, 0.7); /* spacings */
    }
}

/* Where the kinetic energy is along x [m]. */
static double centre_of(const struct small_body *small)
{
    double sum = 0, moment = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        double x[3];
        if (!small_body_has(small, site)) continue;
        body_position(&small->body, site, x);
        const double square = pow(small->body.v[0][site], 2);
        sum += square;
        moment += square * x[0];
    }
    return moment / sum;
}

/* Speed of a pulse along a bar over sqrt(E/rho), less 1; its width is three times the bar's. */
static double speed_error(const struct peer *peer, int across)
{
    struct small_body small;
    struct boundary nothing = small_free_boundary();
    const int width = 3 * across, length = 10 * width;
    peer_new(&small, peer, length, across, across);
    const struct material *m = &small.materials.items[0];
    const double exact = sqrt(m->youngs_modulus / m->density), dt = 0.4 * SMALL_SPACING / exact,
                 way = 2.5 * width * SMALL_SPACING;
    for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
        double x[3];
        if (!small_body_has(&small, site)) continue;
        body_position(&small.body, site, x);
        small.body.v[0][site] = 1e-3 * exp(-pow(x[0] / (width * SMALL_SPACING), 2));
    }
    struct integration integration =
        integration_new(true, dt, 0, &small.materials, &small.body, &nothing, small.model);
    double place[2];
    for (int n = 0; n < 2; n++) {
        while (integration.time < (n + 1) * way / exact)
            verlet_step(&integration, &small.body, &nothing, small.model, false, false);
        place[n] = centre_of(&small) - exact * integration.time;
    }
    integration_free(&integration);
    boundary_free(&nothing);
    small_body_free(&small);
    return (place[1] - place[0]) / way;
}

/* Peridynamics.jl asks for the speed of a wave in a bar within 25 % at 4 particles across, and for
 * less with more of them, down to 5 %.  Ours at 4 and 6 across; what is left of the elastic ones is
 * half of the error of the bar's modulus, as docs/errors.md has it. */
static void test_wave_in_a_bar(void **state)
{
    (void)state;
    static const struct peer bars[] = {{springs, NULL, "energy", "constant", 3.015},
                                       {solid, NULL, NULL, "linear", 3.015},
                                       {solid, NULL, "energy", "linear", 3.015},
                                       {cauchy, small_mix, NULL, "constant", 1},
                                       {cauchy, small_capped, NULL, "constant", 2}};
    for (int k = 0; k < 5; k++) {
        double error[2];
        for (int n = 0; n < 2; n++) {
            error[n] = fabs(speed_error(&bars[k], 4 + 2 * n));
            show(bars[k].materials, error[n]);
        }
        assert_true(error[0] < 0.25);
        assert_true(error[1] < error[0] || error[1] < 0.05);
    }
}

/* Resistance of a chequerboard of displacements A, f over E A/delta^2.  Peridynamics.jl asks for
 * half, in a measure that may differ from this by a factor of two.  Bonds with forces of their own
 * have many times that.  What correspondence has is its stabilisation's alone: of mix, at a horizon
 * of one, 8/3 of the share, so that more than half of it takes a share of a fifth; at three nine
 * times as much. */
static void test_chequerboard(void **state)
{
    (void)state;
    static const struct {
        struct peer peer;
        double least;
    } bodies[] = {{{springs, NULL, NULL, "constant", 3.015}, 5},
                  {{solid, NULL, NULL, "linear", 3.015}, 5},
                  {{cauchy, small_mix, NULL, "constant", 1}, 0.26},
                  {{cauchy, small_mix, NULL, "constant", 3}, 2.3},
                  {{cauchy, "{law: mix, share: 0.2}", NULL, "constant", 1}, 0.52},
                  {{cauchy, small_capped, NULL, "constant", 1}, 5},
                  {{cauchy, small_capped, NULL, "constant", 3}, 5}};
    for (int k = 0; k < 7; k++) {
        struct small_body small;
        const double A = 1e-6 * SMALL_SPACING, delta = bodies[k].peer.horizon * SMALL_SPACING;
        peer_new(&small, &bodies[k].peer, 15, 15, 15);
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&small, site)) continue;
            small_body_position(&small, site, at);
            small.body.u[0][site] = (at[0] + at[1] + at[2]) % 2 ? A : -A;
        }
        small_body_force(&small, false, true);
        const int64_t middle = small_body_middle(&small);
        const double resistance =
            -small.body.f[0][middle] / small.body.u[0][middle] * (delta * delta / 200e9);
        show(bodies[k].peer.materials, resistance);
        assert_true(resistance > bodies[k].least);
        small_body_free(&small);
    }
}

/* Sum of v . (e_x x r) cos(pi x/L): how fast the bar twists. */
static double twist_rate(const struct small_body *small, bool set, double rate)
{
    const int *size = small->lattice.size;
    double sum = 0, norm = 0;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(small, site)) continue;
        small_body_position(small, site, at);
        const double shape = cos(acos(-1) * (at[0] + 0.5) / size[0]),
                     y = (at[1] - 0.5 * (size[1] - 1)) * SMALL_SPACING * shape,
                     z = (at[2] - 0.5 * (size[2] - 1)) * SMALL_SPACING * shape;
        if (set) {
            small->body.v[1][site] = -rate * z;
            small->body.v[2][site] = rate * y;
        }
        sum += small->body.v[2][site] * y - small->body.v[1][site] * z;
        norm += y * y + z * z;
    }
    return sum / norm;
}

/* A free square bar of 48 x 8 x 8 that twists by 0.2 to both sides: Peridynamics.jl asks for the
 * frequency within 30 % and the amplitude after a period within 5 %.  Saint-Venant: sqrt(G J/(rho
 * I))/(2 L), J = 0.1406 a^4, I = a^4/6.  Correspondence: 2 % less at a horizon of one spacing and 6
 * % at two, since a family cut off by the surface finds the shear strain of a place inside, not
 * that of the surface. */
static void test_torsion(void **state)
{
    (void)state;
    static const struct {
        struct peer peer;
        double tolerance;
    } bars[] = {{{springs, NULL, NULL, "constant", 3.015}, 0.3},
                {{solid, NULL, NULL, "linear", 3.015}, 0.3},
                {{cauchy, small_mix, NULL, "constant", 1}, 0.03},
                {{cauchy, small_capped, NULL, "constant", 2}, 0.07}};
    for (int k = 0; k < 4; k++) {
        struct small_body small;
        struct boundary nothing = small_free_boundary();
        peer_new(&small, &bars[k].peer, 48, 8, 8);
        const double G = 80e9, rho = 7850, pi = acos(-1),
                     omega = pi / (48 * SMALL_SPACING) * sqrt(G / rho * 0.1406 * 6);
        twist_rate(&small, true, 0.2 * omega);
        struct integration integration =
            integration_new(true, 1.5e-9, 0, &small.materials, &small.body, &nothing, small.model);
        double before = 0.2 * omega, crossing[3], least = 0;
        int crossings = 0;
        while (crossings < 3 && integration.time < 4 * 2 * pi / omega) {
            verlet_step(&integration, &small.body, &nothing, small.model, false, false);
            const double now = twist_rate(&small, false, 0);
            if (before * now <= 0)
                crossing[crossings++] = integration.time - integration.dt * now / (now - before);
            least = fmin(least, now);
            before = now;
        }
        assert_int_equal(crossings, 3);
        const double frequency = pi / (crossing[1] - crossing[0]) / omega;
        show(bars[k].peer.materials, frequency);
        show("  amplitude", -least / (0.2 * omega));
        show("  second half", (crossing[2] - crossing[1]) / (crossing[1] - crossing[0]));
        assert_near(frequency, 1, bars[k].tolerance);
        assert_near(-least / (0.2 * omega), 1, 0.05);
        integration_free(&integration);
        boundary_free(&nothing);
        small_body_free(&small);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_particles_that_collide),
        cmocka_unit_test(test_uniaxial_strain),
        cmocka_unit_test(test_bar_of_springs),
        cmocka_unit_test(test_energy_of_affine_motions),
        cmocka_unit_test(test_elongation_of_a_bar),
        cmocka_unit_test(test_wave_in_a_bar),
        cmocka_unit_test(test_chequerboard),
        cmocka_unit_test(test_torsion),
    };
    return cmocka_run_group_tests_name("peers", tests, small_ranks_start, small_ranks_stop);
}
