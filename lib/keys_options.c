#include "keys_options.h"

#include "die.h"
#include "memory.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static char *option_name(const struct key *key)
{
    char *name = memory_text(key->name);
    for (char *mark = name; (mark = strchr(mark, '_'));) *mark = '-';
    return name;
}

/* "iso|astm" */
static char *words_of(const char *const *names)
{
    char *words = memory_text(*names);
    while (*++names) words = memory_append(words, "|%s", *names);
    return words;
}

static char *argument_of(const struct key *key)
{
    if (key->kind == KEY_CHOICE) return words_of(key->names);
    return memory_text(key->kind == KEY_TEXT          ? "TEXT"
                       : key->size                    ? "A:B"
                       : strcmp(key->unit, "m") == 0  ? "LENGTH"
                       : strcmp(key->unit, "m2") == 0 ? "AREA"
                       : strcmp(key->unit, "Pa") == 0 ? "STRESS"
                                                      : "NUMBER");
}

/* The key's words with its default in parentheses. */
static char *option_help(const struct key *key)
{
    if (key->otherwise) return memory_print("%s (%s)", key->help, key->otherwise);
    if (key->kind == KEY_CHOICE)
        return memory_print("%s (%s)", key->help, key->names[(int)key->usual]);
    if (key->usuals) return memory_print("%s (%g:%g)", key->help, key->usuals[0], key->usuals[1]);
    return isnan(key->usual) ? memory_text(key->help)
                             : memory_print("%s (%g)", key->help, key->usual);
}

void keys_options(const struct keys *keys, struct option_row rows[], const char *texts[])
{
    for (int i = 0; i < keys->count; i++)
        rows[i] = (struct option_row){.name = option_name(&keys->rows[i]),
                                      .argument = argument_of(&keys->rows[i]),
                                      .help = option_help(&keys->rows[i]),
                                      .value = &texts[i]};
}

void keys_options_free(const struct keys *keys, struct option_row rows[])
{
    for (int i = 0; i < keys->count; i++) {
        free((char *)rows[i].name);
        free((char *)rows[i].argument);
        free((char *)rows[i].help);
    }
}

static double read_number(const struct key *key, const char *option, const char *text)
{
    double value;
    const char *wrong = units_read(text, key->unit, &value);
    if (wrong) die_user("--%s: %s", option, wrong);
    if (!(value >= key->low && value <= key->high))
        die_user("--%s: %s is out of range, expected %g to %g%s%s", option, text, key->low,
                 key->high, strcmp(key->unit, "1") == 0 ? "" : " ",
                 strcmp(key->unit, "1") == 0 ? "" : key->unit);
    return value;
}

static void read_range(const struct key *key, const char *option, const char *text,
                       double values[2])
{
    char *low = memory_text(text), *colon = strchr(low, ':');
    if (!colon) die_user("--%s: '%s', expected A:B", option, text);
    *colon = '\0';
    values[0] = read_number(key, option, low);
    values[1] = read_number(key, option, colon + 1);
    if (values[0] >= values[1])
        die_user("--%s: '%s', the first must be below the second", option, text);
    free(low);
}

static int read_choice(const struct key *key, const char *option, const char *text)
{
    char *known = memory_text("");
    for (int i = 0; key->names[i]; i++) {
        if (strcmp(key->names[i], text) == 0) {
            free(known);
            return i;
        }
        known = memory_append(known, "%s%s", i ? ", " : "", key->names[i]);
    }
    die_user("--%s: '%s', expected one of %s", option, text, known);
}

void keys_read_options(const struct keys *keys, const char *const texts[], void *out)
{
    for (int i = 0; i < keys->count; i++) {
        const struct key *key = &keys->rows[i];
        void *place = (char *)out + key->place;
        if (!texts[i]) continue;
        char *option = option_name(key);
        if (key->kind == KEY_TEXT)
            *(const char **)place = texts[i];
        else if (key->kind == KEY_CHOICE)
            *(int *)place = read_choice(key, option, texts[i]);
        else if (key->size)
            read_range(key, option, texts[i], place);
        else
            *(double *)place = read_number(key, option, texts[i]);
        free(option);
    }
}
