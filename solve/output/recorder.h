/* recorder.h - the history: one record of forces, energies and phase means after the other. */
#ifndef HS_RECORDER_H
#define HS_RECORDER_H

#include "exodus.h"
#include "quantities.h"
#include "record.h"

struct checkpoint;

struct recorder {
    unsigned has; /* what columns may need */
    int n_phases;
    struct history history; /* filled on rank 0 only */
};

/* Columns for what there is (NEEDS_GRIPS, NEEDS_GAUGE), and for the scene's quantities; the
 * attributes of the domain go along (rank 0; domain NULL elsewhere). */
struct recorder recorder_new(const struct domain *domain, int n_phases, char *const phase_names[],
                             const struct scene *scene, unsigned has);
void recorder_free(struct recorder *recorder);

/* Adds a record, to follow a force with mode.record.  Returns the gauge's nominal strain, 0 without
 * gauge (NULL). Collective. */
double recorder_take(struct recorder *recorder, const struct gauge *gauge,
                     struct quantities *quantities, const struct integration *integration,
                     const struct boundary *boundary, struct model *model, struct body *body);

/* All records.  Collective. */
void recorder_visit(struct recorder *recorder, struct checkpoint *checkpoint);

/* Takes the last record back. */
void recorder_forget(struct recorder *recorder);

#endif
