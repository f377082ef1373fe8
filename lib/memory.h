/* memory.h - allocation that never returns NULL. */
#ifndef HS_MEMORY_H
#define HS_MEMORY_H

#include <stddef.h>
#include <stdint.h>

/* count elements of size bytes, zeroed, aligned to 64 bytes; dies when there is no memory or
 * count * size overflows.  count = 0 gives a valid pointer.  Freed with free(). */
void *memory_new(size_t count, size_t size);

/* Room for one more element behind count of them; returns where they now lie, the new one zeroed
 * where the block was made anew.  items: NULL, or of an array that grew by this alone, from the
 * first element on.  The block doubles at powers of two, so that its length need not be kept, and n
 * elements cost O(n). */
void *memory_grow(void *items, int64_t count, size_t size);

/* A copy of a string; text = NULL gives NULL. */
char *memory_text(const char *text);

/* The folder that a file of this name is in: all to its last '/', or "." where it has none. */
char *memory_folder(const char *name);

/* A printed string of whatever length it needs. */
char *memory_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The text, NULL being an empty one, with a printed string behind it, in a new block: the old one
 * is freed. */
char *memory_append(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
