#include "memory.h"
#include "progress.h"
#include "simulation_parts.h"
#include "stable_step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number of the first node whose motion or force is not finite, 0 for none. */
static int64_t first_bad_node(const struct simulation *s)
{
    double first = INFINITY;
    int64_t node = 0;
    for (int64_t site = 0; site < s->lattice.n_sites; site++) {
        if (s->lattice.phase[site] == ABSENT) continue;
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
static char *find_failure(const struct simulation *s)
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
static double mean_deformation(const struct simulation *s)
{
    struct exact_sum sum = exact_sum_new((double)s->lattice.n_nodes);
    const struct strips *strips = model_strips(s->model, &s->body);
    for (int64_t k = 0; k < strips->count; k++) {
        struct node_state node;
        double squares[LANES] = {0};
        model_observe(s->model, &s->body, &strips->items[k], &node);
        for (int i = 0; i < node.count; i++) {
            for (int c = 0; c < 9; c++) squares[i] += node.H[c][i] * node.H[c][i];
            squares[i] = fmin(squares[i], 1);
        }
        body_only_owned(&s->body, strips->items[k].site, node.count, squares);
        exact_sum_add_strip(&sum, node.count, squares, 1);
    }
    double total;
    exact_sum_finish(&sum, 1, &total);
    return sqrt(total / (double)s->lattice.n_nodes);
}

/* The step changes with the shape of the lattice, and where correspondence has lost bonds; it is found again each 5 % of
 * strain, and each hundredth of the bonds. */
static void check_step(struct simulation *s)
{
    const double broken = damage_broken_bonds(s->damage);
    if (fabs(s->deformation - s->checked_deformation) < 0.05 &&
        broken - s->checked_broken < 0.01 * s->n_bonds)
        return;
    s->checked_deformation = s->deformation;
    s->checked_broken = broken;
    const double critical = stable_step(s->model, &s->body, &s->materials);
    if (!isfinite(critical)) return; /* nothing pulls any more: fragments fly on */
    s->critical_step = critical;
    s->integration.dt = s->scene.safety * s->critical_step;
}

/* Whether the next step ends at a frame. */
static bool frame_due(const struct simulation *s)
{
    if (!s->fields) return false;
    const struct scene_fields *wanted = &s->scene.fields;
    int64_t every = wanted->every > 0 ? wanted->every : s->n_steps / wanted->frames;
    return (s->integration.step + 1) % (every > 0 ? every : 1) == 0;
}

/* Records lie denser at the start, t_n = t_end (n/N)^2, where the elastic slope is measured. */
static bool record_due(const struct simulation *s)
{
    const double records = s->scene.history, end = (double)s->n_steps;
    double before = floor(records * sqrt((double)s->integration.step / end));
    double after = floor(records * sqrt((double)(s->integration.step + 1) / end));
    return after > before;
}

static void record(struct simulation *s)
{
    s->strain = recorder_take(&s->recorder, s->gauge, s->quantities, &s->integration, &s->boundary,
                              s->model, &s->body, s->axial);
    s->deformation = s->gauge ? s->strain : mean_deformation(s);
}

static void write_frame(struct simulation *s)
{
    fields_write(s->fields, s->integration.time, s->model, &s->body);
}

/* Whether a number of steps, or a time, is the end. */
static bool is_end(const struct simulation *s, int64_t step, double time)
{
    if (s->scene.end_steps > 0) return step >= s->scene.end_steps;
    if (s->scene.end_time > 0) return time >= s->end_time - 1e-6 * s->integration.dt;
    return step >= 4 * s->n_steps;
}

static bool at_end(const struct simulation *s)
{
    return (s->scene.end_strain > 0 && s->strain >= s->scene.end_strain) ||
           is_end(s, s->integration.step, s->integration.time);
}

/* Whether the next step is the last one that a given end leaves. */
static bool near_end(const struct simulation *s)
{
    return is_end(s, s->integration.step + 1, s->integration.time + s->integration.dt);
}

/* Stepped loads grow after what there is to see of the step has been seen.  At equilibrium the kinetic energy
 * has stayed below a thousandth of the internal one while a wave would have run there and back. */
static void raise_loads(struct simulation *s, bool looking)
{
    const struct energy_balance *balance = &s->integration.balance;
    const double time = s->integration.time, speed = materials_wave_speed(&s->materials);
    double longest = 0;
    if (s->boundary.loads.count == 0) return;
    for (int a = 0; a < 3; a++) longest = fmax(longest, lattice_extent(&s->lattice, a));
    if (looking && balance->kinetic > 1e-3 * energy_internal(balance)) s->disturbed = time;
    const bool equilibrium = looking && time - s->disturbed >= 2 * longest / speed;
    if (integration_raise_loads(&s->integration, &s->body, &s->boundary, equilibrium))
        s->disturbed = time;
}

static double gauge_stress(const struct simulation *s)
{
    if (!boundary_has_grips(&s->boundary)) return 0;
    const struct boundary_set *sets = s->boundary.sets;
    double force = 0.5 * (sets[s->boundary.right].total_force - sets[s->boundary.left].total_force);
    double section = attributes_number(&s->domain.attributes, "section_m2", 0);
    return section > 0 ? force / section : 0;
}

static double share_done(const struct simulation *s)
{
    double by_strain = s->scene.end_strain > 0 ? s->strain / s->scene.end_strain : 0;
    double by_steps = (double)s->integration.step / (double)s->n_steps;
    return by_strain > 0 ? by_strain : fmin(by_steps, 1);
}

/* One step, and what it leaves behind. */
static void advance(struct simulation *s)
{
    enum { LOOK_EVERY = 16 }; /* steps from one look at the energies to the next, at most */
    const bool recording = record_due(s) || near_end(s), framing = frame_due(s),
               looking = recording || framing || (s->integration.step + 1) % LOOK_EVERY == 0;
    if (recording) memset(s->axial, 0, (size_t)s->body.grid.n_sites * sizeof(double));
    verlet_step(&s->integration, &s->body, &s->boundary, s->model, looking,
                recording ? s->axial : NULL);
    if (looking) {
        s->drift = energy_drift(&s->integration.balance);
        s->failure = find_failure(s);
        if (s->failure) return;
    }
    if (recording) {
        record(s);
        check_step(s);
    }
    if (framing || (s->fields && at_end(s))) write_frame(s);
    raise_loads(s, looking);
}

const char *simulation_run(struct simulation *s)
{
    struct progress progress = progress_start(s->ranks.rank == 0 && !s->arguments->quiet);
    simulation_protect(s);
    record(s);
    s->checked_deformation = s->deformation;
    if (s->fields) write_frame(s);
    while (!s->failure && !at_end(s)) {
        advance(s);
        progress_update(&progress, share_done(s), s->integration.step, s->gauge ? s->strain : NAN,
                        gauge_stress(s), s->drift);
    }
    if (!s->failure && s->scene.end_strain > 0 && s->strain < s->scene.end_strain)
        s->failure =
            memory_print("gauge strain %.4f of %.4f after four times the steps expected: the "
                         "specimen deforms outside of the gauge",
                         s->strain, s->scene.end_strain);
    s->wall = progress_finish(&progress);
    return s->failure;
}
