#include "encoding.h"

#include "die.h"
#include "memory.h"

#include <errno.h>
#include <iconv.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* NULL where the bytes are not text of that set. */
static char *convert(const char *bytes, size_t length, const char *set)
{
    enum { LONGEST_CHARACTER = 4 }; /* bytes of UTF-8 for one byte */
    size_t room = LONGEST_CHARACTER * length;
    char *text = memory_new(room + 1, 1), *from = (char *)bytes, *to = text;
    iconv_t converter = iconv_open("UTF-8", set);
    if (converter == (iconv_t)-1) die_run("iconv does not know %s: %s", set, strerror(errno));
    const bool whole = iconv(converter, &from, &length, &to, &room) != (size_t)-1;
    iconv_close(converter);
    if (whole && strlen(text) == (size_t)(to - text)) return text;
    free(text);
    return NULL;
}

/* Latin text in UTF-16 has a zero in every other byte. */
static const char *utf16(const unsigned char *bytes, long length)
{
    if (length >= 2 && bytes[0] == 0xFF && bytes[1] == 0xFE) return "UTF-16LE";
    if (length >= 2 && bytes[0] == 0xFE && bytes[1] == 0xFF) return "UTF-16BE";
    long zeros[2] = {0, 0};
    for (long i = 0; i < length; i++) zeros[i % 2] += bytes[i] == 0;
    if (zeros[0] + zeros[1] == 0 || zeros[0] + zeros[1] < length / 4) return NULL;
    return zeros[0] > zeros[1] ? "UTF-16BE" : "UTF-16LE";
}

static const char byte_order_mark[] = "\xEF\xBB\xBF";

char *encoding_to_utf8(const char *bytes, long length, const char **set)
{
    const size_t mark = strlen(byte_order_mark);
    const char *wide = utf16((const unsigned char *)bytes, length);
    const char *const sets[] = {wide ? wide : "UTF-8", wide ? NULL : "WINDOWS-1252"};
    for (int i = 0; i < 2 && sets[i]; i++) {
        char *text = convert(bytes, (size_t)length, *set = sets[i]);
        if (!text) continue;
        if (strncmp(text, byte_order_mark, mark) == 0)
            memmove(text, text + mark, strlen(text + mark) + 1);
        return text;
    }
    return NULL;
}
