#include "simulation.h"

#include "broken.h"
#include "die.h"
#include "exodus.h"
#include "memory.h"
#include "options.h"
#include "simulation_parts.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Seconds from one saving of records to the next at least, and the share of the run that they may
 * take. */
static const double SAVE_EVERY = 0.5, SAVE_SHARE = 0.005;
/* Records that find room on a full disk: a quarter more than expected, as load steps may be more.
 */
static int64_t reserved(const struct simulation *s)
{
    enum { MOST = 20000 };
    const int64_t records = 16 + simulation_records(s) / 4 * 5;
    return records < MOST ? records : MOST;
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
    if (boundary_has_grips(&s->boundary))
        attributes_set_number(a, "solver_strain_rate_per_s",
                              boundary_full_strain_rate(&s->boundary));
    attributes_set_number(a, "solver_step_s", s->integration.dt);
    attributes_set_number(a, "solver_steps", (double)s->integration.step);
    if (s->gauge) attributes_set_number(a, "gauge_length_m", gauge_length(s->gauge));
    for (int p = 0; s->gauge && p < s->domain.n_phases; p++) {
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

/* The run that a dying program saves what it can of; NULL before and after. */
static struct simulation *endangered;

static bool is_file(const char *name)
{
    return name && strncmp(name, "/dev/", strlen("/dev/")) != 0;
}

/* Beside the output; where that is a pipe or a device, here. */
static char *failed_name(const char *name, const char *fallback)
{
    return memory_print("%s.failed", is_file(name) ? name : fallback);
}

static void keep_fields(void)
{
    struct simulation *s = endangered;
    double time;
    if (!s || !s->fields_output.path || s->fields_output.descriptor >= 0) return; /* a device */
    if (s->fields && fields_count(s->fields) == 0) return; /* without a frame it is nothing */
    char *name = failed_name(s->arguments->fields, "hssolve-fields");
    if (spool_keep(&s->fields_output, name)) {
        if (s->fields) exodus_repair(name, &time); /* amid a frame */
        warn("the frames up to there are kept in %s", name);
    }
    free(name);
}

static void keep_history(void)
{
    struct simulation *s = endangered;
    if (!s || !s->history_output.path || (!s->journal && !s->whole)) return;
    struct exodus_history *journal = s->journal;
    s->journal = NULL;
    char *name = failed_name(s->arguments->history, "hssolve-history");
    if (journal) {
        describe(s);
        exodus_history_close(journal, &s->recorder.history);
    }
    if (spool_keep(&s->history_output, name)) warn("the history up to there is kept in %s", name);
    free(name);
}

/* Where a restart may find the frames, wherever it is started: unfinished, kept, finished. */
static char *names_of_fields(const struct simulation *s)
{
    char here[PATH_MAX] = "", *kept = failed_name(s->arguments->fields, "hssolve-fields");
    const char *const names[] = {s->fields_output.path, kept, s->arguments->fields};
    char *all = memory_text("");
    if (!getcwd(here, sizeof here)) *here = '\0';
    for (int k = 0; k < 3; k++) {
        const bool absolute = names[k][0] == '/';
        all = memory_append(all, "%s%s%s\n", absolute ? "" : here, absolute ? "" : "/", names[k]);
    }
    free(kept);
    return all;
}

/* The last given runs first, and where it dies the other has its turn: of history and fields the
 * history wins. */
void simulation_protect(struct simulation *s)
{
    if (s->ranks.rank != 0) return;
    const enum profile_part before = profile_enter(s->profile, PART_CHECKPOINT);
    endangered = s;
    if (s->fields) s->fields_name = names_of_fields(s);
    die_at_exit(keep_fields);
    die_at_exit(keep_history);
    describe(s);
    spool_refuse_unread(&s->history_output);
    s->journal = exodus_history_open(&s->history_output, &s->recorder.history, reserved(s));
    profile_enter(s->profile, before);
}

void simulation_save_records(struct simulation *s, bool now)
{
    if (!s->journal) return;
    const double begun = ranks_clock();
    if (!now && begun < s->next_save) return;
    const enum profile_part before = profile_enter(s->profile, PART_CHECKPOINT);
    exodus_history_add(s->journal, &s->recorder.history);
    profile_enter(s->profile, before);
    const double end = ranks_clock();
    s->next_save = end + fmax(SAVE_EVERY, (end - begun) / SAVE_SHARE);
}

/* Degraded nodes have next to nothing left to give when their bonds go: below 0 it is the error of
 * a half step (theory.md). */
static void tell_broken(const struct simulation *s)
{
    const double bonds = damage_broken_bonds(s->damage), energy = s->integration.balance.fracture;
    if (bonds > 0 && energy > 0)
        note("%.0f bonds broken, %.3g J", bonds, energy);
    else if (bonds > 0)
        note("%.0f bonds broken, which held next to nothing", bonds);
}

/* Of a run that went on here: what was kept of it is in what is whole now. */
static void forget_kept(const struct simulation *s)
{
    const char *const names[] = {s->arguments->history,
                                 s->frames_missing ? NULL : s->arguments->fields};
    for (int k = 0; s->arguments->restart && k < 2; k++) {
        if (!is_file(names[k])) continue;
        char *name = failed_name(names[k], NULL);
        unlink(name); /* there need not be one */
        free(name);
    }
}

void simulation_finish(struct simulation *s, const char *failure)
{
    profile_enter(s->profile, PART_FRAME);
    if (s->fields) fields_close(s->fields);
    s->fields = NULL;
    const double steps = (double)s->integration.step + 1;
    profile_count(s->profile, WORK_RECORDS, 0, steps);
    profile_count(s->profile, WORK_FRAMES, 0, steps);
    profile_print(s->profile, s->ranks, (double)s->lattice.n_particles,
                  (double)s->integration.evaluations);
    if (s->ranks.rank != 0) return;
    if (failure) {
        if (s->stopped) warn("%s", failure);
        keep_history();
        keep_fields();
        endangered = NULL;
        return;
    }
    struct exodus_history *journal = s->journal;
    describe(s);
    exodus_history_close(journal, &s->recorder.history);
    s->journal = NULL;
    s->whole = true;
    if (s->fields_output.path) spool_finish(&s->fields_output);
    if (!s->arguments->spooled) spool_finish(&s->history_output);
    endangered = NULL;
    simulation_forget_checkpoints(s);
    forget_kept(s);
    tell_broken(s);
    if (s->materials.formulation->stress_of == STRESS_OF_NODES && s->body.broken &&
        s->body.broken->n_lost > 0)
        note("%.0f nodes have no deformation gradient left", s->body.broken->n_lost);
    char *strain = s->gauge ? memory_print("gauge strain %.4f, ", s->strain) : memory_text("");
    const double evaluations = (double)s->integration.evaluations,
                 node_steps = evaluations * (double)s->lattice.n_particles;
    note("%lld steps in %.1f s, %.0f forces: %.3g node-steps/s on each of %d ranks; %senergy drift "
         "%.1e",
         (long long)s->integration.step, s->wall, evaluations, node_steps / s->wall / s->ranks.size,
         s->ranks.size, strain, s->drift);
    free(strain);
}
