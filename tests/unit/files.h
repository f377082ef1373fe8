/* files.h - files that tests read, break and read again. */
#ifndef HS_FILES_H
#define HS_FILES_H

#include "dies.h"

#include "exodus.h"
#include "memory.h"

#include <stdlib.h>
#include <sys/stat.h>

/* [length], freed with free(). */
static inline char *read_bytes(const char *name, size_t *length)
{
    struct stat status;
    assert_int_equal(stat(name, &status), 0);
    *length = (size_t)status.st_size;
    char *bytes = memory_new(*length, 1);
    FILE *file = fopen(name, "rb");
    assert_int_equal(fread(bytes, 1, *length, file), *length);
    fclose(file);
    return bytes;
}

static inline void write_bytes(const char *name, const char *bytes, size_t length)
{
    FILE *file = fopen(name, "wb");
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

static inline struct domain read_domain(const char *name)
{
    struct spool input = spool_input(name);
    struct domain domain = exodus_read_domain(&input);
    spool_close(&input);
    return domain;
}

static inline void try_domain(const void *name)
{
    struct domain domain = read_domain(name);
    domain_free(&domain);
}

/* Any byte of a file may be wrong, here every stride-th: try ends with the program's own exit code
 * or takes the file, but does not crash or hang. */
static inline void expect_no_harm(const char *name, size_t stride, void (*try)(const void *))
{
    size_t length;
    char *bytes = read_bytes(name, &length);
    for (size_t at = 4; at < length; at += stride) {
        bytes[at] = (char)(bytes[at] ^ 0x7f);
        write_bytes("wrong.g", bytes, length);
        bytes[at] = (char)(bytes[at] ^ 0x7f);
        const int code = code_of(try, "wrong.g");
        if (code != 0 && code != EXIT_USER) fail_msg("%s, byte %zu: %d", name, at, code);
    }
    free(bytes);
}

#endif
