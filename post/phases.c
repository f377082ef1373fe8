#include "phases.h"

#include <math.h>
#include <stddef.h>

static const double least_difference = 1e-6; /* of strain; below it q is noise */

static double at(const double *values, long row)
{
    return values ? values[row] : NAN;
}

static double mixture_share(const struct curve *curve, long row)
{
    double sum = 0;
    for (int k = 0; k < curve->n_phases; k++)
        sum += curve->phases[k].fraction * at(curve->phases[k].stress, row);
    return sum / curve->stress[row];
}

struct partition phases_at(const struct curve *curve, long row)
{
    struct partition state = {-1, -1, NAN, NAN, NAN, NAN, NAN, NAN};
    if (curve->n_phases != 2) return state;
    const struct curve_phase *phases = curve->phases;
    state.hard = at(phases[1].true_stress, row) > at(phases[0].true_stress, row) ? 1 : 0;
    state.soft = 1 - state.hard;
    state.hard_stress = at(phases[state.hard].true_stress, row);
    state.soft_stress = at(phases[state.soft].true_stress, row);
    state.hard_strain = at(phases[state.hard].strain, row);
    state.soft_strain = at(phases[state.soft].strain, row);
    double difference = state.soft_strain - state.hard_strain;
    if (fabs(difference) >= least_difference)
        state.factor = (state.hard_stress - state.soft_stress) / difference;
    state.mixture = mixture_share(curve, row);
    return state;
}

void phases_add_factor(struct curve *curve)
{
    if (curve->n_phases != 2) return;
    double *factor = table_add(&curve->table, "partition_q_Pa");
    for (long i = 0; i < curve->n; i++) factor[i] = phases_at(curve, i).factor;
}
