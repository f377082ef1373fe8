/* gradient.c - the deformation gradient at the near nodes (gradient.h).
 *
 * sum (u_j - u_i) xi is split into sum u_j xi, which the columns of family_sums.h make cheap, and
 * u_i s_i, with s_i = 0 of a full family: absent neighbours have u = 0, and s_i leaves them out
 * again.  Nodes with broken bonds, few of all, are summed up bond by bond instead (broken.h).  H is
 * kept in place of F: in small strains 1 + H would lose its last digits. */
#include "gradient.h"

#include "broken.h"
#include "family_sums.h"
#include "scattered.h"

/* row_b = (G_b - u s_b) K^-1, for one row (component) of H */
HS_SIMD static void gradient_row(int count, const double *restrict u, const double *restrict sx,
                                 const double *restrict sy, const double *restrict sz,
                                 const double *restrict xx, const double *restrict yy,
                                 const double *restrict zz, const double *restrict xy,
                                 const double *restrict yz, const double *restrict zx,
                                 double inverse_spacing, const double (*restrict G)[LANES],
                                 double *restrict hx, double *restrict hy, double *restrict hz)
{
    for (int i = 0; i < count; i++) {
        double gx = (G[0][i] - u[i] * sx[i]) * inverse_spacing,
               gy = (G[1][i] - u[i] * sy[i]) * inverse_spacing,
               gz = (G[2][i] - u[i] * sz[i]) * inverse_spacing;
        hx[i] = gx * xx[i] + gy * xy[i] + gz * zx[i];
        hy[i] = gx * xy[i] + gy * yy[i] + gz * yz[i];
        hz[i] = gx * zx[i] + gy * yz[i] + gz * zz[i];
    }
}

void displacement_gradient_strips(struct body *body, int64_t first, int64_t end)
{
    double *const *K = body->inverse, *const *s = body->first;
    for (int64_t n = first; n < end; n++) {
        const int count = body->near.items[n].count;
        const int64_t i = body->near.items[n].site;
        for (int a = 0; a < 3; a++) {
            double G[3][LANES] = {{0}};
            const double *u = body->u[a] + i;
            for (int b = 0; b < 3; b++)
                family_sums_add(body->family, &body->grid, b, count, u, G[b]);
            for (int b = 0; body->broken && b < 3; b++)
                broken_sums(body, i, count, body->u[a], b, G[b]);
            gradient_row(count, u, s[0] + i, s[1] + i, s[2] + i, K[0] + i, K[1] + i, K[2] + i,
                         K[3] + i, K[4] + i, K[5] + i, 1 / body->lattice->spacing,
                         (const double(*)[LANES])G, body->H[3 * a] + i, body->H[3 * a + 1] + i,
                         body->H[3 * a + 2] + i);
        }
        body_add_mean(body, i, count);
        if (body->broken) broken_keep_gradient(body, i, count);
    }
}

void displacement_gradient(struct body *body)
{
    body_need_gradient(body);
    if (lattice_is_scattered(body->lattice)) {
        scattered_gradient(body);
        for (int64_t n = 0; body->broken && n < body->near.count; n++)
            broken_keep_gradient(body, body->near.items[n].site, body->near.items[n].count);
        return;
    }
    displacement_gradient_strips(body, 0, body->near.count);
    /* A ghost's bonds are known to its owner. */
    if (body->broken) halo_exchange(body->gradient_halo, body->H, 9);
}
