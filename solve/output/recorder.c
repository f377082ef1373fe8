#include "recorder.h"

#include "broken.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

static const char *const common[] = {"force_left_N",
                                     "force_right_N",
                                     "extension_m",
                                     "grip_extension_m",
                                     "kinetic_energy_J",
                                     "stored_energy_J",
                                     "plastic_energy_J",
                                     "stabilisation_energy_J",
                                     "damping_energy_J",
                                     "external_work_J",
                                     "energy_drift",
                                     "kinetic_to_internal",
                                     "minimum_section_ratio",
                                     "minimum_section_x_m",
                                     "gauge_left_displacement_m",
                                     "gauge_right_displacement_m",
                                     "unsteady_to_internal",
                                     "fracture_energy_J",
                                     "broken_bonds",
                                     "nodes_without_gradient"};
static const char *const per_phase[] = {"stress_Pa", "true_stress_Pa", "strain", "plastic_strain"};
enum { COMMON = sizeof common / sizeof *common, PER_PHASE = sizeof per_phase / sizeof *per_phase };

static void copy_attributes(struct attributes *to, const struct attributes *from)
{
    for (int i = 0; i < from->count; i++) {
        const struct attribute *item = &from->items[i];
        if (item->text)
            attributes_set_text(to, item->name, item->text);
        else
            attributes_set_number(to, item->name, item->number);
    }
}

struct recorder recorder_new(const struct domain *domain, int n_phases, char *const phase_names[])
{
    struct recorder recorder = {.n_phases = n_phases};
    struct history *history = &recorder.history;
    history->n_columns = COMMON + PER_PHASE * n_phases;
    history->columns = memory_new((size_t)history->n_columns, sizeof *history->columns);
    for (int i = 0; i < COMMON; i++) history->columns[i] = memory_text(common[i]);
    for (int p = 0; p < n_phases; p++)
        for (int k = 0; k < PER_PHASE; k++)
            history->columns[COMMON + p * PER_PHASE + k] =
                memory_print("%s_%s", phase_names[p], per_phase[k]);
    if (domain) copy_attributes(&history->attributes, &domain->attributes);
    return recorder;
}

void recorder_free(struct recorder *recorder)
{
    history_free(&recorder->history);
    *recorder = (struct recorder){0};
}

static double *new_record(struct recorder *recorder, double time)
{
    struct history *history = &recorder->history;
    const size_t columns = (size_t)history->n_columns;
    if (history->n_records == recorder->room) {
        recorder->room = 2 * recorder->room + 64;
        double *times = memory_new((size_t)recorder->room, sizeof *times);
        double *values = memory_new((size_t)recorder->room * columns, sizeof *values);
        if (history->n_records > 0) {
            memcpy(times, history->time, (size_t)history->n_records * sizeof *times);
            memcpy(values, history->values, (size_t)history->n_records * columns * sizeof *values);
        }
        free(history->time);
        free(history->values);
        history->time = times;
        history->values = values;
    }
    history->time[history->n_records] = time;
    return history->values + (size_t)history->n_records++ * columns;
}

/* Nodes without a deformation gradient: from the start, or since their bonds broke. */
static double body_unsupported(const struct body *body)
{
    return (double)body->unsupported + (body->broken ? body->broken->n_lost : 0);
}

double recorder_take(struct recorder *recorder, const struct gauge *gauge,
                     const struct verlet *verlet, const struct boundary *boundary,
                     struct model *model, struct body *body, double *axial)
{
    struct gauge_section section;
    struct gauge_phase *phases = memory_new((size_t)recorder->n_phases, sizeof *phases);
    const struct gauge_planes planes = gauge_displacements(gauge, body);
    const double extension = planes.right - planes.left;
    model_prepare(model, body, axial);
    gauge_measure(gauge, model, body, axial, phases, &section);
    const double unsteady = verlet_unsteady_energy(verlet, body, boundary);
    if (body->ranks.rank == 0) {
        const struct energy_balance *b = &verlet->balance;
        const double internal = energy_internal(b), per_internal = internal > 0 ? 1 / internal : 0;
        const struct boundary_set *left = &boundary->sets[boundary->left],
                                  *right = &boundary->sets[boundary->right];
        const double values[COMMON] = {left->total_force,
                                       right->total_force,
                                       extension,
                                       right->moved - left->moved,
                                       b->kinetic,
                                       b->stored,
                                       b->plastic,
                                       b->stabilisation,
                                       b->damping,
                                       b->work,
                                       energy_drift(b),
                                       b->kinetic * per_internal,
                                       section.ratio,
                                       section.x,
                                       planes.left,
                                       planes.right,
                                       unsteady * per_internal,
                                       b->fracture,
                                       verlet->damage ? damage_broken_bonds(verlet->damage) : 0,
                                       body_unsupported(body)};
        double *record = new_record(recorder, verlet->time);
        memcpy(record, values, sizeof values);
        for (int p = 0; p < recorder->n_phases; p++) {
            double *phase = record + COMMON + p * PER_PHASE;
            phase[0] = phases[p].stress;
            phase[1] = phases[p].true_stress;
            phase[2] = phases[p].strain;
            phase[3] = phases[p].plastic_strain;
        }
    }
    free(phases);
    return extension / gauge_length(gauge);
}
