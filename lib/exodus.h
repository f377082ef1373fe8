/* exodus.h - the only file that knows Exodus and netCDF.
 *
 * All files are CDF-2 (64-bit offset).  Each carries its own length in the global attribute
 * hs_file_bytes, written last: a truncated netCDF file would otherwise read as zeros without an
 * error.  Readers refuse (exit 2) what is empty, truncated, foreign or inconsistent and bound every
 * count by the file's size before allocating; writers check every call (exit 1: disk full). */
#ifndef HS_EXODUS_H
#define HS_EXODUS_H

#include "domain.h"
#include "spool.h"

#include <stdbool.h>

/* "Exodus 6.02, netCDF 4.9.0" (static storage) */
const char *exodus_library(void);

/* Genesis: SPHERE elements, one block a phase, attributes RADIUS and VOLUME, node sets, and the
 * domain's attributes as netCDF global attributes with the prefix "hs_". */
void exodus_write_domain(const struct spool *output, const struct domain *domain);

/* What is wrong with the name of a phase, which becomes that of a block, and a part of those of
 * columns and attributes; NULL: nothing. */
const char *exodus_phase_fault(const char *name);

/* Reads what exodus_write_domain wrote, and Genesis from elsewhere (then without hs_ attributes;
 * hs_file_bytes may be missing): SPHERE elements, one a node, with an element attribute VOLUME, or
 * hexahedra of eight nodes, or both.  A hexahedron becomes a particle at its centroid with its
 * exact volume, and belongs to a node set when at least half of its corners do; particles are then
 * numbered as the elements.  Where all are hexahedra, the domain keeps the mesh's nodes and their
 * sets. */
struct domain exodus_read_domain(const struct spool *input);

/* The same without its positions and volumes, which stay in the file and are read as they are asked
 * for (domain_next): of a file with a spacing whose elements are spheres, one a node, numbered in
 * the nodes' order within each block, as exodus_write_domain has them.  False, and the domain
 * empty, where it is another one; what is wrong with that says exodus_read_domain. */
bool exodus_stream_domain(const struct spool *input, struct domain *domain);

/* Histories: an Exodus file without nodes, one global variable a column, one time step a record.
 * A column's name ends in its unit: force_left_N, extension_m. */
struct history {
    int n_columns;
    char **columns;
    int64_t n_records;
    double *time;   /* [n_records] s */
    double *values; /* [n_records * n_columns], record by record */
    struct attributes attributes;
};

void exodus_write_history(const struct spool *output, const struct history *history);

/* The same record by record: the file holds the history's columns and attributes; expected records
 * find room even where others fill the disk. */
struct exodus_history;
struct exodus_history *exodus_history_open(const struct spool *output,
                                           const struct history *history, int64_t expected);
/* Those records of the history that are new; they are on the disk itself when the call returns. */
void exodus_history_add(struct exodus_history *file, const struct history *history);
/* Adds what is new, and closes it; numbers among the attributes become those of now. */
void exodus_history_close(struct exodus_history *file, const struct history *history);

/* A history or frames that were left behind unfinished become whole up to their last sound record;
 * how many those are, and the time of the last one [s].  Dies (exit 2) where there is none, or the
 * file is no such thing. */
int64_t exodus_repair(const char *name, double *time);

struct history exodus_read_history(const struct spool *input);
void history_free(struct history *history);

/* Fields: the domain with nodal variables, one frame after the other.  Names end in X, Y, Z for
 * vectors, so that ParaView glues them.  One process makes the file; others join it, and all put
 * the numbers of their nodes where they belong, none in the place of another's. */
struct exodus_fields;
struct exodus_fields *exodus_fields_open(const struct spool *output, const struct domain *domain,
                                         int n_variables, const char *const names[]);

/* What others have to know of the file: where it is, where its frames begin. */
struct exodus_layout {
    char path[4096];
    int64_t n_nodes, n_variables, frames, records;
};
const struct exodus_layout *exodus_fields_layout(const struct exodus_fields *fields);
/* Dies (exit 1) where the file is not to be seen from here. */
struct exodus_fields *exodus_fields_join(const struct exodus_layout *layout);

/* Numbers of count nodes from the first one on, of a variable in a frame (from 0). */
void exodus_fields_put(struct exodus_fields *fields, int64_t frame, int variable, int64_t first,
                       int64_t count, const double *values);
/* What has been put from here is on the disk itself: 0, or errno of what failed. */
int exodus_fields_sync(struct exodus_fields *fields);
/* The maker's, when all have put their numbers there: the frame becomes one, and is on the disk
 * itself when the call returns.  failure: errno of another's; dies (exit 1) of it.  A run that
 * fails keeps its last good frame if a function given to die_at_exit (after spool_output) calls
 * exodus_fields_close and spool_finish. */
void exodus_fields_end(struct exodus_fields *fields, double time, int failure);
/* A whole frame: values[variable] is an array of n_nodes. */
void exodus_fields_write(struct exodus_fields *fields, double time, const double *const values[]);
void exodus_fields_close(struct exodus_fields *fields);

int64_t exodus_fields_count(const struct exodus_fields *fields);
/* Takes over so many frames of an earlier file, finished or not, of the same domain and variables;
 * false, and nothing changed, where it is not there or has not got them. */
bool exodus_fields_take(struct exodus_fields *fields, const char *name, int64_t frames);

/* Frames read back; the domain beside them is read by exodus_read_domain from the same input. */
struct frames {
    int64_t n_nodes;
    int n_variables;
    char **variables; /* [n_variables] names, in the file's order */
    int64_t n_frames;
    double *time;             /* [n_frames] s */
    struct exodus_file *file; /* open */
};

/* Dies (exit 2) at what exodus_fields_open did not write, and at a file without frames. */
struct frames exodus_frames_open(const struct spool *input);
/* Index of a variable; -1 where there is none of that name. */
int frames_find(const struct frames *frames, const char *variable);
/* values[n_nodes] of a variable (index) at a frame (from 0). */
void exodus_frames_read(const struct frames *frames, int variable, int64_t frame, double *values);
void exodus_frames_close(struct frames *frames);

#endif
