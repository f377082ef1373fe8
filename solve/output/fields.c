#include "fields.h"

#include "exodus.h"
#include "memory.h"
#include "node_values.h"
#include "variable.h"

#include <stdlib.h>

struct fields {
    struct exodus_fields *file; /* rank 0 */
    int n_variables;
    struct node_component *variables;
    bool states;     /* some are observed */
    double **values; /* [n_variables][nodes] on rank 0 */
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
    fields->values = memory_new((size_t)count, sizeof *fields->values);
    for (int k = 0; k < count; k++) {
        names[k] = node_component_variable(fields->variables[k]);
        variable_set_unit(&domain->attributes, names[k], fields->variables[k].value.unit);
        fields->values[k] = memory_new((size_t)domain->n_nodes, sizeof(double));
    }
    fields->file = exodus_fields_open(output, domain, count, (const char *const *)names);
    for (int k = 0; k < count; k++) free(names[k]);
    free(names);
}

struct fields *fields_open(const struct spool *output, struct domain *domain,
                           const struct scene_fields *wanted, const struct body *body,
                           const struct damage *damage)
{
    struct fields *fields = memory_new(1, sizeof *fields);
    list_variables(fields, wanted);
    if (domain) open_file(fields, output, domain);
    fields->nodes = node_values_new(body, damage);
    return fields;
}

void fields_write(struct fields *fields, double time, struct model *model, struct body *body)
{
    if (fields->states) model_prepare(model, body, 3);
    for (int k = 0; k < fields->n_variables; k++)
        body_gather(body, node_values_field(fields->nodes, fields->variables[k], model, body),
                    fields->file ? fields->values[k] : NULL);
    if (fields->file)
        exodus_fields_write(fields->file, time, (const double *const *)fields->values);
}

int64_t fields_count(const struct fields *fields)
{
    return fields->file ? exodus_fields_count(fields->file) : 0;
}

bool fields_take(struct fields *fields, const char *name, int64_t frames)
{
    return exodus_fields_take(fields->file, name, frames);
}

void fields_close(struct fields *fields)
{
    if (fields->file) {
        exodus_fields_close(fields->file);
        for (int k = 0; k < fields->n_variables; k++) free(fields->values[k]);
        free(fields->values);
    }
    node_values_free(fields->nodes);
    free(fields->variables);
    free(fields);
}
