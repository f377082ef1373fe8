#include "xml.h"

#include "memory.h"

#include <ctype.h>
#include <string.h>

struct xml xml_of(const char *text, size_t length)
{
    return (struct xml){text, text + length};
}

static const char *find(const char *from, const char *end, char character)
{
    return from < end ? memchr(from, character, (size_t)(end - from)) : NULL;
}

bool xml_next(struct xml *xml, struct xml_tag *tag)
{
    for (;;) {
        const char *open = find(xml->at, xml->end, '<');
        if (!open) return false;
        const bool comment = xml->end - open >= 4 && memcmp(open, "<!--", 4) == 0;
        const char *from = open + 1;
        if (comment) {
            from = memmem(open, (size_t)(xml->end - open), "-->", 3);
            if (!from) return false;
        }
        const char *close = find(from, xml->end, '>');
        if (!close) return false;
        xml->at = close + 1;
        *tag = (struct xml_tag){open + 1, close + 1, xml->end};
        if (!comment && open[1] != '?' && open[1] != '!') return true;
    }
}

static bool ends_name(char character)
{
    return isspace((unsigned char)character) || character == '>' || character == '/';
}

bool xml_is(const struct xml_tag *tag, const char *name)
{
    const size_t length = strlen(name);
    return (size_t)(tag->end - tag->name) > length && memcmp(tag->name, name, length) == 0 &&
           ends_name(tag->name[length]);
}

char *xml_attribute(const struct xml_tag *tag, const char *name)
{
    const size_t length = strlen(name);
    const char *at = tag->name, *end = tag->end - 1;
    while (at < end && !isspace((unsigned char)*at)) at++; /* the tag's own name */
    while (at < end) {
        while (at < end && (isspace((unsigned char)*at) || *at == '/')) at++;
        const char *equals = find(at, end, '=');
        if (!equals) return NULL;
        size_t wide = (size_t)(equals - at);
        while (wide > 0 && isspace((unsigned char)at[wide - 1])) wide--;
        const char *open = equals + 1;
        while (open < end && isspace((unsigned char)*open)) open++;
        if (open >= end || (*open != '"' && *open != '\'')) return NULL;
        const char *close = find(open + 1, end, *open);
        if (!close) return NULL;
        if (wide == length && memcmp(at, name, length) == 0)
            return memory_print("%.*s", (int)(close - open - 1), open + 1);
        at = close + 1;
    }
    return NULL;
}

const char *xml_content(const struct xml_tag *tag, size_t *length)
{
    const char *next = find(tag->end, tag->limit, '<');
    *length = (size_t)((next ? next : tag->limit) - tag->end);
    return tag->end;
}
