#include "model.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Keys of the solver section that are not for every formulation. */
static void check_keys(struct deck_node solver, const struct formulation *formulation)
{
    static const char *const special[] = {"stabilisation", "surface_correction"};
    for (size_t k = 0; k < sizeof special / sizeof *special; k++) {
        bool known = false;
        for (int i = 0; formulation->keys[i]; i++)
            known |= strcmp(formulation->keys[i], special[k]) == 0;
        if (!known && deck_has(solver, special[k]))
            deck_error(deck_get(solver, special[k]), "%s materials have no '%s'", formulation->name,
                       special[k]);
    }
}

struct model *model_new(const struct formulation *formulation, struct deck_node solver,
                        const struct family *family, const struct materials *materials)
{
    struct model *model = memory_new(1, sizeof *model);
    model->formulation = formulation;
    check_keys(solver, formulation);
    model->self = formulation->read(solver, family, materials);
    return model;
}

void model_free(struct model *model)
{
    model->formulation->free(model->self);
    free(model);
}

int model_near(const struct model *model, const struct family *family,
               const struct offset **offsets)
{
    *offsets = NULL;
    if (!model->formulation->near) return 0;
    return model->formulation->near(model->self, family, offsets);
}

void model_start(struct model *model, const struct body *body, struct bonds *bonds)
{
    model->formulation->start(model->self, body, bonds);
}

void model_force(struct model *model, struct body *body, struct force_mode mode,
                 struct force_energy *energy)
{
    model->formulation->force(model->self, body, mode, energy);
}

void model_prepare(struct model *model, struct body *body, int rows)
{
    if (model->formulation->prepare) model->formulation->prepare(model->self, body, rows);
}

const struct strips *model_strips(const struct model *model, const struct body *body)
{
    if (!model->formulation->strips) return &body->owned;
    return model->formulation->strips(model->self, body);
}

void model_observe(struct model *model, const struct body *body, const struct strip *strip,
                   struct node_state *state)
{
    model->formulation->observe(model->self, body, strip, state);
}
