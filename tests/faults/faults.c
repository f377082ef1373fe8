/* faults.c - a disk that fails, or a process that is killed, at the n-th call; to be preloaded.
 *
 *   HS_FAULT="CALL N WHAT"   at the N-th call of CALL (write, pwrite, fsync, rename, fallocate,
 *                            ftruncate, mmap, or any of them): an error number, with which it and,
 *                            of what a full disk stops, all that follow fail; or kill, term: the
 *                            process sends itself that signal, then makes the call
 *   HS_FAULT_COUNT=FILE      at the end the number of calls is added to FILE as a line
 *                            "PROGRAM CALL NUMBER"
 *
 * Calls on sockets, pipes and standard error are none of the disk's, and mappings without a file
 * none of its either. */
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum call { WRITE, PWRITE, FSYNC, RENAME, FALLOCATE, FTRUNCATE, MMAP, CALLS };
static const char *const names[CALLS] = {"write",     "pwrite",    "fsync", "rename",
                                         "fallocate", "ftruncate", "mmap"};
static long counts[CALLS], all;

static int on_disk(int descriptor)
{
    struct stat status;
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/* Whether this call fails: errno is set. */
static int fails(enum call call)
{
    const char *fault = getenv("HS_FAULT");
    char wanted[16] = "", what[16] = "";
    long n = 0;
    counts[call]++;
    all++;
    if (!fault || sscanf(fault, "%15s %ld %15s", wanted, &n, what) != 3) return 0;
    const int any = strcmp(wanted, "any") == 0;
    const long count = any ? all : counts[call];
    if (!any && strcmp(wanted, names[call]) != 0) return 0;
    if (strcmp(what, "kill") == 0 || strcmp(what, "term") == 0) {
        if (count == n) kill(getpid(), strcmp(what, "kill") == 0 ? SIGKILL : SIGTERM);
        return 0;
    }
    errno = atoi(what);
    return count == n || (count > n && errno == ENOSPC && call != RENAME);
}

__attribute__((destructor)) static void tell(void)
{
    const char *name = getenv("HS_FAULT_COUNT");
    FILE *file = name ? fopen(name, "a") : NULL;
    if (!file) return;
    for (int k = 0; k < CALLS; k++)
        fprintf(file, "%s %s %ld\n", program_invocation_short_name, names[k], counts[k]);
    fprintf(file, "%s any %ld\n", program_invocation_short_name, all);
    fclose(file);
}

/* The library's own function of that name. */
static void *next(const char *name)
{
    return dlsym(RTLD_NEXT, name);
}

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    ssize_t (*real)(int, const void *, size_t) = next("write");
    return descriptor != STDERR_FILENO && on_disk(descriptor) && fails(WRITE)
               ? -1
               : real(descriptor, bytes, count);
}

ssize_t pwrite(int descriptor, const void *bytes, size_t count, off_t at)
{
    ssize_t (*real)(int, const void *, size_t, off_t) = next("pwrite");
    return on_disk(descriptor) && fails(PWRITE) ? -1 : real(descriptor, bytes, count, at);
}

int fsync(int descriptor)
{
    int (*real)(int) = next("fsync");
    return on_disk(descriptor) && fails(FSYNC) ? -1 : real(descriptor);
}

int rename(const char *from, const char *to)
{
    int (*real)(const char *, const char *) = next("rename");
    return fails(RENAME) ? -1 : real(from, to);
}

int fallocate(int descriptor, int mode, off_t at, off_t count)
{
    int (*real)(int, int, off_t, off_t) = next("fallocate");
    return fails(FALLOCATE) ? -1 : real(descriptor, mode, at, count);
}

int ftruncate(int descriptor, off_t length)
{
    int (*real)(int, off_t) = next("ftruncate");
    return on_disk(descriptor) && fails(FTRUNCATE) ? -1 : real(descriptor, length);
}

void *mmap(void *where, size_t length, int protection, int flags, int descriptor, off_t at)
{
    void *(*real)(void *, size_t, int, int, int, off_t) = next("mmap");
    return descriptor >= 0 && fails(MMAP) ? MAP_FAILED
                                          : real(where, length, protection, flags, descriptor, at);
}
