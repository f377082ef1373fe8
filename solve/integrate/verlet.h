/* verlet.h - explicit central differences (velocity Verlet).
 *
 *   v += dt/2 a;  u += dt v;  a = (f(u) + b)/rho - c (v - v_affine);  v += dt/2 a
 *
 * Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76 (1982) 637.  b are the loads.  Optional damping c acts on
 * the motion relative to the affine one between the grips, so that it does not drag the test itself.  Bonds
 * break where a step has led to: its second half already feels the force that is left. */
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
    double held; /* kinetic energy of nodes held in a motion that depends on place, J */
    struct energy_balance
        balance;           /* damping and work of all steps, the rest of the last that was asked */
    struct damage *damage; /* NULL: nothing breaks */
};

/* Starts from the displacements and velocities as set, those of the boundary taking their places; evaluates
 * the first force.  Collective. */
struct verlet verlet_new(double dt, double damping, const struct materials *materials,
                         struct body *body, struct boundary *boundary, struct model *model);
void verlet_free(struct verlet *verlet);

/* One step.  energies: the balance becomes that at its end; evaluating it costs, and changes no motion.
 * axial as in struct force_mode.  Collective. */
void verlet_step(struct verlet *verlet, struct body *body, struct boundary *boundary,
                 struct model *model, bool energies, double *axial);

/* Between steps: raises the stepped loads that are due.  True where one has been.  Collective. */
bool verlet_raise_loads(struct verlet *verlet, struct body *body, struct boundary *boundary,
                        bool equilibrium);

static inline void verlet_strip_density(const struct verlet *verlet, const struct body *body,
                                        const struct strip *strip, double inverse_density[LANES])
{
    for (int i = 0; i < strip->count; i++)
        inverse_density[i] = verlet->inverse_density[body->grid.phase[strip->site + i]];
}

static inline double verlet_node_mass(const struct verlet *verlet, const struct body *body,
                                      int64_t site)
{
    return body_volume(body, site) / verlet->inverse_density[body->grid.phase[site]];
}

#endif
