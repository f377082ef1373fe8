#include "domain_text.h"

#include "die.h"
#include "memory.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- columns --- */

enum column { COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_BLOCK, COLUMN_VOLUME, COLUMNS };
static const char *const names[COLUMNS][2] = {
    {"x", "x"}, {"y", "y"}, {"z", "z"}, {"block_id", "block"}, {"volume", "vol"}};

enum { MOST_COLUMNS = 64, MOST_BLOCKS = 16, LONGEST_NAME = 64, LONGEST_LINE = 4096 };
static const char between[] = " \t\r,;";

struct particle {
    double value[COLUMNS];
};

struct particles {
    const char *shown;
    int64_t count;
    struct particle *items;
    int n_columns, column[MOST_COLUMNS]; /* COLUMNS: passed over */
    bool flat;                           /* no column of z */
    int n_blocks;
    double numbers[MOST_BLOCKS]; /* rising */
    int n_names;
    struct {
        double number;
        char name[LONGEST_NAME];
    } names[MOST_BLOCKS]; /* where a comment has them */
};

/* What a line has to hold, for messages. */
static char *expected(const struct particles *all)
{
    char *list = memory_text("");
    for (int i = 0; i < all->n_columns; i++) {
        static const char *const shown[COLUMNS + 1] = {"x", "y", "z", "block", "volume", "..."};
        list = memory_append(list, "%s%s", i ? " " : "", shown[all->column[i]]);
    }
    return list;
}

static int find_column(const char *word, size_t length)
{
    for (int c = 0; c < COLUMNS; c++)
        for (int k = 0; k < 2; k++)
            if (strlen(names[c][k]) == length && strncasecmp(names[c][k], word, length) == 0)
                return c;
    return COLUMNS;
}

/* A line of words that names the columns; false where it is none. */
static bool read_header(struct particles *all, const char *line, long number)
{
    bool found[COLUMNS + 1] = {false};
    const char *at = line + strspn(line, between);
    const size_t word = strlen("header:");
    const bool said = strncasecmp(at, "header:", word) == 0;
    if (said) at += word + strspn(at + word, between);
    if (!said && find_column(at, strcspn(at, between)) == COLUMNS) return false;
    for (all->n_columns = 0; *at; all->n_columns++) {
        const size_t length = strcspn(at, between);
        if (all->n_columns == MOST_COLUMNS)
            die_user("%s:%ld: more than %d columns", all->shown, number, MOST_COLUMNS);
        const int column = find_column(at, length);
        if (column < COLUMNS && found[column])
            die_user("%s:%ld: two columns '%s'", all->shown, number, names[column][0]);
        if (column == COLUMNS)
            note("%s:%ld: column '%.*s' is passed over", all->shown, number, (int)length, at);
        all->column[all->n_columns] = column;
        found[column] = true;
        at += length + strspn(at + length, between);
    }
    for (int c = 0; c < COLUMNS; c++)
        if (!found[c] && c != COLUMN_Z)
            die_user("%s:%ld: no column '%s' among '%s'", all->shown, number, names[c][0], line);
    all->flat = !found[COLUMN_Z];
    return true;
}

/* --- lines --- */

static void append(struct particles *all, struct particle particle)
{
    all->items = memory_grow(all->items, all->count, sizeof particle);
    all->items[all->count++] = particle;
}

static void add_block(struct particles *all, double number, long line)
{
    int at = 0;
    while (at < all->n_blocks && all->numbers[at] < number) at++;
    if (at < all->n_blocks && all->numbers[at] == number) return;
    if (all->n_blocks == MOST_BLOCKS)
        die_user("%s:%ld: more than %d blocks", all->shown, line, MOST_BLOCKS);
    for (int i = all->n_blocks++; i > at; i--) all->numbers[i] = all->numbers[i - 1];
    all->numbers[at] = number;
}

static void read_line(struct particles *all, const char *line, long number)
{
    struct particle particle = {.value = {0}};
    const char *at = line + strspn(line, between);
    for (int i = 0; i < all->n_columns; i++) {
        char *end;
        const int column = all->column[i];
        const double value = strtod(at, &end);
        const size_t length = column == COLUMNS ? strcspn(at, between) : (size_t)(end - at);
        if (length == 0 ||
            (column < COLUMNS && (!isfinite(value) || (*end && !strchr(between, *end)))))
            die_user("%s:%ld: expected '%s', found '%s'", all->shown, number, expected(all), line);
        if (column < COLUMNS) particle.value[column] = value;
        at += length;
        at += strspn(at, between);
    }
    if (*at) die_user("%s:%ld: more than '%s' on the line", all->shown, number, expected(all));
    const double block = particle.value[COLUMN_BLOCK], volume = particle.value[COLUMN_VOLUME];
    if (block != floor(block) || block < 0 || block > INT32_MAX)
        die_user("%s:%ld: block %g, expected a whole number from 0 on", all->shown, number, block);
    if (!(volume > 0)) die_user("%s:%ld: volume %g, expected > 0", all->shown, number, volume);
    add_block(all, block, number);
    append(all, particle);
}

/* "blocks: 1 CG 2 UFG" in a comment */
static void read_names(struct particles *all, const char *comment)
{
    const char *at = strstr(comment, "blocks:");
    int block, length;
    char name[LONGEST_NAME];
    if (at) at += strlen("blocks:");
    while (at && all->n_names < MOST_BLOCKS &&
           sscanf(at, "%d %63s%n", &block, name, &length) == 2) {
        all->names[all->n_names].number = block;
        snprintf(all->names[all->n_names++].name, LONGEST_NAME, "%s", name);
        at += length;
    }
}

static struct particles read_particles(const struct spool *input, const char *shown)
{
    struct particles all = {.shown = shown, .n_columns = COLUMNS};
    for (int i = 0; i < COLUMNS; i++) all.column[i] = i;
    FILE *file = fopen(input->path, "r");
    if (!file) die_user("cannot open %s: %s", shown, strerror(errno));
    char line[LONGEST_LINE];
    bool first = true;
    for (long number = 1; fgets(line, sizeof line, file); number++) {
        size_t length = strcspn(line, "#\n");
        if (line[length] == '\0' && !feof(file)) die_user("%s:%ld: line too long", shown, number);
        if (line[length] == '#') read_names(&all, line + length);
        while (length > 0 && strchr(between, line[length - 1])) length--;
        line[length] = '\0';
        if (line[strspn(line, between)] == '\0') continue;
        if (!(first && read_header(&all, line, number))) read_line(&all, line, number);
        first = false;
    }
    if (ferror(file)) die_run("cannot read %s: %s", shown, strerror(errno));
    fclose(file);
    if (all.count == 0) die_user("%s has no particles", shown);
    return all;
}

/* --- the domain --- */

static char *name_of_block(const struct particles *all, double number, struct deck_node materials)
{
    for (int i = 0; i < all->n_names; i++)
        if (all->names[i].number == number) return memory_text(all->names[i].name);
    char *own = memory_print("block_%.0f", number);
    if (deck_has(materials, own)) return own;
    if (number < 1 || number > deck_count(materials))
        deck_error(materials,
                   "%s has block %.0f, but there are %d materials: call its material '%s', or name "
                   "the blocks in a comment of the file, '# blocks: 1 NAME 2 NAME'",
                   all->shown, number, deck_count(materials), own);
    free(own);
    return memory_text(deck_key(materials, (int)number - 1));
}

static void name_phases(struct domain *domain, const struct particles *all, const struct deck *deck)
{
    struct deck_node materials = deck_get(deck_root(deck), "materials");
    domain->n_phases = all->n_blocks;
    domain->phase_names = memory_new((size_t)domain->n_phases, sizeof(char *));
    for (int p = 0; p < domain->n_phases; p++)
        domain->phase_names[p] = name_of_block(all, all->numbers[p], materials);
}

static uint8_t phase_of(const struct particles *all, double number)
{
    uint8_t phase = 0;
    while (all->numbers[phase] != number) phase++;
    return phase;
}

struct domain domain_text_read(const struct spool *input, const char *shown,
                               const struct deck *deck)
{
    struct particles all = read_particles(input, shown);
    const size_t n = (size_t)all.count;
    struct domain domain = {0};
    domain_make_room(&domain, all.count);
    for (size_t i = 0; i < n; i++) {
        const double *value = all.items[i].value;
        domain.x[i] = value[COLUMN_X];
        domain.y[i] = value[COLUMN_Y];
        domain.z[i] = value[COLUMN_Z];
        domain.volume[i] = value[COLUMN_VOLUME];
        domain.phase[i] = phase_of(&all, value[COLUMN_BLOCK]);
    }
    if (all.flat) attributes_set_number(&domain.attributes, "dimensions", 2);
    free(all.items);
    name_phases(&domain, &all, deck);
    return domain;
}
