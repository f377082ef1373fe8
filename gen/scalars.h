/* scalars.h - numbers as other programs write them in bytes, and bytes as they write them in text
 * or packed. */
#ifndef HS_SCALARS_H
#define HS_SCALARS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum scalar {
    SCALAR_INT8,
    SCALAR_UINT8,
    SCALAR_INT16,
    SCALAR_UINT16,
    SCALAR_INT32,
    SCALAR_UINT32,
    SCALAR_INT64,
    SCALAR_UINT64,
    SCALAR_FLOAT32,
    SCALAR_FLOAT64
};

/* "int8", "uint8" and so on, ended by NULL. */
extern const char *const scalar_names[];

size_t scalar_size(enum scalar type);

/* The number that begins at the byte; whole ones beyond 2^53 are rounded. */
double scalar_at(const unsigned char *bytes, enum scalar type, bool big_endian);

void scalars_decode(const unsigned char *bytes, int64_t count, enum scalar type, bool big_endian,
                    double *out);

/* Base 64 (RFC 4648) in pieces, each of which may end with padding; white space is passed over, and
 * any other character ends it.  The caller frees the bytes. */
unsigned char *scalars_base64(const char *text, size_t length, size_t *bytes);

/* Unpacks zlib or gzip to exactly `wanted` bytes; NULL where it is damaged or holds fewer or more.
 * The caller frees them. */
unsigned char *scalars_inflate(const unsigned char *packed, size_t length, size_t wanted);
/* The same of bzip2. */
unsigned char *scalars_bunzip(const unsigned char *packed, size_t length, size_t wanted);

/* The reverse of both; the caller frees what it gets. */
char *scalars_base64_text(const unsigned char *bytes, size_t length);
unsigned char *scalars_deflate(const unsigned char *bytes, size_t length, size_t *packed);

/* No byte of zlib stands for more of them (its manual: 1032:1). */
#define SCALARS_INFLATION 1032

#endif
