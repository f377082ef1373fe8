/* broken.c - families that have lost bonds: shape tensor, gradient and divergence, bond by bond
 * (broken.h).
 *
 * The sums by columns (family_sums.h) take whole families for granted; here is what they leave to
 * the nodes beside a crack. A bit a bond and lower end is asked from both ends.  Shapes change
 * where bonds have broken alone, so a run pays for the nodes beside its cracks and no others.  What
 * remains of a family may span no space, or so little of it that the node would be stiffer than the
 * step allows: then the node is given up as one without a gradient. */
#include "broken.h"

#include "bonds.h"
#include "checkpoint.h"
#include "memory.h"
#include "scattered.h"

#include <stdlib.h>
#include <string.h>

enum { TOUCHED = 1, OUTDATED = 2 };

/* xx + yy + zz of K^-1: what the stiffness of the node's softest family direction grows with. */
static double compliance(const struct body *body, int64_t site)
{
    return body->inverse[0][site] + body->inverse[1][site] + body->inverse[2][site];
}

static struct broken *broken_new(struct body *body)
{
    body_need_gradient(body);
    struct broken *broken = memory_new(1, sizeof *broken);
    const size_t sites = (size_t)body->grid.n_sites;
    broken->words = (body->family->n_half + 63) / 64;
    broken->bits = memory_new(sites * (size_t)broken->words, sizeof *broken->bits);
    broken->touched = memory_new(sites, sizeof *broken->touched);
    broken->lost = memory_new(sites, sizeof *broken->lost);
    broken->whole = memory_new(sites, sizeof *broken->whole);
    for (size_t i = 0; i < sites; i++) broken->whole[i] = compliance(body, (int64_t)i);
    for (int k = 0; k < 9; k++) {
        broken->keep[k] = memory_new(sites, sizeof(double));
        for (size_t i = 0; k % 4 == 0 && i < sites; i++) broken->keep[k][i] = 1;
    }
    return broken;
}

void broken_free(struct broken *broken)
{
    if (!broken) return;
    free(broken->bits);
    free(broken->touched);
    for (int k = 0; k < 9; k++) free(broken->keep[k]);
    free(broken->lost);
    free(broken->whole);
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

/* K_i and s_i (family.2) over the remaining bonds. */
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

static double determinant(const double F[9])
{
    return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
           F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/* 1 + H at a site from body->H, and over the remaining bonds from u, the inverse and s. */
static void old_gradient(const struct body *body, int64_t site, double F[9])
{
    for (int k = 0; k < 9; k++) F[k] = body->H[k][site] + (k % 4 == 0);
}

static void new_gradient(const struct body *body, int64_t site, double F[9])
{
    const double per_spacing = 1 / body->lattice->spacing;
    double K[6];
    for (int k = 0; k < 6; k++) K[k] = body->inverse[k][site];
    for (int a = 0; a < 3; a++) {
        double G[3];
        for (int b = 0; b < 3; b++) {
            broken_sums(body, site, 1, body->u[a], b, &G[b]);
            G[b] = (G[b] - body->u[a][site] * body->first[b][site]) * per_spacing;
        }
        F[3 * a] = G[0] * K[0] + G[1] * K[3] + G[2] * K[5];
        F[3 * a + 1] = G[0] * K[3] + G[1] * K[1] + G[2] * K[4];
        F[3 * a + 2] = G[0] * K[5] + G[1] * K[4] + G[2] * K[2];
        F[4 * a] += 1;
        for (int b = 0; b < 3; b++) F[3 * a + b] += body->lattice_gradient[3 * a + b];
    }
}

/* A of (broken.1), remaining being 1 + H over the remaining bonds; false where these see another
 * volume altogether. */
static bool keep_gradient(const struct body *body, int64_t site, const double remaining[9])
{
    enum { MOST_CHANGE = 5 };
    double F[9];
    old_gradient(body, site, F);
    const double J = determinant(remaining), volume = J / determinant(F);
    if (!(volume > 1.0 / MOST_CHANGE && volume < MOST_CHANGE)) return false;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            /* row a of the inverse: cofactors of column a */
            double sum = 0;
            for (int c = 0; c < 3; c++) {
                const int p = (c + 1) % 3, q = (c + 2) % 3, r = (a + 1) % 3, t = (a + 2) % 3;
                double cofactor = remaining[3 * p + r] * remaining[3 * q + t] -
                                  remaining[3 * p + t] * remaining[3 * q + r];
                sum += cofactor * F[3 * c + b];
            }
            body->broken->keep[3 * a + b][site] = sum / J;
        }
    return true;
}

/* Whether the remaining bonds span space, and not so little of it that a stiff remnant sets the
 * time step. */
static bool still_spans(const struct body *body, int64_t site)
{
    enum { MOST_STIFFENING = 10 };
    const double now = compliance(body, site);
    return now > 0 && now < MOST_STIFFENING * body->broken->whole[site];
}

/* Gives the node up as one without a deformation gradient. */
static void lose(struct body *body, int64_t site)
{
    for (int k = 0; k < 6; k++) body->inverse[k][site] = 0;
    body->broken->lost[site] = 1;
}

static bool has_gradient(const struct body *body, int64_t site)
{
    return body->inverse[0][site] > 0;
}

static void lattice_shapes(struct body *body, bool keep)
{
    struct broken *broken = body->broken;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int64_t i = body->owned.items[s].site, end = i + body->owned.items[s].count; i < end;
             i++) {
            if (!(broken->touched[i] & OUTDATED)) continue;
            broken->touched[i] = TOUCHED;
            if (!has_gradient(body, i)) continue; /* what is lost stays so */
            double inverse[6], first[3], remaining[9];
            shape(body, i, inverse, first);
            for (int k = 0; k < 6; k++) body->inverse[k][i] = inverse[k];
            for (int k = 0; k < 3; k++) body->first[k][i] = first[k];
            bool spans = still_spans(body, i);
            if (spans && keep) {
                new_gradient(body, i, remaining);
                spans = keep_gradient(body, i, remaining);
            }
            if (!spans) lose(body, i);
        }
}

/* Shape tensors of nodes that have lost bonds where families are lists of bonds; every rank finds
 * those of its near nodes. */
static void list_shapes(struct body *body, bool keep)
{
    struct broken *broken = body->broken;
    const size_t sites = (size_t)body->grid.n_sites;
    const int64_t unsupported = body->unsupported;
    double *before[9];
    bool *had = memory_new(sites, sizeof *had);
    for (size_t i = 0; i < sites; i++) had[i] = has_gradient(body, (int64_t)i);
    for (int k = 0; k < 9; k++) {
        before[k] = memory_new(sites, sizeof(double));
        memcpy(before[k], body->H[k], sites * sizeof(double));
    }
    scattered_shapes(body);
    body->unsupported = unsupported;
    if (keep) scattered_gradient(body);
    for (int64_t s = 0; s < body->near.count; s++)
        for (int64_t i = body->near.items[s].site, end = i + body->near.items[s].count; i < end;
             i++) {
            double remaining[9];
            const bool outdated = broken->touched[i] & OUTDATED;
            if (!outdated && !(broken->lost[i] > 0)) continue;
            broken->touched[i] = TOUCHED;
            old_gradient(body, i, remaining);
            for (int k = 0; k < 9; k++) body->H[k][i] = before[k][i];
            const bool spans = had[i] && still_spans(body, i);
            if (!spans || (keep && outdated && !keep_gradient(body, i, remaining))) {
                for (int k = 0; k < 6; k++) body->inverse[k][i] = 0;
                if (had[i]) lose(body, i);
            }
        }
    for (int k = 0; k < 9; k++) free(before[k]);
    free(had);
}

void broken_shapes(struct body *body, bool keep)
{
    if (!body->broken) body->broken = broken_new(body);
    struct broken *broken = body->broken;
    (lattice_is_scattered(body->lattice) ? list_shapes : lattice_shapes)(body, keep);
    broken->n_lost = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++)
            broken->n_lost += broken->lost[body->owned.items[s].site + i];
    ranks_sum(&broken->n_lost, 1);
    halo_exchange(body->gradient_halo, &broken->lost, 1);
}

void broken_keep_gradient(struct body *body, int64_t site, int count)
{
    const struct broken *broken = body->broken;
    for (int64_t i = site; i < site + count; i++) {
        double F[9];
        if (!broken->touched[i] || broken->lost[i] > 0) continue;
        old_gradient(body, i, F);
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) {
                double sum = a == b ? -1 : 0;
                for (int c = 0; c < 3; c++) sum += F[3 * a + c] * broken->keep[3 * c + b][i];
                body->H[3 * a + b][i] = sum;
            }
    }
}

void broken_keep_stress(struct body *body, int64_t site, int count)
{
    const struct broken *broken = body->broken;
    for (int64_t i = site; i < site + count; i++) {
        if (!broken->touched[i]) continue;
        for (int a = 0; a < 3; a++) {
            double row[3];
            for (int b = 0; b < 3; b++) {
                row[b] = 0;
                for (int c = 0; c < 3; c++)
                    row[b] += body->S[3 * a + c][i] * broken->keep[3 * b + c][i];
            }
            for (int b = 0; b < 3; b++) body->S[3 * a + b][i] = row[b];
        }
    }
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

struct visited {
    struct body *body;
    struct bonds *bonds;
};

static bool place_broken(void *owner, int64_t strip, int point, bool make, double *places[])
{
    const struct visited *visited = owner;
    struct bond_strip *at = &visited->bonds->strips[strip];
    const struct bond_view view = bonds_view(visited->bonds, at);
    const bool whole = view.weight[point * view.weight_step] > 0;
    (void)places;
    if (make && whole) broken_add(visited->body, visited->bonds, at, point);
    return !whole && bonds_first_weight(visited->bonds, at, point) > 0;
}

static void visit_record(struct body *body, struct checkpoint *checkpoint)
{
    struct broken *broken = body->broken;
    const size_t sites = (size_t)body->grid.n_sites;
    double *touched = memory_new(sites, sizeof *touched);
    for (size_t i = 0; i < sites; i++) touched[i] = broken->touched[i];
    checkpoint_fields(checkpoint, "broken: ends", &touched, 1);
    checkpoint_fields(checkpoint, "broken: what keeps F", broken->keep, 9);
    checkpoint_fields(checkpoint, "broken: compliance before", &broken->whole, 1);
    checkpoint_fields(checkpoint, "broken: lost", &broken->lost, 1);
    checkpoint_numbers(checkpoint, "broken: number lost", &broken->n_lost, 1);
    checkpoint_fields(checkpoint, "inverse shape tensor", body->inverse, 6);
    checkpoint_fields(checkpoint, "first moments", body->first, 3);
    for (size_t i = 0; i < sites; i++)
        if (body->grid.flags[i]) broken->touched[i] = (uint8_t)touched[i];
    free(touched);
}

void broken_visit(struct body *body, struct bonds *bonds, struct checkpoint *checkpoint)
{
    struct visited visited = {body, bonds};
    bool gradient = body->H[0] != NULL, any = body->broken != NULL, changed = bonds->changed;
    double some = any ? 1 : 0;
    if (!checkpoint_reads(checkpoint)) ranks_sum(&some, 1);
    any = some > 0;
    checkpoint_flag(checkpoint, "gradients", &gradient);
    if (gradient) body_need_gradient(body);
    checkpoint_flag(checkpoint, "some bond is broken", &any);
    if (any && !body->broken) body->broken = broken_new(body);
    if (any) {
        checkpoint_bonds(checkpoint, "broken bonds", 0, place_broken, &visited);
        visit_record(body, checkpoint);
    }
    checkpoint_flag(checkpoint, "weights have changed", &changed);
    bonds->changed = changed;
}
