/* memory.h - allocation that never returns NULL. */
#ifndef HS_MEMORY_H
#define HS_MEMORY_H

#include <stddef.h>

/* count elements of size bytes, zeroed, aligned to 64 bytes; dies when there is no memory or
 * count * size overflows.  count = 0 gives a valid pointer.  Freed with free(). */
void *memory_new(size_t count, size_t size);

/* A copy of a string; text = NULL gives NULL. */
char *memory_text(const char *text);

/* A printed string of whatever length it needs. */
char *memory_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
