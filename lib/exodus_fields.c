#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { UNUSED_ID = 0 };

/* --- writing ---------------------------------------------------------------------------------- */

struct exodus_fields {
    struct exodus_file file;
    int64_t n_nodes;
    int n_variables, n_frames;
};

struct exodus_fields *exodus_fields_open(const struct spool *output, const struct domain *domain,
                                         int n_variables, const char *const names[])
{
    struct exodus_fields *fields = memory_new(1, sizeof *fields);
    struct exodus_file file = exodus_create(output, &domain->attributes);
    exodus_put_domain(&file, domain);
    /* The library wants names that it could write to. */
    char **copies = memory_new((size_t)n_variables, sizeof *copies);
    for (int i = 0; i < n_variables; i++) {
        exodus_check_name(&file, names[i]);
        copies[i] = memory_text(names[i]);
    }
    exodus_wrote(&file, ex_put_variable_param(file.id, EX_NODAL, n_variables), "the variables");
    exodus_wrote(&file, ex_put_variable_names(file.id, EX_NODAL, n_variables, copies),
                 "the variables' names");
    for (int i = 0; i < n_variables; i++) free(copies[i]);
    free(copies);
    *fields = (struct exodus_fields){file, domain->n_nodes, n_variables, 0};
    return fields;
}

void exodus_fields_write(struct exodus_fields *fields, double time, const double *const values[])
{
    const struct exodus_file *file = &fields->file;
    int frame = fields->n_frames + 1;
    for (int i = 0; i < fields->n_variables; i++)
        exodus_wrote(
            file,
            ex_put_var(file->id, frame, EX_NODAL, i + 1, UNUSED_ID, fields->n_nodes, values[i]),
            "a frame");
    exodus_wrote(file, ex_put_time(file->id, frame, &time), "a frame's time");
    exodus_sync(file);
    fields->n_frames = frame;
}

void exodus_fields_close(struct exodus_fields *fields)
{
    if (fields == NULL) return;
    exodus_finish(&fields->file);
    free(fields);
}

int64_t exodus_fields_count(const struct exodus_fields *fields)
{
    return fields->n_frames;
}

static bool is_alike(const struct exodus_fields *fields, const struct exodus_file *other,
                     int64_t frames)
{
    int n_variables = 0;
    return ex_get_variable_param(other->id, EX_NODAL, &n_variables) >= 0 &&
           n_variables == fields->n_variables &&
           ex_inquire_int(other->id, EX_INQ_NODES) == fields->n_nodes &&
           ex_inquire_int(other->id, EX_INQ_TIME) >= frames;
}

bool exodus_fields_take(struct exodus_fields *fields, const char *name, int64_t frames)
{
    const struct spool input = {.descriptor = -1, .path = (char *)(uintptr_t)name};
    const size_t nodes = (size_t)fields->n_nodes;
    if (access(name, R_OK) != 0) return false;
    struct exodus_file other = exodus_open_any(&input);
    const bool alike = is_alike(fields, &other, frames);
    const double **values = memory_new((size_t)fields->n_variables, sizeof *values);
    double *all = memory_new((size_t)fields->n_variables * nodes, sizeof *all), time;
    for (int frame = 1; alike && frame <= frames; frame++) {
        for (int i = 0; i < fields->n_variables; i++) {
            double *one = all + (size_t)i * nodes;
            exodus_read(
                &other,
                ex_get_var(other.id, frame, EX_NODAL, i + 1, UNUSED_ID, fields->n_nodes, one),
                "a frame");
            values[i] = one;
        }
        exodus_read(&other, ex_get_time(other.id, frame, &time), "a frame's time");
        exodus_fields_write(fields, time, values);
    }
    exodus_close(&other);
    free(values);
    free(all);
    return alike;
}

/* --- reading ---------------------------------------------------------------------------------- */

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
