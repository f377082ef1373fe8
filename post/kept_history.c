#include "kept_history.h"

#include "die.h"
#include "memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_NAMES = 1000 };

/* What die_at_exit cannot hand over: the descriptor of the pipe's copy. */
static int kept = -1;

/* A file that is not there yet; -1: none can be made in that folder. */
static int new_file(const char *folder, char **name)
{
    for (int i = 1; i < MOST_NAMES; i++) {
        *name = i == 1 ? memory_print("%shspost-history.e", folder)
                       : memory_print("%shspost-history-%d.e", folder, i);
        const int file = open(*name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) return file;
        free(*name);
    }
    return -1;
}

static int copy(int to)
{
    struct stat status;
    off_t place = 0;
    if (fstat(kept, &status) != 0) return -1;
    while (place < status.st_size)
        if (sendfile(to, kept, &place, (size_t)(status.st_size - place)) <= 0) return -1;
    return close(to);
}

static void keep(void)
{
    const char *temporary = getenv("TMPDIR");
    char *second = memory_print("%s/", temporary && *temporary ? temporary : "/tmp"), *name = NULL;
    const char *const folders[] = {"", second};
    for (int i = 0; i < 2; i++) {
        const int file = new_file(folders[i], &name);
        if (file >= 0 && copy(file) == 0) {
            warn("the history that was read is kept: %s", name);
            return;
        }
        if (file >= 0) unlink(name);
    }
    warn("the history that was read could not be kept: %s", strerror(errno));
}

void kept_history(const struct spool *spool)
{
    struct stat status;
    const bool pipe =
        spool->descriptor >= 0 && fstat(spool->descriptor, &status) == 0 && status.st_nlink == 0;
    if (!pipe) return;
    kept = fcntl(spool->descriptor, F_DUPFD_CLOEXEC, 3);
    if (kept >= 0) die_at_exit(keep);
}
