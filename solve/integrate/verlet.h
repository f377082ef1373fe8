/* verlet.h - explicit central differences (velocity Verlet).
 *
 *   v += dt/2 a;  u += dt v;  a = f(u)/rho - c (v - v_affine);  v += dt/2 a
 *
 * Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76 (1982) 637.  Optional damping c acts on the motion
 * relative to the affine one between the grips, so that it does not drag the test itself.  Bonds break where
 * a step has led to: its second half already feels the force that is left. */
#ifndef HS_VERLET_H
#define HS_VERLET_H

#include "boundary.h"
#include "damage.h"
#include "energy.h"
#include "model.h"

struct verlet {
    double dt, time;
    int64_t step;
    double damping;           /* 1/s */
    double *inverse_density;  /* [phases] m^3/kg */
    struct force_energy zero; /* empty sums with their extractors */
    struct exact_sum kinetic_zero;
    struct energy_balance balance;
    struct damage *damage; /* NULL: nothing breaks */
};

/* Starts from the body's u = 0, velocities as set; evaluates the first force. */
struct verlet verlet_new(double dt, double damping, const struct materials *materials,
                         struct body *body, struct boundary *boundary, struct model *model);
void verlet_free(struct verlet *verlet);

/* One step; the balance is that at its end.  axial as in struct force_mode.  Collective. */
void verlet_step(struct verlet *verlet, struct body *body, struct boundary *boundary,
                 struct model *model, double *axial);

/* Kinetic energy [J] of the motion beyond the uniform stretching that the grips impose: waves, and necks.
 * Collective. */
double verlet_unsteady_energy(const struct verlet *verlet, const struct body *body,
                              const struct boundary *boundary);

#endif
