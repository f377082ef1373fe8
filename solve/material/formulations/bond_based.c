/* bond_based.c - the prototype microelastic material: central forces, each bond a spring.
 *
 *   s = (|y| - |xi|)/|xi|,  y = xi + u_j - u_i                                       (bond_based.1)
 *   f_i = sum_j c w s V_j y/|y|                                                      (bond_based.2)
 *   c = 18 K/M in space, 8 K_2/M in a plane, M = integral of w |xi| over the family  (bond_based.3)
 *
 * Silling, Askari, Computers & Structures 83 (2005) 1526, section 3, with w = 1: c = 18 K/(pi
 * delta^4); K_2 is the bulk modulus of the plane, E/(2(1 - nu)) in plane stress and E/(2(1 + nu)(1
 * - 2 nu)) in plane strain: with w = 1, c = 9 E/(pi h delta^3) and 48 E/(5 pi h delta^3) (Trageser,
 * Seleson, J. Peridyn. Nonlocal Model. 2 (2020) 278).  Central forces fix Poisson's ratio: 1/4, in
 * plane stress 1/3.  A bond through two phases is as stiff as theirs in series (interface.h), or
 * has the mean of their c: its weight makes the difference.
 *
 * A bond needs nothing of its ends but where they are: one pass, which pull is all of.  One root
 * and one division set its pace, so s/|y| is one fraction.  Energies come with the forces where
 * they are asked for, and c is read at both ends only where phases differ in it: four kernels, each
 * a loop of its own in the three variants of bond_loop.h. */
#include "bond_loop.h"
#include "bond_stress.h"
#include "gradient.h"
#include "interface.h"
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
    bool series;     /* bonds through two phases */
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
    model->series = interface_read(solver);
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

/* The weight of a bond takes it from the mean of its ends' c to that of its phases in series. */
static void weigh_strip(const struct interface *interface, const struct bond_based *model,
                        struct bond_strip *strip)
{
    double of_ends[4][BOND_LANES], *const share[2] = {of_ends[0], of_ends[1]},
                                          *const part[2] = {of_ends[2], of_ends[3]};
    if (!interface_strip(interface, strip, share, part)) return;
    double *weight = bonds_own_weights(model->bonds, strip);
    const struct bond_view view = bonds_view(model->bonds, strip);
    for (int k = 0; k < view.count; k++) {
        const double lower = model->of_node[bond_lower(&view, k)],
                     upper = model->of_node[bond_upper(&view, k)];
        if (share[0][k] != 1 || share[1][k] != 1)
            weight[k] *= share[0][k] * lower / (0.5 * (lower + upper));
    }
}

static void put_in_series(const struct bond_based *model, const double *modulus)
{
    struct interface *interface = interface_new(model->bonds, model->materials->count, modulus);
    for (int64_t s = 0; interface && s < model->bonds->count; s++)
        weigh_strip(interface, model, &model->bonds->strips[s]);
    interface_free(interface);
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
        if (model->series) put_in_series(model, modulus);
    }
    free(modulus);
}

/* c of a bond, and its weight. */
HS_INLINE double stiffness(const struct bond_pass *p, int k, struct bond b, bool phases)
{
    return (phases ? 0.5 * (p->node[0][0][k] + p->node[1][0][k]) : p->number) * b.weight;
}

/* (bond_based.2), where asked with the energy c w s^2 |xi| V_i V_j/2 of the bond.
 * s/|y| = (|y|^2 - |xi|^2)/((|y| + |xi|) |xi| |y|). */
HS_INLINE void pull(const struct bond_pass *p, int k, struct bond b, bool phases, bool energy)
{
    const double square = b.length * b.length + b.longer, now = sqrt(square);
    const double share = b.longer / (b.length * square + (b.length * b.length) * now);
    const double c = stiffness(p, k, b, phases), s = share * now;
    bond_push(p, k, b, c * b.volume_j * share, c * b.volume_i * share);
    if (energy) p->each[0][k] = 0.5 * c * (s * s) * b.length * (b.volume_i * b.volume_j);
}
BOND_KERNELS(pull_alone, pull(p, k, b, false, false))
BOND_KERNELS(pull_energy, pull(p, k, b, false, true))
BOND_KERNELS(pull_phases, pull(p, k, b, true, false))
BOND_KERNELS(pull_phases_energy, pull(p, k, b, true, true))
/* [phases][energy] */
static bond_kernel *const *const pulling[2][2] = {{pull_alone, pull_energy},
                                                  {pull_phases, pull_phases_energy}};

/* y, and the force over |y|, per volume of either end. */
HS_INLINE void find_force(const struct bond_pass *p, int k, struct bond b, bool phases)
{
    const double square = b.length * b.length + b.longer, now = sqrt(square);
    p->each[0][k] = b.x;
    p->each[1][k] = b.y;
    p->each[2][k] = b.z;
    p->each[3][k] =
        stiffness(p, k, b, phases) * (b.longer / (b.length * square + (b.length * b.length) * now));
}
BOND_KERNELS(find_forces, find_force(p, k, b, false))
BOND_KERNELS(find_forces_phases, find_force(p, k, b, true))

/* Extension, force state of either end, half of the force each, and energy density of the bond. */
HS_INLINE void find_state(const struct bond_pass *p, int k, struct bond b)
{
    const double e = bond_extension(b), c = stiffness(p, k, b, p->node[0][0] != NULL);
    p->each[0][k] = e;
    p->each[1][k] = 0.5 * c * e / b.length;
    p->each[2][k] = 0.5 * c * e * e / b.length;
}
BOND_KERNELS(find_states, find_state(p, k, b))

HS_INLINE void run(bond_kernel *const kernel[], const struct bond_based *model,
                   const struct bond_strip *strip, int sums, double *const sum[],
                   struct bond_pass *pass)
{
    pass->number = model->modulus;
    pass->node[0][0] = NULL;
    bond_run(kernel, model->bonds, strip,
             (struct bond_fields){model->of_node ? 1 : 0, sums, &model->of_node, sum}, pass);
}

static void bond_based_bond_energy(const void *self, const struct body *body,
                                   const struct bond_strip *strip, double *energy)
{
    (void)body;
    double extension[BOND_LANES], half[BOND_LANES];
    struct bond_pass pass = {.each = {extension, half, energy}};
    run(find_states, self, strip, 0, NULL, &pass);
}

static void sum_stress(const struct bond_based *model, const struct body *body,
                       const struct bond_strip *strip)
{
    double y[3][BOND_LANES], force[BOND_LANES];
    struct bond_pass pass = {.each = {y[0], y[1], y[2], force}};
    run(model->of_node ? find_forces_phases : find_forces, model, strip, 0, NULL, &pass);
    bond_stress_cross(model->bonds, strip, (const double *const[]){y[0], y[1], y[2]}, force, body);
}

static void bond_based_force(void *self, struct body *body, struct force_mode mode,
                             struct force_energy *energy)
{
    const struct bond_based *model = self;
    const struct bonds *bonds = model->bonds;
    bond_kernel *const *kernel = pulling[model->of_node != NULL][mode.energy];
    double terms[BOND_LANES];
    halo_exchange(body->displacement_halo, body->u, 3);
    body_clear(body, body->f, 3);
    for (int64_t s = 0; s < bonds->count; s++) {
        struct bond_pass pass;
        pass.each[0] = terms;
        run(kernel, model, &bonds->strips[s], 3, body->f, &pass);
        if (body->stress_sums && bond_stress_crosses(bonds, &bonds->strips[s]))
            sum_stress(model, body, &bonds->strips[s]);
        if (!mode.energy) continue;
        bonds_only_owned(bonds, &bonds->strips[s], terms);
        exact_sum_add_strip(&energy->stored, bonds->strips[s].count, terms, 1);
    }
    if (body->stress_sums) bond_stress_nodes(body);
}

static void bond_based_prepare(void *self, struct body *body, int rows)
{
    const struct bond_based *model = self;
    const struct bonds *bonds = model->bonds;
    double e[BOND_LANES], half[BOND_LANES], energy[BOND_LANES];
    displacement_gradient(body);
    body_clear(body, body->S, 3 * rows);
    for (int64_t s = 0; s < bonds->count; s++) {
        struct bond_pass pass = {.each = {e, half, energy}};
        run(find_states, model, &bonds->strips[s], 0, NULL, &pass);
        bond_stress_add(bonds, &bonds->strips[s], e, half, half, rows, body);
    }
}

static void bond_based_observe(void *self, const struct body *body, const struct strip *strip,
                               struct node_state *node)
{
    const struct bond_based *model = self;
    node_state_from_nominal(body, strip, model->materials, node);
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
    .keys = (const char *const[]){"surface_correction", "interfaces", NULL},
    .read = bond_based_read,
    .start = bond_based_start,
    .force = bond_based_force,
    .prepare = bond_based_prepare,
    .observe = bond_based_observe,
    .bond_energy = bond_based_bond_energy,
    .opening = opening_bond_based,
    .free = bond_based_free,
};
