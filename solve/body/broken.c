#include "broken.h"

#include "bonds.h"
#include "memory.h"
#include "scattered.h"

#include <stdlib.h>

enum { TOUCHED = 1, OUTDATED = 2 };

static struct broken *broken_new(const struct body *body)
{
    struct broken *broken = memory_new(1, sizeof *broken);
    const size_t sites = (size_t)body->grid.n_sites;
    broken->words = (body->family->n_half + 63) / 64;
    broken->bits = memory_new(sites * (size_t)broken->words, sizeof *broken->bits);
    broken->touched = memory_new(sites, sizeof *broken->touched);
    broken->lost = memory_new(sites, sizeof *broken->lost);
    return broken;
}

void broken_free(struct broken *broken)
{
    if (!broken) return;
    free(broken->bits);
    free(broken->touched);
    free(broken->lost);
    free(broken);
}

void broken_add(struct body *body, struct bonds *bonds, struct bond_strip *strip, int k)
{
    const struct bond_view view = bonds_view(bonds, strip);
    const int64_t i = bond_lower(&view, k), j = bond_upper(&view, k);
    bonds_own_weights(bonds, strip)[k] = 0;
    if (!body->broken) body->broken = broken_new(body);
    body->broken->touched[i] = body->broken->touched[j] = TOUCHED | OUTDATED;
    if (strip->offset < 0) return;
    body->broken->bits[i * body->broken->words + strip->offset / 64] |= UINT64_C(1)
                                                                        << (strip->offset % 64);
}

/* K_i and s_i (family.2) over the bonds left. */
static bool shape(const struct body *body, int64_t site, double inverse[6], double first[3])
{
    const struct family *family = body->family;
    double K[6] = {0};
    first[0] = first[1] = first[2] = 0;
    for (int o = 0; o < family->n_half; o++) {
        const int64_t shift = grid_shift(&body->grid, family->half[o].step);
        for (int sign = -1; sign <= 1; sign += 2) {
            const int64_t other = site + sign * shift, lower = sign > 0 ? site : other;
            if (body->grid.phase[other] == ABSENT || broken_bond(body->broken, lower, o)) continue;
            family_add_shape(&family->half[o], sign, K, first);
        }
    }
    return family_invert_shape(K, body->lattice->dimensions, inverse);
}

void broken_shapes(struct body *body)
{
    if (!body->broken) body->broken = broken_new(body);
    struct broken *broken = body->broken;
    const bool scattered = body->lattice->point[0] != NULL;
    if (scattered) scattered_shapes(body);
    broken->n_lost = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            const int64_t site = body->owned.items[s].site + i;
            if (scattered) {
                broken->lost[site] = body->inverse[0][site] > 0 ? 0 : 1;
            } else if (broken->touched[site] & OUTDATED) {
                double inverse[6], first[3];
                broken->lost[site] = shape(body, site, inverse, first) ? 0 : 1;
                for (int k = 0; k < 6; k++) body->inverse[k][site] = inverse[k];
                for (int k = 0; k < 3; k++) body->first[k][site] = first[k];
                broken->touched[site] = TOUCHED;
            }
            broken->n_lost += broken->lost[site];
        }
    ranks_sum(&broken->n_lost, 1);
    halo_exchange(body->gradient_halo, &broken->lost, 1);
}

void broken_sums(const struct body *body, int64_t site, int count, const double *field, int b,
                 double *sums)
{
    const struct family *family = body->family;
    for (int k = 0; k < count; k++) {
        const int64_t i = site + k;
        if (!body->broken->touched[i]) continue;
        double sum = 0;
        for (int o = 0; o < family->n_half; o++) {
            const struct offset *offset = &family->half[o];
            if (!offset->step[b]) continue;
            const int64_t shift = grid_shift(&body->grid, offset->step);
            double plus = broken_bond(body->broken, i, o) ? 0 : field[i + shift],
                   minus = broken_bond(body->broken, i - shift, o) ? 0 : field[i - shift];
            sum += (plus - minus) * (offset->weight * offset->step[b]);
        }
        sums[k] = sum;
    }
}
