#include "fields.h"

#include "exodus.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COMPONENTS = 6 };

/* Where a field's numbers come from. */
enum source { BODY_FIELD, NODE_STRESS, VON_MISES, PLASTIC_STRAIN, PHASE, DAMAGE };

/* One field of the deck: its Exodus variables, in names that ParaView glues into vectors. */
static const struct field {
    enum source source;
    int count;
    const char *components[MOST_COMPONENTS];
} table[] = {
    {BODY_FIELD, 3, {"DisplacementX", "DisplacementY", "DisplacementZ"}},
    {BODY_FIELD, 3, {"VelocityX", "VelocityY", "VelocityZ"}},
    {BODY_FIELD, 3, {"ForceX", "ForceY", "ForceZ"}},
    {NODE_STRESS, 6, {"StressXX", "StressYY", "StressZZ", "StressXY", "StressYZ", "StressZX"}},
    {VON_MISES, 1, {"VonMises"}},
    {PLASTIC_STRAIN, 1, {"EquivalentPlasticStrain"}},
    {PHASE, 1, {"Phase"}},
    {DAMAGE, 1, {"Damage"}},
};
const char *const field_names[] = {"displacement", "velocity",  "force",
                                   "stress",       "von_mises", "equivalent_plastic_strain",
                                   "phase",        "damage"};
const int field_count = sizeof field_names / sizeof *field_names;

struct fields {
    struct exodus_fields *file; /* rank 0 */
    struct scene_fields wanted;
    const struct damage *damage;
    int n_variables;
    double **values;                                    /* [n_variables][nodes] on rank 0 */
    double *stress[MOST_COMPONENTS], *plastic, *scalar; /* box fields to gather from */
};

struct fields *fields_open(const struct spool *output, const struct domain *domain,
                           const struct scene_fields *wanted, const struct body *body,
                           const struct damage *damage)
{
    struct fields *fields = memory_new(1, sizeof *fields);
    const char **names = memory_new((size_t)wanted->n_variables * MOST_COMPONENTS, sizeof *names);
    fields->wanted = *wanted;
    fields->damage = damage;
    for (int k = 0; k < wanted->n_variables; k++)
        for (int c = 0; c < table[wanted->variables[k]].count; c++)
            names[fields->n_variables++] = table[wanted->variables[k]].components[c];
    if (domain) {
        fields->file = exodus_fields_open(output, domain, fields->n_variables, names);
        fields->values = memory_new((size_t)fields->n_variables, sizeof *fields->values);
        for (int k = 0; k < fields->n_variables; k++)
            fields->values[k] = memory_new((size_t)domain->n_nodes, sizeof(double));
    }
    free(names);
    for (int k = 0; k < MOST_COMPONENTS; k++)
        fields->stress[k] = memory_new((size_t)body->grid.n_sites, sizeof(double));
    fields->plastic = memory_new((size_t)body->grid.n_sites, sizeof(double));
    fields->scalar = memory_new((size_t)body->grid.n_sites, sizeof(double));
    return fields;
}

static void find_node_values(struct fields *fields, struct model *model, struct body *body)
{
    model_prepare(model, body, NULL);
    const struct strips *strips = model_strips(model, body);
    for (int64_t s = 0; s < strips->count; s++) {
        const struct strip *strip = &strips->items[s];
        const size_t bytes = (size_t)strip->count * sizeof(double);
        struct node_state node;
        model_observe(model, body, strip, &node);
        for (int k = 0; k < MOST_COMPONENTS; k++)
            memcpy(fields->stress[k] + strip->site, node.cauchy[k], bytes);
        memcpy(fields->plastic + strip->site, node.plastic, bytes);
    }
}

static double von_mises(double *const stress[MOST_COMPONENTS], int64_t i)
{
    double xy = stress[0][i] - stress[1][i], yz = stress[1][i] - stress[2][i],
           zx = stress[2][i] - stress[0][i];
    double shear =
        stress[3][i] * stress[3][i] + stress[4][i] * stress[4][i] + stress[5][i] * stress[5][i];
    return sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * shear);
}

static const double *component(struct fields *fields, int variable, int c, struct body *body)
{
    double *const *const vectors[] = {body->u, body->v, body->f};
    switch (table[variable].source) {
    case BODY_FIELD:
        return vectors[variable][c];
    case NODE_STRESS:
        return fields->stress[c];
    case PLASTIC_STRAIN:
        return fields->plastic;
    case DAMAGE:
        damage_index(fields->damage, fields->scalar);
        return fields->scalar;
    default:
        break;
    }
    for (int64_t i = 0; i < body->grid.n_sites; i++) {
        if (!(body->grid.flags[i] & SITE_OWNED)) continue;
        fields->scalar[i] = table[variable].source == VON_MISES ? von_mises(fields->stress, i)
                                                                : body->grid.phase[i];
    }
    return fields->scalar;
}

void fields_write(struct fields *fields, double time, struct model *model, struct body *body)
{
    int variable = 0;
    find_node_values(fields, model, body);
    for (int k = 0; k < fields->wanted.n_variables; k++)
        for (int c = 0; c < table[fields->wanted.variables[k]].count; c++, variable++)
            body_gather(body, component(fields, fields->wanted.variables[k], c, body),
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
    for (int k = 0; k < MOST_COMPONENTS; k++) free(fields->stress[k]);
    free(fields->plastic);
    free(fields->scalar);
    free(fields);
}
