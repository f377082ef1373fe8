#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { UNUSED_ID = 0, WORD = sizeof(double) };

/* Who makes the file has its head and the domain written by the library; what comes behind them are
 * records, each a time and the variables one behind the other, which all write side by side. */
struct exodus_fields {
    struct exodus_layout layout;
    struct exodus_file file; /* its maker's */
    int descriptor;
    int failure; /* errno of the first write that failed */
    /* Numbers that go behind each other, as the file has them. */
    int64_t at, count;
    uint64_t *waiting; /* [WAITING] */
};
enum { WAITING = 1 << 15 };

static uint64_t swapped(double value)
{
    uint64_t word;
    memcpy(&word, &value, sizeof word);
    return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? __builtin_bswap64(word) : word;
}

static void flush(struct exodus_fields *fields)
{
    if (fields->failure == 0 && !spool_write_at(fields->descriptor, fields->waiting,
                                                (size_t)fields->count * WORD, fields->at))
        fields->failure = errno;
    fields->count = 0;
}

static void put(struct exodus_fields *fields, int64_t at, int64_t count, const double *values)
{
    for (int64_t i = 0; i < count; i++, at += WORD) {
        if (fields->count == WAITING || at != fields->at + fields->count * WORD) flush(fields);
        if (fields->count == 0) fields->at = at;
        fields->waiting[fields->count++] = swapped(values[i]);
    }
}

struct exodus_fields *exodus_fields_join(const struct exodus_layout *layout)
{
    struct exodus_fields *fields = memory_new(1, sizeof *fields);
    fields->layout = *layout;
    fields->waiting = memory_new(WAITING, sizeof *fields->waiting);
    spool_outlive_limits();
    fields->descriptor = open(layout->path, O_WRONLY | O_CLOEXEC);
    if (fields->descriptor < 0)
        die_run("%s: cannot be opened by all ranks: %s", layout->path, strerror(errno));
    return fields;
}

static void put_variables(const struct exodus_file *file, int count, const char *const names[])
{
    /* The library wants names that it could write to. */
    char **copies = memory_new((size_t)count, sizeof *copies);
    for (int i = 0; i < count; i++) {
        exodus_check_name(file, names[i]);
        copies[i] = memory_text(names[i]);
    }
    exodus_wrote(file, ex_put_variable_param(file->id, EX_NODAL, count), "the variables");
    exodus_wrote(file, ex_put_variable_names(file->id, EX_NODAL, count, copies),
                 "the variables' names");
    for (int i = 0; i < count; i++) free(copies[i]);
    free(copies);
}

struct exodus_fields *exodus_fields_open(const struct spool *output, const struct domain *domain,
                                         int n_variables, const char *const names[])
{
    struct exodus_file file = exodus_create(output, &domain->attributes);
    exodus_define_domain(&file, domain);
    put_variables(&file, n_variables, names);
    exodus_put_nodes(&file, domain);
    exodus_let_go(&file);
    struct exodus_layout layout = {.n_nodes = domain->n_nodes, .n_variables = n_variables};
    layout.records = exodus_variable_place(file.path, file.shown, "time_whole");
    /* Another process of this machine finds an unnamed file there, too. */
    const char *own = "/proc/self/";
    const bool unnamed = strncmp(file.path, own, strlen(own)) == 0;
    char *path = unnamed ? memory_print("/proc/%ld/%s", (long)getpid(), file.path + strlen(own))
                         : memory_text(file.path);
    if (strlen(path) >= sizeof layout.path) die_run("%s: too long a name", path);
    strcpy(layout.path, path);
    free(path);
    struct exodus_fields *fields = exodus_fields_join(&layout);
    fields->file = file;
    return fields;
}

const struct exodus_layout *exodus_fields_layout(const struct exodus_fields *fields)
{
    return &fields->layout;
}

static int64_t record_of(const struct exodus_layout *layout, int64_t frame)
{
    return layout->records + frame * WORD * (1 + layout->n_variables * layout->n_nodes);
}

void exodus_fields_put(struct exodus_fields *fields, int64_t frame, int variable, int64_t first,
                       int64_t count, const double *values)
{
    const struct exodus_layout *layout = &fields->layout;
    put(fields, record_of(layout, frame) + WORD * (1 + variable * layout->n_nodes + first), count,
        values);
}

int exodus_fields_sync(struct exodus_fields *fields)
{
    flush(fields);
    if (fields->failure == 0 && fsync(fields->descriptor) != 0 && errno != EINVAL && errno != EROFS)
        fields->failure = errno;
    return fields->failure;
}

void exodus_fields_end(struct exodus_fields *fields, double time, int failure)
{
    struct exodus_layout *layout = &fields->layout;
    if (fields->failure == 0) fields->failure = failure;
    put(fields, record_of(layout, layout->frames), 1, &time);
    flush(fields);
    if (fields->failure == 0)
        exodus_set_records(layout->path, fields->file.shown, layout->frames + 1);
    if (exodus_fields_sync(fields) != 0)
        die_run("%s: cannot write a frame: %s", fields->file.shown, strerror(fields->failure));
    layout->frames++;
}

void exodus_fields_write(struct exodus_fields *fields, double time, const double *const values[])
{
    const struct exodus_layout *layout = &fields->layout;
    for (int i = 0; i < layout->n_variables; i++)
        exodus_fields_put(fields, layout->frames, i, 0, layout->n_nodes, values[i]);
    exodus_fields_end(fields, time, 0);
}

void exodus_fields_close(struct exodus_fields *fields)
{
    if (fields == NULL) return;
    close(fields->descriptor);
    if (fields->file.path) exodus_finish(&fields->file);
    free(fields->waiting);
    free(fields);
}

int64_t exodus_fields_count(const struct exodus_fields *fields)
{
    return fields->layout.frames;
}

static bool is_alike(const struct exodus_layout *layout, const struct exodus_file *other,
                     int64_t frames)
{
    int n_variables = 0;
    return ex_get_variable_param(other->id, EX_NODAL, &n_variables) >= 0 &&
           n_variables == layout->n_variables &&
           ex_inquire_int(other->id, EX_INQ_NODES) == layout->n_nodes &&
           ex_inquire_int(other->id, EX_INQ_TIME) >= frames;
}

static void take_variable(struct exodus_fields *fields, const struct exodus_file *other,
                          int64_t frame, int variable)
{
    const int64_t n = fields->layout.n_nodes;
    double *some = memory_new(WAITING, sizeof *some);
    for (int64_t first = 0; first < n; first += WAITING) {
        const int64_t count = n - first < WAITING ? n - first : WAITING;
        exodus_read(other,
                    ex_get_partial_var(other->id, (int)frame + 1, EX_NODAL, variable + 1, UNUSED_ID,
                                       first + 1, count, some),
                    "a frame");
        exodus_fields_put(fields, frame, variable, first, count, some);
    }
    free(some);
}

bool exodus_fields_take(struct exodus_fields *fields, const char *name, int64_t frames)
{
    const struct spool input = {.descriptor = -1, .path = (char *)(uintptr_t)name};
    if (access(name, R_OK) != 0) return false;
    struct exodus_file other = exodus_open_any(&input);
    const bool alike = is_alike(&fields->layout, &other, frames);
    for (int64_t frame = 0; alike && frame < frames; frame++) {
        double time;
        for (int i = 0; i < fields->layout.n_variables; i++)
            take_variable(fields, &other, frame, i);
        exodus_read(&other, ex_get_time(other.id, (int)frame + 1, &time), "a frame's time");
        exodus_fields_end(fields, time, 0);
    }
    exodus_close(&other);
    return alike;
}
