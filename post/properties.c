#include "properties.h"

#include "csv.h"
#include "die.h"
#include "memory.h"
#include "varied_columns.h"

#include <jansson.h>
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

void properties_write_csv(FILE *file, const struct properties lists[], const struct label labels[],
                          int count)
{
    struct varied_columns columns = varied_columns_of(labels, count);
    const bool many = count > 1 || columns.count > 0;
    fputs(many ? "curve,file,varied" : "", file);
    varied_columns_heading(file, &columns, VARIED_QUESTION);
    fprintf(file, "%sproperty,symbol,value,unit,uncertainty,definition\n", many ? "," : "");
    for (int k = 0; k < count; k++)
        for (int i = 0; i < lists[k].count; i++) {
            const char *const texts[] = {labels[k].curve, labels[k].file, labels[k].varied};
            for (int j = 0; many && j < 3; j++) {
                if (j) fputc(',', file);
                csv_text(file, texts[j]);
            }
            varied_columns_values(file, &columns, &labels[k], VARIED_QUESTION);
            if (many) fputc(',', file);
            write_row(file, &lists[k].items[i]);
        }
    varied_columns_free(&columns);
}

static json_t *json_text(const char *text)
{
    json_t *string = json_string(text);
    if (!string) die_user("'%s' is not UTF-8, which JSON is made of; give another --title", text);
    return string;
}

/* null for what is no number. */
static json_t *json_number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

/* What varied, as the study writes it. */
static json_t *json_values(const struct varied *varied)
{
    json_t *values = json_object();
    for (int i = 0; i < varied->count; i++)
        json_object_set_new(values, varied->items[i].name, json_text(varied->items[i].value));
    return values;
}

static json_t *object_of(const struct property *property, const struct label *label)
{
    json_t *object = json_object();
    if (label) {
        json_object_set_new(object, "curve", json_text(label->curve));
        json_object_set_new(object, "file", json_text(label->file));
        json_object_set_new(object, "varied", json_text(label->varied));
        if (label->values.count) json_object_set_new(object, "values", json_values(&label->values));
    }
    json_object_set_new(object, "property", json_text(property->name));
    json_object_set_new(object, "symbol", json_text(property->symbol));
    json_object_set_new(object, "value", json_number(property->value));
    json_object_set_new(object, "unit", json_text(property->unit));
    json_object_set_new(object, "uncertainty", json_number(property->uncertainty));
    json_object_set_new(object, "definition", json_text(property->definition));
    if (property->flag) json_object_set_new(object, "flag", json_text(property->flag));
    return object;
}

void properties_write_json(FILE *file, const struct properties lists[], const struct label labels[],
                           int count)
{
    json_t *array = json_array();
    for (int k = 0; k < count; k++)
        for (int i = 0; i < lists[k].count; i++)
            json_array_append_new(array,
                                  object_of(&lists[k].items[i], count > 1 ? &labels[k] : NULL));
    json_dumpf(array, file, JSON_INDENT(2));
    fputc('\n', file);
    json_decref(array);
}

double properties_value(const struct properties *list, const char *name)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->items[i].name, name) == 0) return list->items[i].value;
    return NAN;
}

/* What people look at first. */
static const struct {
    const char *name;
    int decimals;
} shown[] = {{"modulus", 1},
             {"modulus_deviation", 2},
             {"proof_strength_0.2", 0},
             {"upper_yield_strength", 0},
             {"lower_yield_strength", 0},
             {"yield_point_extension", 2},
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

const char *properties_main(int i)
{
    return i < (int)(sizeof shown / sizeof *shown) ? shown[i].name : NULL;
}

void properties_print(const struct properties *list, const char *title)
{
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
