#include "cores.h"

#include "die.h"
#include "memory.h"
#include "output.h"
#include "spool.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char magic[] = "hstools-cores 1";
static const char *const shapes[] = {"cell", "sphere"};
enum { LONGEST_FILE = 2000000000 };

void cores_write(const struct cores *cores, const char *topology, const char *path)
{
    struct output output = output_open(path);
    fprintf(output.stream, "%s\n", magic);
    fprintf(output.stream, "topology %s\n", topology);
    fprintf(output.stream, "core %s\n", shapes[cores->shape]);
    const struct cores_box *box = &cores->box;
    fprintf(output.stream, "size_m %.17g %.17g %.17g\n", box->size[0], box->size[1], box->size[2]);
    char axes[4];
    if (*cores_axes(box, axes)) fprintf(output.stream, "periodic %s\n", axes);
    fprintf(output.stream, "distance_m %.17g\n", cores->distance);
    fprintf(output.stream, "count %lld\n", (long long)cores->own);
    for (int64_t c = 0; c < cores->own; c++)
        fprintf(output.stream, "%.17g %.17g %.17g %lld\n", cores->centre[c][0], cores->centre[c][1],
                cores->centre[c][2], (long long)cores->order[c]);
    output_close(&output);
}

/* A text walked line by line; the messages need the number. */
struct lines {
    const char *path;
    char *rest;
    int64_t number;
};

static const char *next_line(struct lines *lines, const char *expected)
{
    lines->number++;
    if (!lines->rest || !*lines->rest)
        die_user("%s:%lld: the file ends, expected %s", lines->path, (long long)lines->number,
                 expected);
    char *line = lines->rest;
    lines->rest = strchr(line, '\n');
    if (lines->rest) *lines->rest++ = '\0';
    return line;
}

static _Noreturn void refuse(const struct lines *lines, const char *line, const char *expected)
{
    die_user("%s:%lld: found '%.60s', expected %s", lines->path, (long long)lines->number, line,
             expected);
}

static void read_choice(struct lines *lines, const char *key, const char *value)
{
    char *expected = memory_print("%s %s", key, value);
    const char *line = next_line(lines, expected);
    if (strcmp(line, expected) != 0) refuse(lines, line, expected);
    free(expected);
}

/* "key number number ..." */
static void read_numbers(struct lines *lines, const char *key, int count, double *values)
{
    const char *line = next_line(lines, key);
    size_t length = strlen(key);
    if (strncmp(line, key, length) != 0) refuse(lines, line, key);
    const char *rest = line + length;
    for (int i = 0; i < count; i++) {
        char *end;
        values[i] = strtod(rest, &end);
        if (end == rest || !isfinite(values[i])) refuse(lines, line, "finite numbers");
        rest = end;
    }
    if (*rest) refuse(lines, line, "no more on the line");
}

/* "periodic xz", where there is such a line. */
static void read_periodic(struct lines *lines, struct cores_box *box)
{
    if (!lines->rest || strncmp(lines->rest, "periodic ", strlen("periodic ")) != 0) return;
    const char *line = next_line(lines, "periodic"), *names = line + strlen("periodic ");
    char axes[4];
    for (int axis = 0; axis < 3; axis++) {
        box->periodic[axis] = strchr(names, "xyz"[axis]) != NULL;
        if (box->periodic[axis] && !(box->size[axis] > 0))
            refuse(lines, line, "axes along which the size is positive");
    }
    if (*names == '\0' || strcmp(cores_axes(box, axes), names) != 0)
        refuse(lines, line, "axes in their order, such as xyz or xz");
}

static void read_head(struct lines *lines, const char *topology, struct cores *cores)
{
    const char *line = next_line(lines, magic);
    if (strcmp(line, magic) != 0) refuse(lines, line, magic);
    read_choice(lines, "topology", topology);
    line = next_line(lines, "core cell, or core sphere");
    cores->shape = strcmp(line, "core sphere") == 0 ? CORE_SPHERE : CORE_CELL;
    if (cores->shape == CORE_CELL && strcmp(line, "core cell") != 0)
        refuse(lines, line, "core cell, or core sphere");
    read_numbers(lines, "size_m ", 3, cores->box.size);
    read_periodic(lines, &cores->box);
    read_numbers(lines, "distance_m ", 1, &cores->distance);
    double count;
    read_numbers(lines, "count ", 1, &count);
    double longest = lines->rest ? (double)strlen(lines->rest) / 8 + 1 : 0;
    /* Each core takes 8 characters at least: a wrong count cannot ask for endless memory. */
    if (count < 1 || count != floor(count) || count > longest)
        die_user("%s:%lld: the count does not fit the file", lines->path, (long long)lines->number);
    if (!(cores->distance > 0)) die_user("%s: distance_m must be positive", lines->path);
    cores->count = (int64_t)count;
}

/* The whole file; standard input belongs to the deck. */
static char *read_text(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0) die_user("cannot read the cores %s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode) || status.st_size > LONGEST_FILE)
        die_user("%s: cores are read from a file of at most %d bytes", path, LONGEST_FILE);
    long length;
    return spool_text(path, (long)status.st_size, &length);
}

struct cores cores_read(const char *path, const char *topology)
{
    char *text = read_text(path);
    struct lines lines = {.path = path, .rest = text};
    struct cores cores = {0};
    read_head(&lines, topology, &cores);
    cores.centre = memory_new((size_t)cores.count, sizeof *cores.centre);
    cores.order = memory_new((size_t)cores.count, sizeof *cores.order);
    for (int64_t c = 0; c < cores.count; c++) {
        double values[4];
        read_numbers(&lines, "", 4, values);
        for (int axis = 0; axis < 3; axis++) {
            cores.centre[c][axis] = values[axis];
            if (fabs(values[axis]) > 0.5 * cores.box.size[axis] + 100 * cores.distance)
                die_user("%s:%lld: the centre is more than 100 distances from the body", path,
                         (long long)lines.number);
        }
        if (values[3] < 0 || values[3] >= (double)cores.count || values[3] != floor(values[3]))
            die_user("%s:%lld: found the order %g, expected 0 to %lld", path,
                     (long long)lines.number, values[3], (long long)cores.count - 1);
        cores.order[c] = (int64_t)values[3];
    }
    free(text);
    cores_finish(&cores, CORES_REACH * cores.distance);
    return cores;
}
