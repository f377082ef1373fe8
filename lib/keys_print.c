#include "keys.h"

#include "die.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How a manual is set: what stands before, between and behind the texts of a row. */
static const struct layout {
    const char *special;               /* characters that the format would take for its own */
    const char *section[3];            /* path, help */
    const char *key[4];                /* name, what it takes, help */
    const char *variant[4];            /* chooser, name, help */
    const char *rows[2], *own_rows[2]; /* around those of a section, of a variant */
} layouts[] = {
    [KEYS_TEXT] = {"",
                   {"", "\n    ", "\n\n"},
                   {"  ", " [", "]\n      ", "\n"},
                   {"  ", ": ", "\n      ", "\n"},
                   {"", "\n"},
                   {"", ""}},
    [KEYS_MDOC] = {"\\",
                   {".Ss ", "\n", "\n"},
                   {".It Cm ", "\n[", "]\n", "\n"},
                   {".It Cm ", " : Li ", "\n", "\n"},
                   {".Bl -tag -width Ds\n", ".El\n"},
                   {".Bl -tag -width Ds\n", ".El\n"}},
    [KEYS_MARKDOWN] = {"\\|*<`",
                       {"### ", "\n\n", "\n\n"},
                       {"| `", "` | ", " | ", " |\n"},
                       {"| **`", ": ", "`** | | ", " |\n"},
                       {"| key | takes | what |\n|---|---|---|\n", "\n"},
                       {"", ""}},
};

enum { MOST_SECTIONS = 200 };

struct printer {
    FILE *file;
    enum keys_format format;
    const struct layout *layout;
    const struct section *printed[MOST_SECTIONS];
    int count;
};

/* --- words and numbers ------------------------------------------------------------------------ */

static void put(const struct printer *to, const char *text)
{
    fputs(text, to->file);
}

/* Special characters escaped, one space behind a sentence, in mdoc a new line; NULL: nothing. */
static void put_words(const struct printer *to, const char *text)
{
    const bool mdoc = to->format == KEYS_MDOC;
    bool first = true;
    for (const char *c = text; c && *c; c++) {
        const bool sentence = c[0] == '.' && c[1] == ' ';
        if (mdoc && first && (*c == '.' || *c == '\'')) put(to, "\\&");
        if (strchr(to->layout->special, *c)) put(to, "\\");
        fputc(mdoc && *c == '\\' ? 'e' : *c, to->file);
        if (sentence) put(to, mdoc ? "\n" : " ");
        while (sentence && c[1] == ' ') c++;
        first = sentence;
    }
}

/* "1e6", "0.001", "2147483647": no more digits than it takes. */
static void put_number(const struct printer *to, double value)
{
    char plain[32], power[32];
    snprintf(plain, sizeof plain, "%.10g", value);
    snprintf(power, sizeof power, "%.0e", value);
    const bool round = strlen(plain) > 5 && strtod(power, NULL) == value;
    const char *text = round ? power : plain, *mark = strchr(text, 'e');
    fprintf(to->file, "%.*s", mark ? (int)(mark - text) : (int)strlen(text), text);
    if (mark) fprintf(to->file, "e%d", atoi(mark + 1));
}

/* --- what a key takes ------------------------------------------------------------------------- */

static void put_range(const struct printer *to, const struct key *key)
{
    const bool low = isfinite(key->low), high = isfinite(key->high);
    if (low || high) put(to, low && high ? ", " : low ? ", at least " : ", at most ");
    if (low) put_number(to, key->low);
    if (low && high) put(to, " to ");
    if (high) put_number(to, key->high);
    if (key->kind == KEY_SPACINGS) put(to, " spacings");
}

static void put_names(const struct printer *to, const char *const names[])
{
    for (int i = 0; names[i]; i++) fprintf(to->file, "%s%s", i ? ", " : "", names[i]);
}

static void put_numbers(const struct printer *to, const struct key *key)
{
    const bool pure = !key->unit || strcmp(key->unit, "1") == 0;
    if (key->size && key->rising) put(to, "[low, high], ");
    if (key->size && !key->rising)
        fprintf(to->file, key->kind == KEY_SPACING ? "number or list of %d, " : "list of %d, ",
                key->size);
    put(to, key->kind == KEY_LENGTH || key->kind == KEY_SPACINGS ? "m or spacings"
            : key->kind == KEY_INTEGER                           ? "whole number"
            : key->kind == KEY_SPACING                           ? "m"
            : pure                                               ? "number"
                                                                 : key->unit);
    put_range(to, key);
}

static void put_values(const struct printer *to, const struct key *key)
{
    switch (key->kind) {
    case KEY_CHOICE:
        put_names(to, key->names);
        break;
    case KEY_FLAG:
        put(to, "true or false");
        break;
    case KEY_TEXT:
    case KEY_SECTION:
    case KEY_NODE:
        put_words(to, key->form ? key->form : key->kind == KEY_TEXT ? "text" : "mapping");
        if (key->names) put(to, " of "), put_names(to, key->names);
        if (key->unit) fprintf(to->file, ", %s", key->unit), put_range(to, key);
        break;
    default:
        put_numbers(to, key);
    }
}

static void put_default(const struct printer *to, const struct key *key)
{
    const bool number = key->kind <= KEY_INTEGER;
    if (key->required) {
        put(to, "; required");
    } else if (key->otherwise) {
        put(to, *key->otherwise ? "; default: " : "");
        put_words(to, key->otherwise);
    } else if (key->kind == KEY_CHOICE) {
        fprintf(to->file, "; default %s", key->names[(int)key->usual]);
    } else if (key->kind == KEY_FLAG) {
        fprintf(to->file, "; default %s", key->usual > 0 ? "true" : "false");
    } else if (!number || isnan(keys_usual(key, 0))) {
        put(to, "; optional");
    } else {
        put(to, key->size ? "; default [" : "; default ");
        put_number(to, keys_usual(key, 0));
        for (int k = 1; k < key->size; k++) put(to, ", "), put_number(to, keys_usual(key, k));
        put(to, key->size ? "]" : key->kind == KEY_SPACINGS ? " spacings" : "");
    }
}

/* "; explicit and hybrid only" of a key that not all variants have. */
static void put_users(const struct printer *to, const struct section *section,
                      const struct key *key)
{
    const char *before = "; ";
    for (int i = 0; key->users && section->variant(i); i++) {
        if (!(key->users >> i & 1)) continue;
        fprintf(to->file, "%s%s", before, section->variant(i)->name);
        before = " and ";
    }
    if (key->users) put(to, " only");
}

/* --- sections --------------------------------------------------------------------------------- */

static void put_keys(const struct printer *to, const struct section *section,
                     const struct keys *keys)
{
    const char *const *marks = to->layout->key;
    for (int i = 0; i < keys->count; i++) {
        const struct key *key = &keys->rows[i];
        fprintf(to->file, "%s%s%s", marks[0], key->name, marks[1]);
        put_values(to, key);
        put_default(to, key);
        if (keys == &section->keys) put_users(to, section, key);
        put(to, marks[2]);
        put_words(to, key->help);
        put(to, marks[3]);
    }
}

static void put_chooser(const struct printer *to, const struct section *section)
{
    const char *const *marks = to->layout->key;
    fprintf(to->file, "%s%s%s", marks[0], section->chooser, marks[1]);
    for (int i = 0; section->variant(i); i++)
        fprintf(to->file, "%s%s", i ? ", " : "", section->variant(i)->name);
    if (section->usual >= 0)
        fprintf(to->file, "; default %s", section->variant(section->usual)->name);
    fprintf(to->file, "%s%sSee below.%s", section->usual < 0 ? "; required" : "", marks[2],
            marks[3]);
}

static void put_variants(const struct printer *to, const struct section *section)
{
    const char *const *marks = to->layout->variant;
    for (int i = 0; section->variant(i); i++) {
        const struct variant *variant = section->variant(i);
        fprintf(to->file, "%s%s%s%s%s", marks[0], section->chooser, marks[1], variant->name,
                marks[2]);
        put_words(to, variant->help);
        put(to, marks[3]);
        if (variant->keys.count == 0) continue;
        put(to, to->layout->own_rows[0]);
        put_keys(to, section, &variant->keys);
        put(to, to->layout->own_rows[1]);
    }
}

static void put_section(const struct printer *to, const struct section *section)
{
    const bool chooses = section->variant && !section->outside;
    const char *const *marks = to->layout->section;
    fprintf(to->file, "%s%s%s", marks[0], section->path, marks[1]);
    put_words(to, section->help);
    fprintf(to->file, "%s%s", marks[2], to->layout->rows[0]);
    if (chooses) put_chooser(to, section);
    put_keys(to, section, &section->keys);
    if (chooses) put_variants(to, section);
    put(to, to->layout->rows[1]);
}

static void visit(struct printer *to, const struct section *section);

static void visit_keys(struct printer *to, const struct keys *keys)
{
    for (int i = 0; i < keys->count; i++)
        if (keys->rows[i].section) visit(to, keys->rows[i].section);
}

/* Prints the section and those that its keys name, each once. */
static void visit(struct printer *to, const struct section *section)
{
    for (int i = 0; i < to->count; i++)
        if (to->printed[i] == section) return;
    if (to->count == MOST_SECTIONS) die_run("a manual of more than %d sections", MOST_SECTIONS);
    to->printed[to->count++] = section;
    put_section(to, section);
    visit_keys(to, &section->keys);
    for (int i = 0; section->variant && section->variant(i); i++)
        visit_keys(to, &section->variant(i)->keys);
}

void keys_print(FILE *file, const struct section *const sections[], enum keys_format format)
{
    struct printer to = {.file = file, .format = format, .layout = &layouts[format]};
    for (int i = 0; sections[i]; i++) visit(&to, sections[i]);
}
