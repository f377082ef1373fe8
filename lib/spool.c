#include "spool.h"

#include "die.h"
#include "memory.h"
#include "taken.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_OUTPUTS = 16, CHUNK = 1 << 18 };

/* --- unfinished files ------------------------------------------------------------------------- */

/* What has to go when the process dies, but not when a child of it does; read in signal handlers,
 * too. */
static struct {
    char *volatile path;
    pid_t owner;
} unfinished[MOST_OUTPUTS];

static void remove_unfinished(void)
{
    for (int i = 0; i < MOST_OUTPUTS; i++)
        if (unfinished[i].path != NULL && unfinished[i].owner == getpid())
            unlink(unfinished[i].path);
}

static void keep_track(char *path)
{
    for (int i = 0; i < MOST_OUTPUTS; i++) {
        if (unfinished[i].path != NULL) continue;
        unfinished[i].owner = getpid();
        unfinished[i].path = path;
        die_at_exit(remove_unfinished);
        die_at_signals(remove_unfinished);
        return;
    }
    die_run("more than %d output files at once", MOST_OUTPUTS);
}

static void lose_track(const char *path)
{
    for (int i = 0; i < MOST_OUTPUTS; i++)
        if (unfinished[i].path == path) unfinished[i].path = NULL;
}

/* --- copying ---------------------------------------------------------------------------------- */

static bool is_standard(const char *name)
{
    return name == NULL || strcmp(name, "-") == 0;
}

static const char *temporary_directory(void)
{
    const char *directory = getenv("TMPDIR");
    return directory != NULL && *directory != '\0' ? directory : "/tmp";
}

/* An unlinked file: nothing to clean up, whatever happens. */
static int temporary_file(void)
{
    const char *directory = temporary_directory();
    int descriptor = open(directory, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor >= 0) return descriptor;
    /* Some file systems (NFS) do not know O_TMPFILE. */
    char *path = memory_print("%s/hstools-XXXXXX", directory);
    descriptor = mkostemp(path, O_CLOEXEC);
    if (descriptor < 0)
        die_run("cannot make a temporary file in %s: %s (set TMPDIR)", directory, strerror(errno));
    unlink(path);
    free(path);
    return descriptor;
}

char *spool_folder(void)
{
    char *path = memory_print("%s/hstools-XXXXXX", temporary_directory());
    if (!mkdtemp(path))
        die_run("cannot make a folder in %s: %s (set TMPDIR)", temporary_directory(),
                strerror(errno));
    return path;
}

static int remove_entry(const char *path, const struct stat *status, int kind, struct FTW *place)
{
    (void)status, (void)kind, (void)place;
    remove(path);
    return 0;
}

void spool_remove_folder(char *path)
{
    enum { MOST_OPEN = 16 };
    nftw(path, remove_entry, MOST_OPEN, FTW_DEPTH | FTW_PHYS);
    free(path);
}

static char *descriptor_path(int descriptor)
{
    return memory_print("/proc/self/fd/%d", descriptor);
}

/* Up to count bytes, fewer only at the end of the input. */
static size_t read_fully(int from, char *bytes, size_t count, const char *name)
{
    size_t done = 0;
    while (done < count) {
        ssize_t got = read(from, bytes + done, count - done);
        if (got == 0) break;
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) die_run("cannot read %s: %s", name, strerror(errno));
        done += (size_t)got;
    }
    return done;
}

/* False where it cannot: errno. */
static bool write_all(int to, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t put = write(to, bytes, count);
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return false;
        bytes += put;
        count -= (size_t)put;
    }
    return true;
}

bool spool_write_at(int descriptor, const void *bytes, size_t count, int64_t at)
{
    const char *from = bytes;
    while (count > 0) {
        const ssize_t put = pwrite(descriptor, from, count, at);
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return false;
        from += put;
        at += put;
        count -= (size_t)put;
    }
    return true;
}

static void write_fully(int to, const char *bytes, size_t count, const char *name)
{
    if (!write_all(to, bytes, count)) die_run("cannot write %s: %s", name, strerror(errno));
}

static size_t copy(int from, const char *from_name, int to, const char *to_name)
{
    char *chunk = memory_new(CHUNK, 1);
    size_t total = 0, got;
    while ((got = read_fully(from, chunk, CHUNK, from_name)) > 0) {
        write_fully(to, chunk, got, to_name);
        total += got;
    }
    free(chunk);
    return total;
}

/* From a temporary file. */
static void copy_file(const char *from, const char *to, const char *shown)
{
    const int read = open(from, O_RDONLY | O_CLOEXEC),
              written = open(to, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (read < 0 || written < 0) die_run("cannot copy to %s: %s", shown, strerror(errno));
    copy(read, "a temporary file", written, shown);
    close(read);
    if (close(written) != 0) die_run("cannot write %s: %s", shown, strerror(errno));
}

char *spool_copy(const char *path, const char *folder)
{
    char *to = memory_print("%s/copy", folder);
    copy_file(path, to, to);
    return to;
}

/* --- inputs ----------------------------------------------------------------------------------- */

static int open_input(const char *name, const char *shown)
{
    int descriptor = is_standard(name) ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)
                                       : open(name, O_RDONLY | O_CLOEXEC);
    struct stat status;
    if (descriptor < 0 || fstat(descriptor, &status) != 0)
        die_user("cannot open %s: %s", shown, strerror(errno));
    if (S_ISDIR(status.st_mode)) die_user("%s is a directory, expected a file", shown);
    if (isatty(descriptor)) die_user("%s is a terminal, expected a file or a pipe", shown);
    taken_as_input(descriptor);
    return descriptor;
}

static const char *input_name(const char *name)
{
    return is_standard(name) ? "standard input" : name;
}

struct spool spool_input(const char *name)
{
    const char *shown = input_name(name);
    struct spool spool = {.descriptor = open_input(name, shown)};
    struct stat status;
    spool.path = descriptor_path(spool.descriptor);
    bool seekable = fstat(spool.descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                    lseek(spool.descriptor, 0, SEEK_CUR) == 0 && access(spool.path, R_OK) == 0;
    if (seekable && status.st_size == 0) die_user("%s is empty", shown);
    if (!is_standard(name) && seekable) {
        close(spool.descriptor);
        free(spool.path);
        return (struct spool){.descriptor = -1, .path = memory_text(name)};
    }
    if (seekable) return spool;
    int temporary = temporary_file();
    if (copy(spool.descriptor, shown, temporary, "a temporary file") == 0)
        die_user("%s is empty (did the program before it fail?)", shown);
    close(spool.descriptor);
    free(spool.path);
    return (struct spool){.descriptor = temporary, .path = descriptor_path(temporary)};
}

struct spool spool_bytes(const char *bytes, size_t length)
{
    const int temporary = temporary_file();
    write_fully(temporary, bytes, length, "a temporary file");
    return (struct spool){.descriptor = temporary, .path = descriptor_path(temporary)};
}

char *spool_text(const char *name, long limit, long *length)
{
    const char *shown = input_name(name);
    int descriptor = open_input(name, shown);
    size_t most = (size_t)limit;
    char *text = memory_new(most + 2, 1);
    size_t count = read_fully(descriptor, text, most + 1, shown);
    close(descriptor);
    if (count > most) die_user("%s is larger than %ld bytes", shown, limit);
    *length = (long)count;
    return text;
}

/* --- outputs ---------------------------------------------------------------------------------- */

/* Devices and named pipes cannot be replaced by a new file: they are written to. */
static bool is_stream(const char *name)
{
    struct stat status;
    if (stat(name, &status) != 0) return false;
    if (S_ISDIR(status.st_mode)) die_user("%s is a directory, expected a file name", name);
    return !S_ISREG(status.st_mode);
}

static int open_stream(const char *name)
{
    int descriptor =
        name == NULL ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3) : open(name, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        die_run("cannot open %s: %s", name ? name : "standard output", strerror(errno));
    return descriptor;
}

void spool_outlive_limits(void)
{
    signal(SIGXFSZ, SIG_IGN);
}

void spool_check_output(const char *name)
{
    if (is_standard(name) || is_stream(name)) return;
    char *folder = memory_folder(name);
    if (access(folder, W_OK | X_OK) != 0) die_user("cannot write %s: %s", name, strerror(errno));
    free(folder);
}

void spool_refuse_unread(const struct spool *spool)
{
    struct pollfd stream = {.fd = STDOUT_FILENO, .events = POLLOUT};
    if (spool->descriptor < 0 || spool->final || poll(&stream, 1, 0) <= 0) return;
    if (stream.revents & POLLERR)
        die_run("nobody reads standard output: the program behind the pipe has ended");
}

static struct spool stream_output(const char *name)
{
    /* A parent may have had SIGPIPE ignored; a filter is meant to die of it. */
    signal(SIGPIPE, SIG_DFL);
    int temporary = temporary_file();
    return (struct spool){
        .descriptor = temporary, .path = descriptor_path(temporary), .final = memory_text(name)};
}

struct spool spool_output(const char *name)
{
    spool_outlive_limits();
    if (is_standard(name)) {
        if (isatty(STDOUT_FILENO))
            die_user("no binary data to a terminal: use -o FILE, a pipe or > FILE");
        if (fcntl(STDOUT_FILENO, F_GETFD) < 0) die_user("standard output is closed");
        return stream_output(NULL);
    }
    if (is_stream(name)) return stream_output(name);
    taken_as_output(name);
    /* A symbolic link stays one: the file behind it is replaced. */
    char *behind = realpath(name, NULL);
    struct spool spool = {.descriptor = -1, .final = memory_text(behind ? behind : name)};
    free(behind);
    spool.path = memory_print("%s.partial-%ld", spool.final, (long)getpid());
    int descriptor = open(spool.path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) die_user("cannot write %s: %s", name, strerror(errno));
    close(descriptor);
    keep_track(spool.path);
    return spool;
}

void spool_sync(const char *path, const char *shown)
{
    int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) die_run("cannot open %s: %s", shown, strerror(errno));
    /* What is no file of a disk (EINVAL) cannot be lost by one. */
    if (fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS)
        die_run("cannot write %s to its disk: %s", shown, strerror(errno));
    close(descriptor);
}

/* Some file systems cannot, and lose no name by it. */
void spool_sync_folder(const char *path)
{
    char *folder = memory_folder(path);
    int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
    free(folder);
}

void spool_rename(const char *from, const char *to)
{
    spool_sync(from, to);
    if (rename(from, to) != 0) die_run("cannot rename %s to %s: %s", from, to, strerror(errno));
    spool_sync_folder(to);
}

void spool_reserve(const char *path, const char *shown, int64_t bytes)
{
    struct stat status;
    int descriptor = open(path, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0 || fstat(descriptor, &status) != 0)
        die_run("cannot open %s: %s", shown, strerror(errno));
    if (fallocate(descriptor, FALLOC_FL_KEEP_SIZE, status.st_size, bytes) != 0 &&
        (errno == ENOSPC || errno == EDQUOT))
        die_run("%s: no room for the %.3g MB that are to come: %s", shown, 1e-6 * (double)bytes,
                strerror(errno));
    close(descriptor);
}

void spool_release(const char *path)
{
    struct stat status;
    if (stat(path, &status) == 0 && truncate(path, status.st_size) != 0) return; /* it is no loss */
}

/* To the stream, to the last byte; 0, or the error of that. */
static int pump(const struct spool *spool, int stream)
{
    char *chunk = memory_new(CHUNK, 1);
    bool sound = true;
    size_t got;
    if (lseek(spool->descriptor, 0, SEEK_SET) != 0) die_run("cannot read a temporary file again");
    while (sound && (got = read_fully(spool->descriptor, chunk, CHUNK, "a temporary file")) > 0)
        sound = write_all(stream, chunk, got);
    free(chunk);
    const int failure = sound ? 0 : errno;
    return close(stream) == 0 || failure ? failure : errno;
}

/* A reader that has gone ends this program quietly, as it does any filter; what took long to make
 * is kept before. */
static void send(struct spool *spool)
{
    char *shown = memory_text(spool->final ? spool->final : "standard output");
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    const int stream = open_stream(spool->final);
    sigaction(SIGPIPE, &ignore, &before);
    const int failure = pump(spool, stream);
    sigaction(SIGPIPE, &before, NULL);
    if (failure && spool->precious && spool_keep(spool, spool->precious))
        warn("nobody has read %s to its end: it is kept in %s", shown, spool->precious);
    if (failure == EPIPE && before.sa_handler == SIG_DFL) raise(SIGPIPE);
    if (failure) die_run("cannot write %s: %s", shown, strerror(failure));
    free(shown);
}

void spool_finish(struct spool *spool)
{
    if (spool->descriptor >= 0) {
        send(spool);
    } else {
        lose_track(spool->path); /* it is whole: where it gets no name it stays */
        spool_rename(spool->path, spool->final);
    }
    free(spool->final);
    spool->final = NULL;
    spool_close(spool);
}

bool spool_is_empty(const struct spool *spool)
{
    struct stat status;
    return stat(spool->path, &status) != 0 || status.st_size == 0;
}

bool spool_keep(struct spool *spool, const char *name)
{
    const bool file = strncmp(spool->path, "/proc/", strlen("/proc/")) != 0;
    lose_track(spool->path);
    if (spool_is_empty(spool)) {
        if (file) unlink(spool->path);
        return false;
    }
    if (file) {
        spool_rename(spool->path, name);
    } else {
        struct spool kept = spool_output(name);
        copy_file(spool->path, kept.path, name);
        if (truncate(spool->path, 0) != 0) warn("%s stays as it was", spool->path);
        spool_finish(&kept);
    }
    free(spool->final);
    spool->final = NULL;
    return true;
}

void spool_close(struct spool *spool)
{
    bool dropped = spool->descriptor < 0 && spool->final != NULL;
    if (dropped) {
        unlink(spool->path);
        lose_track(spool->path);
    }
    if (spool->descriptor >= 0) close(spool->descriptor);
    free(spool->path);
    free(spool->final);
    *spool = (struct spool){.descriptor = -1};
}
