/* spool.h - netCDF must seek, pipes cannot: the bridge between them.
 *
 * Reading: a pipe is copied to an unlinked temporary file (in $TMPDIR, else /tmp) whose
 * /proc/self/fd path netCDF can open.  Writing: to a pipe, an unlinked file is filled and pumped
 * out at the end; to a name, "name.partial-PID" is filled and renamed when whole, removed when the
 * program dies. */
#ifndef HS_SPOOL_H
#define HS_SPOOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct spool {
    int descriptor;    /* -1 where path is a file of its own */
    char *path;        /* what to open or create */
    char *final;       /* name after spool_finish, NULL for stdout */
    const char *shown; /* name in messages; NULL: final */
    /* Where a stream that cannot be written to its end is kept; NULL: nowhere. */
    const char *precious;
};

/* name = NULL or "-": standard input.  An empty input or a terminal is the user's error. */
struct spool spool_input(const char *name);

/* A new folder among the temporary ones, for who needs one of his own: its path.  Removed with all
 * that is in it. */
char *spool_folder(void);
void spool_remove_folder(char *path);
/* The bytes of a file as one in such a folder, whose path is returned. */
char *spool_copy(const char *path, const char *folder);

/* These bytes as an input. */
struct spool spool_bytes(const char *bytes, size_t length);

/* name = NULL or "-": standard output; refuses a terminal (exit 2, "use -o FILE or a pipe").
 * Called early, so that an unwritable directory is found before the work is done. */
struct spool spool_output(const char *name);
/* The same look at an output that is opened later: at its folder. */
void spool_check_output(const char *name);
/* Dies (exit 1) where this output is a pipe that has no reader any more: before long work. */
void spool_refuse_unread(const struct spool *spool);

/* Makes the output appear: renames it when it is on the disk itself, so that a power cut leaves the
 * whole of it or nothing, or copies it to stdout (checked to the last byte; a closed pipe ends the
 * program quietly by SIGPIPE as with any filter, a full disk exits 1; either keeps what is
 * precious). */
void spool_finish(struct spool *spool);

/* What there is of an unfinished output gets this name, for good; false where it is empty, and
 * gone.  Dies (exit 1) where it cannot: then it stays where it is. */
bool spool_keep(struct spool *spool, const char *name);

/* Whether nothing has been written to it, or that has gone elsewhere. */
bool spool_is_empty(const struct spool *spool);

/* The file at from, once it is on the disk itself, gets the name to; exit 1 where it cannot. */
void spool_rename(const char *from, const char *to);

/* What has been written to the file at path is on the disk itself; exit 1 where it cannot get
 * there. */
void spool_sync(const char *path, const char *shown);

/* So are the names of the folder that path lies in. */
void spool_sync_folder(const char *path);

/* Bytes of the disk behind the end of the file at path, so that it still grows where the disk is
 * full otherwise: exit 1 where the disk has not so many.  A disk that knows no such thing reserves
 * nothing. */
void spool_reserve(const char *path, const char *shown, int64_t bytes);
/* Gives back what the file at path has not taken. */
void spool_release(const char *path);

/* Closes an input, or drops an output that is not finished. */
void spool_close(struct spool *spool);

/* Everything of a text input, NUL-terminated, at most limit bytes; *length without the NUL. */
char *spool_text(const char *name, long limit, long *length);

/* Writes all of it from that byte of the file on, whatever else writes there; false where it
 * cannot: errno. */
bool spool_write_at(int descriptor, const void *bytes, size_t count, int64_t at);

/* A file that outgrows its limit (ulimit -f) is from now on an error of a write, told as a full
 * disk is. */
void spool_outlive_limits(void);

#endif
