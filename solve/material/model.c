#include "model.h"

#include "laws.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* Keys of the solver section that are not for every formulation. */
static void check_keys(struct deck_node solver, const struct formulation *formulation)
{
    static const char *const special[] = {"stabilisation", "residual", "surface_correction",
                                          "interfaces"};
    for (size_t k = 0; k < sizeof special / sizeof *special; k++) {
        bool known = false;
        for (int i = 0; formulation->keys[i]; i++)
            known |= strcmp(formulation->keys[i], special[k]) == 0;
        if (!known && deck_has(solver, special[k]))
            deck_error(deck_get(solver, special[k]), "%s materials have no '%s'", formulation->name,
                       special[k]);
    }
}

struct model *model_new(struct deck_node solver, const struct family *family,
                        const struct materials *materials)
{
    struct model *model = memory_new(1, sizeof *model);
    model->formulation = materials->formulation;
    model->materials = materials;
    check_keys(solver, model->formulation);
    model->self = model->formulation->read(solver, family, materials);
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
    struct exact_sum sums[9];
    double stress[9];
    if (!lattice_is_periodic(body->lattice)) {
        model->formulation->force(model->self, body, mode, energy);
        return;
    }
    /* No mean stress of a metal exceeds ten times its modulus. */
    const double volume = (double)body->lattice->n_particles * body->volume,
                 bound = 10 * volume * materials_stiffest(model->materials);
    for (int k = 0; k < 9; k++) sums[k] = exact_sum_new(bound);
    body->stress_sums = sums;
    body_to_lattice(body, body->mean_gradient, body->lattice_gradient);
    model->formulation->force(model->self, body, mode, energy);
    body->stress_sums = NULL;
    exact_sum_finish(sums, 9, stress);
    for (int k = 0; k < 9; k++) stress[k] /= body->whole_volume;
    body_to_test(body, stress, body->mean_stress);
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

void model_observe(const struct model *model, const struct body *body, const struct strip *strip,
                   struct node_state *state)
{
    static const struct state plastic_strain = STATE_PLASTIC_STRAIN;
    double buffer[LANES];
    model->formulation->observe(model->self, body, strip, state);
    const double *p = model_state(model, strip, law_state_number(plastic_strain.name), 0, buffer);
    memcpy(state->plastic, p, (size_t)strip->count * sizeof *p);
}

void model_visit(struct model *model, const struct body *body, struct checkpoint *checkpoint)
{
    if (model->formulation->visit) model->formulation->visit(model->self, body, checkpoint);
}

bool model_has_state(const struct model *model, int number)
{
    for (int k = 0; k < model->materials->n_laws; k++)
        if (model->materials->laws[k].component[number] >= 0) return true;
    return false;
}

const double *model_state(const struct model *model, const struct strip *strip, int number,
                          int component, double *buffer)
{
    if (model_has_state(model, number))
        return model->formulation->state(model->self, strip, number, component, buffer);
    for (int i = 0; i < strip->count; i++) buffer[i] = state_initial(law_state(number), component);
    return buffer;
}

void node_state_cauchy(struct node_state *state, const double *const nominal[9])
{
    static const int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    for (int i = 0; i < state->count; i++) {
        double F[9], P[9];
        for (int k = 0; k < 9; k++) {
            F[k] = state->H[k][i] + (k % 4 == 0);
            P[k] = nominal[k][i];
        }
        double J = F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) +
                   F[2] * (F[3] * F[7] - F[4] * F[6]);
        for (int k = 0; k < 6; k++) {
            const double *a = P + 3 * row[k], *b = F + 3 * column[k];
            state->cauchy[k][i] = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / J;
        }
    }
}
