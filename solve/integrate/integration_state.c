#include "integration_state.h"

#include "profile.h"

void integration_force(struct integration *integration, struct model *model, struct body *body,
                       struct force_mode mode, struct force_energy *energy)
{
    const enum profile_part before =
        profile_enter(body->profile, mode.energy ? PART_FORCE_ENERGIES : PART_FORCE);
    profile_count(body->profile, WORK_ENERGIES, mode.energy, 1);
    integration->evaluations++;
    mode.time = integration->force_time;
    mode.dt = mode.time - integration->committed_time;
    model_force(model, body, mode, energy);
    if (mode.commit) integration->committed_time = mode.time;
    profile_enter(body->profile, before);
}

double integration_internal_energy(const struct force_energy *energy)
{
    double values[3];
    exact_sum_finish(
        (const struct exact_sum[]){energy->stored, energy->plastic, energy->stabilisation}, 3,
        values);
    return values[0] + values[1] + values[2];
}
