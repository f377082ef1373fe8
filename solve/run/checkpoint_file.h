/* checkpoint_file.h - a file of tables that ranks write side by side and any other number of them
 * reads.
 *
 * A table has a name and rows of a key and `width` numbers.  Each rank writes its rows as blocks
 * of their own, where the lengths of the others leave them their place: nothing is gathered.  A
 * reader goes through the blocks of all and picks by key.  Tables are read in the order in which
 * they were written.
 *
 * The file is the head (a mark with the number of this format, a word that shows the order of
 * bytes, the length), then for each table its name, width and number of blocks, and the blocks;
 * what describes and what is described have checksums.  The length is entered last, when the rest
 * is on the disk itself: a file without it was never finished. */
#ifndef HS_CHECKPOINT_FILE_H
#define HS_CHECKPOINT_FILE_H

#include "ranks.h"

#include <stdint.h>

union checkpoint_word {
    int64_t key;
    double number;
};

struct checkpoint_file;

/* To be written by all ranks; path: one that no other program uses.  Collective, as all that
 * writes. */
struct checkpoint_file *checkpoint_file_create(const char *path, struct ranks ranks);
/* Each rank reads for itself.  Dies (exit 2) where the file is none of these, was not finished, is
 * damaged or of another format; where there is an older one beside it (NAME.1), it is named. */
struct checkpoint_file *checkpoint_file_open(const char *name);
/* NULL, or why what was written is not on the disk (static storage); the same on all ranks. */
const char *checkpoint_file_close(struct checkpoint_file *file);

bool checkpoint_file_reads(const struct checkpoint_file *file);

/* A table to which this rank gives so many rows, each a key and width numbers; then as often the
 * place of its next one, to be filled before the one behind it is asked for; then the end. */
void checkpoint_file_begin(struct checkpoint_file *file, const char *name, int64_t width,
                           int64_t rows);
union checkpoint_word *checkpoint_file_row(struct checkpoint_file *file);
void checkpoint_file_end(struct checkpoint_file *file);

/* The next table: its number of blocks; *width is compared, or found where it is below 0.  Each
 * block's words are a new list.  All blocks have to be read. */
int64_t checkpoint_file_table(struct checkpoint_file *file, const char *name, int64_t *width);
union checkpoint_word *checkpoint_file_block(struct checkpoint_file *file, int64_t width,
                                             int64_t *rows);

/* Bytes that rank 0 has; read, they are a new list with a zero behind it. */
void checkpoint_file_bytes(struct checkpoint_file *file, const char *name, char **bytes,
                           int64_t *length);

/* All bytes of a file, rank 0's, elsewhere -1; read, they go to the descriptor, or nowhere where it
 * is -1. */
void checkpoint_file_copy(struct checkpoint_file *file, const char *name, int descriptor);

/* Dies (exit 2): what is wrong with the file that is read. */
_Noreturn void checkpoint_file_refuse(const struct checkpoint_file *file, const char *reason);

#endif
