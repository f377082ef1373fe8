#include "recorder.h"

#include "broken.h"
#include "damping.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Columns of a tension test are there where the scene has what they measure. */
enum need { NOTHING, GRIPS, GAUGE };
static const struct {
    const char *name;
    enum need need;
} common[] = {
    {"force_left_N", GRIPS},
    {"force_right_N", GRIPS},
    {"extension_m", GAUGE},
    {"grip_extension_m", GRIPS},
    {"kinetic_energy_J", NOTHING},
    {"stored_energy_J", NOTHING},
    {"plastic_energy_J", NOTHING},
    {"stabilisation_energy_J", NOTHING},
    {"damping_energy_J", NOTHING},
    {"external_work_J", NOTHING},
    {"energy_drift", NOTHING},
    {"kinetic_to_internal", NOTHING},
    {"minimum_section_ratio", GAUGE},
    {"minimum_section_x_m", GAUGE},
    {"gauge_left_displacement_m", GAUGE},
    {"gauge_right_displacement_m", GAUGE},
    {"unsteady_to_internal", NOTHING},
    {"fracture_energy_J", NOTHING},
    {"broken_bonds", NOTHING},
    {"removed_nodes", NOTHING},
    {"nodes_without_gradient", NOTHING},
    {"quasi_static", NOTHING},
    {"residual", NOTHING},
    {"force_evaluations", NOTHING},
};
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

static bool has(const struct recorder *recorder, enum need need)
{
    return need == NOTHING || (need == GRIPS ? recorder->grips : recorder->gauge);
}

static void add_column(struct history *history, char *name)
{
    history->columns[history->n_columns++] = name;
}

static void add_quantity(struct history *history, const struct scene_quantity *quantity)
{
    for (int i = 0; i < history->n_columns; i++)
        if (strcmp(history->columns[i], quantity->name) == 0)
            deck_error(deck_get(quantity->where, "name"), "the history has a column '%s' already",
                       quantity->name);
    add_column(history, memory_text(quantity->name));
}

struct recorder recorder_new(const struct domain *domain, int n_phases, char *const phase_names[],
                             const struct scene *scene, bool grips, bool gauge)
{
    struct recorder recorder = {.grips = grips, .gauge = gauge, .n_phases = n_phases};
    struct history *history = &recorder.history;
    const int most = COMMON + PER_PHASE * n_phases + scene->n_quantities;
    history->columns = memory_new((size_t)most, sizeof *history->columns);
    for (int i = 0; i < COMMON; i++)
        if (has(&recorder, common[i].need)) add_column(history, memory_text(common[i].name));
    for (int p = 0; gauge && p < n_phases; p++)
        for (int k = 0; k < PER_PHASE; k++)
            add_column(history, memory_print("%s_%s", phase_names[p], per_phase[k]));
    for (int q = 0; q < scene->n_quantities; q++) add_quantity(history, &scene->quantities[q]);
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
    history->time = memory_grow(history->time, history->n_records, sizeof *history->time);
    history->values = memory_grow(history->values, history->n_records, columns * sizeof(double));
    history->time[history->n_records] = time;
    return history->values + (size_t)history->n_records++ * columns;
}

void recorder_forget(struct recorder *recorder)
{
    if (recorder->history.n_records > 0) recorder->history.n_records--;
}

/* Nodes without a deformation gradient: from the start, or since their bonds broke. */
static double body_unsupported(const struct body *body)
{
    return (double)body->unsupported + (body->broken ? body->broken->n_lost : 0);
}

/* The columns that are there whatever the phases; those that are not measured are passed over. */
static double *put_common(const struct recorder *recorder, const double values[COMMON],
                          double *record)
{
    for (int i = 0; i < COMMON; i++)
        if (has(recorder, common[i].need)) *record++ = values[i];
    return record;
}

static double *put_phases(const struct recorder *recorder, const struct gauge_phase *phases,
                          double *record)
{
    for (int p = 0; recorder->gauge && p < recorder->n_phases; p++) {
        *record++ = phases[p].stress;
        *record++ = phases[p].true_stress;
        *record++ = phases[p].strain;
        *record++ = phases[p].plastic_strain;
    }
    return record;
}

double recorder_take(struct recorder *recorder, const struct gauge *gauge,
                     struct quantities *quantities, const struct integration *integration,
                     const struct boundary *boundary, struct model *model, struct body *body)
{
    static const struct boundary_set nothing;
    const bool grips = boundary_has_grips(boundary);
    const struct boundary_set *left = grips ? &boundary->sets[boundary->left] : &nothing,
                              *right = grips ? &boundary->sets[boundary->right] : &nothing;
    struct gauge_section section = {0};
    struct gauge_planes planes = {0};
    struct gauge_phase *phases = memory_new((size_t)recorder->n_phases, sizeof *phases);
    double *wanted = memory_new((size_t)quantities_count(quantities), sizeof *wanted);
    if (gauge) planes = gauge_displacements(gauge, body);
    /* At rest the energies of bonds are tested after the record, of what it has prepared. */
    const bool states = quantities_need_states(quantities);
    if (gauge || states || !integration->moving) model_prepare(model, body, states ? 3 : 1);
    if (gauge) gauge_measure(gauge, model, body, phases, &section);
    quantities_measure(quantities, model, body, wanted);
    const double unsteady =
        integration->moving ? damping_unsteady_energy(integration, body, boundary) : 0;
    const double extension = planes.right - planes.left;
    if (body->ranks.rank == 0) {
        const struct energy_balance *b = &integration->balance;
        const double internal = energy_internal(b), per_internal = internal > 0 ? 1 / internal : 0;
        const double values[COMMON] = {
            left->total_force,
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
            integration->damage ? damage_broken_bonds(integration->damage) : 0,
            integration->damage ? damage_removed_nodes(integration->damage) : 0,
            body_unsupported(body),
            integration->moving ? 0 : 1,
            integration->residual,
            (double)integration->evaluations};
        double *record = put_common(recorder, values, new_record(recorder, integration->time));
        record = put_phases(recorder, phases, record);
        for (int q = 0; q < quantities_count(quantities); q++) *record++ = wanted[q];
    }
    free(phases);
    free(wanted);
    return gauge ? extension / gauge_length(gauge) : 0;
}
