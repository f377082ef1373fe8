/* The state of a run: written on its way, and taken up again. */
#include "checkpoint.h"
#include "die.h"
#include "exodus.h"
#include "memory.h"
#include "options.h"
#include "restart.h"
#include "simulation_parts.h"
#include "spool.h"
#include "taken.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- the walk --------------------------------------------------------------------------------- */

static void visit_explicit(struct explicit_steps *steps, struct checkpoint *checkpoint)
{
    double values[] = {steps->critical, steps->deformation, steps->broken, steps->disturbed,
                       steps->length,   steps->strain,      steps->growth, steps->since};
    checkpoint_numbers(checkpoint, "explicit steps", values, sizeof values / sizeof *values);
    steps->critical = values[0];
    steps->deformation = values[1];
    steps->broken = values[2];
    steps->disturbed = values[3];
    steps->length = values[4];
    steps->strain = values[5];
    steps->growth = values[6];
    steps->since = values[7];
    checkpoint_flag(checkpoint, "energies are known", &steps->looked);
}

static void visit_run(struct simulation *s, struct checkpoint *checkpoint)
{
    double values[] = {s->strain, s->drift, s->highest_load, s->framed, s->load_steps.strain_rate};
    checkpoint_numbers(checkpoint, "run", values, sizeof values / sizeof *values);
    s->strain = values[0];
    s->drift = values[1];
    s->highest_load = values[2];
    s->framed = values[3];
    s->load_steps.strain_rate = values[4];
    checkpoint_flag(checkpoint, "fallen", &s->fallen);
}

/* All that lives from one step to the next.  Bonds break before what is kept of them. */
static void visit(struct simulation *s, struct checkpoint *checkpoint)
{
    damage_visit(s->damage, checkpoint);
    integration_visit(&s->integration, &s->body, checkpoint);
    boundary_visit(&s->boundary, &s->body, s->integration.time, checkpoint);
    model_visit(s->model, &s->body, checkpoint);
    if (s->load_steps.quasi_static) quasi_static_visit(s->load_steps.quasi_static, checkpoint);
    visit_explicit(&s->explicit_steps, checkpoint);
    legs_visit(&s->load_steps.legs, checkpoint);
    if (legs_are(s)) boundary_turn(&s->boundary, s->load_steps.legs.sense);
    if (s->course->visit) s->course->visit(s, checkpoint);
    visit_run(s, checkpoint);
    recorder_visit(&s->recorder, checkpoint);
}

/* --- writing ---------------------------------------------------------------------------------- */

char *simulation_checkpoint_name(const struct simulation *s)
{
    const struct arguments *a = s->arguments;
    if (a->checkpoint) return memory_text(a->checkpoint);
    const bool file = a->history && strncmp(a->history, "/dev/", strlen("/dev/")) != 0;
    return memory_print("%s.checkpoint", file ? a->history : "hssolve");
}

static bool asked_for(const struct simulation *s)
{
    return s->arguments->checkpoint || s->scene.checkpoint.given.index;
}

/* Of long load steps each begins with one, so that it can be cut off: at most a fiftieth of the
 * time goes there. */
static bool is_slow(const struct simulation *s)
{
    return s->load_steps.equilibrium && !s->integration.moving &&
           s->longest > fmax(0.2, 50 * s->saving);
}

bool simulation_checkpoint_wish(const struct simulation *s)
{
    const struct scene_checkpoint *wanted = &s->scene.checkpoint;
    if (s->ranks.rank != 0) return false;
    if (is_slow(s)) return true;
    if (!asked_for(s)) return false;
    return wanted->seconds > 0 && ranks_clock() >= s->saved + wanted->seconds;
}

bool simulation_checkpoint_due(const struct simulation *s)
{
    const struct scene_checkpoint *wanted = &s->scene.checkpoint;
    return s->integration.granted[WISH_CHECKPOINT] > 0 ||
           (wanted->steps > 0 && s->integration.step - s->saved_step >= wanted->steps);
}

static struct run_texts texts_of(const struct simulation *s)
{
    struct run_texts texts = {.domain = s->input}; /* open since it was read */
    if (s->ranks.rank != 0) return texts;
    texts.program = memory_text(options_version());
    texts.deck = memory_text(deck_text(s->deck));
    texts.deck_name = memory_text(s->arguments->deck ? deck_name(s->deck) : "");
    texts.fields = memory_text(s->fields_name ? s->fields_name : "");
    return texts;
}

/* The newest has the name, the one before NAME.1 and so on.  Whatever ends the run here, NAME is
 * one or the other: the one before gets a second name first, where the file system has such. */
static const char *rename_all(const char *partial, const char *name, int64_t keep)
{
    for (int64_t k = keep - 1; k > 0; k--) {
        char *from = k > 1 ? memory_print("%s.%lld", name, (long long)k - 1) : memory_text(name);
        char *to = memory_print("%s.%lld", name, (long long)k);
        unlink(to); /* there need not be one, of either */
        if (k > 1 || link(from, to) != 0) rename(from, to);
        free(from);
        free(to);
    }
    if (rename(partial, name) != 0) return strerror(errno);
    spool_sync_folder(name);
    return NULL;
}

bool simulation_checkpoint(struct simulation *s)
{
    const double begun = ranks_clock();
    const enum profile_part before = profile_enter(s->profile, PART_CHECKPOINT);
    long process = (long)getpid();
    ranks_share(&process, sizeof process);
    char *name = simulation_checkpoint_name(s),
         *partial = memory_print("%s.partial-%ld", name, process);
    struct run_texts texts = texts_of(s);
    struct checkpoint_file *file = checkpoint_file_create(partial, s->ranks);
    int64_t frames = s->fields ? fields_count(s->fields) : 0;
    run_texts_visit(&texts, file);
    struct checkpoint *checkpoint = checkpoint_new(file, &s->body);
    checkpoint_integer(checkpoint, "frames", &frames);
    visit(s, checkpoint);
    checkpoint_free(checkpoint);
    const char *failure = checkpoint_file_close(file);
    if (s->ranks.rank == 0 && !failure)
        failure = rename_all(partial, name, s->scene.checkpoint.keep);
    if (s->ranks.rank == 0 && failure) {
        warn("no checkpoint in %s: %s", name, failure);
        unlink(partial);
    }
    bool saved = !failure;
    ranks_share(&saved, sizeof saved);
    run_texts_free(&texts);
    free(partial);
    free(name);
    profile_enter(s->profile, before);
    s->saved = ranks_clock();
    s->saved_step = s->integration.step;
    s->saving = s->saved - begun;
    s->saved_records = s->recorder.history.n_records;
    s->resumable = saved;
    return saved;
}

void simulation_forget_checkpoints(const struct simulation *s)
{
    if (asked_for(s)) return;
    char *name = simulation_checkpoint_name(s);
    const char *from = s->arguments->restart;
    const bool own = s->saving > 0 || (from && taken_are_one(from, name));
    if (own) unlink(name);
    for (int64_t k = 1; own && k < s->scene.checkpoint.keep; k++) {
        char *older = memory_print("%s.%lld", name, (long long)k);
        unlink(older);
        free(older);
    }
    free(name);
}

/* --- reading ---------------------------------------------------------------------------------- */

/* The frames of before, which are not in the checkpoint. */
static void take_frames(struct simulation *s, char *names, int64_t frames)
{
    if (!s->fields || s->ranks.rank != 0 || frames == 0) return;
    char *rest = names;
    for (char *name; (name = strsep(&rest, "\n"));)
        if (*name && fields_take(s->fields, name, frames)) return;
    s->frames_missing = true;
    warn("the frames of before t = %.4g s are not at hand: %s begins there", s->integration.time,
         s->arguments->fields);
}

void simulation_restore(struct simulation *s)
{
    const enum profile_part before = profile_enter(s->profile, PART_CHECKPOINT);
    struct run_texts texts = {.domain = -1};
    struct checkpoint_file *file = checkpoint_file_open(s->arguments->restart);
    int64_t frames = 0;
    run_texts_visit(&texts, file);
    struct checkpoint *checkpoint = checkpoint_new(file, &s->body);
    checkpoint_integer(checkpoint, "frames", &frames);
    visit(s, checkpoint);
    checkpoint_free(checkpoint);
    checkpoint_file_close(file);
    take_frames(s, texts.fields, frames);
    run_texts_free(&texts);
    s->saved_step = s->integration.step;
    ranks_wait();
    profile_enter(s->profile, before);
    note("goes on from step %lld, t = %.4g s", (long long)s->integration.step, s->integration.time);
}
