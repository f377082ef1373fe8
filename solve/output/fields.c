#include "fields.h"

#include "exodus.h"
#include "memory.h"
#include "node_values.h"

#include <stdlib.h>

enum { MOST_COMPONENTS = 6 };

/* One field of the deck: its components, and its Exodus variables in names that ParaView glues into
 * vectors. */
static const struct field {
    int first; /* enum node_value */
    int count;
    const char *components[MOST_COMPONENTS];
} table[] = {
    {DISPLACEMENT_X, 3, {"DisplacementX", "DisplacementY", "DisplacementZ"}},
    {VELOCITY_X, 3, {"VelocityX", "VelocityY", "VelocityZ"}},
    {FORCE_X, 3, {"ForceX", "ForceY", "ForceZ"}},
    {EXTERNAL_FORCE_X, 3, {"ExternalForceX", "ExternalForceY", "ExternalForceZ"}},
    {STRESS_XX, 6, {"StressXX", "StressYY", "StressZZ", "StressXY", "StressYZ", "StressZX"}},
    {VON_MISES, 1, {"VonMises"}},
    {PLASTIC_STRAIN, 1, {"EquivalentPlasticStrain"}},
    {PHASE, 1, {"Phase"}},
    {DAMAGE, 1, {"Damage"}},
};
const char *const field_names[] = {"displacement",
                                   "velocity",
                                   "force",
                                   "external_force",
                                   "stress",
                                   "von_mises",
                                   "equivalent_plastic_strain",
                                   "phase",
                                   "damage"};
const int field_count = sizeof field_names / sizeof *field_names;

struct fields {
    struct exodus_fields *file; /* rank 0 */
    struct scene_fields wanted;
    int n_variables;
    bool states;     /* some are the nodes' states */
    double **values; /* [n_variables][nodes] on rank 0 */
    struct node_values *nodes;
};

struct fields *fields_open(const struct spool *output, const struct domain *domain,
                           const struct scene_fields *wanted, const struct body *body,
                           const struct damage *damage)
{
    struct fields *fields = memory_new(1, sizeof *fields);
    const char **names = memory_new((size_t)wanted->n_variables * MOST_COMPONENTS, sizeof *names);
    fields->wanted = *wanted;
    for (int k = 0; k < wanted->n_variables; k++) {
        fields->states |= node_value_is_state(table[wanted->variables[k]].first);
        for (int c = 0; c < table[wanted->variables[k]].count; c++)
            names[fields->n_variables++] = table[wanted->variables[k]].components[c];
    }
    if (domain) {
        fields->file = exodus_fields_open(output, domain, fields->n_variables, names);
        fields->values = memory_new((size_t)fields->n_variables, sizeof *fields->values);
        for (int k = 0; k < fields->n_variables; k++)
            fields->values[k] = memory_new((size_t)domain->n_nodes, sizeof(double));
    }
    free(names);
    fields->nodes = node_values_new(body, damage);
    return fields;
}

void fields_write(struct fields *fields, double time, struct model *model, struct body *body)
{
    int variable = 0;
    if (fields->states) {
        model_prepare(model, body, 3);
        node_values_find(fields->nodes, model, body);
    }
    for (int k = 0; k < fields->wanted.n_variables; k++)
        for (int c = 0; c < table[fields->wanted.variables[k]].count; c++, variable++)
            body_gather(body,
                        node_values_field(fields->nodes,
                                          table[fields->wanted.variables[k]].first + c, body),
                        fields->file ? fields->values[variable] : NULL);
    if (fields->file)
        exodus_fields_write(fields->file, time, (const double *const *)fields->values);
}

void fields_close(struct fields *fields)
{
    if (fields->file) {
        exodus_fields_close(fields->file);
        for (int k = 0; k < fields->n_variables; k++) free(fields->values[k]);
        free(fields->values);
    }
    node_values_free(fields->nodes);
    free(fields);
}
