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
    const double drift = energy_drift(&s->verlet.balance);
    if (isfinite(drift) && fabs(drift) <= s->scene.energy_tolerance) return NULL;
    if (isfinite(drift))
        return memory_print("the energy balance is off by %.2g (energy_tolerance %g) at step %lld, "
                            "t = %.4g s: reduce solver.safety",
                            drift, s->scene.energy_tolerance, (long long)s->verlet.step,
                            s->verlet.time);
    int64_t node = first_bad_node(s);
    return memory_print("not a number at node %lld, step %lld, t = %.4g s", (long long)node,
                        (long long)s->verlet.step, s->verlet.time);
}

/* The step changes with the shape of the lattice; it is found again each 5 % of gauge strain. */
static void check_step(struct simulation *s)
{
    if (fabs(s->strain - s->checked_strain) < 0.05) return;
    s->checked_strain = s->strain;
    s->critical_step = stable_step(s->model, &s->body, &s->materials);
    s->verlet.dt = s->scene.safety * s->critical_step;
}

static bool due(int64_t step, int64_t n_steps, int count)
{
    int64_t every = n_steps / count > 0 ? n_steps / count : 1;
    return step % every == 0;
}

/* Records lie denser at the start, t_n = t_end (n/N)^2, where the elastic slope is measured. */
static bool record_due(const struct simulation *s)
{
    const double records = s->scene.history, end = (double)s->n_steps;
    double before = floor(records * sqrt((double)s->verlet.step / end));
    double after = floor(records * sqrt((double)(s->verlet.step + 1) / end));
    return after > before;
}

static void record(struct simulation *s)
{
    s->strain = recorder_take(&s->recorder, s->gauge, &s->verlet, &s->boundary, s->model, &s->body,
                              s->axial);
}

static bool at_end(const struct simulation *s)
{
    if (s->scene.end_time > 0) return s->verlet.time >= s->end_time - 1e-6 * s->verlet.dt;
    return s->strain >= s->scene.end_strain || s->verlet.step >= 4 * s->n_steps;
}

/* Whether the next step is the last one that a given end time leaves. */
static bool near_end(const struct simulation *s)
{
    return s->scene.end_time > 0 &&
           s->verlet.time + s->verlet.dt >= s->end_time - 1e-6 * s->verlet.dt;
}

static double gauge_stress(const struct simulation *s)
{
    const struct boundary_set *sets = s->boundary.sets;
    double force = 0.5 * (sets[s->boundary.right].total_force - sets[s->boundary.left].total_force);
    double section = attributes_number(&s->domain.attributes, "section_m2", 0);
    return section > 0 ? force / section : 0;
}

static double share_done(const struct simulation *s)
{
    double by_strain = s->scene.end_strain > 0 ? s->strain / s->scene.end_strain : 0;
    double by_steps = (double)s->verlet.step / (double)s->n_steps;
    return by_strain > 0 ? by_strain : fmin(by_steps, 1);
}

const char *simulation_run(struct simulation *s)
{
    struct progress progress = progress_start(s->ranks.rank == 0 && !s->arguments->quiet);
    const size_t bytes = (size_t)s->body.grid.n_sites * sizeof(double);
    simulation_protect(s);
    record(s);
    if (s->fields) fields_write(s->fields, s->verlet.time, s->model, &s->body);
    while (!s->failure && !at_end(s)) {
        bool recording = record_due(s) || near_end(s);
        if (recording) memset(s->axial, 0, bytes);
        verlet_step(&s->verlet, &s->body, &s->boundary, s->model, recording ? s->axial : NULL);
        s->failure = find_failure(s);
        if (s->failure) break;
        if (recording) {
            record(s);
            check_step(s);
        }
        if (s->fields && (due(s->verlet.step, s->n_steps, s->scene.fields.frames) || at_end(s)))
            fields_write(s->fields, s->verlet.time, s->model, &s->body);
        progress_update(&progress, share_done(s), s->verlet.step, s->strain, gauge_stress(s),
                        energy_drift(&s->verlet.balance));
    }
    if (!s->failure && s->scene.end_strain > 0 && s->strain < s->scene.end_strain)
        s->failure =
            memory_print("gauge strain %.4f of %.4f after four times the steps expected: the "
                         "specimen deforms outside of the gauge",
                         s->strain, s->scene.end_strain);
    s->wall = progress_finish(&progress);
    return s->failure;
}
