/* critical_stretch.c - (critical_stretch.1): a bond breaks beyond a stretch s = (|y| - |xi|)/|xi| (Silling, Askari, Computers &
 * Structures 83 (2005) 1526); from a fracture energy G by s = sqrt(G/a), (opening.1) and (opening.2). */
#include "damage.h"
#include "simd.h"

#include <math.h>

/* room = s_c |xi| - (|y| - |xi|); |y| - |xi| as in (bond_based.1), exact for small displacements. */
HS_INLINE void stretch_room(int count, const double *const u[3], const double *const v[3],
                            const struct bond_view *bond, int g, const double *value, double *room)
{
    const double *ux = u[0], *uy = u[1], *uz = u[2], *vx = v[0], *vy = v[1], *vz = v[2];
    const double *X = bond->xi[0], *Y = bond->xi[1], *Z = bond->xi[2], *L = bond->length;
#pragma omp simd
    for (int k = 0; k < count; k++) {
        double x = X[k * g], y = Y[k * g], z = Z[k * g], length = L[k * g];
        double a = vx[k] - ux[k], b = vy[k] - uy[k], d = vz[k] - uz[k];
        double longer = (2 * x + a) * a + (2 * y + b) * b + (2 * z + d) * d;
        double now = sqrt((x + a) * (x + a) + (y + b) * (y + b) + (z + d) * (z + d));
        room[k] = value[k] * length - longer / (now + length);
    }
}

HS_SIMD static void room_alike(int count, const double *const u[3], const double *const v[3],
                               const struct bond_view *bond, const double *value, double *room)
{
    stretch_room(count, u, v, bond, 0, value, room);
}

HS_SIMD static void room_scattered(int count, const double *const u[3], const double *const v[3],
                                   const struct bond_view *bond, const double *value, double *room)
{
    stretch_room(count, u, v, bond, 1, value, room);
}

static void room(const struct damage_view *see, const struct bond_strip *strip,
                 const struct bond_view *bond, const double *value, double *out)
{
    (void)strip;
    double buffer[6][BOND_LANES];
    const double *u[3], *v[3];
    for (int a = 0; a < 3; a++) {
        u[a] = bond_gather(bond, false, see->body->u[a], buffer[a]);
        v[a] = bond_gather(bond, true, see->body->u[a], buffer[3 + a]);
    }
    (bond->geometry_step ? room_scattered : room_alike)(bond->count, u, v, bond, value, out);
}

static double from_fracture_energy(const struct damage_view *see, int a, int b, double energy,
                                   struct deck_node where)
{
    const struct formulation *formulation = see->materials->formulation;
    double sum = 0;
    const int phases[2] = {a, b};
    if (!formulation->opening)
        deck_error(
            where,
            "%s materials have no formula for the stretch of a fracture energy: their stress "
            "comes from nodes, not from bonds; give 'value'",
            formulation->name);
    for (int k = 0; k < 2; k++)
        sum += 0.5 * formulation->opening(&see->materials->items[phases[k]], see->materials->plane,
                                          see->body->family, see->body->lattice);
    return sqrt(energy / sum);
}

static const struct key keys[] = {{"value", KEY_NUMBER, 0, "1", 1e-12, 10,
                                   .otherwise = "by fracture_energy",
                                   .help = "(length - length at rest)/(length at rest)"}};

const struct damage_law damage_critical_stretch = {
    .words = {"critical_stretch", "A bond breaks beyond a stretch.", KEYS(keys)},
    .size = sizeof(double),
    .room = room,
    .from_fracture_energy = from_fracture_energy,
};
