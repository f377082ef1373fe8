/* Particles between their corners: against exact states and laws of conservation. */
#include "small_body.h"

#include "check.h"
#include "law.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

#define ELASTICITY "density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
#define VOCE       "hardening: {law: voce, yield: 182.1 MPa, saturation: 513.0 MPa, rate: 5.320}"
#define NICKEL     "{A: {model: corner, " ELASTICITY ", " VOCE "}}"
#define ELASTIC    "{A: {model: corner, law: elastic, " ELASTICITY "}}"

static const double young = 210e9, poisson = 0.31, spacing = SMALL_SPACING;
static const char *const residuals[] = {"{form: flowing}", "{form: four_points}"};
enum { RESIDUALS_TESTED = 2 };

/* A staircase without two of its edges. */
static uint8_t staircase(const int size[3], const int at[3])
{
    (void)size;
    return (at[1] == 0 && at[2] == 0) || (at[1] == 2 && at[0] > 2) ? ABSENT : 0;
}

static double force_on(const struct body *body, int a, int64_t site)
{
    return body->f[a][site] * body->volumes[site];
}

/* A uniform uniaxial stress to 20 % of strain, in cubes and in boxes: the corners inside and on
 * faces along the load are at rest, and each particle with nothing before it along the load pulls
 * at its four corners there with a quarter of P dy dz.  Exact but for rounding: 1e-11 of the
 * largest force. */
static void test_uniaxial_stress_in_a_staircase(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * RESIDUALS_TESTED; k++) {
        const double y = k / 2 ? 0.7 : 1, z = k / 2 ? 3 : 1;
        struct small_body small;
        small_body_new(&small, &(struct small_case){.size = {5, 4, 3},
                                                    .edge = {1, y, z},
                                                    .residual = residuals[k % 2],
                                                    .materials = NICKEL,
                                                    .phase = staircase});
        struct small_point point = small_point_new(&small.materials);
        for (int step = 1; step <= 20; step++) {
            small_point_stretch(&point, &small.materials, 0.01 * step);
            small_body_deform(&small, point.H);
            small_body_force(&small, true, false);
        }
        const struct body *body = &small.body;
        const struct lattice *l = &small.lattice;
        const double face = point.stress * y * z * spacing * spacing;
        for (int64_t site = 0; site < body->grid.n_sites; site++) {
            int at[3];
            double expected = 0;
            if (!small_body_has(&small, site)) continue;
            small_body_position(&small, site, at);
            for (int c = 0; c < 4; c++) {
                const int row = at[1] - (c & 1), layer = at[2] - (c >> 1);
                expected += (lattice_phase(l, at[0], row, layer) != ABSENT) -
                            (lattice_phase(l, at[0] - 1, row, layer) != ABSENT);
            }
            assert_near(force_on(body, 0, site), expected * face / 4, 1e-11 * face);
            assert_near(force_on(body, 1, site), 0, 1e-11 * face);
            assert_near(force_on(body, 2, site), 0, 1e-11 * face);
        }
        small_body_free(&small);
    }
}

enum kind { IN_SPACE, IN_PLANE, IN_STRESS, IN_MESH, KINDS };

/* A body that has flowed at random, strains of 3 %; of a mesh, whose hexahedra are no boxes. */
static void shaken(struct small_body *small, const char *residual, const char *materials,
                   enum kind kind)
{
    const bool plane = kind == IN_PLANE || kind == IN_STRESS;
    const double H[9] = {0.02, 0.01, 0, 0, -0.01, plane ? 0 : 0.005, 0, 0, plane ? 0 : 0.01};
    small_body_new(small, &(struct small_case){.size = {4, 3, plane ? 1 : 3},
                                               .residual = residual,
                                               .materials = materials,
                                               .phase = staircase,
                                               .mesh = kind == IN_MESH,
                                               .jitter = 0.2,
                                               .plane = kind == IN_PLANE    ? PLANE_STRAIN
                                                        : kind == IN_STRESS ? PLANE_STRESS
                                                                            : SPACE});
    small_body_deform(small, H);
    small_body_force(small, true, false);
    small_body_shake(small, 0.03, 7);
    small_body_force(small, true, false);
    small_body_shake(small, 0.01, 8);
    if (!plane) return;
    for (int64_t site = 0; site < small->body.grid.n_sites; site++) small->body.u[2][site] = 0;
}

/* Sums of forces and of moments vanish to rounding. */
static void test_momentum(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS * RESIDUALS_TESTED; k++) {
        struct small_body small;
        shaken(&small, residuals[k / KINDS], NICKEL, (enum kind)(k % KINDS));
        small_body_force(&small, false, false);
        const struct body *body = &small.body;
        double sum[3] = {0}, moment[3] = {0}, largest = 0;
        for (int64_t site = 0; site < body->grid.n_sites; site++) {
            double x[3], F[3];
            if (!small_body_has(&small, site)) continue;
            body_position(body, site, x);
            for (int a = 0; a < 3; a++) {
                x[a] += body->u[a][site];
                F[a] = force_on(body, a, site);
                sum[a] += F[a];
                largest = fmax(largest, fabs(F[a]));
            }
            for (int a = 0; a < 3; a++) {
                const int b = (a + 1) % 3, c = (a + 2) % 3;
                moment[a] += x[b] * F[c] - x[c] * F[b];
            }
        }
        for (int a = 0; a < 3; a++) {
            assert_near(sum[a], 0, 1e-13 * largest);
            assert_near(moment[a], 0, 1e-13 * largest * 4 * spacing);
        }
        small_body_free(&small);
    }
}

/* The force is the derivative of the energy, by central differences in one direction at random:
 * their error is the second derivative's, 1e-7 of the force at a step of 1e-4 spacings, against
 * rounding of 1e-16 over it. */
static void test_force_is_the_gradient(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS * RESIDUALS_TESTED; k++) {
        struct small_body small;
        shaken(&small, residuals[k / KINDS], NICKEL, (enum kind)(k % KINDS));
        const struct body *body = &small.body;
        const double step = 1e-4 * spacing;
        double energy[2], work = 0, size = 0;
        small_body_force(&small, false, true);
        for (int end = 0; end < 2; end++) {
            for (int64_t site = 0; site < body->grid.n_sites; site++)
                for (int a = 0; a < body->lattice->dimensions; a++) {
                    const double way = step * sin(12.9898 * (double)(3 * site + a));
                    if (end == 0 && small_body_has(&small, site)) {
                        work += way * force_on(body, a, site);
                        size += fabs(way * force_on(body, a, site));
                    }
                    body->u[a][site] += end ? 2 * way : -way;
                }
            energy[end] = small_body_elastic_energy(&small);
        }
        assert_near(0.5 * (energy[0] - energy[1]), work, 1e-6 * size);
        small_body_free(&small);
    }
}

/* A rotation on top of a state that has flowed turns the forces and nothing else. */
static void test_objectivity(void **state)
{
    const double angle = 0.7, c = cos(angle), s = sin(angle), R[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
    (void)state;
    for (int k = 0; k < KINDS * RESIDUALS_TESTED; k++) {
        struct small_body small;
        shaken(&small, residuals[k / KINDS], NICKEL, (enum kind)(k % KINDS));
        const struct body *body = &small.body;
        small_body_force(&small, false, false);
        double *before = memory_new(3 * (size_t)body->grid.n_sites, sizeof *before), largest = 0;
        for (int64_t site = 0; site < body->grid.n_sites; site++) {
            double x[3];
            if (!small_body_has(&small, site)) continue;
            body_position(body, site, x);
            double y[3];
            for (int a = 0; a < 3; a++) {
                before[3 * site + a] = body->f[a][site];
                largest = fmax(largest, fabs(body->f[a][site]));
                y[a] = x[a] + body->u[a][site];
            }
            for (int a = 0; a < 3; a++)
                body->u[a][site] =
                    R[3 * a] * y[0] + R[3 * a + 1] * y[1] + R[3 * a + 2] * y[2] - x[a];
        }
        small_body_force(&small, false, false);
        for (int64_t site = 0; site < body->grid.n_sites; site++)
            for (int a = 0; a < 3 && small_body_has(&small, site); a++) {
                const double *f = before + 3 * site;
                const double turned = R[3 * a] * f[0] + R[3 * a + 1] * f[1] + R[3 * a + 2] * f[2];
                assert_near(body->f[a][site], turned, 1e-10 * largest);
            }
        free(before);
        small_body_free(&small);
    }
}

/* A uniform gradient of 20 %, with flow, in a mesh of hexahedra that are no boxes and have warped
 * faces: each particle has that gradient, nodes inside are at rest and the others in balance.
 * Rounding: 1e-13, and 1e-11 of the largest force. */
static void test_patch_of_a_mesh(void **state)
{
    const double H[9] = {0.2, 0.05, -0.02, 0.03, -0.08, 0.04, 0.01, -0.06, -0.05};
    (void)state;
    for (int k = 0; k < RESIDUALS_TESTED; k++) {
        struct small_body small;
        small_body_new(&small, &(struct small_case){.size = {4, 3, 3},
                                                    .residual = residuals[k],
                                                    .materials = NICKEL,
                                                    .mesh = true,
                                                    .jitter = 0.25});
        const struct body *body = &small.body;
        small_body_deform(&small, H);
        small_body_force(&small, true, false);
        struct node_state seen;
        model_observe(small.model, body, &body->near.items[0], &seen);
        for (int c = 0; c < 9; c++)
            for (int i = 0; i < seen.count; i++) assert_near(seen.H[c][i], H[c], 1e-13);
        double largest = 0, load[3] = {0};
        int inside = 0;
        for (int64_t site = 0; site < body->grid.n_sites; site++)
            for (int a = 0; a < 3 && small_body_has(&small, site); a++)
                largest = fmax(largest, fabs(force_on(body, a, site)));
        for (int64_t site = 0; site < body->grid.n_sites; site++) {
            int elements = 0;
            for (int64_t n = 0; n < 8 * small.lattice.n_particles; n++)
                elements += small.lattice.hexahedron[n] == site;
            for (int a = 0; a < 3 && small_body_has(&small, site); a++) {
                load[a] += force_on(body, a, site);
                if (elements == 8) assert_near(force_on(body, a, site), 0, 1e-11 * largest);
            }
            inside += elements == 8;
        }
        assert_int_equal(inside, 3 * 2 * 2);
        for (int a = 0; a < 3; a++) assert_near(load[a], 0, 1e-11 * largest);
        small_body_free(&small);
    }
}

/* Cubes as a mesh are the lattice: the same forces in a state that has flowed, to rounding, 1e-12
 * of the largest. */
static void test_cubes_as_a_mesh(void **state)
{
    (void)state;
    for (int k = 0; k < RESIDUALS_TESTED; k++) {
        struct small_body small[2];
        double largest = 0;
        int found = 0;
        for (int m = 0; m < 2; m++) {
            small_body_new(&small[m], &(struct small_case){.size = {4, 3, 3},
                                                           .edge = {1, 0.7, 2},
                                                           .residual = residuals[k],
                                                           .materials = NICKEL,
                                                           .phase = staircase,
                                                           .mesh = m == 1});
            struct body *body = &small[m].body;
            for (int step = 1; step <= 4; step++) {
                for (int64_t site = 0; site < body->grid.n_sites; site++) {
                    double x[3];
                    if (!small_body_has(&small[m], site)) continue;
                    body_position(body, site, x);
                    for (int a = 0; a < 3; a++)
                        body->u[a][site] =
                            0.02 * step * spacing *
                            sin((2 + a) * x[a] / spacing + 3 * x[(a + 1) % 3] / spacing);
                }
                small_body_force(&small[m], true, false);
            }
            largest = fmax(largest, small_body_largest(&small[m], body->f));
        }
        for (int64_t i = 0; i < small[1].body.grid.n_sites; i++) {
            double x[3];
            if (!small_body_has(&small[1], i)) continue;
            body_position(&small[1].body, i, x);
            int at[3];
            for (int a = 0; a < 3; a++)
                at[a] = (int)lround((x[a] - small[0].lattice.origin[a]) / small[0].lattice.edge[a]);
            const int64_t j = grid_site(&small[0].body.grid, at);
            for (int a = 0; a < 3; a++)
                assert_near(small[1].body.f[a][i], small[0].body.f[a][j], 1e-12 * largest);
            assert_relative(small[1].body.volumes[i], small[0].body.volumes[j], 1e-12);
            found++;
        }
        assert_int_equal(found, small[0].lattice.n_nodes);
        for (int m = 0; m < 2; m++) small_body_free(&small[m]);
    }
}

/* A sheet in plane stress under equal stretches of both axes to 20 %, flowing: the stress across
 * vanishes, that in the plane is the one of the law at the stretch across which bisection of that
 * law's answer gives; 1e-10 of it, 1e-12 of the moduli being taken for no stress. */
static void test_sheet_in_plane_stress(void **state)
{
    (void)state;
    for (int k = 0; k < RESIDUALS_TESTED; k++) {
        struct small_body small;
        small_body_new(&small, &(struct small_case){.size = {4, 3, 1},
                                                    .residual = residuals[k],
                                                    .materials = NICKEL,
                                                    .plane = PLANE_STRESS});
        const struct body *body = &small.body;
        const struct law_in_use *use = &small.materials.laws[0];
        struct small_point point = small_point_new(&small.materials);
        struct node_state seen;
        double across = 0;
        for (int step = 1; step <= 20; step++) {
            const double stretch = 0.01 * step, H[9] = {stretch, 0, 0, 0, stretch, 0, 0, 0, 0};
            struct points strip = {.count = 1};
            double low = across - 0.05, high = across + 0.05;
            small_body_deform(&small, H);
            small_body_force(&small, true, false);
            strip.H[0][0] = strip.H[4][0] = stretch;
            strip.mu[0] = small.materials.shear[0];
            strip.bulk[0] = small.materials.bulk[0];
            for (int halving = 0; halving < 100; halving++) {
                strip.H[8][0] = across = 0.5 * (low + high);
                use->law->update(use->pairs, &strip, point.state, 1,
                                 (struct step){.commit = false});
                *(strip.P[8][0] < 0 ? &low : &high) = across;
            }
            use->law->update(use->pairs, &strip, point.state, 1, (struct step){.commit = true});
            model_observe(small.model, body, &body->near.items[0], &seen);
            assert_near(seen.H[8][0], across, 1e-12);
            assert_near(seen.cauchy[2][0], 0, 1e-11 * strip.bulk[0]);
            const double cauchy = strip.P[0][0] / ((1 + stretch) * (1 + across));
            assert_relative(seen.cauchy[0][0], cauchy, 1e-8);
        }
        assert_true(small_point_plastic(&point) > 0.3);
        small_body_free(&small);
    }
}

static uint8_t layers(const int size[3], const int at[3])
{
    (void)size;
    return (uint8_t)(at[0] % 2);
}

/* Layers of one particle, stiffnesses 1:10, in series under uniaxial strain: with strains as 10:1
 * each corner between them is at rest. The difference is that of the finite strains: exact for the
 * stress that each layer's law gives, so the strain of the stiff layers is found for it by
 * bisection; rounding 1e-11. */
static void test_layers_in_series(void **state)
{
    (void)state;
    struct small_body small;
    small_body_new(&small, &(struct small_case){
                               .size = {6, 2, 2},
                               .materials = "{A: {model: corner, law: elastic, " ELASTICITY "}, "
                                            "B: {model: corner, law: elastic, density: 8900, "
                                            "youngs_modulus: 2100 GPa, poissons_ratio: 0.31}}",
                               .n_phases = 2,
                               .phase = layers});
    const double M = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
    /* P = M ln(F)/F in uniaxial logarithmic strain */
    const double soft = 0.01, stress = M * log(1 + soft) / (1 + soft);
    double low = 0, high = soft;
    for (int k = 0; k < 100; k++) {
        const double middle = 0.5 * (low + high);
        *(10 * M * log(1 + middle) / (1 + middle) < stress ? &low : &high) = middle;
    }
    const struct body *body = &small.body;
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&small, site)) continue;
        small_body_position(&small, site, at);
        body->u[0][site] = spacing * ((at[0] + 1) / 2 * soft + at[0] / 2 * low);
    }
    small_body_force(&small, false, false);
    for (int64_t site = 0; site < body->grid.n_sites; site++) {
        int at[3];
        if (!small_body_has(&small, site)) continue;
        small_body_position(&small, site, at);
        if (at[0] > 0 && at[0] < 6)
            assert_near(force_on(body, 0, site), 0, 1e-9 * stress * spacing * spacing);
    }
    small_body_free(&small);
}

/* A cube twisted by theta for each unit of its length, about any axis, stores two thirds of its
 * energy of shear, mu theta^2 dx^2/12 for each unit of volume: half of the gradient is rotation. */
static void test_twist(void **state)
{
    (void)state;
    const double theta = 1e-4 / spacing, mu = young / (2 * (1 + poisson)),
                 shear = mu * pow(theta * spacing, 2) / 12 * pow(spacing, 3);
    for (int k = 0; k < 6; k++) {
        const int a = k % 3, b = (a + 1) % 3, c = (a + 2) % 3;
        struct small_body small;
        small_body_new(&small, &(struct small_case){.size = {1, 1, 1},
                                                    .residual = residuals[0],
                                                    .mesh = k / 3,
                                                    .materials = ELASTIC});
        double x[3], middle[3] = {0};
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            if (!small_body_has(&small, site)) continue;
            body_position(&small.body, site, x);
            for (int d = 0; d < 3; d++) middle[d] += x[d] / 8;
        }
        for (int64_t site = 0; site < small.body.grid.n_sites; site++) {
            if (!small_body_has(&small, site)) continue;
            body_position(&small.body, site, x);
            small.body.u[b][site] = -theta * (x[a] - middle[a]) * (x[c] - middle[c]);
            small.body.u[c][site] = theta * (x[a] - middle[a]) * (x[b] - middle[b]);
        }
        small_body_force(&small, false, false);
        assert_relative(small_body_elastic_energy(&small), 2. / 3 * shear, 1e-6);
        small_body_free(&small);
    }
}

/* One cell whose corners move by s_x s_y h along x alone: F stays 1, nothing but the residual acts,
 * and its force and work are those of a linear spring with a linear hardening slider, (flowing.1)
 * to (flowing.3), but for precision, a strain.  From a strain on, in steps of so many limits, which
 * turn. Returns e' over alpha. */
static double check_flow(double from, double stride, int steps, double precision)
{
    struct small_body small;
    small_body_new(&small,
                   &(struct small_case){.size = {1, 1, 1},
                                        .residual = "{modulus: 0.5, limit: 0.1, hardening: 8}",
                                        .materials = NICKEL});
    const struct body *body = &small.body;
    const double mu = young / (2 * (1 + poisson)), w = sqrt(8. / 3) / spacing,
                 share = 182.1e6 / (sqrt(3) * mu), limit = 0.1 * share, slope = 8 * share,
                 volume = spacing * spacing * spacing;
    double plastic = 0, alpha = 0, dissipated = 0;
    for (int step = 1; step <= steps; step++) {
        const int turn = 5 * steps / 8;
        const double e = from + (step < turn ? step : 2 * turn - step) * stride * limit,
                     yield = limit + slope * alpha, trial = e - plastic,
                     beyond = fmax(fabs(trial) - yield, 0), increment = beyond / (1 + slope);
        dissipated += 0.5 * mu * (yield * increment + 0.5 * slope * increment * increment);
        plastic += copysign(increment, trial);
        alpha += increment;
        for (int64_t site = 0; site < body->grid.n_sites; site++) {
            int at[3];
            if (!small_body_has(&small, site)) continue;
            small_body_position(&small, site, at);
            body->u[0][site] = (2 * at[0] - 1) * (2 * at[1] - 1) * e / w;
        }
        const struct exact_sum zero = exact_sum_new(1e9 * volume);
        struct force_energy energy = {zero, zero, zero};
        model_force(small.model, &small.body, (struct force_mode){.commit = true, .energy = true},
                    &energy);
        double values[3];
        exact_sum_finish(
            (const struct exact_sum[]){energy.stored, energy.plastic, energy.stabilisation}, 3,
            values);
        /* e = w F^-1 h: beside what s_x s_y gets, A = - t e, of which a corner gets a quarter over
         * dx. */
        const double stress = 0.5 * mu * (e - plastic),
                     corner = stress * volume * (w / 8 + e / (4 * spacing));
        const int64_t first = grid_site(&body->grid, (const int[]){0, 0, 0});
        assert_near(force_on(body, 0, first), -corner, mu * spacing * spacing * precision);
        assert_near(values[1], dissipated * volume, mu * volume * yield * precision);
        assert_near(values[2], 0.5 * stress * (e - plastic) * volume,
                    mu * volume * yield * precision);
    }
    small_body_free(&small);
    return plastic / alpha;
}

/* e' and alpha, up to 4e-4, are rounded to 2^-25 of them in each of 30 steps that flow, and in the
 * other to 2^-24 of 0.5: of steps of 1.3e-9 those that flow wait until they are 2^-21 together,
 * which is the work that is not booked yet. */
static void test_flow_of_the_residual(void **state)
{
    (void)state;
    assert_true(check_flow(0, 0.2, 40, 1e-9) < 0.8); /* it has flowed back, too */
    check_flow(0.5, 1e-5, 40000, 0x1p-20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uniaxial_stress_in_a_staircase),
        cmocka_unit_test(test_momentum),
        cmocka_unit_test(test_force_is_the_gradient),
        cmocka_unit_test(test_objectivity),
        cmocka_unit_test(test_patch_of_a_mesh),
        cmocka_unit_test(test_cubes_as_a_mesh),
        cmocka_unit_test(test_sheet_in_plane_stress),
        cmocka_unit_test(test_layers_in_series),
        cmocka_unit_test(test_twist),
        cmocka_unit_test(test_flow_of_the_residual),
    };
    return cmocka_run_group_tests(tests, small_ranks_start, small_ranks_stop);
}
