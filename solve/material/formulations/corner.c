/* corner.c - particles between their corners: a classical law at every particle, whose family are
 * its corners.
 *
 *   F_p = 1 + sum_c u_c (x) g_c,  g_c = w V_c K^-1 xi_c = s_c/(4 dx)                     (corner.1)
 *   h_m = sum_c s_m(c) u_c/8                                                             (corner.2)
 *   f_c V_c = - sum_p (A_p g_c + sum_m s_m(c) m_m/8),  A = V_p P(F_p) + residual         (corner.3)
 *
 * c: the eight corners of a particle's cell (in a plane four, and the factors 1/2 and 1/4), s_c
 * their signs along the axes, xi_c = s_c dx/2 the bonds from the particle to them, K their shape
 * tensor, s_m the products of signs that F does not see (residual.h).  (corner.1) is the gradient
 * of Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, section 18, with the
 * constant influence function, its points of stress apart from those that move (Luo,
 * Sundararaghavan, Int. J. Solids Struct. 150 (2018) 197), and (corner.3) the derivative of the
 * energy sum_p V_p psi.
 *
 * Why corners: sum_p V_p g_c is zero at a corner inside a body of one spacing and the outward area
 * at one of its surface, whatever its shape.  So tractions act where the surface is, a surface and
 * an interface need no correction, a family never reaches over one, and one pressure a particle
 * against three unknowns a corner does not lock.  On a cube it is the hexahedron of one point with
 * the mean strain of Flanagan, Belytschko (1981): what of peridynamics is left, and what not, says
 * docs/theory.md. */
#include "hexahedra.h"
#include "integrity.h"
#include "memory.h"
#include "model.h"
#include "points.h"
#include "residual.h"

#include <stdlib.h>
#include <string.h>

struct corner {
    const struct materials *materials;
    const struct residual *residual;
    void *self; /* the residual's parameters and state */
    struct point_store *points;
    double *nominal; /* box field: axial stress of particles, as of the last force to be recorded */
    int64_t row[4];  /* shifts to the corners' rows (0, 0), (1, 0), (0, 1), (1, 1) along y and z */
    double slope[3]; /* 1/(4 dx) */
    struct hexahedra *hexahedra; /* of a mesh, in place of rows and slopes; else NULL */
};

static void *corner_read(struct deck_node solver, const struct family *family,
                         const struct materials *materials)
{
    struct corner *model = memory_new(1, sizeof *model);
    static const char *const of_bonds[] = {"horizon", "influence", "volumes"};
    for (size_t k = 0; k < sizeof of_bonds / sizeof *of_bonds; k++)
        if (deck_has(solver, of_bonds[k]))
            deck_error(deck_get(solver, of_bonds[k]),
                       "corner has no '%s': the family of a particle is its corners", of_bonds[k]);
    (void)family;
    model->materials = materials;
    model->residual = residual_read(deck_find(solver, "residual"), &model->self);
    return model;
}

static void corner_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct corner *model = self;
    const int64_t y = body->grid.step[1],
                  z = body->lattice->dimensions == 2 ? 0 : body->grid.step[2];
    const int64_t row[4] = {0, y, z, y + z};
    (void)bonds;
    memcpy(model->row, row, sizeof row);
    for (int a = 0; a < 3; a++) model->slope[a] = 0.25 / body->lattice->edge[a];
    model->points = points_new(body, model->materials, &body->near, 0);
    model->nominal = memory_new((size_t)body->grid.n_sites, sizeof *model->nominal);
    if (body->lattice->hexahedron) model->hexahedra = hexahedra_new(body);
    model->residual->start(model->self, body, model->materials, model->hexahedra);
}

static void corner_visit(void *self, const struct body *body, struct checkpoint *checkpoint)
{
    struct corner *model = self;
    points_visit(model->points, checkpoint, "particles", &body->near);
    model->residual->visit(model->self, &body->near, checkpoint);
}

static void corner_free(void *self)
{
    struct corner *model = self;
    if (model->residual) model->residual->free(model->self);
    points_free(model->points);
    hexahedra_free(model->hexahedra);
    free(model->nominal);
    free(model);
}

/* Of the four corners with the same x: the sum, and the products with their signs along y, z and
 * both. */
struct face {
    double sum, y, z, yz;
};

/* Of numbers a to d in the rows of corner.row; in a plane, where the rows of z are those without, z
 * and yz are zero. */
HS_INLINE struct face combine_face(double a, double b, double c, double d)
{
    const double lower = a + b, upper = c + d, below = b - a, above = d - c;
    return (struct face){lower + upper, below + above, upper - lower, above - below};
}

/* (corner.1), a row of H, and (corner.2), one component of each mode. */
HS_SIMD static void load_component(int count, const double *restrict a, const double *restrict b,
                                   const double *restrict c, const double *restrict d,
                                   const double *restrict slope, double (*restrict H)[LANES],
                                   double *restrict xy, double *restrict yz, double *restrict zx,
                                   double *restrict xyz)
{
    for (int i = 0; i < count; i++) {
        const struct face left = combine_face(a[i], b[i], c[i], d[i]),
                          right = combine_face(a[i + 1], b[i + 1], c[i + 1], d[i + 1]);
        H[0][i] = slope[0] * (right.sum - left.sum);
        H[1][i] = slope[1] * (left.y + right.y);
        H[2][i] = slope[2] * (left.z + right.z);
        xy[i] = 0.125 * (right.y - left.y);
        yz[i] = 0.125 * (left.yz + right.yz);
        zx[i] = 0.125 * (right.z - left.z);
        xyz[i] = 0.125 * (right.yz - left.yz);
    }
}

static void load_rows(const struct corner *model, const struct body *body,
                      const struct strip *strip, struct points *points, struct cells *cells)
{
    for (int a = 0; a < 3; a++) {
        const double *u = body->u[a] + strip->site;
        load_component(strip->count, u + model->row[0], u + model->row[1], u + model->row[2],
                       u + model->row[3], model->slope, points->H + 3 * a, cells->h[0][a],
                       cells->h[1][a], cells->h[2][a], cells->h[MODE_XYZ][a]);
    }
}

HS_SIMD static void add_mean(int count, double mean, double *restrict H)
{
    for (int i = 0; i < count; i++) H[i] += mean;
}

/* Gradient and amplitudes of the particles of a strip; those that carry nothing are switched off.
 */
static void load(const struct corner *model, const struct body *body, const struct strip *strip,
                 struct points *points, struct cells *cells)
{
    const struct integrity *integrity = body->integrity;
    points_load(model->points, strip, points);
    if (model->hexahedra)
        hexahedra_load(model->hexahedra, strip, points, cells);
    else
        load_rows(model, body, strip, points, cells);
    if (lattice_is_periodic(body->lattice))
        for (int k = 0; k < TENSOR; k++)
            add_mean(strip->count, body->lattice_gradient[k], points->H[k]);
    if (!integrity || integrity->whole) return;
    for (int i = 0; i < strip->count; i++)
        if (!(integrity->node[strip->site + i] > 0)) points_switch_off(points, i);
}

HS_SIMD static void weigh_stress(int count, double share, const double *restrict volume,
                                 double (*restrict P)[LANES], double (*restrict A)[PADDED])
{
    for (int k = 0; k < TENSOR; k++)
        for (int i = 0; i < count; i++) A[k][PAD + i] = share * volume[i] * P[k][i];
}

/* (corner.3), one component: what the corners' rows get, particles to their left and right. */
HS_SIMD static void scatter_component(int count, const double *restrict slope,
                                      double (*restrict A)[PADDED], const double *restrict xy,
                                      const double *restrict yz, const double *restrict zx,
                                      const double *restrict xyz, double *restrict a,
                                      double *restrict b, double *restrict c, double *restrict d)
{
    for (int i = 0; i <= count; i++) {
        const int p = PAD + i, q = p - 1;
        const double sum = slope[0] * (A[0][q] - A[0][p]),
                     y = slope[1] * (A[1][q] + A[1][p]) + 0.125 * (xy[q] - xy[p]),
                     z = slope[2] * (A[2][q] + A[2][p]) + 0.125 * (zx[q] - zx[p]),
                     both = 0.125 * ((yz[q] + yz[p]) + (xyz[q] - xyz[p]));
        a[i] -= (sum - y) + (both - z);
        b[i] -= (sum + y) - (z + both);
        c[i] -= (sum - y) + (z - both);
        d[i] -= (sum + y) + (z + both);
    }
}

static void close_row(int count, double row[PADDED])
{
    row[PAD - 1] = row[PAD + count] = 0;
}

HS_SIMD static void add_row(int count, const double *restrict from, double *restrict to)
{
    for (int i = 0; i < count; i++) to[i] += from[i];
}

static void scatter(const struct corner *model, struct body *body, struct cells *cells)
{
    const int n = cells->strip->count;
    const bool plane = body->lattice->dimensions == 2;
    for (int k = 0; k < TENSOR; k++) close_row(n, cells->A[k]);
    for (int k = 0; k < 3 * MODES; k++) close_row(n, cells->m[k / 3][k % 3]);
    for (int a = 0; a < 3; a++) {
        double *f = body->f[a] + cells->strip->site;
        /* In a plane the rows of z are those without, which get their shares one by one. */
        double c[LANES + 1], d[LANES + 1];
        for (int i = 0; plane && i <= n; i++) c[i] = d[i] = 0;
        scatter_component(n, model->slope, cells->A + 3 * a, cells->m[0][a], cells->m[1][a],
                          cells->m[2][a], cells->m[MODE_XYZ][a], f + model->row[0],
                          f + model->row[1], plane ? c : f + model->row[2],
                          plane ? d : f + model->row[3]);
        if (!plane) continue;
        add_row(n + 1, c, f + model->row[0]);
        add_row(n + 1, d, f + model->row[1]);
    }
}

/* (macroscopic.2): A is conjugate to the gradient, of the residual, too. */
static void sum_stress(const struct body *body, const struct cells *cells)
{
    const struct strip *strip = cells->strip;
    for (int k = 0; k < TENSOR; k++) {
        double terms[LANES];
        memcpy(terms, cells->A[k] + PAD, (size_t)strip->count * sizeof *terms);
        body_sum_owned(body, strip->site, strip->count, terms, 1, &body->stress_sums[k]);
    }
}

/* Along the axis of the test. */
static void record_nominal(const struct corner *model, const struct body *body,
                           const struct cells *cells)
{
    for (int i = 0; i < cells->strip->count; i++) {
        double axial = cells->A[4 * body->lattice->axis][PAD + i];
        if (body->turned) {
            axial = 0;
            for (int k = 0; k < TENSOR; k++)
                axial += body->frame[k / 3] * body->frame[k % 3] * cells->A[k][PAD + i];
        }
        model->nominal[cells->strip->site + i] = axial / cells->volume[i];
    }
}

static void strip_force(struct corner *model, struct body *body, const struct strip *strip,
                        struct force_mode mode, struct force_energy *energy)
{
    struct points points;
    struct cells cells;
    HS_ALIGNED double flow[LANES];
    const double share = model->residual->share(model->self);
    cells.strip = strip;
    cells.points = &points;
    load(model, body, strip, &points, &cells);
    for (int i = 0; i < strip->count; i++)
        cells.volume[i] = body_particle_volume(body, strip->site + i);
    cells.integrity = integrity_of_nodes(body, strip->site, strip->count);
    memcpy(flow, points_flow_stress(model->points, strip, flow),
           (size_t)strip->count * sizeof *flow);
    points_update(model->points, strip, &points, mode, cells.integrity);
    weigh_stress(strip->count, share, cells.volume, points.P, cells.A);
    if (body->lattice->dimensions == 2) memset(cells.m, 0, sizeof cells.m);
    if (mode.energy) {
        cells_sum(body, &cells, points.stored, share, &energy->stored);
        cells_sum(body, &cells, points.dissipated, share, &energy->plastic);
    }
    model->residual->add(model->self, body, &cells, flow, mode, energy);
    if (body->stress_sums) sum_stress(body, &cells);
    if (mode.record) record_nominal(model, body, &cells);
    if (model->hexahedra)
        hexahedra_scatter(model->hexahedra, &cells, body->f);
    else
        scatter(model, body, &cells);
}

HS_SIMD static void divide(int count, const double *restrict volume, double *restrict f)
{
    for (int i = 0; i < count; i++) f[i] = volume[i] > 0 ? f[i] / volume[i] : 0;
}

/* Of the displacements that a strip reads the row that those before it have not. */
static void fetch_row(const struct corner *model, const struct body *body,
                      const struct strip *strip)
{
    for (int a = 0; a < 3; a++)
        prefetch(body->u[a] + strip->site + model->row[3],
                 (size_t)strip->count * sizeof *body->u[a]);
}

static void corner_force(void *self, struct body *body, struct force_mode mode,
                         struct force_energy *energy)
{
    struct corner *model = self;
    halo_exchange(body->displacement_halo, body->u, 3);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < body->near.count; s++) {
        if (s + 1 < body->near.count && !model->hexahedra)
            fetch_row(model, body, &body->near.items[s + 1]);
        strip_force(model, body, &body->near.items[s], mode, energy);
    }
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        for (int a = 0; a < body->lattice->dimensions; a++)
            divide(strip->count, body->volumes + strip->site, body->f[a] + strip->site);
        if (body->lattice->dimensions ==
            2) /* what is left of stress across the plane is rounding */
            memset(body->f[2] + strip->site, 0, (size_t)strip->count * sizeof(double));
    }
}

static void corner_observe(void *self, const struct body *body, const struct strip *strip,
                           struct node_state *node)
{
    struct corner *model = self;
    struct points points;
    struct cells cells;
    load(model, body, strip, &points, &cells);
    points_observe(model->points, body, strip, &points, model->nominal, node);
}

static const struct strips *corner_strips(const void *self, const struct body *body)
{
    (void)self;
    return &body->near;
}

static const double *corner_state(const void *self, const struct strip *strip, int number,
                                  int component, double *buffer)
{
    return points_state(((const struct corner *)self)->points, strip, number, component, buffer);
}

/* The radius of a family, sqrt(3)/2: no two corners see each other, there are no bonds. */
const struct formulation formulation_corner = {
    .name = "corner",
    .stress_of = STRESS_OF_NODES,
    .influence = "constant",
    .horizon = 0.8660254037844386,
    .corners = true,
    .keys = (const char *const[]){"residual", "coincident_nodes", NULL},
    .read = corner_read,
    .start = corner_start,
    .force = corner_force,
    .observe = corner_observe,
    .strips = corner_strips,
    .state = corner_state,
    .visit = corner_visit,
    .free = corner_free,
};
