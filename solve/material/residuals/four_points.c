/* four_points.c - the law once more at four points of the cell, which carry a share of the stress.
 *
 *   Pi = (1 - a) V psi(F) + a V/4 sum_q psi(F + sum_m h_m (x) grad s_m(r_q))        (four_points.1)
 *
 * r_q: (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1), each over sqrt 3: they integrate the squares of
 * all s_m as the eight points of Gauss do, and in a plane are his four.  Nothing but the law acts,
 * at five updates of it for each particle: the reference that the flowing residual is measured
 * against.  In a hexahedron of a mesh grad s_m is taken less its mean over the four points, which
 * is zero in a box: then uniform stress does nothing to the amplitudes. */
#include "hexahedron.h"
#include "memory.h"
#include "mesh.h"
#include "residual.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 4 };

struct four_points {
    double share; /* a */
    /* grad s_m at the points [1/m], a vector of lanes for each component: of a lattice one for all
     * strips, of a mesh strip by strip. */
    double *slope;
    bool everywhere; /* one for all */
    struct point_store *points[POINTS];
};
enum { SLOPES = POINTS * MODES * 3 };

static const struct key keys[] = {
    {"share", KEY_NUMBER, offsetof(struct four_points, share), "1", 0.001, 1, .usual = 0.1,
     .help = "a, of the stress: the rest is that of the particle's own gradient"},
};

static void find_point(int q, double r[3])
{
    static const int sign[POINTS][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (int a = 0; a < 3; a++) r[a] = sign[q][a] / sqrt(3);
}

static void slopes_of_lattice(struct four_points *four, const struct body *body)
{
    four->slope = memory_new(SLOPES * LANES, sizeof *four->slope);
    for (int k = 0; k < SLOPES; k++) {
        double r[3];
        find_point(k / (3 * MODES), r);
        const double slope = residual_slope(k / 3 % MODES, k % 3, r, body->lattice->edge);
        for (int i = 0; i < LANES; i++) four->slope[k * LANES + i] = slope;
    }
}

static void slopes_of_mesh(struct four_points *four, const struct body *body)
{
    four->slope = memory_new(SLOPES * (size_t)body->near.points, sizeof *four->slope);
    for (int64_t s = 0; s < body->near.count; s++)
        for (int i = 0; i < body->near.items[s].count; i++) {
            const struct strip *strip = &body->near.items[s];
            struct hexahedron hexahedron;
            double slope[POINTS][MODES][3], mean[MODES][3] = {{0}};
            mesh_hexahedron(body->lattice, strip->site + i, &hexahedron);
            for (int q = 0; q < POINTS; q++) {
                double r[3];
                find_point(q, r);
                hexahedron_slopes(&hexahedron, r, slope[q]);
                for (int k = 0; k < 3 * MODES; k++)
                    mean[k / 3][k % 3] += slope[q][k / 3][k % 3] / POINTS;
            }
            for (int k = 0; k < SLOPES; k++)
                four->slope[SLOPES * strip->store + k * strip->stride + i] =
                    slope[k / (3 * MODES)][k / 3 % MODES][k % 3] - mean[k / 3 % MODES][k % 3];
        }
}

static void start(void *self, const struct body *body, const struct materials *materials,
                  struct hexahedra *hexahedra)
{
    struct four_points *four = self;
    four->everywhere = !hexahedra;
    (hexahedra ? slopes_of_mesh : slopes_of_lattice)(four, body);
    for (int q = 0; q < POINTS; q++) four->points[q] = points_new(body, materials, &body->near, 0);
}

/* Lanes of component a of grad s_m at point q. */
static const double *slope_of(const struct four_points *four, const struct strip *strip, int q,
                              int m, int a)
{
    const int number = (q * MODES + m) * 3 + a;
    if (four->everywhere) return four->slope + number * LANES;
    return four->slope + SLOPES * strip->store + number * strip->stride;
}

static void visit(void *self, const struct strips *strips, struct checkpoint *checkpoint)
{
    static const char *const names[POINTS] = {"point 1", "point 2", "point 3", "point 4"};
    struct four_points *four = self;
    for (int q = 0; q < POINTS; q++) points_visit(four->points[q], checkpoint, names[q], strips);
}

static void release(void *self)
{
    struct four_points *four = self;
    for (int q = 0; q < POINTS; q++) points_free(four->points[q]);
    free(four->slope);
    free(four);
}

static double share(const void *self)
{
    return 1 - ((const struct four_points *)self)->share;
}

HS_SIMD static void add_scaled(int count, const double *restrict factor, const double *restrict x,
                               double *restrict y)
{
    for (int i = 0; i < count; i++) y[i] += factor[i] * x[i];
}

HS_SIMD static void add_stress(int count, double factor, const double *restrict volume,
                               const double *restrict P, double *restrict out)
{
    for (int i = 0; i < count; i++) out[PAD + i] += factor * volume[i] * P[i];
}

HS_SIMD static void add_moment(int count, double factor, const double *restrict slope,
                               const double *restrict volume, const double *restrict P,
                               double *restrict out)
{
    for (int i = 0; i < count; i++) out[PAD + i] += factor * slope[i] * volume[i] * P[i];
}

static void add(void *self, const struct body *body, struct cells *cells, const double *flow,
                struct force_mode mode, struct force_energy *energy)
{
    const struct four_points *four = self;
    const struct strip *strip = cells->strip;
    const int n = strip->count, modes = body->lattice->dimensions == 2 ? 1 : MODES;
    const double weight = four->share / POINTS;
    (void)flow;
    memset(cells->m, 0, sizeof cells->m);
    for (int q = 0; q < POINTS; q++) {
        struct points points = *cells->points;
        for (int m = 0; m < modes; m++)
            for (int k = 0; k < TENSOR; k++)
                add_scaled(n, slope_of(four, strip, q, m, k % 3), cells->h[m][k / 3], points.H[k]);
        for (int i = 0; i < n; i++)
            if (!(points.mu[i] > 0)) points_switch_off(&points, i);
        points_update(four->points[q], strip, &points, mode, cells->integrity);
        for (int k = 0; k < TENSOR; k++)
            add_stress(n, weight, cells->volume, points.P[k], cells->A[k]);
        for (int m = 0; m < modes; m++)
            for (int k = 0; k < TENSOR; k++)
                add_moment(n, weight, slope_of(four, strip, q, m, k % 3), cells->volume,
                           points.P[k], cells->m[m][k / 3]);
        if (!mode.energy) continue;
        cells_sum(body, cells, points.stored, weight, &energy->stored);
        cells_sum(body, cells, points.dissipated, weight, &energy->plastic);
    }
}

const struct residual residual_four_points = {
    .words = {"four_points",
              "The law at four points of the cell beside its middle: five updates of it for each "
              "particle, the reference.",
              KEYS(keys)},
    .size = sizeof(struct four_points),
    .start = start,
    .share = share,
    .add = add,
    .visit = visit,
    .free = release,
};
