#include "simulation.h"

#include "gradient.h"
#include "memory.h"
#include "progress.h"
#include "simulation_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number of the first node whose motion or force is not finite, 0 for none. */
static int64_t first_bad_node(const struct simulation *s)
{
    double first = INFINITY;
    int64_t node = 0;
    for (int64_t site = 0; site < s->lattice.n_sites; site++) {
        if (!lattice_has_node(&s->lattice, site)) continue;
        node++;
        int at[3];
        lattice_position(&s->lattice, site, at);
        int64_t here = grid_site(&s->body.grid, at);
        if (here < 0 || !(s->body.grid.flags[here] & SITE_OWNED)) continue;
        double sum = 0;
        for (int a = 0; a < 3; a++)
            sum += s->body.u[a][here] + s->body.v[a][here] + s->body.f[a][here];
        if (!isfinite(sum)) {
            first = (double)node;
            break;
        }
    }
    ranks_minimum(&first, 1);
    return isfinite(first) ? (int64_t)first : 0;
}

/* NULL while the run is sound. */
char *simulation_find_failure(const struct simulation *s)
{
    const double drift = s->drift;
    if (isfinite(drift) && fabs(drift) <= s->scene.energy_tolerance) return NULL;
    if (isfinite(drift))
        return memory_print("the energy balance is off by %.2g (energy_tolerance %g) at step %lld, "
                            "t = %.4g s: reduce solver.safety",
                            drift, s->scene.energy_tolerance, (long long)s->integration.step,
                            s->integration.time);
    int64_t node = first_bad_node(s);
    return memory_print("not a number at node %lld, step %lld, t = %.4g s", (long long)node,
                        (long long)s->integration.step, s->integration.time);
}

/* Root mean square displacement gradient, none of which counts more than 1. */
static double mean_deformation(struct simulation *s)
{
    if (s->materials.formulation->stress_of == STRESS_OF_BONDS) displacement_gradient(&s->body);
    struct exact_sum sum = exact_sum_new((double)s->lattice.n_particles);
    const struct strips *strips = model_strips(s->model, &s->body);
    for (int64_t k = 0; k < strips->count; k++) {
        struct node_state node;
        double squares[LANES] = {0};
        model_observe(s->model, &s->body, &strips->items[k], &node);
        for (int i = 0; i < node.count; i++) {
            for (int c = 0; c < 9; c++) squares[i] += node.H[c][i] * node.H[c][i];
            squares[i] = fmin(squares[i], 1);
        }
        body_sum_owned(&s->body, strips->items[k].site, node.count, squares, 1, &sum);
    }
    double total;
    exact_sum_finish(&sum, 1, &total);
    return sqrt(total / (double)s->lattice.n_particles);
}

double simulation_deformation(struct simulation *s)
{
    if (!s->gauge) return mean_deformation(s);
    const struct gauge_planes planes = gauge_displacements(s->gauge, &s->body);
    return (planes.right - planes.left) / gauge_length(s->gauge);
}

double simulation_grip_load(const struct simulation *s)
{
    return boundary_load(&s->boundary, &s->body);
}

void simulation_record(struct simulation *s)
{
    const enum profile_part before = profile_enter(s->profile, PART_RECORD);
    profile_count(s->profile, WORK_RECORDS, 1, 0);
    const double load = simulation_grip_load(s);
    s->highest_load = fmax(s->highest_load, load);
    s->fallen = s->scene.end_load > 0 && damage_broken_bonds(s->damage) > 0 &&
                load < s->scene.end_load * s->highest_load;
    s->strain = recorder_take(&s->recorder, s->gauge, s->quantities, &s->integration, &s->boundary,
                              s->model, &s->body);
    profile_enter(s->profile, before);
}

void simulation_write_frame(struct simulation *s)
{
    const enum profile_part before = profile_enter(s->profile, PART_FRAME);
    profile_count(s->profile, WORK_FRAMES, 1, 0);
    fields_write(s->fields, s->integration.time, s->model, &s->body);
    s->framed = s->integration.time;
    profile_enter(s->profile, before);
}

/* Frames until so many steps ahead, of load steps that are counted. */
static int64_t counted(const struct simulation *s, int ahead)
{
    return (s->integration.step + ahead) * s->scene.fields.frames / s->scene.end_steps;
}

bool simulation_frame_due(const struct simulation *s)
{
    const struct scene_fields *wanted = &s->scene.fields;
    const struct integration *integration = &s->integration;
    if (!s->fields) return false;
    if (wanted->every > 0) return (integration->step + 1) % wanted->every == 0;
    if (s->load_steps.stretched) return counted(s, 1) > counted(s, 0);
    const double each = s->end_time / (double)wanted->frames;
    return floor((integration->time + integration->dt) / each) > floor(integration->time / each);
}

/* Whether a number of steps, or a time, is the end. */
bool simulation_is_end(const struct simulation *s, int64_t step, double time)
{
    if (s->scene.end_steps > 0) return step >= s->scene.end_steps;
    if (s->scene.end_time > 0) return time >= s->end_time - 1e-6 * s->integration.dt;
    return time >= MOST_WAYS * s->end_time;
}

bool simulation_at_end(const struct simulation *s)
{
    const bool there =
        legs_are(s) ? legs_done(s) : s->scene.end_strain > 0 && s->strain >= s->scene.end_strain;
    return s->fallen || there || simulation_is_end(s, s->integration.step, s->integration.time);
}

static double gauge_stress(const struct simulation *s)
{
    double section = attributes_number(&s->domain.attributes, "section_m2", 0);
    return section > 0 ? simulation_grip_load(s) / section : 0;
}

static double share_done(const struct simulation *s)
{
    double by_strain = s->scene.end_strain > 0 ? s->strain / s->scene.end_strain : 0;
    if (legs_are(s)) return (double)s->load_steps.legs.leg / s->scene.programme.count;
    if (s->load_steps.stretched) return (double)s->integration.step / (double)s->scene.end_steps;
    return by_strain > 0 ? by_strain : fmin(s->integration.time / s->end_time, 1);
}

static void advance(struct simulation *s)
{
    const double begun = ranks_clock();
    s->integration.wish[WISH_STOP] = stop_asked(&s->stop, s->longest + 2 * s->saving) ? 1 : 0;
    s->integration.wish[WISH_CHECKPOINT] = simulation_checkpoint_wish(s) ? 1 : 0;
    struct equilibrium *equilibrium = s->load_steps.equilibrium;
    if (equilibrium) equilibrium->stop = s->resumable ? &s->stop : NULL;
    profile_enter(s->profile, PART_ADVANCE);
    s->course->advance(s);
    profile_enter(s->profile, PART_REST);
    s->resumable = false;
    s->longest = fmax(s->longest, ranks_clock() - begun);
}

static void say_stopped(struct simulation *s, const char *where, bool saved)
{
    const char *why = stop_asked(&s->stop, s->longest + 2 * s->saving);
    char *name = simulation_checkpoint_name(s);
    free(s->failure);
    s->stopped = true;
    s->failure = memory_print("stopped %s step %lld, t = %.4g s (%s)%s%s", where,
                              (long long)s->integration.step, s->integration.time,
                              why ? why : "asked by a signal",
                              saved ? ": goes on with --restart " : "", saved ? name : "");
    free(name);
}

/* The run ends here for now; rank 0 need not be the one who was asked. */
static void stop(struct simulation *s)
{
    const bool saved = simulation_checkpoint(s);
    if (s->fields && s->framed < s->integration.time) simulation_write_frame(s);
    say_stopped(s, "at", saved);
}

/* Amid a load step, of which nothing is left but the checkpoint at its start. */
static void stop_amid(struct simulation *s)
{
    if (s->ranks.rank == 0) s->recorder.history.n_records = s->saved_records;
    say_stopped(s, "amid the load step behind", true);
}

bool simulation_stopped(const struct simulation *s)
{
    return s->stopped;
}

/* As it begins, or as it was when it stopped. */
static void begin(struct simulation *s)
{
    const bool restart = s->arguments->restart != NULL;
    s->saved = ranks_clock();
    if (restart && s->course->begin) s->course->begin(s);
    if (restart)
        simulation_restore(s);
    else
        simulation_record(s);
    simulation_protect(s);
    if (restart) return;
    if (s->course->begin) s->course->begin(s);
    if (s->fields) simulation_write_frame(s);
}

/* Between two steps. */
static void look_around(struct simulation *s)
{
    if (s->load_steps.equilibrium && s->load_steps.equilibrium->cut) {
        stop_amid(s);
        return;
    }
    simulation_save_records(s, false);
    if (s->failure || simulation_at_end(s)) return;
    if (s->integration.granted[WISH_STOP] > 0)
        stop(s);
    else if (simulation_checkpoint_due(s))
        simulation_checkpoint(s);
}

static void watch(void *progress, const struct equilibrium *e)
{
    progress_search(progress, e->integration->step + 1, e->evaluations, equilibrium_residual(e),
                    e->tolerance);
}

const char *simulation_run(struct simulation *s)
{
    struct progress progress = progress_start(s->ranks.rank == 0 && !s->arguments->quiet);
    s->stop = stop_begin(s->arguments->time_limit);
    if (s->load_steps.equilibrium) {
        s->load_steps.equilibrium->watch = watch;
        s->load_steps.equilibrium->watcher = &progress;
    }
    begin(s);
    while (!s->failure && !simulation_at_end(s)) {
        advance(s);
        progress_update(&progress, share_done(s), s->integration.step, s->gauge ? s->strain : NAN,
                        gauge_stress(s), s->drift);
        look_around(s);
    }
    if (!s->failure && legs_are(s) && !legs_done(s) && !s->fallen)
        s->failure =
            memory_print("leg %d of %d of the programme is not at its end after four times "
                         "the way expected: gauge strain %.4f",
                         s->load_steps.legs.leg + 1, s->scene.programme.count, s->strain);
    else if (!s->failure && !legs_are(s) && s->scene.end_strain > 0 &&
             s->strain < s->scene.end_strain && !s->fallen)
        s->failure =
            memory_print("gauge strain %.4f of %.4f after four times the steps expected: the "
                         "specimen deforms outside of the gauge",
                         s->strain, s->scene.end_strain);
    s->wall = progress_finish(&progress);
    if (s->load_steps.equilibrium) s->load_steps.equilibrium->watch = NULL;
    stop_end(&s->stop);
    return s->failure;
}
