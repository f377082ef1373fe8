#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UNUSED_ID = 0 };

/* Counts that the file has room for: a double a node, variable and frame. */
static void read_counts(const struct exodus_file *file, struct frames *frames)
{
    frames->n_nodes = ex_inquire_int(file->id, EX_INQ_NODES);
    frames->n_frames = ex_inquire_int(file->id, EX_INQ_TIME);
    exodus_read(file, ex_get_variable_param(file->id, EX_NODAL, &frames->n_variables),
                "the variables");
    if (frames->n_nodes == 0 || frames->n_variables == 0 || frames->n_frames == 0)
        die_user("%s: no frames of fields in it, expected the file of hssolve -o", file->shown);
    exodus_bound(file, frames->n_variables, 8, "variables");
    exodus_bound(file, frames->n_nodes, 8 * (int64_t)frames->n_variables, "nodes");
    exodus_bound(file, frames->n_frames, 8 * (int64_t)frames->n_variables * frames->n_nodes,
                 "frames");
}

static void read_variables(const struct exodus_file *file, struct frames *frames)
{
    char **names = exodus_names(frames->n_variables);
    exodus_read(file, ex_get_variable_names(file->id, EX_NODAL, frames->n_variables, names),
                "the variables' names");
    frames->variables = memory_new((size_t)frames->n_variables, sizeof *frames->variables);
    for (int i = 0; i < frames->n_variables; i++) frames->variables[i] = memory_text(names[i]);
    free(names);
}

struct frames exodus_frames_open(const struct spool *input)
{
    struct frames frames = {.file = memory_new(1, sizeof *frames.file)};
    *frames.file = exodus_open(input, false);
    read_counts(frames.file, &frames);
    read_variables(frames.file, &frames);
    frames.time = memory_new((size_t)frames.n_frames, sizeof *frames.time);
    exodus_read(frames.file, ex_get_all_times(frames.file->id, frames.time), "the times");
    for (int64_t i = 0; i < frames.n_frames; i++)
        if (!isfinite(frames.time[i]))
            die_user("%s: damaged: frame %lld has no finite time", frames.file->shown,
                     (long long)i + 1);
    return frames;
}

int frames_find(const struct frames *frames, const char *variable)
{
    for (int i = 0; i < frames->n_variables; i++)
        if (strcmp(frames->variables[i], variable) == 0) return i;
    return -1;
}

void exodus_frames_read(const struct frames *frames, int variable, int64_t frame, double *values)
{
    exodus_read(frames->file,
                ex_get_var(frames->file->id, (int)frame + 1, EX_NODAL, variable + 1, UNUSED_ID,
                           frames->n_nodes, values),
                frames->variables[variable]);
}

void exodus_frames_close(struct frames *frames)
{
    exodus_close(frames->file);
    free(frames->file);
    for (int i = 0; i < frames->n_variables; i++) free(frames->variables[i]);
    free(frames->variables);
    free(frames->time);
    *frames = (struct frames){0};
}
