/* bond_based.c - the prototype microelastic material: central forces, each bond a spring.
 *
 *   s = (|y| - |xi|)/|xi|,  y = xi + u_j - u_i                                       (bond_based.1)
 *   f_i = sum_j c w s V_j y/|y|                                                      (bond_based.2)
 *   c = 18 K/M in space, 8 K_2/M in a plane, M = integral of w |xi| over the family  (bond_based.3)
 *
 * Silling, Askari, Computers & Structures 83 (2005) 1526, section 3, with w = 1: c = 18 K/(pi delta^4);
 * K_2 is the bulk modulus of the plane, E/(2(1 - nu)) in plane stress and E/(2(1 + nu)(1 - 2 nu)) in plane
 * strain: with w = 1, c = 9 E/(pi h delta^3) and 48 E/(5 pi h delta^3) (Trageser, Seleson, J. Peridyn.
 * Nonlocal Model. 2 (2020) 278).  Central forces fix Poisson's ratio: 1/4, in plane stress 1/3.  A bond
 * between two phases has the mean of their c. */
#include "bond_ends.h"
#include "gradient.h"
#include "memory.h"
#include "model.h"
#include "nominal.h"
#include "opening.h"
#include "surface_correction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct bond_based {
    const struct materials *materials;
    const struct family *family;
    struct bonds *bonds;
    enum surface_correction correction;
    double modulus;  /* c [N/m^6] where all phases have the same, else */
    double *of_node; /* of each node, a box field */
};

static void *bond_based_read(struct deck_node solver, const struct family *family,
                             const struct materials *materials)
{
    struct bond_based *model = memory_new(1, sizeof *model);
    if (family->influence == family_influence("steep"))
        deck_error(deck_get(solver, "influence"),
                   "the steep influence function has no continuum that a micromodulus could match");
    model->materials = materials;
    model->family = family;
    model->correction = surface_correction_read(solver);
    return model;
}

/* (bond_based.3) */
static double micromodulus(const struct material *m, enum plane plane, const struct family *family,
                           const struct lattice *lattice)
{
    const double pi = acos(-1), dx = lattice->spacing, K = material_bulk_modulus(m, plane);
    if (plane == SPACE) return 18 * K / (4 * pi * family_moment(family, 3) * pow(dx, 4));
    return 8 * K / (2 * pi * lattice->thickness * family_moment(family, 2) * pow(dx, 3));
}

static void bond_based_start(void *self, const struct body *body, struct bonds *bonds)
{
    struct bond_based *model = self;
    const struct materials *all = model->materials;
    double *modulus = memory_new((size_t)all->count, sizeof *modulus);
    bool alike = true;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 1);
    for (int p = 0; p < all->count; p++) {
        modulus[p] = micromodulus(&all->items[p], all->plane, model->family, body->lattice);
        alike &= modulus[p] == modulus[0];
    }
    model->modulus = modulus[0];
    if (!alike) {
        const uint8_t *phase = body->grid.phase;
        model->of_node = memory_new((size_t)body->grid.n_sites, sizeof *model->of_node);
        for (int64_t i = 0; i < body->grid.n_sites; i++)
            if (phase[i] != ABSENT) model->of_node[i] = modulus[phase[i]];
    }
    free(modulus);
}

/* What a kernel reads and writes of a strip: arrays of its first bond, or one number for all of it. */
struct pull {
    int count;
    const double *u_lower[3], *u_upper[3];
    const double *xi[3], *length, *weight, *volume_i, *volume_j;
    const double *c_lower, *c_upper;
    double *f_lower[3], *f_upper[3];
    double *terms; /* energy of each bond, where asked */
};

/* (bond_based.2) of the bonds of a strip, with an array each of geometry, weight and modulus where g, w and m; with
 * energy c w s^2 |xi| V_i V_j/2 of each bond.  s = (2 xi.eta + eta.eta)/((|y| + |xi|) |xi|), eta = u_j - u_i, is exact to
 * round-off for small displacements, too. */
HS_INLINE void pull(const struct pull *p, bool g, bool w, bool m, bool energy)
{
    const double *ux = p->u_lower[0], *uy = p->u_lower[1], *uz = p->u_lower[2];
    const double *vx = p->u_upper[0], *vy = p->u_upper[1], *vz = p->u_upper[2];
    const double *X = p->xi[0], *Y = p->xi[1], *Z = p->xi[2], *L = p->length, *W = p->weight;
    const double *Vi = p->volume_i, *Vj = p->volume_j, *Ci = p->c_lower, *Cj = p->c_upper;
    double *ix = p->f_lower[0], *iy = p->f_lower[1], *iz = p->f_lower[2];
    double *jx = p->f_upper[0], *jy = p->f_upper[1], *jz = p->f_upper[2], *terms = p->terms;
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, C0 = *Ci;
    const int count = p->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double modulus = (m ? 0.5 * (Ci[k] + Cj[k]) : C0) * (w ? W[k] : W0);
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        double square = length * length + longer, now = sqrt(square);
        double both = length * square + (length * length) * now; /* (|y| + |xi|) |xi| |y| */
        double share = longer / both;                            /* s/|y| */
        double i = modulus * volume_j * share, j = modulus * volume_i * share;
        x += a;
        y += b;
        z += d;
        ix[k] += i * x;
        iy[k] += i * y;
        iz[k] += i * z;
        jx[k] -= j * x;
        jy[k] -= j * y;
        jz[k] -= j * z;
        if (energy) {
            double s = share * now;
            terms[k] = 0.5 * modulus * (s * s) * length * (volume_i * volume_j);
        }
    }
}

#define VARIANT(name, g, w, m, energy)                                                             \
    HS_SIMD static void name(const struct pull *p)                                                 \
    {                                                                                              \
        pull(p, g, w, m, energy);                                                                  \
    }
#define VARIANTS(name, g, w, m)                                                                    \
    VARIANT(name, g, w, m, false)                                                                  \
    VARIANT(name##_energy, g, w, m, true)
#define CHOICE(name)                                                                               \
    {                                                                                              \
        name, name##_energy                                                                        \
    }
VARIANTS(pull_alike, false, false, false)
VARIANTS(pull_weighted, false, true, false)
VARIANTS(pull_phases, false, false, true)
VARIANTS(pull_weighted_phases, false, true, true)
VARIANTS(pull_scattered, true, true, false)
VARIANTS(pull_scattered_phases, true, true, true)

/* Of a lattice [weights][moduli][energy], of scattered particles [moduli][energy]. */
static void (*const on_lattice[2][2][2])(const struct pull *) = {
    {CHOICE(pull_alike), CHOICE(pull_phases)},
    {CHOICE(pull_weighted), CHOICE(pull_weighted_phases)}};
static void (*const scattered[2][2])(const struct pull *) = {CHOICE(pull_scattered),
                                                             CHOICE(pull_scattered_phases)};

static void add_energy(const struct bond_based *model, const struct bond_strip *strip,
                       double *terms, struct exact_sum *stored)
{
    const struct bond_view view = bonds_view(model->bonds, strip);
    bonds_only_owned(model->bonds, &view, terms);
    exact_sum_add_strip(stored, view.count, terms, 1);
}

/* stored: where not NULL, the strip's energy is added. */
static void pull_lattice(const struct bond_based *model, struct body *body,
                         const struct bond_strip *strip, struct exact_sum *stored)
{
    const struct bonds *bonds = model->bonds;
    const struct bond_geometry *g = &bonds->geometry[strip->offset];
    const int64_t i = strip->i, j = i + g->shift;
    double terms[BOND_LANES], force[3][BOND_LANES];
    struct pull p;
    p.count = strip->count;
    p.length = &g->length;
    p.weight = strip->weight ? strip->weight : &g->weight;
    p.volume_i = p.volume_j = bonds->volume;
    p.c_lower = p.c_upper = &model->modulus;
    if (model->of_node) {
        p.c_lower = model->of_node + i;
        p.c_upper = model->of_node + j;
    }
    p.terms = terms;
    for (int a = 0; a < 3; a++) {
        p.xi[a] = &g->xi[a];
        p.u_lower[a] = body->u[a] + i;
        p.u_upper[a] = body->u[a] + j;
        p.f_lower[a] = body->f[a] + i;
        p.f_upper[a] = body->f[a] + j;
    }
    if (!g->apart) bond_detour(3, force, strip->count, p.f_upper);
    on_lattice[strip->weight != NULL][model->of_node != NULL][stored != NULL](&p);
    if (!g->apart) bond_detour_end(3, force, strip->count, body->f, j);
    if (stored) add_energy(model, strip, terms, stored);
}

static void pull_scattered_strip(const struct bond_based *model, struct body *body,
                                 const struct bond_strip *strip, struct exact_sum *stored)
{
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][BOND_LANES], force[6][BOND_LANES], moduli[2][BOND_LANES],
        terms[BOND_LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    struct pull p = {.count = view.count,
                     .length = view.length,
                     .weight = view.weight,
                     .volume_i = view.volume_i,
                     .volume_j = view.volume_j,
                     .c_lower = &model->modulus,
                     .c_upper = &model->modulus,
                     .terms = terms};
    if (model->of_node) {
        p.c_lower = bond_gather(&view, false, model->of_node, moduli[0]);
        p.c_upper = bond_gather(&view, true, model->of_node, moduli[1]);
    }
    for (int a = 0; a < 3; a++) {
        p.xi[a] = view.xi[a];
        p.u_lower[a] = u.lower[a];
        p.u_upper[a] = u.upper[a];
        p.f_lower[a] = bond_target(&view, false, body->f[a], force[a]);
        p.f_upper[a] = bond_target(&view, true, body->f[a], force[3 + a]);
    }
    scattered[model->of_node != NULL][stored != NULL](&p);
    for (int a = 0; a < 3; a++) {
        bond_scatter(&view, false, body->f[a], force[a]);
        bond_scatter(&view, true, body->f[a], force[3 + a]);
    }
    if (stored) add_energy(model, strip, terms, stored);
}

/* c of bond k of a view. */
static double modulus_of(const struct bond_based *model, const struct bond_view *view, int k)
{
    if (!model->of_node) return model->modulus;
    return 0.5 * (model->of_node[bond_lower(view, k)] + model->of_node[bond_upper(view, k)]);
}

static void bond_based_bond_energy(const void *self, const struct body *body,
                                   const struct bond_strip *strip, double *energy)
{
    const struct bond_based *model = self;
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][BOND_LANES], e[BOND_LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    bond_ends_extensions(&view, &u, e);
    for (int k = 0; k < view.count; k++)
        energy[k] = 0.5 * modulus_of(model, &view, k) * view.weight[k * view.weight_step] * e[k] *
                    e[k] / view.length[k * view.geometry_step];
}

static void bond_based_force(void *self, struct body *body, struct force_mode mode,
                             struct force_energy *energy)
{
    const struct bond_based *model = self;
    halo_exchange(body->displacement_halo, body->u, 3);
    body_clear(body, body->f, 3);
    struct exact_sum *stored = mode.energy ? &energy->stored : NULL;
    for (int64_t s = 0; s < model->bonds->count; s++)
        (lattice_is_scattered(body->lattice) ? pull_scattered_strip : pull_lattice)(
            model, body, &model->bonds->strips[s], stored);
}

/* Half of the force of a bond belongs to either end. */
static void add_stress(const struct bond_based *model, struct body *body,
                       const struct bond_strip *strip, int rows)
{
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][BOND_LANES], e[BOND_LANES], half[BOND_LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    bond_ends_extensions(&view, &u, e);
    for (int k = 0; k < view.count; k++)
        half[k] = 0.5 * modulus_of(model, &view, k) * view.weight[k * view.weight_step] * e[k] /
                  view.length[k * view.geometry_step];
    bond_ends_add_stress(&view, &u, e, half, half, rows, body);
}

static void bond_based_prepare(void *self, struct body *body, int rows)
{
    const struct bond_based *model = self;
    displacement_gradient(body);
    body_clear(body, body->S, 3 * rows);
    for (int64_t s = 0; s < model->bonds->count; s++)
        add_stress(model, body, &model->bonds->strips[s], rows);
}

static void bond_based_observe(void *self, const struct body *body, const struct strip *strip,
                               struct node_state *node)
{
    const struct bond_based *model = self;
    node_state_from_nominal(body, strip, model->materials, node);
    memset(node->plastic, 0, sizeof node->plastic);
}

static void bond_based_free(void *self)
{
    struct bond_based *model = self;
    free(model->of_node);
    free(model);
}

const struct formulation formulation_bond_based = {
    .name = "bond-based",
    .influence = "constant",
    .keys = (const char *const[]){"surface_correction", NULL},
    .read = bond_based_read,
    .start = bond_based_start,
    .force = bond_based_force,
    .prepare = bond_based_prepare,
    .observe = bond_based_observe,
    .bond_energy = bond_based_bond_energy,
    .opening = opening_bond_based,
    .free = bond_based_free,
};
