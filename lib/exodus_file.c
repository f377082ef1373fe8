#include "exodus_file.h"

#include "die.h"
#include "exodus.h"
#include "memory.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define PREFIX           "hs_"
#define LENGTH_ATTRIBUTE PREFIX "file_bytes"

const char *exodus_library(void)
{
    static char text[64];
    /* netCDF's text goes on with the date of its build. */
    int length = (int)strcspn(nc_inq_libvers(), " ");
    snprintf(text, sizeof text, "Exodus %.2f, netCDF %.*s", (double)EX_API_VERS, length,
             nc_inq_libvers());
    return text;
}

/* What Exodus returns where it fails, and where it only warns (an empty set, say). */
enum { FAILED = -1, WARNED = 1 };

/* --- checks ----------------------------------------------------------------------------------- */

/* Exodus returns -1 and keeps the reason, netCDF returns the reason; positive is a warning. */
static const char *reason(int status)
{
    const char *message, *function;
    int code = status;
    if (status == FAILED) ex_get_err(&message, &function, &code);
    return code == 0 ? "unknown reason" : nc_strerror(code);
}

void exodus_wrote(const struct exodus_file *file, int status, const char *what)
{
    if (status < 0 || status > WARNED)
        die_run("%s: cannot write %s: %s", file->shown, what, reason(status));
}

void exodus_read(const struct exodus_file *file, int status, const char *what)
{
    if (status < 0 || status > WARNED)
        die_user("%s: cannot read %s: %s", file->shown, what, reason(status));
}

void exodus_bound(const struct exodus_file *file, int64_t count, int64_t size, const char *what)
{
    /* Deflate packs 1032 bytes into one at best (zlib's technical details, on its compression
     * factor). */
    const int64_t bytes = file->packed ? 1032 * file->bytes : file->bytes;
    if (count < 0 || count > bytes / size)
        die_user("%s: damaged: %lld %s cannot be in %lld bytes", file->shown, (long long)count,
                 what, (long long)file->bytes);
}

void exodus_check_name(const struct exodus_file *file, const char *name)
{
    if (strlen(name) > EXODUS_NAME)
        die_run("%s: name '%s' is longer than %d characters", file->shown, name, EXODUS_NAME);
}

const char *exodus_phase_fault(const char *name)
{
    enum { MOST = 45 }; /* "_plastic_strain" and the like stand behind it */
    for (const char *c = name; *c; c++)
        if ((unsigned char)*c < ' ' || *c == '/' || *c == '\177')
            return "has a '/' or a control character, which names in the files cannot have";
    if (*name == ' ' || (*name && name[strlen(name) - 1] == ' '))
        return "begins or ends with a blank";
    return strlen(name) > MOST ? "is longer than 45 bytes, which names in the files cannot be"
                               : NULL;
}

char **exodus_names(int64_t count)
{
    size_t number = (size_t)count, pointers = number * sizeof(char *);
    char **names = memory_new(pointers + number * (EXODUS_NAME + 1), 1);
    for (size_t i = 0; i < number; i++) names[i] = (char *)names + pointers + i * (EXODUS_NAME + 1);
    return names;
}

static int64_t file_size(const struct exodus_file *file)
{
    struct stat status;
    if (stat(file->path, &status) != 0) die_run("%s: cannot find out its length", file->shown);
    return status.st_size;
}

/* --- attributes ------------------------------------------------------------------------------- */

static void put_attributes(const struct exodus_file *file, const struct attributes *attributes)
{
    double unknown = 0;
    int status = nc_redef(file->id);
    exodus_wrote(file, status == NC_EINDEFINE ? NC_NOERR : status, "the header");
    exodus_wrote(file,
                 nc_put_att_double(file->id, NC_GLOBAL, LENGTH_ATTRIBUTE, NC_DOUBLE, 1, &unknown),
                 LENGTH_ATTRIBUTE);
    for (int i = 0; i < attributes->count; i++) {
        const struct attribute *item = &attributes->items[i];
        char *name = memory_print(PREFIX "%s", item->name);
        status = item->text != NULL
                     ? nc_put_att_text(file->id, NC_GLOBAL, name, strlen(item->text), item->text)
                     : nc_put_att_double(file->id, NC_GLOBAL, name, NC_DOUBLE, 1, &item->number);
        exodus_wrote(file, status, name);
        free(name);
    }
    exodus_wrote(file, nc_enddef(file->id), "the header");
}

static void read_attribute(const struct exodus_file *file, const char *name, struct attributes *all)
{
    nc_type type;
    size_t length;
    exodus_read(file, nc_inq_att(file->id, NC_GLOBAL, name, &type, &length), "an attribute");
    exodus_bound(file, (int64_t)length, 1, "characters of an attribute");
    if (type == NC_CHAR) {
        char *text = memory_new(length + 1, 1);
        exodus_read(file, nc_get_att_text(file->id, NC_GLOBAL, name, text), "an attribute");
        attributes_set_text(all, name + strlen(PREFIX), text);
        free(text);
    } else if (type == NC_DOUBLE && length == 1) {
        double number;
        exodus_read(file, nc_get_att_double(file->id, NC_GLOBAL, name, &number), "an attribute");
        attributes_set_number(all, name + strlen(PREFIX), number);
    }
}

struct attributes exodus_read_attributes(const struct exodus_file *file)
{
    struct attributes attributes = {0};
    int count;
    exodus_read(file, nc_inq_natts(file->id, &count), "the attributes");
    for (int i = 0; i < count; i++) {
        char name[NC_MAX_NAME + 1];
        exodus_read(file, nc_inq_attname(file->id, NC_GLOBAL, i, name), "an attribute");
        if (strncmp(name, PREFIX, strlen(PREFIX)) == 0 && strcmp(name, LENGTH_ATTRIBUTE) != 0)
            read_attribute(file, name, &attributes);
    }
    return attributes;
}

/* For other readers of Exodus: who wrote the file, by what command.  No date: the same deck is to
 * give the same bytes. */
static void put_provenance(const struct exodus_file *file, const struct attributes *attributes)
{
    char program[MAX_STR_LENGTH + 1] = "hstools", version[MAX_STR_LENGTH + 1] = "", none[] = "";
    const char *line = attributes_text(attributes, "program");
    const char *command = attributes_text(attributes, "command");
    if (line != NULL) sscanf(line, "%32s %32s", program, version);
    char *record[1][4] = {{program, version, none, none}};
    exodus_wrote(file, ex_put_qa(file->id, 1, record), "the QA record");
    if (command == NULL || *command == '\0') return;
    size_t length = strlen(command), count = (length + MAX_LINE_LENGTH - 1) / MAX_LINE_LENGTH;
    char **lines = memory_new(count, sizeof *lines);
    for (size_t i = 0; i < count; i++)
        lines[i] = memory_print("%.*s", (int)MAX_LINE_LENGTH, command + i * MAX_LINE_LENGTH);
    exodus_wrote(file, ex_put_info(file->id, (int)count, lines), "the command line");
    for (size_t i = 0; i < count; i++) free(lines[i]);
    free(lines);
}

/* Where HDF5 has no memory to start in it ends by a signal; with this much it starts. */
static void room_to_start(void)
{
    free(memory_new(2, 1 << 20));
}

/* --- files ------------------------------------------------------------------------------------ */

struct exodus_file exodus_create(const struct spool *output, const struct attributes *attributes)
{
    int memory_word = sizeof(double), file_word = sizeof(double);
    struct exodus_file file = {.path = memory_text(output->path)};
    file.shown = memory_text(output->shown   ? output->shown
                             : output->final ? output->final
                                             : "standard output");
    ex_opts(0);
    room_to_start();
    file.id = ex_create(file.path, EX_CLOBBER | EX_LARGE_MODEL | EX_ALL_INT64_API, &memory_word,
                        &file_word);
    exodus_wrote(&file, file.id < 0 ? FAILED : 0, "the beginning");
    ex_set_max_name_length(file.id, EXODUS_NAME);
    put_attributes(&file, attributes);
    put_provenance(&file, attributes);
    return file;
}

void exodus_sync(const struct exodus_file *file)
{
    exodus_wrote(file, ex_update(file->id), "what is new");
    spool_sync(file->path, file->shown);
}

void exodus_renew_numbers(const struct exodus_file *file, const struct attributes *attributes)
{
    for (int i = 0; i < attributes->count; i++) {
        const struct attribute *item = &attributes->items[i];
        if (item->text) continue;
        char *name = memory_print(PREFIX "%s", item->name);
        exodus_wrote(
            file, nc_put_att_double(file->id, NC_GLOBAL, name, NC_DOUBLE, 1, &item->number), name);
        free(name);
    }
}

static void enter_length(const struct exodus_file *file)
{
    int id;
    double bytes = (double)file_size(file);
    /* An attribute that keeps its size is rewritten in place. */
    exodus_wrote(file, nc_open(file->path, NC_WRITE, &id), "its length");
    exodus_wrote(file, nc_put_att_double(id, NC_GLOBAL, LENGTH_ATTRIBUTE, NC_DOUBLE, 1, &bytes),
                 "its length");
    exodus_wrote(file, nc_close(id), "its length");
    if ((double)file_size(file) != bytes)
        die_run("%s: changed while it was closed: does another program write to it?", file->shown);
}

static void forget(struct exodus_file *file)
{
    free(file->path);
    free(file->shown);
}

void exodus_let_go(struct exodus_file *file)
{
    exodus_wrote(file, ex_close(file->id), "the end");
    file->id = -1;
}

void exodus_finish(struct exodus_file *file)
{
    if (file->id >= 0) exodus_let_go(file);
    spool_release(file->path);
    enter_length(file);
    forget(file);
}

/* The form of netCDF that these tools write; a copy in another one has another length. */
static bool is_own_form(const struct exodus_file *file)
{
    int form = 0;
    exodus_read(file, nc_inq_format(file->id, &form), "its form");
    return form == NC_FORMAT_64BIT_OFFSET;
}

static void check_length(const struct exodus_file *file, bool foreign)
{
    nc_type type;
    size_t length;
    double bytes = 0;
    const bool own = is_own_form(file);
    if (!own && foreign) return;
    if (!own)
        die_user("%s: netCDF of a form (ncdump -k) that these tools do not write; if it is a copy "
                 "of one of theirs: nccopy -k 64-bit-offset IN OUT",
                 file->shown);
    if (nc_inq_att(file->id, NC_GLOBAL, LENGTH_ATTRIBUTE, &type, &length) != NC_NOERR) {
        if (foreign) return;
        die_user("%s: not written by these tools: no attribute " LENGTH_ATTRIBUTE, file->shown);
    }
    if (type == NC_DOUBLE && length == 1)
        exodus_read(file, nc_get_att_double(file->id, NC_GLOBAL, LENGTH_ATTRIBUTE, &bytes),
                    LENGTH_ATTRIBUTE);
    if (bytes == 0)
        die_user(
            "%s: was never finished by the program that wrote it (hssolve --repair gives back what "
            "is whole in it)",
            file->shown);
    if (bytes != (double)file->bytes)
        die_user("%s: truncated or damaged: it has %lld bytes, and had %.0f when it was finished%s",
                 file->shown, (long long)file->bytes, bytes,
                 ex_inquire_int(file->id, EX_INQ_TIME) > 0
                     ? "; hssolve --repair gives back what is whole in it"
                     : "");
}

/* All that a file of netCDF-4 has, wherever it leads. */
static void touch(const char *path)
{
    int id, count = 0, global = 0;
    if (nc_open(path, NC_NOWRITE, &id) != NC_NOERR) return;
    nc_inq(id, NULL, &count, &global, NULL);
    for (int v = NC_GLOBAL; v < count; v++) {
        int rank = 0, attributes = v == NC_GLOBAL ? global : 0, dimensions[NC_MAX_VAR_DIMS];
        nc_type type = 0;
        size_t all = sizeof(double), length;
        char name[NC_MAX_NAME + 1];
        if (v != NC_GLOBAL && nc_inq_var(id, v, name, &type, &rank, dimensions, &attributes))
            continue;
        for (int a = 0; a < attributes; a++)
            if (nc_inq_attname(id, v, a, name) == NC_NOERR) nc_inq_att(id, v, name, &type, &length);
        for (int d = 0; d < rank; d++)
            all *= nc_inq_dimlen(id, dimensions[d], &length) == NC_NOERR ? length : 0;
        void *values = v == NC_GLOBAL ? NULL : malloc(all);
        if (values) nc_get_var(id, v, values);
        free(values);
    }
}

/* libnetcdf 4.9 ends by a signal, or never, at some damaged files of HDF5: a child looks at such a
 * file first. */
static bool is_sound(const char *path)
{
    enum { LONGEST = 20 }; /* s */
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        /* The end is what is asked for: nobody's handler is to go on here. */
        static const int ends[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM};
        for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) signal(ends[i], SIG_DFL);
        if (!freopen("/dev/null", "w", stderr)) _exit(EXIT_FAILURE);
        alarm(LONGEST);
        touch(path);
        _exit(EXIT_SUCCESS);
    }
    if (child > 0) waitpid(child, &status, 0);
    return status == 0;
}

static int open_to_read(const char *path)
{
    int memory_word = sizeof(double), file_word = 0;
    float version;
    room_to_start();
    ex_opts(0);
    return ex_open(path, EX_READ | EX_ALL_INT64_API, &memory_word, &file_word, &version);
}

/* HDF5 follows links to names, of which what comes through a pipe has none. */
static int open_packed(const struct exodus_file *file, bool piped)
{
    char *folder = piped ? spool_folder() : NULL,
         *path = piped ? spool_copy(file->path, folder) : memory_text(file->path);
    const bool sound = is_sound(path);
    const int id = sound ? open_to_read(path) : -1;
    if (piped) spool_remove_folder(folder);
    free(path);
    if (!sound) die_user("%s: damaged: netCDF fails to read it", file->shown);
    return id;
}

struct exodus_file exodus_open_any(const struct spool *input)
{
    struct exodus_file file = {.path = memory_text(input->path)};
    bool piped = strncmp(input->path, "/proc/", strlen("/proc/")) == 0;
    file.shown = memory_text(piped ? "standard input" : input->path);
    file.bytes = file_size(&file);
    file.packed = !exodus_check_header(file.path, file.shown);
    file.id = file.packed ? open_packed(&file, piped) : open_to_read(file.path);
    exodus_read(&file, file.id < 0 ? FAILED : 0, "it as Exodus");
    ex_set_max_name_length(file.id, EXODUS_NAME);
    return file;
}

struct exodus_file exodus_open(const struct spool *input, bool foreign)
{
    struct exodus_file file = exodus_open_any(input);
    check_length(&file, foreign);
    return file;
}

void exodus_close(struct exodus_file *file)
{
    ex_close(file->id);
    forget(file);
}

/* How many records end within the file: where one begins is the place of its first variable. */
static int64_t records_within(const struct exodus_file *file)
{
    int count = 0, unlimited = -1;
    int64_t begin = INT64_MAX, size = 0;
    nc_inq(file->id, NULL, &count, NULL, &unlimited);
    for (int v = 0; v < count; v++) {
        char name[NC_MAX_NAME + 1];
        int rank = 0, dimensions[NC_MAX_VAR_DIMS];
        nc_type type;
        size_t bytes, length;
        nc_inq_var(file->id, v, name, &type, &rank, dimensions, NULL);
        if (rank == 0 || dimensions[0] != unlimited) continue;
        nc_inq_type(file->id, type, NULL, &bytes);
        for (int d = 1; d < rank; d++) {
            nc_inq_dimlen(file->id, dimensions[d], &length);
            bytes *= length;
        }
        const int64_t place = exodus_variable_place(file->path, file->shown, name);
        if (place < begin) begin = place;
        size += ((int64_t)bytes + 3) / 4 * 4;
    }
    return size > 0 && file->bytes > begin ? (file->bytes - begin) / size : 0;
}

/* Records are written one behind the other, and time goes on: what is not so has not reached the
 * disk. */
static int64_t sound_records(const struct exodus_file *file, double *last)
{
    const int64_t records = ex_inquire_int(file->id, EX_INQ_TIME), within = records_within(file);
    int64_t sound = 0;
    exodus_bound(file, records, 8, "records");
    double *time = memory_new((size_t)records, sizeof *time);
    if (records > 0) exodus_read(file, ex_get_all_times(file->id, time), "the times");
    while (sound < records && sound < within && isfinite(time[sound]) &&
           time[sound] < NC_FILL_FLOAT &&
           (sound == 0 || (time[sound] > 0 && time[sound] >= time[sound - 1])))
        sound++;
    if (sound == 0)
        die_user("%s: not one whole record in it: nothing can be given back, run it again",
                 file->shown);
    *last = time[sound - 1];
    free(time);
    return sound;
}

int64_t exodus_repair(const char *name, double *time)
{
    const struct spool input = {.descriptor = -1, .path = (char *)(uintptr_t)name};
    struct exodus_file file = exodus_open_any(&input);
    nc_type type;
    size_t length;
    double bytes = 0;
    if (!is_own_form(&file))
        die_user("%s: netCDF of a form (ncdump -k) that these tools do not write: copy the "
                 "original again",
                 name);
    if (nc_inq_att(file.id, NC_GLOBAL, LENGTH_ATTRIBUTE, &type, &length) != NC_NOERR ||
        type != NC_DOUBLE || length != 1)
        die_user("%s: not written by these tools: no attribute " LENGTH_ATTRIBUTE, name);
    exodus_read(&file, nc_get_att_double(file.id, NC_GLOBAL, LENGTH_ATTRIBUTE, &bytes),
                "its length");
    if (bytes == (double)file.bytes) die_user("%s is whole: there is nothing to repair", name);
    const int64_t sound = sound_records(&file, time);
    ex_close(file.id);
    exodus_set_records(name, name, sound);
    enter_length(&file);
    spool_sync(name, name);
    forget(&file);
    return sound;
}
