#include "kept_history.h"

#include "die.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_NAMES = 1000, LONGEST_NAME = 4096 };

/* What neither die_at_exit nor a signal can hand over: the descriptor of the pipe's copy, and
 * the folder of temporary files, with a slash at its end. */
static int kept = -1;
static char temporary[LONGEST_NAME];

/* What follows runs in signal handlers, too: no memory is asked for, and nothing printed by
 * stdio. */

static char *append(char *to, const char *text)
{
    while (*text) *to++ = *text++;
    *to = '\0';
    return to;
}

static void append_number(char *to, int number)
{
    char digits[16];
    int n = 0;
    for (; number > 0; number /= 10) digits[n++] = (char)('0' + number % 10);
    while (n > 0) *to++ = digits[--n];
    *to = '\0';
}

/* A file that is not there yet; -1: none can be made in that folder. */
static int new_file(const char *folder, char name[2 * LONGEST_NAME])
{
    for (int i = 1; i < MOST_NAMES; i++) {
        char *end = append(append(name, folder), "hspost-history");
        if (i > 1) append_number(append(end, "-"), i);
        append(name + strlen(name), ".e");
        const int file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) return file;
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

/* One line on standard error, as warn() prints it. */
static void tell(const char *text, const char *name)
{
    char line[3 * LONGEST_NAME];
    char *end = append(append(append(line, die_program()), ": warning: "), text);
    end = append(append(end, name), "\n");
    if (write(STDERR_FILENO, line, (size_t)(end - line)) < 0) return;
}

static void keep(void)
{
    const char *const folders[] = {"", temporary};
    char name[2 * LONGEST_NAME];
    for (int i = 0; i < 2 && kept >= 0; i++) {
        const int file = new_file(folders[i], name);
        if (file >= 0 && copy(file) == 0) {
            tell("the history that was read is kept: ", name);
            kept = -1;
            return;
        }
        if (file >= 0) unlink(name);
    }
    if (kept >= 0) tell("the history that was read could not be kept", "");
}

void kept_history(const struct spool *spool)
{
    struct stat status;
    const char *folder = getenv("TMPDIR");
    const bool pipe =
        spool->descriptor >= 0 && fstat(spool->descriptor, &status) == 0 && status.st_nlink == 0;
    if (!pipe) return;
    if (!folder || !*folder || strlen(folder) > LONGEST_NAME - 2) folder = "/tmp";
    append(append(temporary, folder), "/");
    kept = fcntl(spool->descriptor, F_DUPFD_CLOEXEC, 3);
    if (kept < 0) return;
    die_at_exit(keep);
    die_at_signals(keep);
}
