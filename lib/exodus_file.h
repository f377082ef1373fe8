/* exodus_file.h - what the exodus_*.c files share: opening, closing, checking, attributes.
 * Private to them: only they include Exodus and netCDF. */
#ifndef HS_EXODUS_FILE_H
#define HS_EXODUS_FILE_H

#include "domain.h"
#include "spool.h"

#include <exodusII.h>
#include <stdbool.h>

enum { EXODUS_NAME = 64 }; /* longest name of a block, set or variable */

struct exodus_file {
    int id;
    char *path;
    char *shown; /* the name in messages */
    int64_t bytes;
    bool packed; /* netCDF-4, whose numbers may be compressed */
};

/* Creates a file of 64-bit offset format that holds doubles and takes 64-bit integers, with these
 * attributes, provenance records, and a place for hs_file_bytes. */
struct exodus_file exodus_create(const struct spool *output, const struct attributes *attributes);

/* The library closes the file; others may go on with it. */
void exodus_let_go(struct exodus_file *file);

/* Closes a written file, where it is open, and enters its length. */
void exodus_finish(struct exodus_file *file);

/* What has been written is on the disk itself. */
void exodus_sync(const struct exodus_file *file);
/* Numbers of attributes that the file has get these values. */
void exodus_renew_numbers(const struct exodus_file *file, const struct attributes *attributes);

/* Opens a file of any netCDF format; a classic one has a sane header and is whole by its
 * hs_file_bytes, and without that attribute passes only where foreign is true.  A netCDF-4 file,
 * which these tools do not write, passes only there. */
struct exodus_file exodus_open(const struct spool *input, bool foreign);
/* The same, whole or not. */
struct exodus_file exodus_open_any(const struct spool *input);
void exodus_close(struct exodus_file *file);

/* The attributes with the prefix hs_, without it. */
struct attributes exodus_read_attributes(const struct exodus_file *file);

/* Dies (exit 1) where a status of the library says that writing what failed. */
void exodus_wrote(const struct exodus_file *file, int status, const char *what);
/* Dies (exit 2) where reading what failed. */
void exodus_read(const struct exodus_file *file, int status, const char *what);
/* Dies (exit 2) unless count elements of size bytes can be in the file. */
void exodus_bound(const struct exodus_file *file, int64_t count, int64_t size, const char *what);
/* Dies (exit 1) where a name is longer than the format allows. */
void exodus_check_name(const struct exodus_file *file, const char *name);

/* count buffers for names; freed as one block. */
char **exodus_names(int64_t count);

/* Blocks and sets of a domain; then its nodes and elements, as many at once as are at hand, when
 * all that the file is to hold is defined: netCDF moves what is behind a growing head. */
void exodus_define_domain(const struct exodus_file *file, const struct domain *domain);
void exodus_put_nodes(const struct exodus_file *file, const struct domain *domain);

/* Dies (exit 2) where the head of a classic netCDF file is damaged: libnetcdf 4.9 believes every
 * count it finds there and can hang on a wrong one.  False where it is netCDF-4. */
bool exodus_check_header(const char *path, const char *shown);
/* Byte where the numbers of a variable begin; of one with a number a record those of the first,
 * which need not be there yet.  Dies (exit 2) where there is none of that name. */
int64_t exodus_variable_place(const char *path, const char *shown, const char *name);
/* Enters another number of records into a sound one. */
void exodus_set_records(const char *path, const char *shown, int64_t records);

#endif
