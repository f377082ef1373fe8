#include "recorder.h"

#include "checkpoint.h"
#include "damping.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

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
                             const struct scene *scene, unsigned has)
{
    struct recorder recorder = {.has = has, .n_phases = has & NEEDS_GAUGE ? n_phases : 0};
    struct history *history = &recorder.history;
    const struct record empty = record_empty();
    int count;
    struct record_column *columns = record_columns(&empty, has, &count);
    const int most = count + gauge_mean_count * recorder.n_phases + scene->n_quantities;
    history->columns = memory_new((size_t)most, sizeof *history->columns);
    for (int i = 0; i < count; i++)
        add_column(history, column_title(columns[i].name, columns[i].unit));
    free(columns);
    for (int p = 0; p < recorder.n_phases; p++)
        for (int k = 0; k < gauge_mean_count; k++) {
            char *title = column_title(gauge_means[k].name, gauge_means[k].unit);
            add_column(history, memory_print("%s_%s", phase_names[p], title));
            free(title);
        }
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

/* more: what stands behind the columns of every history. */
static void add_record(struct recorder *recorder, const struct record *record, const double *more)
{
    int count;
    struct record_column *columns = record_columns(record, recorder->has, &count);
    double *values = new_record(recorder, record->integration->time);
    for (int i = 0; i < count; i++) values[i] = columns[i].value;
    for (int i = count; i < recorder->history.n_columns; i++) values[i] = more[i - count];
    free(columns);
}

void recorder_forget(struct recorder *recorder)
{
    if (recorder->history.n_records > 0) recorder->history.n_records--;
}

/* What the nodes say: of the gauge into the record and the means of phases, and the quantities. */
static void measure(const struct gauge *gauge, struct quantities *quantities, bool moving,
                    struct model *model, struct body *body, struct record *record, double *means,
                    double *wanted)
{
    const bool states = quantities_need_states(quantities);
    /* At rest the energies of bonds are tested after the record, of what is prepared here. */
    if (gauge || states || !moving) model_prepare(model, body, states ? 3 : 1);
    if (gauge) {
        record->planes = gauge_displacements(gauge, body);
        gauge_measure(gauge, model, body, means, &record->section);
    }
    quantities_measure(quantities, model, body, wanted);
}

double recorder_take(struct recorder *recorder, const struct gauge *gauge,
                     struct quantities *quantities, const struct integration *integration,
                     const struct boundary *boundary, struct model *model, struct body *body)
{
    struct record record = record_empty();
    const int n_means = gauge_mean_count * recorder->n_phases;
    double *means = memory_new((size_t)(n_means + quantities_count(quantities)), sizeof *means);
    record.integration = integration;
    record.body = body;
    if (boundary_has_grips(boundary)) {
        record.left = &boundary->sets[boundary->left];
        record.right = &boundary->sets[boundary->right];
        record.force_left = record.left->reaction;
        record.force_right = record.right->reaction;
    } else {
        record.force_right = boundary_load(boundary, body);
        record.force_left = -record.force_right;
    }
    measure(gauge, quantities, integration->moving, model, body, &record, means, means + n_means);
    if (integration->moving) record.unsteady = damping_unsteady_energy(integration, body, boundary);
    if (body->ranks.rank == 0) add_record(recorder, &record, means);
    free(means);
    return gauge ? (record.planes.right - record.planes.left) / gauge_length(gauge) : 0;
}

/* Rank 0 has them. */
void recorder_visit(struct recorder *recorder, struct checkpoint *checkpoint)
{
    struct history *history = &recorder->history;
    int64_t count = history->n_records;
    checkpoint_integer(checkpoint, "records", &count);
    ranks_share(&count, sizeof count);
    const int64_t columns = history->n_columns;
    double *time = memory_new((size_t)count + 1, sizeof *time),
           *values = memory_new((size_t)(count * columns) + 1, sizeof *values);
    for (int64_t i = 0; i < history->n_records; i++) {
        time[i] = history->time[i];
        memcpy(values + i * columns, history->values + i * columns,
               (size_t)columns * sizeof *values);
    }
    checkpoint_numbers(checkpoint, "times of the records", time, count);
    checkpoint_numbers(checkpoint, "records, column by column", values, count * columns);
    for (int64_t i = 0; checkpoint_reads(checkpoint) && i < count; i++)
        memcpy(new_record(recorder, time[i]), values + i * columns,
               (size_t)columns * sizeof *values);
    free(time);
    free(values);
}
