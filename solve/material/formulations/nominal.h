/* nominal.h - what is seen of nodes whose stress comes from bonds. */
#ifndef HS_NOMINAL_H
#define HS_NOMINAL_H

#include "material.h"
#include "model.h"

/* H from body->H, and Cauchy and nominal stress from P in body->S; of elastic materials in plane
 * strain stress zz is nu (xx + yy), which no bond carries, in plane stress H_zz is -nu/(1 - nu)
 * (H_xx + H_yy). */
void node_state_from_nominal(const struct body *body, const struct strip *strip,
                             const struct materials *materials, struct node_state *state);

#endif
