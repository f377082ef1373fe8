#include "scalars.h"

#include "die.h"
#include "memory.h"

#include <bzlib.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

const char *const scalar_names[] = {"int8",  "uint8",  "int16",   "uint16",  "int32", "uint32",
                                    "int64", "uint64", "float32", "float64", NULL};

size_t scalar_size(enum scalar type)
{
    static const size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[type];
}

/* The bits of a number of `size` bytes, whatever the order of them. */
static uint64_t bits_at(const unsigned char *bytes, size_t size, bool big_endian)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++) bits = bits << 8 | bytes[big_endian ? i : size - 1 - i];
    return bits;
}

double scalar_at(const unsigned char *bytes, enum scalar type, bool big_endian)
{
    const uint64_t bits = bits_at(bytes, scalar_size(type), big_endian);
    const uint32_t half = (uint32_t)bits;
    float single;
    double full;
    switch (type) {
    case SCALAR_INT8:
        return (int8_t)bits;
    case SCALAR_INT16:
        return (int16_t)bits;
    case SCALAR_INT32:
        return (int32_t)bits;
    case SCALAR_INT64:
        return (double)(int64_t)bits;
    case SCALAR_FLOAT32:
        memcpy(&single, &half, sizeof single);
        return (double)single;
    case SCALAR_FLOAT64:
        memcpy(&full, &bits, sizeof full);
        return full;
    case SCALAR_UINT8:
    case SCALAR_UINT16:
    case SCALAR_UINT32:
    case SCALAR_UINT64:
        break;
    }
    return (double)bits;
}

void scalars_decode(const unsigned char *bytes, int64_t count, enum scalar type, bool big_endian,
                    double *out)
{
    const size_t size = scalar_size(type);
    for (int64_t i = 0; i < count; i++)
        out[i] = scalar_at(bytes + (size_t)i * size, type, big_endian);
}

static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/* The value of a character, -1 of one that is none. */
static int base64_value(char character)
{
    const char *found = character ? strchr(digits, character) : NULL;
    return found ? (int)(found - digits) : -1;
}

unsigned char *scalars_base64(const char *text, size_t length, size_t *bytes)
{
    unsigned char *out = memory_new(length / 4 * 3 + 3, 1);
    uint32_t bits = 0;
    int held = 0; /* characters of the group of four */
    *bytes = 0;
    for (size_t i = 0; i < length; i++) {
        if (strchr(" \t\r\n", text[i]) && text[i]) continue;
        const int value = base64_value(text[i]);
        if (value < 0 && text[i] != '=') break;
        if (value >= 0) {
            bits = bits << 6 | (uint32_t)value;
            if (++held < 4) continue;
        } else if (held < 2) {
            continue; /* the second '=' of a group */
        }
        /* 2, 3 or 4 characters are 1, 2 or 3 bytes. */
        bits <<= 6 * (4 - held);
        for (int k = 0; k < held - 1; k++) out[(*bytes)++] = (unsigned char)(bits >> (16 - 8 * k));
        bits = 0;
        held = 0;
    }
    return out;
}

char *scalars_base64_text(const unsigned char *bytes, size_t length)
{
    char *text = memory_new((length + 2) / 3 * 4 + 1, 1), *out = text;
    for (size_t i = 0; i < length; i += 3) {
        const size_t left = length - i;
        const uint32_t bits = (uint32_t)bytes[i] << 16 |
                              (left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0) |
                              (left > 2 ? bytes[i + 2] : 0);
        for (size_t k = 0; k < 4; k++) *out++ = k <= left ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

unsigned char *scalars_deflate(const unsigned char *bytes, size_t length, size_t *packed)
{
    uLongf room = compressBound(length);
    unsigned char *out = memory_new(room, 1);
    if (compress(out, &room, bytes, length) != Z_OK) die_run("out of memory for zlib");
    *packed = room;
    return out;
}

unsigned char *scalars_bunzip(const unsigned char *packed, size_t length, size_t wanted)
{
    if (length > UINT_MAX || wanted >= UINT_MAX) return NULL;
    unsigned made = (unsigned)wanted + 1;
    char *out = memory_new(made, 1);
    const int status =
        BZ2_bzBuffToBuffDecompress(out, &made, (char *)(uintptr_t)packed, (unsigned)length, 0, 0);
    if (status == BZ_OK && made == wanted) return (unsigned char *)out;
    free(out);
    return NULL;
}

unsigned char *scalars_inflate(const unsigned char *packed, size_t length, size_t wanted)
{
    enum { EITHER_HEAD = 32 }; /* zlib's or gzip's, found out by the library */
    z_stream stream = {0};
    unsigned char *out = memory_new(wanted + 1, 1);
    size_t taken = 0, made = 0;
    if (inflateInit2(&stream, MAX_WBITS + EITHER_HEAD) != Z_OK) return NULL;
    int status = Z_OK;
    while (status == Z_OK && made <= wanted) {
        const size_t in = length - taken, room = wanted + 1 - made;
        stream.next_in = (unsigned char *)(uintptr_t)packed + taken;
        stream.next_out = out + made;
        stream.avail_in = (unsigned)(in < UINT_MAX ? in : UINT_MAX);
        stream.avail_out = (unsigned)(room < UINT_MAX ? room : UINT_MAX);
        const unsigned before_in = stream.avail_in, before_out = stream.avail_out;
        status = inflate(&stream, Z_NO_FLUSH);
        taken += before_in - stream.avail_in;
        made += before_out - stream.avail_out;
        if (before_in == stream.avail_in && before_out == stream.avail_out) break;
    }
    inflateEnd(&stream);
    if (status == Z_STREAM_END && made == wanted) return out;
    free(out);
    return NULL;
}
