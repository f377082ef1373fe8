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
    double *modulus; /* c of each pair of phases, a * count + b [N/m^6] */
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
    const int n = all->count;
    model->bonds = bonds;
    surface_correction_apply(model->correction, bonds, 1);
    model->modulus = memory_new((size_t)(n * n), sizeof *model->modulus);
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++)
            model->modulus[a * n + b] =
                0.5 * (micromodulus(&all->items[a], all->plane, model->family, body->lattice) +
                       micromodulus(&all->items[b], all->plane, model->family, body->lattice));
}

HS_SIMD static void look_up(int count, const uint8_t *restrict a, const uint8_t *restrict b, int n,
                            const double *restrict table, double *restrict out)
{
#pragma omp simd
    for (int k = 0; k < count; k++) out[k] = table[a[k] * n + b[k]];
}

/* Micromodulus of the bonds of a strip: one number (step 0) or one a bond, in the buffer. */
static const double *moduli(const struct bond_based *model, const struct bond_strip *strip,
                            const struct bond_view *view, double *buffer, int *step)
{
    const uint8_t *phase = model->bonds->body->grid.phase;
    const int n = model->materials->count;
    *step = strip->pair < 0;
    if (strip->pair >= 0) return &model->modulus[strip->pair / 16 * n + strip->pair % 16];
    if (!view->lower)
        look_up(view->count, phase + view->i, phase + view->j, n, model->modulus, buffer);
    for (int k = 0; view->lower && k < view->count; k++)
        buffer[k] = model->modulus[phase[bond_lower(view, k)] * n + phase[bond_upper(view, k)]];
    return buffer;
}

/* What a kernel reads and writes of a strip. */
struct pull {
    int count;
    struct bond_ends u;
    const struct bond_view *view;
    const double *modulus;
    double *lower[3], *upper[3]; /* force densities */
    double *terms;               /* energy of each bond, where asked */
};

/* (bond_based.2) of the bonds of a strip, an element of geometry, weight and modulus every g, w and m; with
 * energy c w s^2 |xi| V_i V_j/2 of each bond.  e = (2 xi.eta + eta.eta)/(|y| + |xi|) is exact to round-off for
 * small displacements, too. */
HS_INLINE void pull(const struct pull *p, int g, int w, int m, bool energy)
{
    const struct bond_view *v = p->view;
    const double *ux = p->u.lower[0], *uy = p->u.lower[1], *uz = p->u.lower[2];
    const double *vx = p->u.upper[0], *vy = p->u.upper[1], *vz = p->u.upper[2];
    const double *X = v->xi[0], *Y = v->xi[1], *Z = v->xi[2], *L = v->length, *W = v->weight;
    const double *Vi = v->volume_i, *Vj = v->volume_j, *C = p->modulus;
    double *ix = p->lower[0], *iy = p->lower[1], *iz = p->lower[2];
    double *jx = p->upper[0], *jy = p->upper[1], *jz = p->upper[2], *terms = p->terms;
    const double X0 = *X, Y0 = *Y, Z0 = *Z, L0 = *L, W0 = *W, Vj0 = *Vj, C0 = *C;
    const int count = p->count;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = g ? X[k] : X0, y = g ? Y[k] : Y0, z = g ? Z[k] : Z0, length = g ? L[k] : L0;
        double volume_j = g ? Vj[k] : Vj0, volume_i = g ? Vi[k] : volume_j; /* alike on a lattice */
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        x += a;
        y += b;
        z += d;
        double now = sqrt(x * x + y * y + z * z);
        double modulus = (m ? C[k] : C0) * (w ? W[k] : W0);
        double slope = longer / ((now + length) * (length * now));
        double i = (modulus * volume_j) * slope, j = (modulus * volume_i) * slope;
        ix[k] += i * x;
        iy[k] += i * y;
        iz[k] += i * z;
        jx[k] -= j * x;
        jy[k] -= j * y;
        jz[k] -= j * z;
        if (energy)
            terms[k] =
                0.5 * modulus * (slope * now) * (slope * now) * length * (volume_i * volume_j);
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
VARIANTS(pull_alike, 0, 0, 0)
VARIANTS(pull_weighted, 0, 1, 0)
VARIANTS(pull_phases, 0, 0, 1)
VARIANTS(pull_weighted_phases, 0, 1, 1)
VARIANTS(pull_scattered, 1, 1, 0)
VARIANTS(pull_scattered_phases, 1, 1, 1)

/* [geometry_step][weight_step][step of the modulus][energy] */
static void (*const pulling[2][2][2][2])(const struct pull *) = {
    {{CHOICE(pull_alike), CHOICE(pull_phases)},
     {CHOICE(pull_weighted), CHOICE(pull_weighted_phases)}},
    {{{NULL, NULL}, {NULL, NULL}}, {CHOICE(pull_scattered), CHOICE(pull_scattered_phases)}}};

/* Strip number s; stored: where not NULL, its energy is added, else strips after it may go with it: returns how
 * many have been done. */
static int64_t pull_strip(const struct bond_based *model, struct body *body, int64_t s,
                          struct exact_sum *stored)
{
    const struct bond_strip *strip = &model->bonds->strips[s];
    struct bond_view view;
    int64_t done = 1;
    if (stored)
        view = bonds_view(model->bonds, strip);
    else
        done = bonds_line(model->bonds, s, &view);
    double displacement[6][LANES], force[6][LANES], moduli_buffer[LANES], terms[LANES];
    int several;
    struct pull p = {.count = view.count,
                     .u = bond_ends_find(&view, body, displacement),
                     .view = &view,
                     .modulus = moduli(model, strip, &view, moduli_buffer, &several),
                     .terms = terms};
    for (int a = 0; a < 3; a++) {
        p.lower[a] = bond_target(&view, false, body->f[a], force[a]);
        p.upper[a] = bond_target(&view, true, body->f[a], force[3 + a]);
    }
    pulling[view.geometry_step][view.weight_step][several][stored != NULL](&p);
    for (int a = 0; a < 3; a++) {
        bond_scatter(&view, false, body->f[a], force[a]);
        bond_scatter(&view, true, body->f[a], force[3 + a]);
    }
    if (!stored) return done;
    bonds_only_owned(model->bonds, &view, terms);
    exact_sum_add_strip(stored, view.count, terms, 1);
    return done;
}

static void bond_based_bond_energy(const void *self, const struct body *body,
                                   const struct bond_strip *strip, double *energy)
{
    const struct bond_based *model = self;
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][LANES], moduli_buffer[LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    int several;
    const double *c = moduli(model, strip, &view, moduli_buffer, &several);
    double e[LANES];
    bond_ends_extensions(&view, &u, e);
    for (int k = 0; k < view.count; k++)
        energy[k] = 0.5 * c[k * several] * view.weight[k * view.weight_step] * e[k] * e[k] /
                    view.length[k * view.geometry_step];
}

static void bond_based_force(void *self, struct body *body, struct force_mode mode,
                             struct force_energy *energy)
{
    const struct bond_based *model = self;
    halo_exchange(body->displacement_halo, body->u, 3);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < model->bonds->count;)
        s += pull_strip(model, body, s, mode.energy ? &energy->stored : NULL);
}

/* Half of the force of a bond belongs to either end. */
static void add_stress(const struct bond_based *model, struct body *body,
                       const struct bond_strip *strip)
{
    const struct bond_view view = bonds_view(model->bonds, strip);
    double displacement[6][LANES], moduli_buffer[LANES], half[LANES];
    const struct bond_ends u = bond_ends_find(&view, body, displacement);
    int several;
    const double *c = moduli(model, strip, &view, moduli_buffer, &several);
    double e[LANES];
    bond_ends_extensions(&view, &u, e);
    for (int k = 0; k < view.count; k++)
        half[k] = 0.5 * c[k * several] * view.weight[k * view.weight_step] * e[k] /
                  view.length[k * view.geometry_step];
    bond_ends_add_stress(&view, &u, half, half, body);
}

static void bond_based_prepare(void *self, struct body *body, double *axial)
{
    const struct bond_based *model = self;
    displacement_gradient(body);
    body_clear(body, body->S, 9);
    for (int64_t s = 0; s < model->bonds->count; s++)
        add_stress(model, body, &model->bonds->strips[s]);
    if (axial) memcpy(axial, body->S[0], (size_t)body->grid.n_sites * sizeof(double));
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
    free(model->modulus);
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
