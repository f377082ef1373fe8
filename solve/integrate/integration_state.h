/* integration_state.h - where a body is in time, and where the energy has gone: what all
 * integrators share. */
#ifndef HS_INTEGRATION_STATE_H
#define HS_INTEGRATION_STATE_H

#include "boundary.h"
#include "damage.h"
#include "energy.h"
#include "model.h"

/* What one rank may wish for all of them, who have to agree: it goes with the message that each
 * step sends anyway. */
enum wish { WISH_STOP, WISH_CHECKPOINT, WISHES };

struct integration {
    bool moving;                       /* with inertia */
    double dt, time;                   /* of the steps from here on; s */
    double force_time, committed_time; /* of the next force, of the last with mode.commit; s */
    int64_t step;
    int64_t evaluations;      /* of the force so far */
    double residual;          /* of the last equilibrium, relative; 0 after an explicit step */
    double damping;           /* 1/s */
    double local_damping;     /* share of the force on a node */
    double *inverse_density;  /* [phases] m^3/kg */
    struct force_energy zero; /* empty sums with their extractors */
    struct exact_sum kinetic_zero;
    double held; /* kinetic energy of nodes held in a motion that depends on place, J */
    struct energy_balance balance; /* damping and work of all steps; energies as last asked for */
    struct damage *damage;         /* NULL: nothing breaks */
    double wish[WISHES], granted[WISHES]; /* over 0: of this rank; of any, as of the last step */
};

/* model_force, counted, with the times of mode. */
void integration_force(struct integration *integration, struct model *model, struct body *body,
                       struct force_mode mode, struct force_energy *energy);

/* stored + plastic + stabilisation of the sums that a force has filled [J].  Collective. */
double integration_internal_energy(const struct force_energy *energy);

static inline double integration_inverse_density(const struct integration *integration,
                                                 const struct body *body, int64_t site)
{
    return body->densities ? 1 / body->densities[site]
                           : integration->inverse_density[body->grid.phase[site]];
}

static inline void integration_strip_density(const struct integration *integration,
                                             const struct body *body, const struct strip *strip,
                                             double inverse_density[LANES])
{
    for (int i = 0; i < strip->count; i++)
        inverse_density[i] = integration_inverse_density(integration, body, strip->site + i);
}

static inline double integration_node_mass(const struct integration *integration,
                                           const struct body *body, int64_t site)
{
    return body_volume(body, site) / integration_inverse_density(integration, body, site);
}

#endif
