#include "xml_deck.h"

#include "die.h"
#include "memory.h"
#include "translation.h"

#include <expat.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 30 };

struct reading {
    XML_Parser parser;
    const char *name;
    FILE *out;
    unsigned long line; /* of what is written next, from 1 */
    int depth;
};

static unsigned long line_of(const struct reading *r)
{
#ifdef XML_ATTR_DEPRECATED
    return XML_GetCurrentLineNumber64(r->parser);
#else
    return XML_GetCurrentLineNumber(r->parser);
#endif
}

static const char *attribute(const char **all, const char *name)
{
    for (; *all; all += 2)
        if (strcmp(all[0], name) == 0) return all[1];
    return NULL;
}

static void write_name(struct reading *r, const char *name)
{
    char *text = quoted(name);
    while (r->line < line_of(r)) {
        fputc('\n', r->out);
        r->line++;
    }
    fprintf(r->out, "%s: ", text);
    free(text);
}

static void start(void *reading, const char *element, const char **attributes)
{
    struct reading *r = reading;
    const char *name = attribute(attributes, "name"), *value = attribute(attributes, "value");
    if (strcmp(element, "ParameterList") == 0) {
        if (r->depth == DEEPEST)
            die_user("%s:%lu: lists within lists, over %d of them", r->name, line_of(r), DEEPEST);
        if (r->depth++ > 0) write_name(r, name ? name : "");
        fputs("{", r->out);
        return;
    }
    if (strcmp(element, "Parameter") != 0 || !name || !value || r->depth == 0)
        die_user("%s:%lu: <%s>, expected <ParameterList name=...> and within <Parameter name=... "
                 "value=...>",
                 r->name, line_of(r), element);
    write_name(r, name);
    char *text = quoted(value);
    /* A text over several lines stays on one. */
    for (char *c = text; *c; c++)
        if (*c == '\n' || *c == '\r' || *c == '\t') *c = ' ';
    fprintf(r->out, "%s, ", text);
    free(text);
}

static void end(void *reading, const char *element)
{
    struct reading *r = reading;
    if (strcmp(element, "ParameterList") == 0) fputs(--r->depth > 0 ? "}, " : "}\n", r->out);
}

/* Entities are for no parameter; they can grow without end. */
static void refuse_entity(void *reading, const char *entity, int parameter, const char *value,
                          int length, const char *base, const char *system, const char *public,
                          const char *notation)
{
    const struct reading *r = reading;
    (void)parameter, (void)value, (void)length, (void)base, (void)system, (void)public,
        (void)notation;
    die_user("%s:%lu: entity '%s', expected none", r->name, line_of(r), entity);
}

char *xml_deck_yaml(const char *text, size_t length, const char *name)
{
    char *yaml = NULL;
    size_t size = 0;
    struct reading r = {.parser = XML_ParserCreate(NULL), .name = name, .line = 1};
    r.out = open_memstream(&yaml, &size);
    XML_SetUserData(r.parser, &r);
    XML_SetElementHandler(r.parser, start, end);
    XML_SetEntityDeclHandler(r.parser, refuse_entity);
    if (XML_Parse(r.parser, text, (int)length, 1) != XML_STATUS_OK)
        die_user("%s:%lu: %s", name, line_of(&r), XML_ErrorString(XML_GetErrorCode(r.parser)));
    XML_ParserFree(r.parser);
    fclose(r.out);
    return yaml;
}
