/* bond_loop.h - what one bond does, done to all bonds of a strip.
 *
 * A material writes what one bond gives to its ends, as an inline function of struct bond;
 * BOND_KERNELS makes loops of it, and bond_run lays the fields of the ends before them.  Why it is
 * laid out like this:
 *
 * A root and a division a bond set the pace, so that all else has to be out of their way, and each
 * bond is visited once, for both its ends.  On a lattice the bonds of a strip share their offset:
 * their lower ends lie on end in memory, their upper ones as well, and a kernel reads and writes
 * the fields themselves, vector by vector.  Bonds that are alike have their geometry and weight in
 * registers, which takes a fifth off the time of those with an array of weights, as a surface
 * correction or a break makes them.  Between scattered particles there are arrays of everything,
 * ends are gathered before and scattered after.  These are the three variants; they give the same
 * bits for the same numbers, so that a strip may be alike on one rank and weighted on another.
 *
 * What a strip adds must not meet itself.  Its lower ends are always apart on a lattice; so are its
 * upper ones, unless the offset runs along x: then they are the lower ends of others in the strip,
 * and what they get takes a detour through a buffer, to be added after the loop.
 *
 * Strip follows strip in an order that the whole body fixes, lower ends come before upper ones, and
 * no vector sums up within itself: the terms of a node are added in the same order on any number of
 * ranks and at any width of vectors. */
#ifndef HS_BOND_LOOP_H
#define HS_BOND_LOOP_H

#include "bonds.h"

#include <math.h>

enum { BOND_NODE_FIELDS = 4, BOND_SUMS = 3, BOND_GIVEN = 4, BOND_EACH = 6 };

/* A strip as a kernel sees it: arrays of its first bond, or of one number for all bonds where they
 * are alike.  [0]: lower, [1]: upper ends.  What follows volume is the kernel's own. */
struct bond_pass {
    int count;
    const double *u[2][3], *xi[3], *length, *weight, *volume[2];
    const double *node[2][BOND_NODE_FIELDS]; /* fields of the nodes that it reads */
    double *sum[2][BOND_SUMS];               /* those it adds to */
    const double *given[BOND_GIVEN];         /* numbers of each bond that it reads */
    double *each[BOND_EACH];                 /* those it writes */
    double number;                           /* one for all */
};

/* One bond from node i, its lower end, to j. */
struct bond {
    double xi_x, xi_y, xi_z, length; /* X_j - X_i, its length [m] */
    double x, y, z;                  /* now [m] */
    double longer; /* |y|^2 - |xi|^2, exact to round-off for small displacements, too [m^2] */
    double weight, volume_i, volume_j; /* of the bond; of its ends [m^3] */
};

typedef void bond_kernel(const struct bond_pass *);
enum { BONDS_ALIKE, BONDS_WEIGHTED, BONDS_SCATTERED, BOND_VARIANTS };

/* The first bond at rest. */
HS_INLINE struct bond bond_first(const struct bond_pass *p)
{
    return (struct bond){.xi_x = *p->xi[0],
                         .xi_y = *p->xi[1],
                         .xi_z = *p->xi[2],
                         .length = *p->length,
                         .weight = *p->weight,
                         .volume_i = *p->volume[1], /* one volume of all nodes: one register */
                         .volume_j = *p->volume[1]};
}

/* Bond k, which has its own geometry where g, its own weight where w, else those of the first. */
HS_INLINE struct bond bond_at(const struct bond_pass *p, struct bond first, int k, bool g, bool w)
{
    struct bond b = first;
    if (g) {
        b.xi_x = p->xi[0][k];
        b.xi_y = p->xi[1][k];
        b.xi_z = p->xi[2][k];
        b.length = p->length[k];
        b.volume_i = p->volume[0][k];
        b.volume_j = p->volume[1][k];
    }
    if (w) b.weight = p->weight[k];
    const double a = p->u[1][0][k] - p->u[0][0][k], c = p->u[1][1][k] - p->u[0][1][k],
                 d = p->u[1][2][k] - p->u[0][2][k];
    b.longer = (2 * b.xi_x + a) * a + (2 * b.xi_y + c) * c + (2 * b.xi_z + d) * d;
    b.x = b.xi_x + a;
    b.y = b.xi_y + c;
    b.z = b.xi_z + d;
    return b;
}

/* |y| - |xi| [m] */
HS_INLINE double bond_extension(struct bond b)
{
    return b.longer / (sqrt(b.x * b.x + b.y * b.y + b.z * b.z) + b.length);
}

/* Force densities over |y|: i along the bond at the lower end, j against it at the upper one. */
HS_INLINE void bond_push(const struct bond_pass *p, int k, struct bond b, double i, double j)
{
    p->sum[0][0][k] += i * b.x;
    p->sum[0][1][k] += i * b.y;
    p->sum[0][2][k] += i * b.z;
    p->sum[1][0][k] -= j * b.x;
    p->sum[1][1][k] -= j * b.y;
    p->sum[1][2][k] -= j * b.z;
}

/* Pointers and the first bond are copied before the loop, so that no store of it can change them.
 */
#define BOND_KERNEL(name, g, w, call)                                                              \
    HS_SIMD static void name(const struct bond_pass *pass)                                         \
    {                                                                                              \
        const struct bond_pass copy = *pass, *const p = &copy;                                     \
        const struct bond first = bond_first(pass);                                                \
        const int count = copy.count;                                                              \
        _Pragma("omp simd") for (int k = 0; k < count; k++)                                        \
        {                                                                                          \
            const struct bond b = bond_at(p, first, k, g, w);                                      \
            call;                                                                                  \
        }                                                                                          \
    }

/* name[BOND_VARIANTS] of a call of an inline function, with the pass p, the bond's number k, and
 * the bond b. */
#define BOND_KERNELS(name, call)                                                                   \
    BOND_KERNEL(name##_alike, false, false, call)                                                  \
    BOND_KERNEL(name##_weighted, false, true, call)                                                \
    BOND_KERNEL(name##_scattered, true, true, call)                                                \
    static bond_kernel *const name[] = {name##_alike, name##_weighted, name##_scattered};

/* Box fields that a kernel reads and adds to. */
struct bond_fields {
    int nodes, sums;
    double *const *node, *const *sum;
};

/* The displacements at the upper ends, for the kernel to read, become moved: by the mean gradient
 * of a periodic body over xi.  By xi, not by where the ends are, so that a bond and its images have
 * the same bits. */
void bond_move_apart(const struct bond_view *view, const struct body *body, struct bond_pass *pass,
                     double *const moved[3]);

/* bond_run between scattered particles. */
void bond_run_scattered(bond_kernel *kernel, const struct bonds *bonds,
                        const struct bond_strip *strip, struct bond_fields fields,
                        struct bond_pass *pass);

/* Where the offset of a lattice strip runs along x, what a kernel adds to fields at the upper ends
 * takes a detour: through the cleared buffers, which become the targets, and then to the fields
 * from the site j on. */
HS_INLINE void bond_detour(int fields, double buffer[][BOND_LANES], int count, double *target[])
{
    for (int a = 0; a < fields; a++)
        target[a] = memset(buffer[a], 0, (size_t)count * sizeof **target);
}
HS_INLINE void bond_detour_end(int fields, double buffer[][BOND_LANES], int count,
                               double *const field[], int64_t j)
{
    for (int a = 0; a < fields; a++) {
        double *first = field[a] + j;
        for (int k = 0; k < count; k++) first[k] += buffer[a][k];
    }
}

/* Runs a kernel over a strip, whose own numbers are in pass.  Inlined, so that on a lattice nothing
 * is left of it but addresses: behind a call, with a view of each strip, lines of 40 bonds took 16
 * to 28 % longer. */
HS_INLINE void bond_run(bond_kernel *const kernel[BOND_VARIANTS], const struct bonds *bonds,
                        const struct bond_strip *strip, struct bond_fields fields,
                        struct bond_pass *pass)
{
    if (strip->offset < 0) {
        bond_run_scattered(kernel[BONDS_SCATTERED], bonds, strip, fields, pass);
        return;
    }
    const struct bond_geometry *g = &bonds->geometry[strip->offset];
    const int64_t i = strip->i, j = i + g->shift;
    double buffer[BOND_SUMS][BOND_LANES], moved[3][BOND_LANES];
    pass->count = strip->count;
    pass->length = &g->length;
    pass->weight = strip->weight ? strip->weight : &g->weight;
    pass->volume[0] = pass->volume[1] = bonds->volume;
    for (int a = 0; a < 3; a++) {
        pass->xi[a] = &g->xi[a];
        pass->u[0][a] = bonds->body->u[a] + i;
        pass->u[1][a] = bonds->body->u[a] + j;
    }
    for (int a = 0; a < fields.nodes; a++) {
        pass->node[0][a] = fields.node[a] + i;
        pass->node[1][a] = fields.node[a] + j;
    }
    for (int a = 0; a < fields.sums; a++) {
        pass->sum[0][a] = fields.sum[a] + i;
        pass->sum[1][a] = fields.sum[a] + j;
    }
    if (lattice_is_periodic(bonds->body->lattice)) {
        const struct bond_view view = bonds_view(bonds, strip);
        bond_move_apart(&view, bonds->body, pass, (double *const[]){moved[0], moved[1], moved[2]});
    }
    if (!g->apart) bond_detour(fields.sums, buffer, strip->count, pass->sum[1]);
    kernel[strip->weight ? BONDS_WEIGHTED : BONDS_ALIKE](pass);
    if (!g->apart) bond_detour_end(fields.sums, buffer, strip->count, fields.sum, j);
}

#endif
