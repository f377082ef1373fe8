/* spool.h - netCDF must seek, pipes cannot: the bridge between them.
 *
 * Reading: a pipe is copied to an unlinked temporary file (in $TMPDIR, else /tmp) whose
 * /proc/self/fd path netCDF can open.  Writing: to a pipe, an unlinked file is filled and pumped
 * out at the end; to a name, "name.partial-PID" is filled and renamed when whole, removed when the
 * program dies. */
#ifndef HS_SPOOL_H
#define HS_SPOOL_H

#include <stdbool.h>

struct spool {
    int descriptor; /* -1 where path is a file of its own */
    char *path;     /* what to open or create */
    char *final;    /* name after spool_finish, NULL for stdout */
};

/* name = NULL or "-": standard input.  An empty input or a terminal is the user's error. */
struct spool spool_input(const char *name);

/* name = NULL or "-": standard output; refuses a terminal (exit 2, "use -o FILE or a pipe").
 * Called early, so that an unwritable directory is found before the work is done. */
struct spool spool_output(const char *name);

/* Makes the output appear: renames it, or copies it to stdout (checked to the last byte; a closed
 * pipe ends the program quietly by SIGPIPE as with any filter, a full disk exits 1). */
void spool_finish(struct spool *spool);

/* Closes an input, or drops an output that is not finished. */
void spool_close(struct spool *spool);

/* Everything of a text input, NUL-terminated, at most limit bytes; *length without the NUL. */
char *spool_text(const char *name, long limit, long *length);

#endif
