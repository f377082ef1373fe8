/* scene_body.h - a small body with what a deck's sections boundary and initial do to it. */
#ifndef HS_SCENE_BODY_H
#define HS_SCENE_BODY_H

#include "small_body.h"
#include "verlet.h"

struct scene_body {
    struct small_body small;
    struct deck *deck;
    struct domain domain;
    struct scene scene;
    struct boundary boundary;
    struct integration integration;
};

/* sections: "boundary: [...], initial: [...]"; a body of phase A whose node sets are none.  Its
 * address must stay. */
void scene_body_new(struct scene_body *it, const struct small_case *wanted, const char *sections,
                    double damping, double dt);
void scene_body_free(struct scene_body *it);

/* One step with its energies; then loads that are due are raised. */
void scene_body_step(struct scene_body *it);

#endif
