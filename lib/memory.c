#include "memory.h"

#include "die.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

void *memory_new(size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > PTRDIFF_MAX - ALIGNMENT)
        die_run("cannot allocate %zu elements of %zu bytes", count, size);
    /* aligned_alloc wants a multiple of the alignment. */
    bytes = (bytes / ALIGNMENT + 1) * ALIGNMENT;
    void *block = aligned_alloc(ALIGNMENT, bytes);
    if (block == NULL) die_run("out of memory: %.3g MB wanted", (double)bytes / 1e6);
    return memset(block, 0, bytes);
}

char *memory_text(const char *text)
{
    if (text == NULL) return NULL;
    size_t bytes = strlen(text) + 1;
    return memcpy(memory_new(bytes, 1), text, bytes);
}

char *memory_print(const char *format, ...)
{
    char *text = NULL;
    va_list arguments;
    va_start(arguments, format);
    int length = vasprintf(&text, format, arguments);
    va_end(arguments);
    if (length < 0) die_run("out of memory while printing a text");
    return text;
}
