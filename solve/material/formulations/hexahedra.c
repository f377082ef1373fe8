/* hexahedra.c - gradients and modes of particles between the corners of a mesh's elements.
 *
 *   F_p = 1 + sum_c u_c (x) g_c,  g_c the mean of grad N_c                            (hexahedra.1)
 *   h_m = sum_c a_m(c) u_c,  a_m(c) = (s_m(c) - X_m . G_c)/8                          (hexahedra.2)
 *   e = L^T F^-1 h,  L L^T the mean of (grad s_m - its mean) . (grad s_n - its mean)  (hexahedra.3)
 *
 * with the geometry of hexahedron.h.  The mean gradient is exact for any corners and its sum over
 * the elements at an inner node zero, so the patch test holds (Flanagan, Belytschko, Int. J. Numer.
 * Methods Engrg. 17 (1981) 679); what the motion has beyond it is orthogonal to affine motions.  On
 * a box these are (corner.1), (corner.2) and (flowing.1). */
#include "hexahedra.h"

#include "hexahedron.h"
#include "memory.h"
#include "mesh.h"
#include "residual.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 8, GRADIENT = 3 * CORNERS, AMPLITUDE = MODES * CORNERS };

struct hexahedra {
    const struct body *body;
    /* Strip by strip of the near particles, component by component: of corner k along a 3 k + a, of
     * mode m and corner k CORNERS m + k. */
    double *gradient, *amplitude;
};

struct hexahedra *hexahedra_new(const struct body *body)
{
    struct hexahedra *all = memory_new(1, sizeof *all);
    const size_t points = (size_t)body->near.points;
    all->body = body;
    all->gradient = memory_new(GRADIENT * points, sizeof(double));
    all->amplitude = memory_new(AMPLITUDE * points, sizeof(double));
    for (int64_t s = 0; s < body->near.count; s++) {
        const struct strip *strip = &body->near.items[s];
        double *gradient = all->gradient + GRADIENT * strip->store,
               *amplitude = all->amplitude + AMPLITUDE * strip->store;
        for (int i = 0; i < strip->count; i++) {
            struct hexahedron corners;
            struct hexahedron_shape shape;
            mesh_hexahedron(body->lattice, strip->site + i, &corners);
            hexahedron_shape(&corners, &shape);
            for (int k = 0; k < GRADIENT; k++)
                gradient[k * strip->stride + i] = shape.gradient[k / 3][k % 3];
            for (int k = 0; k < AMPLITUDE; k++)
                amplitude[k * strip->stride + i] = shape.amplitude[k / CORNERS][k % CORNERS];
        }
    }
    return all;
}

void hexahedra_free(struct hexahedra *hexahedra)
{
    if (!hexahedra) return;
    free(hexahedra->gradient);
    free(hexahedra->amplitude);
    free(hexahedra);
}

/* The sum of h_m.h_n spread[m][n] is that of the squares of L^T h, spread = L L^T. */
void hexahedra_normalise(struct hexahedra *hexahedra)
{
    const struct body *body = hexahedra->body;
    for (int64_t s = 0; s < body->near.count; s++) {
        const struct strip *strip = &body->near.items[s];
        double *amplitude = hexahedra->amplitude + AMPLITUDE * strip->store;
        for (int i = 0; i < strip->count; i++) {
            struct hexahedron corners;
            struct hexahedron_shape shape;
            mesh_hexahedron(body->lattice, strip->site + i, &corners);
            hexahedron_shape(&corners, &shape);
            gsl_matrix_view L = gsl_matrix_view_array(shape.spread[0], MODES, MODES);
            gsl_linalg_cholesky_decomp1(&L.matrix);
            for (int k = 0; k < AMPLITUDE; k++) {
                double sum = 0;
                for (int m = k / CORNERS; m < MODES; m++)
                    sum += shape.spread[m][k / CORNERS] * shape.amplitude[m][k % CORNERS];
                amplitude[k * strip->stride + i] = sum;
            }
        }
    }
}

void hexahedra_axes(const struct hexahedra *hexahedra, double *axes)
{
    static const int ends[2][4][2] = {{{0, 1}, {3, 2}, {4, 5}, {7, 6}},
                                      {{0, 3}, {1, 2}, {4, 7}, {5, 6}}};
    const struct body *body = hexahedra->body;
    for (int64_t s = 0; s < body->near.count; s++)
        for (int i = 0; i < body->near.items[s].count; i++) {
            const struct strip *strip = &body->near.items[s];
            double edge[2][3] = {{0}}, *to = axes + TENSOR * strip->store + i;
            struct hexahedron element;
            mesh_hexahedron(body->lattice, strip->site + i, &element);
            for (int k = 0; k < 24; k++)
                edge[k / 12][k % 3] += element.corner[ends[k / 12][k / 3 % 4][1]][k % 3] -
                                       element.corner[ends[k / 12][k / 3 % 4][0]][k % 3];
            const double *u = edge[0], *v = edge[1];
            const double w[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                 u[0] * v[1] - u[1] * v[0]},
                         across = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]),
                         along = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
            for (int a = 0; a < 3; a++) {
                const int b = (a + 1) % 3, c = (a + 2) % 3;
                to[a * strip->stride] = u[a] / along;
                to[(3 + a) * strip->stride] = (w[b] * u[c] - w[c] * u[b]) / (across * along);
                to[(6 + a) * strip->stride] = w[a] / across;
            }
        }
}

HS_SIMD static void add_products(int count, const double *restrict x, const double *restrict y,
                                 double *restrict sum)
{
    for (int i = 0; i < count; i++) sum[i] += x[i] * y[i];
}

void hexahedra_load(const struct hexahedra *hexahedra, const struct strip *strip,
                    struct points *points, struct cells *cells)
{
    const struct body *body = hexahedra->body;
    const int32_t *corner = body->lattice->hexahedron + CORNERS * strip->site;
    const double *gradient = hexahedra->gradient + GRADIENT * strip->store,
                 *amplitude = hexahedra->amplitude + AMPLITUDE * strip->store;
    const size_t bytes = (size_t)strip->count * sizeof(double);
    for (int k = 0; k < TENSOR; k++) memset(points->H[k], 0, bytes);
    for (int m = 0; m < 3 * MODES; m++) memset(cells->h[m / 3][m % 3], 0, bytes);
    for (int k = 0; k < CORNERS; k++)
        for (int a = 0; a < 3; a++) {
            double u[LANES];
            for (int i = 0; i < strip->count; i++) u[i] = body->u[a][corner[CORNERS * i + k]];
            for (int b = 0; b < 3; b++)
                add_products(strip->count, u, gradient + (3 * k + b) * strip->stride,
                             points->H[3 * a + b]);
            for (int m = 0; m < MODES; m++)
                add_products(strip->count, u, amplitude + (CORNERS * m + k) * strip->stride,
                             cells->h[m][a]);
        }
}

void hexahedra_scatter(const struct hexahedra *hexahedra, const struct cells *cells,
                       double *const f[3])
{
    const struct strip *strip = cells->strip;
    const int32_t *corner = hexahedra->body->lattice->hexahedron + CORNERS * strip->site;
    const double *gradient = hexahedra->gradient + GRADIENT * strip->store,
                 *amplitude = hexahedra->amplitude + AMPLITUDE * strip->store;
    double force[3][CORNERS][LANES] = {{{0}}};
    for (int a = 0; a < 3; a++)
        for (int k = 0; k < CORNERS; k++) {
            for (int b = 0; b < 3; b++)
                add_products(strip->count, cells->A[3 * a + b] + PAD,
                             gradient + (3 * k + b) * strip->stride, force[a][k]);
            for (int m = 0; m < MODES; m++)
                add_products(strip->count, cells->m[m][a] + PAD,
                             amplitude + (CORNERS * m + k) * strip->stride, force[a][k]);
        }
    /* Particle by particle, whatever strips it shares with others: so a node's sum has the same
     * bits on any rank. */
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < strip->count; i++)
            for (int k = 0; k < CORNERS; k++) f[a][corner[CORNERS * i + k]] -= force[a][k][i];
}
