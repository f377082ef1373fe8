#include "simulation.h"

#include "boundary.h"
#include "correspondence.h"
#include "die.h"
#include "domain_input.h"
#include "exodus.h"
#include "fields.h"
#include "gauge.h"
#include "memory.h"
#include "options.h"
#include "progress.h"
#include "recorder.h"
#include "scene.h"
#include "stable_step.h"
#include "verlet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct simulation {
    const struct arguments *arguments;
    struct ranks ranks;
    struct domain domain; /* rank 0 */
    struct deck *deck;
    struct scene scene;
    struct lattice lattice;
    struct family family;
    struct materials materials;
    struct body body;
    struct correspondence *model;
    struct boundary boundary;
    struct gauge *gauge;
    struct verlet verlet;
    struct recorder recorder;
    struct fields *fields;
    struct spool history_output, fields_output; /* rank 0 */
    double *axial;                              /* box field */
    double critical_step, end_time, strain, checked_strain;
    int64_t n_steps; /* expected */
    double wall;     /* s */
    char *failure;
};

static const struct domain *own_domain(const struct simulation *s)
{
    return s->ranks.rank == 0 ? &s->domain : NULL;
}

/* Rank 0 reads and checks everything a user can get wrong; the others follow what is known to be good,
 * so that each error is told once. */
static void read_inputs(struct simulation *s)
{
    int n_phases = 0;
    long length = 0;
    char *text = NULL, *name = NULL;
    if (s->ranks.rank == 0) {
        domain_input_read(s->arguments, &s->domain, &s->deck);
        s->scene = scene_read(s->deck);
        s->lattice = lattice_find(&s->domain);
        scene_check_sets(&s->scene, &s->domain);
        n_phases = s->domain.n_phases;
        s->materials = materials_read(deck_get(deck_root(s->deck), "materials"), n_phases,
                                      s->domain.phase_names);
        stabilisation_choose(s->scene.stabilisation);
        text = memory_text(deck_text(s->deck));
        name = memory_text(deck_name(s->deck));
        length = (long)strlen(text);
    }
    lattice_share(&s->lattice, s->ranks.rank);
    ranks_share(&length, sizeof length);
    ranks_share(&n_phases, sizeof n_phases);
    if (s->ranks.rank != 0) {
        text = memory_new((size_t)length + 1, 1);
        s->domain.phase_names = memory_new((size_t)n_phases, sizeof(char *));
        s->domain.n_phases = n_phases;
    }
    ranks_share(text, (size_t)length);
    for (int p = 0; p < n_phases; p++) {
        char phase[256] = {0};
        if (s->ranks.rank == 0) snprintf(phase, sizeof phase, "%s", s->domain.phase_names[p]);
        ranks_share(phase, sizeof phase);
        if (s->ranks.rank != 0) s->domain.phase_names[p] = memory_text(phase);
    }
    if (s->ranks.rank != 0) {
        note_set_quiet(1);
        s->deck = deck_parse(text, (size_t)length, "deck");
        s->scene = scene_read(s->deck);
        s->materials = materials_read(deck_get(deck_root(s->deck), "materials"), n_phases,
                                      s->domain.phase_names);
    }
    free(text);
    free(name);
}

static void open_outputs(struct simulation *s)
{
    const struct arguments *a = s->arguments;
    if (s->ranks.rank != 0) return;
    if (a->ranks > 1 && a->ranks != s->ranks.size)
        die_user("-j %d within a launcher that started %d: leave one of them out", a->ranks,
                 s->ranks.size);
    if (a->spooled)
        s->history_output = (struct spool){.descriptor = -1, .path = memory_text(a->spooled)};
    else if (!a->history && s->ranks.size > 1)
        die_user("under mpirun or srun the history needs a name: --history FILE "
                 "(mpirun hides a full disk and a closed pipe)");
    else
        s->history_output = spool_output(a->history);
    if (a->fields && s->scene.fields.frames == 0)
        die_user("-o %s: the deck's output section asks for no fields", a->fields);
    if (!a->fields && s->scene.fields.frames > 0) note("no -o FILE: the fields are not written");
    if (a->fields) s->fields_output = spool_output(a->fields);
}

static void build(struct simulation *s)
{
    s->family = family_new(s->scene.horizon, s->scene.influence);
    const struct stabilisation *stabilisation = stabilisation_choose(s->scene.stabilisation);
    void *self = stabilisation->read(s->scene.stabilisation, &s->family, &s->materials);
    const struct offset *bonds;
    int n_bonds = stabilisation->bonds(self, &s->family, &bonds);
    s->body = body_new(&s->lattice, &s->family, bonds, n_bonds, s->ranks);
    s->model = correspondence_new(&s->body, &s->materials, stabilisation, self);
    s->boundary =
        boundary_new(&s->scene, &s->body, own_domain(s), 10 * materials_stiffest(&s->materials));
    s->gauge = gauge_new(&s->body, own_domain(s), s->domain.n_phases);
    s->axial = memory_new((size_t)s->body.grid.n_sites, sizeof(double));
    if (s->body.unsupported == s->lattice.n_nodes)
        die_user("no node has a deformation gradient: the body is too thin for horizon %g",
                 s->scene.horizon);
}

/* Poisson's ratio of the mean moduli, for the start velocity. */
static double mean_poissons_ratio(const struct simulation *s)
{
    double sum = 0;
    for (int p = 0; p < s->materials.count; p++)
        sum += gauge_fraction(s->gauge, p) * s->materials.items[p].poissons_ratio;
    return sum;
}

static void plan_time(struct simulation *s)
{
    s->critical_step = stable_step(s->model, &s->body, &s->materials);
    double dt = s->scene.safety * s->critical_step, rate = boundary_strain_rate(&s->boundary);
    s->end_time = s->scene.end_time;
    if (s->scene.end_strain > 0) {
        if (!(rate > 0))
            deck_error(deck_find(deck_root(s->deck), "boundary"),
                       "end_strain needs grips that move apart (strain rate %g 1/s)", rate);
        /* By the ramp's end the grips have gone half of what they would at full speed. */
        s->end_time = s->scene.end_strain / rate + 0.5 * s->scene.ramp;
    }
    if (!(s->end_time / dt < 1e12))
        deck_error(deck_find(deck_root(s->deck), "solver"),
                   "%.3g s in steps of %.3g s are over 1e12 steps", s->end_time, dt);
    s->n_steps = (int64_t)ceil(s->end_time / dt);
    if (s->scene.start == START_AFFINE)
        boundary_affine_start(&s->boundary, &s->body, mean_poissons_ratio(s));
    s->verlet = verlet_new(dt, s->scene.damping, &s->materials, &s->body, &s->boundary, s->model);
}

struct simulation *simulation_new(const struct arguments *arguments, struct ranks ranks)
{
    struct simulation *s = memory_new(1, sizeof *s);
    s->arguments = arguments;
    s->ranks = ranks;
    read_inputs(s);
    open_outputs(s);
    build(s);
    plan_time(s);
    s->recorder = recorder_new(own_domain(s), s->domain.n_phases, s->domain.phase_names);
    if (arguments->fields) {
        if (ranks.rank == 0) {
            attributes_set_text(&s->domain.attributes, "solver_program", options_version());
            attributes_set_text(&s->domain.attributes, "deck", deck_text(s->deck));
        }
        s->fields = fields_open(&s->fields_output, own_domain(s), &s->scene.fields, &s->body);
    }
    return s;
}

void simulation_announce(struct simulation *s)
{
    double start = ranks_clock();
    correspondence_force(s->model, &s->body, (struct force_mode){.frozen = true}, NULL);
    double force = ranks_clock() - start;
    double memory = (double)(body_memory(&s->body) + correspondence_memory(s->model));
    struct exact_sum sum = exact_sum_new(1e18);
    exact_sum_add(&sum, memory);
    exact_sum_finish(&sum, 1, &memory);
    if (s->ranks.rank != 0) return;
    int64_t bonds = family_bonds(&s->family, &s->lattice);
    note("%lld nodes, %lld bonds, %d ranks; step %.3g s (%.2f of the critical %.3g s), about %lld "
         "steps "
         "to %.3g s; strain rate %.3g 1/s, fastest wave %.0f m/s; %.0f MB; about %.0f s",
         (long long)s->lattice.n_nodes, (long long)bonds, s->ranks.size, s->verlet.dt,
         s->scene.safety, s->critical_step, (long long)s->n_steps, s->end_time,
         boundary_strain_rate(&s->boundary), materials_wave_speed(&s->materials), memory * 1e-6,
         1.15 * force * (double)s->n_steps);
    if (s->body.unsupported > 0)
        warn("%lld nodes have too few neighbours for a deformation gradient and carry no stress",
             (long long)s->body.unsupported);
}

/* Number of the first node whose motion or force is not finite, 0 for none. */
static int64_t first_bad_node(const struct simulation *s)
{
    double first = INFINITY;
    int64_t node = 0;
    for (int64_t site = 0; site < s->lattice.n_sites; site++) {
        if (s->lattice.phase[site] == ABSENT) continue;
        node++;
        int64_t line = site / s->lattice.size[0];
        int at[3] = {(int)(site % s->lattice.size[0]), (int)(line % s->lattice.size[1]),
                     (int)(line / s->lattice.size[1])};
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

/* The step shrinks with the thinning section; it is found again each 5 % of strain. */
static void check_step(struct simulation *s)
{
    if (s->strain < s->checked_strain + 0.05) return;
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

static void describe(struct simulation *s)
{
    struct attributes *a = &s->recorder.history.attributes;
    const char *launched = getenv("HSSOLVE_COMMAND"); /* the user's command where -j started us */
    attributes_set_text(a, "deck", deck_text(s->deck));
    attributes_set_text(a, "deck_name", deck_name(s->deck));
    attributes_set_text(a, "solver_program", options_version());
    attributes_set_text(a, "solver_command", launched ? launched : s->arguments->command);
    attributes_set_number(a, "solver_horizon", s->scene.horizon);
    attributes_set_number(a, "solver_strain_rate_per_s", boundary_strain_rate(&s->boundary));
    attributes_set_number(a, "solver_step_s", s->verlet.dt);
    attributes_set_number(a, "solver_steps", (double)s->verlet.step);
    attributes_set_number(a, "gauge_length_m", gauge_length(s->gauge));
    for (int p = 0; p < s->domain.n_phases; p++) {
        char *name = memory_print("phase_%s_fraction", s->domain.phase_names[p]);
        attributes_set_number(a, name, gauge_fraction(s->gauge, p));
        free(name);
    }
    double modulus = s->materials.items[0].youngs_modulus;
    bool same = true;
    for (int p = 1; p < s->materials.count; p++)
        same &= s->materials.items[p].youngs_modulus == modulus;
    if (same) attributes_set_number(a, "youngs_modulus_Pa", modulus);
}

/* Under its name, or as NAME.failed. */
static void finish_output(struct spool *output, const char *failed_name, const char *failure)
{
    if (failure) {
        free(output->final);
        output->final = memory_text(failed_name);
        warn("what was good is kept in %s", failed_name);
    }
    spool_finish(output);
}

void simulation_finish(struct simulation *s, const char *failure)
{
    const struct arguments *a = s->arguments;
    if (s->fields) fields_close(s->fields);
    s->fields = NULL;
    if (s->ranks.rank != 0) return;
    if (a->fields) {
        char *name = memory_print("%s.failed", a->fields);
        finish_output(&s->fields_output, name, failure);
        free(name);
    }
    describe(s);
    if (failure) {
        char *name = memory_print("%s.failed", a->history ? a->history : "hssolve-history");
        struct spool kept = spool_output(name);
        exodus_write_history(&kept, &s->recorder.history);
        spool_finish(&kept);
        warn("the history up to there is kept in %s", name);
        free(name);
        return;
    }
    exodus_write_history(&s->history_output, &s->recorder.history);
    if (!a->spooled) spool_finish(&s->history_output);
    double node_steps = (double)s->verlet.step * (double)s->lattice.n_nodes;
    note("%lld steps in %.1f s: %.3g node-steps/s on each of %d ranks; gauge strain %.4f, energy "
         "drift "
         "%.1e",
         (long long)s->verlet.step, s->wall, node_steps / s->wall / s->ranks.size, s->ranks.size,
         s->strain, energy_drift(&s->verlet.balance));
}

void simulation_free(struct simulation *s)
{
    recorder_free(&s->recorder);
    verlet_free(&s->verlet);
    gauge_free(s->gauge);
    boundary_free(&s->boundary);
    correspondence_free(s->model);
    body_free(&s->body);
    materials_free(&s->materials);
    family_free(&s->family);
    lattice_free(&s->lattice);
    scene_free(&s->scene);
    deck_free(s->deck);
    domain_free(&s->domain);
    if (s->history_output.path) spool_close(&s->history_output);
    if (s->fields_output.path) spool_close(&s->fields_output);
    free(s->axial);
    free(s->failure);
    free(s);
}
