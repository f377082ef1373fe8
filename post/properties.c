#include "properties.h"

#include "csv.h"
#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct property *properties_add(struct properties *list, const char *name, const char *symbol,
                                double value, const char *unit, double uncertainty,
                                const char *definition, ...)
{
    char *text;
    va_list arguments;
    va_start(arguments, definition);
    if (vasprintf(&text, definition, arguments) < 0) die_run("out of memory");
    va_end(arguments);
    list->items = memory_grow(list->items, list->count, sizeof *list->items);
    struct property *property = &list->items[list->count++];
    *property = (struct property){
        memory_text(name), memory_text(symbol), value, unit, uncertainty, text, NULL};
    return property;
}

static void write_row(FILE *file, const struct property *property)
{
    csv_text(file, property->name);
    fputc(',', file);
    csv_text(file, property->symbol);
    fputc(',', file);
    csv_number(file, property->value);
    fputc(',', file);
    csv_text(file, property->unit);
    fputc(',', file);
    csv_number(file, property->uncertainty);
    fputc(',', file);
    char *definition = property->flag
                           ? memory_print("%s [%s]", property->definition, property->flag)
                           : memory_text(property->definition);
    csv_text(file, definition);
    free(definition);
    fputc('\n', file);
}

void properties_write_csv(FILE *file, const struct properties lists[], const char *const titles[],
                          int count)
{
    fprintf(file, "%sproperty,symbol,value,unit,uncertainty,definition\n",
            count > 1 ? "curve," : "");
    for (int k = 0; k < count; k++)
        for (int i = 0; i < lists[k].count; i++) {
            if (count > 1) {
                csv_text(file, titles[k]);
                fputc(',', file);
            }
            write_row(file, &lists[k].items[i]);
        }
}

/* RFC 8259, section 7; the text is UTF-8 and stays it. */
static void write_string(FILE *file, const char *text)
{
    fputc('"', file);
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else if (c < 0x20)
            fprintf(file, "\\u%04x", c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

static void write_member(FILE *file, const char *key, const char *text)
{
    fprintf(file, "\"%s\": ", key);
    write_string(file, text);
}

static void write_number(FILE *file, const char *key, double value)
{
    fprintf(file, ", \"%s\": ", key);
    if (isfinite(value))
        csv_number(file, value);
    else
        fputs("null", file);
}

static void write_object(FILE *file, const struct property *property, const char *title)
{
    fputs("  {", file);
    if (title) {
        write_member(file, "curve", title);
        fputs(", ", file);
    }
    write_member(file, "property", property->name);
    fputs(", ", file);
    write_member(file, "symbol", property->symbol);
    write_number(file, "value", property->value);
    fputs(", ", file);
    write_member(file, "unit", property->unit);
    write_number(file, "uncertainty", property->uncertainty);
    fputs(", ", file);
    write_member(file, "definition", property->definition);
    if (property->flag) {
        fputs(", ", file);
        write_member(file, "flag", property->flag);
    }
    fputc('}', file);
}

void properties_write_json(FILE *file, const struct properties lists[], const char *const titles[],
                           int count)
{
    bool first = true;
    fputs("[\n", file);
    for (int k = 0; k < count; k++)
        for (int i = 0; i < lists[k].count; i++) {
            if (!first) fputs(",\n", file);
            first = false;
            write_object(file, &lists[k].items[i], count > 1 ? titles[k] : NULL);
        }
    fputs("\n]\n", file);
}

void properties_print(const struct properties *list, const char *title)
{
    static const struct {
        const char *name;
        int decimals;
    } shown[] = {{"modulus", 1},
                 {"proof_strength_0.2", 0},
                 {"upper_yield_strength", 0},
                 {"tensile_strength", 0},
                 {"extension_at_maximum_force", 1},
                 {"plastic_extension_at_maximum_force", 1},
                 {"extension_at_fracture", 1},
                 {"reduction_of_area", 0},
                 {"hardening_exponent", 3},
                 {"considere_strain", 3},
                 {"toughness", 1},
                 {"force_imbalance", 4},
                 {"kinetic_to_internal", 4},
                 {"unsteady_to_internal", 4}};
    note("%s", title);
    for (size_t k = 0; k < sizeof shown / sizeof *shown; k++)
        for (int i = 0; i < list->count; i++) {
            const struct property *row = &list->items[i];
            if (strcmp(row->name, shown[k].name) != 0 || isnan(row->value)) continue;
            note("  %-10s %10.*f %-5s %s", row->symbol, shown[k].decimals, row->value, row->unit,
                 row->flag ? row->flag : "");
        }
}

void properties_free(struct properties *list)
{
    for (int i = 0; i < list->count; i++) {
        free(list->items[i].name);
        free(list->items[i].symbol);
        free(list->items[i].definition);
    }
    free(list->items);
    *list = (struct properties){0};
}
