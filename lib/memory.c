#include "memory.h"

#include "die.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { ALIGNMENT = 64, LARGE_PAGE = 2 << 20 };

void *memory_new(size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > PTRDIFF_MAX - LARGE_PAGE)
        die_run("cannot allocate %zu elements of %zu bytes", count, size);
    /* Fields of large bodies, of which many are read at once, lie in large pages where the system
     * has them, but for what does not fill one. */
    const size_t large = bytes / LARGE_PAGE * LARGE_PAGE;
    void *block = NULL;
    if (posix_memalign(&block, large ? LARGE_PAGE : ALIGNMENT, bytes ? bytes : 1) != 0)
        die_run("out of memory: %.3g MB wanted", (double)bytes / 1e6);
    if (large) madvise(block, large, MADV_HUGEPAGE);
    memset(block, 0, bytes);
    return block;
}

void *memory_grow(void *items, int64_t count, size_t size)
{
    enum { LEAST = 16 };
    const bool full = count == 0 || (count >= LEAST && (count & (count - 1)) == 0);
    if (!full) return items;
    void *longer = memory_new(count ? 2 * (size_t)count : LEAST, size);
    if (count > 0) memcpy(longer, items, (size_t)count * size);
    free(items);
    return longer;
}

char *memory_text(const char *text)
{
    if (text == NULL) return NULL;
    size_t bytes = strlen(text) + 1;
    return memcpy(memory_new(bytes, 1), text, bytes);
}

char *memory_folder(const char *name)
{
    const char *end = strrchr(name, '/');
    return end ? memory_print("%.*s", (int)(end - name) + 1, name) : memory_text(".");
}

static char *print(const char *format, va_list arguments)
{
    char *text = NULL;
    if (vasprintf(&text, format, arguments) < 0) die_run("out of memory while printing a text");
    return text;
}

char *memory_print(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = print(format, arguments);
    va_end(arguments);
    return text;
}

char *memory_append(char *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *more = print(format, arguments), *all = memory_print("%s%s", text ? text : "", more);
    va_end(arguments);
    free(more);
    free(text);
    return all;
}
