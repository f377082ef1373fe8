#include "fields.h"

#include "exodus.h"
#include "memory.h"
#include "node_values.h"
#include "variable.h"

#include <stdlib.h>

struct fields {
    struct exodus_fields *file;
    int n_variables;
    struct node_component *variables;
    bool states;    /* some are observed */
    int64_t *first; /* [owned strips] number of a strip's first particle in the file */
    struct node_values *nodes;
};

static void list_variables(struct fields *fields, const struct scene_fields *wanted)
{
    const size_t most = (size_t)wanted->n_variables * NODE_COMPONENTS;
    fields->variables = memory_new(most, sizeof *fields->variables);
    for (int k = 0; k < wanted->n_variables; k++) {
        const struct node_value value = node_value(wanted->variables[k]);
        fields->states |= value.observe != NULL;
        for (int c = 0; c < value.components; c++)
            fields->variables[fields->n_variables++] = (struct node_component){value, c};
    }
}

/* A file of frames on rank 0, which says the units of what it holds. */
static void open_file(struct fields *fields, const struct spool *output, struct domain *domain)
{
    const int count = fields->n_variables;
    char **names = memory_new((size_t)count, sizeof *names);
    for (int k = 0; k < count; k++) {
        names[k] = node_component_variable(fields->variables[k]);
        variable_set_unit(&domain->attributes, names[k], fields->variables[k].value.unit);
    }
    fields->file = exodus_fields_open(output, domain, count, (const char *const *)names);
    for (int k = 0; k < count; k++) free(names[k]);
    free(names);
}

/* Particles before each strip; strips are in the order of sites, as particles in the file. */
static int64_t *number_strips(const struct body *body)
{
    int64_t *first = memory_new((size_t)body->owned.count, sizeof *first), site = 0, number = 0;
    for (int64_t s = 0; s < body->owned.count; s++) {
        const int64_t next = body_number(body, body->owned.items[s].site);
        for (; site < next; site++) number += body->lattice->phase[site] != ABSENT;
        first[s] = number;
    }
    return first;
}

struct fields *fields_open(const struct spool *output, struct domain *domain,
                           const struct scene_fields *wanted, const struct body *body,
                           const struct damage *damage)
{
    struct fields *fields = memory_new(1, sizeof *fields);
    struct exodus_layout layout = {0};
    list_variables(fields, wanted);
    if (domain) {
        open_file(fields, output, domain);
        layout = *exodus_fields_layout(fields->file);
    }
    ranks_share(&layout, sizeof layout);
    if (!domain) fields->file = exodus_fields_join(&layout);
    fields->first = number_strips(body);
    fields->nodes = node_values_new(body, damage);
    return fields;
}

static void put(const struct fields *fields, int64_t frame, int variable, const struct body *body,
                const double *field)
{
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        int64_t number = fields->first[s];
        for (int64_t site = strip->site; site < strip->site + strip->count; site++)
            if (body->grid.phase[site] != ABSENT)
                exodus_fields_put(fields->file, frame, variable, number++, 1, &field[site]);
    }
}

/* Where a rank's numbers have not reached the disk, rank 0 tells it, keeps what is good, and ends
 * all. */
static void end_frame(struct fields *fields, double time, struct ranks ranks)
{
    double failure = -exodus_fields_sync(fields->file);
    ranks_minimum(&failure, 1);
    if (ranks.rank == 0) exodus_fields_end(fields->file, time, (int)-failure);
}

void fields_write(struct fields *fields, double time, struct model *model, struct body *body)
{
    int64_t frame = fields_count(fields); /* rank 0 knows: after a restart it has some */
    ranks_share(&frame, sizeof frame);
    if (fields->states) model_prepare(model, body, 3);
    for (int k = 0; k < fields->n_variables; k++)
        put(fields, frame, k, body,
            node_values_field(fields->nodes, fields->variables[k], model, body));
    end_frame(fields, time, body->ranks);
}

int64_t fields_count(const struct fields *fields)
{
    return exodus_fields_count(fields->file);
}

bool fields_take(struct fields *fields, const char *name, int64_t frames)
{
    return exodus_fields_take(fields->file, name, frames);
}

void fields_close(struct fields *fields)
{
    exodus_fields_close(fields->file);
    node_values_free(fields->nodes);
    free(fields->first);
    free(fields->variables);
    free(fields);
}
