#include "taken.h"

#include "die.h"
#include "memory.h"

#include <fcntl.h>
#include <glob.h>
#include <limits.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Of this process, as its open files are. */
static struct {
    int n_inputs, n_outputs;
    struct file {
        uint64_t device, number;      /* which a later file can have again */
        int64_t seconds, nanoseconds; /* of its birth; 0 where a file system does not know */
    } * inputs;
    char **outputs; /* absolute names */
} taken;

/* Of a name, or with an empty one of a descriptor; false where that is no file of a disk. */
static bool find_file(int descriptor, const char *name, struct file *file)
{
    struct statx status = {.stx_mask = 0};
    const int flags = name[0] ? 0 : AT_EMPTY_PATH;
    if (statx(descriptor, name, flags, STATX_BASIC_STATS | STATX_BTIME, &status) != 0) return false;
    const bool born = status.stx_mask & STATX_BTIME;
    *file = (struct file){.device = (uint64_t)status.stx_dev_major << 32 | status.stx_dev_minor,
                          .number = status.stx_ino,
                          .seconds = born ? status.stx_btime.tv_sec : 0,
                          .nanoseconds = born ? status.stx_btime.tv_nsec : 0};
    return S_ISREG(status.stx_mode);
}

static bool is_same(const struct file *a, const struct file *b)
{
    return a->device == b->device && a->number == b->number && a->seconds == b->seconds &&
           a->nanoseconds == b->nanoseconds;
}

bool taken_are_one(const char *name, const char *other)
{
    struct file a, b;
    return find_file(AT_FDCWD, name, &a) && find_file(AT_FDCWD, other, &b) && is_same(&a, &b);
}

void taken_as_input(int descriptor)
{
    struct file file;
    if (!find_file(descriptor, "", &file)) return;
    taken.inputs = memory_grow(taken.inputs, taken.n_inputs, sizeof *taken.inputs);
    taken.inputs[taken.n_inputs++] = file;
}

/* Where a file is, or is going to be; a folder that is not there is told by who opens it. */
static char *place_of(const char *name)
{
    char *there = realpath(name, NULL);
    if (there) return there;
    const char *end = strrchr(name, '/');
    char *folder = memory_folder(name), *real = realpath(folder, NULL),
         *place = memory_print("%s/%s", real ? real : folder, end ? end + 1 : name);
    free(real);
    free(folder);
    return place;
}

static bool is_input(const char *name)
{
    struct file file;
    if (!find_file(AT_FDCWD, name, &file)) return false;
    for (int i = 0; i < taken.n_inputs; i++)
        if (is_same(&taken.inputs[i], &file)) return true;
    return false;
}

/* A name with nothing in it that a pattern could mean. */
static char *literal(const char *name)
{
    char *pattern = memory_new(2 * strlen(name) + 1, 1), *to = pattern;
    for (; *name; *to++ = *name++)
        if (strchr("*?[\\", *name)) *to++ = '\\';
    return pattern;
}

/* Outputs that are not finished carry the number of their process. */
static void look_for_others(const char *place, const char *name)
{
    glob_t found;
    char *fixed = literal(place), *pattern = memory_print("%s.partial-*", fixed);
    if (glob(pattern, GLOB_NOSORT, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc; i++) {
            const long process = strtol(strrchr(found.gl_pathv[i], '-') + 1, NULL, 10);
            if (process > 0 && process != (long)getpid() && kill((pid_t)process, 0) == 0)
                warn("process %ld is writing %s, too: what ends last stays", process, name);
        }
        globfree(&found);
    }
    free(pattern);
    free(fixed);
}

/* Dies where one of these places is that of name. */
static void refuse_second(const char *place, char *const places[], int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (places[i] && strcmp(places[i], place) == 0)
            die_user("two outputs are called %s: give each a name of its own", name);
}

/* Standard output, pipes and devices take any number of outputs. */
static bool is_file(const char *name)
{
    struct stat status;
    return strcmp(name, "-") != 0 && (stat(name, &status) != 0 || S_ISREG(status.st_mode));
}

static void refuse_input(const char *place, const char *name)
{
    if (is_input(place))
        die_user("%s is an input, which would be overwritten: give the output another name", name);
}

void taken_check(const char *const names[], int count)
{
    char **places = memory_new((size_t)count, sizeof *places);
    for (int i = 0; i < count; i++) {
        if (!names[i] || !is_file(names[i])) continue;
        places[i] = place_of(names[i]);
        refuse_input(places[i], names[i]);
        refuse_second(places[i], places, i, names[i]);
    }
    for (int i = 0; i < count; i++) free(places[i]);
    free(places);
}

void taken_as_output(const char *name)
{
    char *place = place_of(name);
    refuse_input(place, name);
    refuse_second(place, taken.outputs, taken.n_outputs, name);
    look_for_others(place, name);
    taken.outputs = memory_grow(taken.outputs, taken.n_outputs, sizeof *taken.outputs);
    taken.outputs[taken.n_outputs++] = place;
}

void taken_again(const char *name)
{
    char *place = place_of(name);
    for (int i = 0; i < taken.n_outputs; i++) {
        if (strcmp(taken.outputs[i], place) != 0) continue;
        free(taken.outputs[i]);
        taken.outputs[i] = taken.outputs[--taken.n_outputs];
    }
    free(place);
}

void taken_forget(void)
{
    for (int i = 0; i < taken.n_outputs; i++) free(taken.outputs[i]);
    free(taken.outputs);
    free(taken.inputs);
    taken.n_inputs = taken.n_outputs = 0;
    taken.inputs = NULL;
    taken.outputs = NULL;
}
