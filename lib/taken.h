/* taken.h - which files a program reads and writes: no output takes the place of an input, nor
 * of another output. */
#ifndef HS_TAKEN_H
#define HS_TAKEN_H

#include <stdbool.h>

/* A file that is open is an input; what is no file of a disk can be read and written. */
void taken_as_input(int descriptor);

/* A file of that name is going to be written.  Dies (exit 2) where it is an input, or an output
 * already; warns where another process is about to write it, too. */
void taken_as_output(const char *name);

/* Files of these names (NULL: none) are going to be written, later.  Dies (exit 2) where two of
 * them are one, or one is an input that is open by now or was. */
void taken_check(const char *const names[], int count);

/* Whether both names are there, and of one file of a disk. */
bool taken_are_one(const char *name, const char *other);

/* An output of that name is there, and may be replaced by the next one, as in trials. */
void taken_again(const char *name);

/* Nothing is taken, as when a program begins: for who is several of them, such as a test. */
void taken_forget(void);

#endif
