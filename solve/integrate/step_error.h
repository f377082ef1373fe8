/* step_error.h - how far load steps have left the path, by the forces on the sets that move.
 *
 * Within a step the return to the yield surface knows the strain at its end alone, so that
 * directions of flow that turn are met late; the error of a step is of the second order in its
 * length, the sum of the first.  What a step did not do as the one before it, a predictor against
 * the corrector, is its measure:
 *
 *   D = |F' - F - (w'.w/w.w) dF|,  local error = (D - r |F'|/5)/24                   (step_error.1)
 *   e' = e exp(-|w'|/L) + local,  L = 9 max(|F|, 0.3 max |F|)/max |dF|/|w|           (step_error.2)
 *
 * r: tolerance of the residual; F: reactions of the sets, dF and w: their change and the ways of
 * the sets in the last step, or, where the motion turns back, in the stiffest one.  Flow forgets
 * where it came from in some elastic strains, L.  A step that is so short that it is not
 * refused counts as the most that it was allowed: a yield within it is a kink that D takes for an
 * error.  Where the forces fall along the way, strain gathers, and errors grow that e knows nothing
 * of.  The 24, the 9 and the 5 are measured, not derived (docs/errors.md, load steps). */
#ifndef HS_STEP_ERROR_H
#define HS_STEP_ERROR_H

#include "boundary.h"

struct checkpoint;

struct step_error {
    double accuracy; /* of the forces, relative to the largest so far; 0: no step is refused */
    double breaking; /* the same, of steps in which bonds break */
    int count;       /* of sets */
    double *force, *now, *change, *way; /* [count] N at start and end; N and m in the last step */
    double *stiffest, *stiffest_way;    /* [count] change and way of the stiffest step, N, m */
    bool started, predicts;             /* force is known; change and way are */
    bool falls;                         /* the work of the change by the way is negative */
    double largest, steepest;           /* |F| [N], |dF|/|w| [N/m] so far */
    double error, local;                /* e, and the part of this step [N] */
};

struct step_error step_error_new(double accuracy, double breaking, const struct boundary *boundary);
void step_error_free(struct step_error *error);

/* The forces at the start of a step, where they are not those at the end of the last one.
 * Collective. */
void step_error_start(struct step_error *error, const struct boundary *boundary,
                      const struct body *body);
/* Measures the step that has come to rest to this tolerance of the residual, with the sets' ways;
 * largest share of its length that would have been allowed: below 1 it is too long; INFINITY where
 * nothing is known.  Collective. */
double step_error_room(struct step_error *error, const struct boundary *boundary,
                       const struct body *body, double tolerance);
/* The same of a step at whose end bonds break, after step_error_room: what they bear is known as
 * well as the forces at which they do. */
double step_error_breaking_room(const struct step_error *error);
/* The step counts; room for one after it of the same length, as above. */
double step_error_take(struct step_error *error, const struct boundary *boundary);
/* Something else than the sets' motion has changed the forces. */
void step_error_forget(struct step_error *error);

/* Collective. */
void step_error_visit(struct step_error *error, struct checkpoint *checkpoint);

#endif
