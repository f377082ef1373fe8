#include "image_text.h"

#include "die.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct image_text image_text_of(const struct image_source *source)
{
    return (struct image_text){.source = source, .line = 1};
}

static bool is_space(unsigned char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

void image_refuse(const struct image_text *text, const char *format, ...)
{
    char message[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    die_user("%s:%lld: %s", text->source->path, (long long)text->line, message);
}

bool image_word(struct image_text *text, char *word, size_t room)
{
    const struct image_source *source = text->source;
    size_t length = 0;
    while (text->at < source->length && is_space(source->bytes[text->at]))
        text->line += source->bytes[text->at++] == '\n';
    for (; text->at < source->length && !is_space(source->bytes[text->at]); text->at++)
        if (length + 1 < room) word[length++] = (char)source->bytes[text->at];
    word[length] = '\0';
    return length > 0;
}

bool image_line(struct image_text *text, char *line, size_t room)
{
    const struct image_source *source = text->source;
    size_t length = 0;
    if (text->at >= source->length) return false;
    for (; text->at < source->length && source->bytes[text->at] != '\n'; text->at++)
        if (length + 1 < room) line[length++] = (char)source->bytes[text->at];
    if (text->at < source->length) {
        text->at++;
        text->line++;
    }
    while (length > 0 && line[length - 1] == '\r') length--;
    line[length] = '\0';
    return true;
}

double image_number(struct image_text *text, const char *what)
{
    char word[64], *end;
    if (!image_word(text, word, sizeof word))
        image_refuse(text, "the file ends, expected %s", what);
    const double value = strtod(word, &end);
    if (*end) image_refuse(text, "found '%.40s', expected %s", word, what);
    return value;
}

void image_numbers(struct image_text *text, const char *what, int64_t count, double *out)
{
    for (int64_t i = 0; i < count; i++) out[i] = image_number(text, what);
}

int image_split(char *line, char *fields[], int most)
{
    int count = 0;
    for (char *rest = line; *rest;) {
        while (is_space((unsigned char)*rest)) *rest++ = '\0';
        if (!*rest) break;
        if (count < most) fields[count] = rest;
        count++;
        while (*rest && !is_space((unsigned char)*rest)) rest++;
    }
    return count;
}
