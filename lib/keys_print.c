#include "keys.h"

#include "die.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How a manual is set: what stands before, between and after the texts of a row. */
static const struct layout {
    const char *section[3];               /* path, help */
    const char *open, *close;             /* of a section's rows */
    const char *key[4];                   /* name, what it takes, help */
    const char *variant[4];               /* chooser, name, help */
    const char *open_inner, *close_inner; /* of a variant's rows */
    const char *special;                  /* characters that the format would take for its own */
} layouts[] = {
    [KEYS_TEXT] = {.section = {"", "\n    ", "\n\n"},
                   .open = "",
                   .close = "\n",
                   .key = {"  ", " [", "]\n      ", "\n"},
                   .variant = {"  ", ": ", "\n      ", "\n"},
                   .open_inner = "",
                   .close_inner = "",
                   .special = ""},
    [KEYS_MDOC] = {.section = {".Ss ", "\n", "\n"},
                   .open = ".Bl -tag -width Ds\n",
                   .close = ".El\n",
                   .key = {".It Cm ", "\n[", "]\n", "\n"},
                   .variant = {".It Cm ", " : Li ", "\n", "\n"},
                   .open_inner = ".Bl -tag -width Ds\n",
                   .close_inner = ".El\n",
                   .special = "\\"},
    [KEYS_MARKDOWN] = {.section = {"### ", "\n\n", "\n\n"},
                       .open = "| key | takes | what |\n|---|---|---|\n",
                       .close = "\n",
                       .key = {"| `", "` | ", " | ", " |\n"},
                       .variant = {"| **`", ": ", "`** | | ", " |\n"},
                       .open_inner = "",
                       .close_inner = "",
                       .special = "\\|*<`"},
};

enum { MOST_SECTIONS = 200 };

struct printer {
    FILE *file;
    enum keys_format format;
    const struct layout *layout;
    const struct section *printed[MOST_SECTIONS];
    int count;
};

/* --- what a key takes ------------------------------------------------------------------------- */

/* "1e6", "0.001", "2147483647": no more digits than it takes. */
static void write_number(FILE *file, double value)
{
    char plain[32], power[32];
    snprintf(plain, sizeof plain, "%.10g", value);
    snprintf(power, sizeof power, "%.0e", value);
    const bool round = strlen(plain) > 5 && strtod(power, NULL) == value;
    const char *text = round ? power : plain, *mark = strchr(text, 'e');
    if (mark)
        fprintf(file, "%.*se%d", (int)(mark - text), text, atoi(mark + 1));
    else
        fputs(text, file);
}

static void write_range(FILE *file, const struct key *key)
{
    if (key->low > -HUGE_VAL || key->high < HUGE_VAL) fputs(", ", file);
    if (key->low > -HUGE_VAL) {
        fputs(key->high < HUGE_VAL ? "" : "at least ", file);
        write_number(file, key->low);
    }
    if (key->high < HUGE_VAL) {
        fputs(key->low > -HUGE_VAL ? " to " : "at most ", file);
        write_number(file, key->high);
    }
    if (key->kind == KEY_SPACINGS) fputs(" spacings", file);
}

static void write_names(FILE *file, const char *const names[])
{
    for (int i = 0; names[i]; i++) fprintf(file, "%s%s", i ? ", " : "", names[i]);
}

static void write_values(FILE *file, const struct key *key)
{
    const bool pure = !key->unit || strcmp(key->unit, "1") == 0;
    const bool length = key->kind == KEY_LENGTH || key->kind == KEY_SPACINGS;
    switch (key->kind) {
    case KEY_CHOICE:
        write_names(file, key->names);
        break;
    case KEY_FLAG:
        fputs("true or false", file);
        break;
    case KEY_TEXT:
        fputs(key->form ? key->form : "text", file);
        break;
    case KEY_SECTION:
    case KEY_NODE:
        fputs(key->form ? key->form : "mapping", file);
        if (key->names) fputs(" of ", file), write_names(file, key->names);
        if (key->unit) fprintf(file, ", %s", key->unit), write_range(file, key);
        break;
    default:
        if (key->rising) fputs("[low, high], ", file);
        if (key->size && !key->rising) fprintf(file, "list of %d, ", key->size);
        fputs(length                     ? "m or spacings"
              : key->kind == KEY_INTEGER ? "whole number"
              : key->kind == KEY_SPACING ? "m"
              : pure                     ? "number"
                                         : key->unit,
              file);
        write_range(file, key);
    }
}

static void write_default(FILE *file, const struct key *key)
{
    const bool number = key->kind <= KEY_INTEGER;
    const int size = key->size ? key->size : 1;
    if (key->required) {
        fputs("; required", file);
    } else if (key->otherwise) {
        fprintf(file, "; default: %s", key->otherwise);
    } else if (key->kind == KEY_CHOICE) {
        fprintf(file, "; default %s", key->names[(int)key->usual]);
    } else if (key->kind == KEY_FLAG) {
        fprintf(file, "; default %s", key->usual > 0 ? "true" : "false");
    } else if (!number || (!key->usuals && isnan(key->usual))) {
        fputs("; optional", file);
    } else {
        fputs(key->size ? "; default [" : "; default ", file);
        for (int k = 0; k < size; k++) {
            if (k) fputs(", ", file);
            write_number(file, keys_usual(key, k));
        }
        fprintf(file, "%s%s", key->size ? "]" : "", key->kind == KEY_SPACINGS ? " spacings" : "");
    }
}

/* "; explicit and hybrid only" of a key that not all variants have. */
static void write_users(FILE *file, const struct section *section, const struct key *key)
{
    const char *before = "; ";
    for (int i = 0; key->users && section->variant(i); i++) {
        if (!(key->users >> i & 1)) continue;
        fprintf(file, "%s%s", before, section->variant(i)->name);
        before = " and ";
    }
    if (key->users) fputs(" only", file);
}

/* --- rows --------------------------------------------------------------------------------------- */

/* Special characters escaped, one space behind a sentence, in mdoc a new line; NULL: nothing. */
static void put_words(const struct printer *to, const char *text)
{
    const bool mdoc = to->format == KEYS_MDOC;
    bool first = true;
    for (const char *c = text; c && *c; c++) {
        const bool sentence = c[0] == '.' && c[1] == ' ';
        if (mdoc && first && (*c == '.' || *c == '\'')) fputs("\\&", to->file);
        if (strchr(to->layout->special, *c)) fputc('\\', to->file);
        fputc(mdoc && *c == '\\' ? 'e' : *c, to->file);
        if (sentence) fputc(mdoc ? '\n' : ' ', to->file);
        while (sentence && c[1] == ' ') c++;
        first = sentence;
    }
}

static void put_row(const struct printer *to, const char *const marks[4], const char *first,
                    const char *second, const char *help)
{
    fprintf(to->file, "%s%s%s", marks[0], first, marks[1]);
    put_words(to, second);
    fputs(marks[2], to->file);
    put_words(to, help);
    fputs(marks[3], to->file);
}

static void put_keys(const struct printer *to, const struct section *section,
                     const struct keys *keys)
{
    for (int i = 0; i < keys->count; i++) {
        const struct key *key = &keys->rows[i];
        char *takes;
        size_t length;
        FILE *words = open_memstream(&takes, &length);
        if (!words) die_run("out of memory for the manual");
        write_values(words, key);
        write_default(words, key);
        if (keys == &section->keys) write_users(words, section, key);
        fclose(words);
        put_row(to, to->layout->key, key->name, takes, key->help);
        free(takes);
    }
}

static void put_chooser(const struct printer *to, const struct section *section)
{
    fprintf(to->file, "%s%s%s", to->layout->key[0], section->chooser, to->layout->key[1]);
    for (int i = 0; section->variant(i); i++)
        fprintf(to->file, "%s%s", i ? ", " : "", section->variant(i)->name);
    if (section->usual < 0)
        fputs("; required", to->file);
    else
        fprintf(to->file, "; default %s", section->variant(section->usual)->name);
    fprintf(to->file, "%sSee below.%s", to->layout->key[2], to->layout->key[3]);
}

static void put_variants(const struct printer *to, const struct section *section)
{
    for (int i = 0; section->variant(i); i++) {
        const struct variant *variant = section->variant(i);
        put_row(to, to->layout->variant, section->chooser, variant->name, variant->help);
        if (variant->keys.count == 0) continue;
        fputs(to->layout->open_inner, to->file);
        put_keys(to, section, &variant->keys);
        fputs(to->layout->close_inner, to->file);
    }
}

static void put_section(const struct printer *to, const struct section *section)
{
    const bool chooses = section->variant && !section->outside;
    fprintf(to->file, "%s%s%s", to->layout->section[0], section->path, to->layout->section[1]);
    put_words(to, section->help);
    fprintf(to->file, "%s%s", to->layout->section[2], to->layout->open);
    if (chooses) put_chooser(to, section);
    put_keys(to, section, &section->keys);
    if (chooses) put_variants(to, section);
    fputs(to->layout->close, to->file);
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
