#include "options.h"

#include "completion.h"
#include "deck.h"
#include "die.h"
#include "exodus.h"
#include "keys.h"
#include "memory.h"
#include "random.h"
#include "version.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* getopt_long reports row i of the table as LONG_OPTION + i, letters as themselves. */
enum { LONG_OPTION = 256, HELP_COLUMN = 30 };

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "GCC " __VERSION__
#endif

static const struct option_row built_in[] = {
    {'h', "help", NULL, "print this and leave", NULL, NULL},
    {'V', "version", NULL, "print the version and leave", NULL, NULL},
    {0, "completion", "bash|zsh", "print what bash or zsh completes by, and leave", NULL, NULL},
    {0, "keys", "[=FORMAT]", "print the deck's keys (text, mdoc, markdown) and leave", NULL, NULL},
};
enum { HELP, VERSION, COMPLETION, KEYS_OPTION, BUILT_IN };

/* Rows of the table and built in ones; without sections there is no --keys. */
static int count_rows(const struct option_table *table)
{
    return table->count + (table->sections ? BUILT_IN : KEYS_OPTION);
}

static const struct option_row *row_at(const struct option_table *table, int i)
{
    return i < table->count ? &table->rows[i] : &built_in[i - table->count];
}

static void print_help(const struct option_table *table)
{
    printf("Usage: %s %s\n\n%s\n\n", table->program, table->synopsis, table->purpose);
    for (int i = 0; i < count_rows(table); i++) {
        const struct option_row *row = row_at(table, i);
        char letter[] = "-?, ";
        letter[1] = row->letter;
        const char *argument = row->argument ? row->argument : "";
        int printed = printf("  %s--%s%s%s", row->letter ? letter : "    ", row->name,
                             *argument && *argument != '[' ? " " : "", argument);
        printf("%*s%s\n", printed < HELP_COLUMN ? HELP_COLUMN - printed : 1, "", row->help);
    }
}

static _Noreturn void leave_after_printing(void)
{
    if (fflush(stdout) != 0 || ferror(stdout)) die_run("cannot write to standard output");
    exit(EXIT_SUCCESS);
}

/* Fills getopt_long's two descriptions of the options. */
static void describe(const struct option_table *table, char *letters, struct option *names)
{
    for (int i = 0; i < count_rows(table); i++) {
        const struct option_row *row = row_at(table, i);
        names[i].name = row->name;
        names[i].has_arg = !row->argument            ? no_argument
                           : row->argument[0] == '[' ? optional_argument
                                                     : required_argument;
        names[i].val = LONG_OPTION + i;
        if (row->letter == 0) continue;
        *letters++ = row->letter;
        if (row->argument) *letters++ = ':';
    }
}

static const struct option_row *row_of(const struct option_table *table, int found)
{
    if (found >= LONG_OPTION) return row_at(table, found - LONG_OPTION);
    for (int i = 0; i < count_rows(table); i++)
        if (row_at(table, i)->letter == found) return row_at(table, i);
    return NULL;
}

static void print_keys(const struct option_table *table, const char *format)
{
    static const char *const formats[] = {"text", "mdoc", "markdown"};
    for (int i = 0; i < 3; i++) {
        if (format && strcmp(format, formats[i]) != 0) continue;
        keys_print(stdout, table->sections, (enum keys_format)i);
        leave_after_printing();
    }
    die_user("--keys=%s: expected text, mdoc or markdown", format);
}

static _Noreturn void print_completion(const struct option_table *table, const char *shell)
{
    const int count = count_rows(table);
    const struct option_row **rows = memory_new((size_t)count, sizeof *rows);
    for (int i = 0; i < count; i++) rows[i] = row_at(table, i);
    completion_print(shell, table->program, rows, count);
    free(rows);
    leave_after_printing();
}

/* Options that print something and leave; others return. */
static void leave_by(const struct option_table *table, const struct option_row *row,
                     const char *argument)
{
    if (row == &built_in[HELP]) {
        print_help(table);
        leave_after_printing();
    }
    if (row == &built_in[VERSION]) {
        fputs(options_version(), stdout);
        leave_after_printing();
    }
    if (row == &built_in[COMPLETION]) print_completion(table, argument);
    if (row == &built_in[KEYS_OPTION]) print_keys(table, argument);
}

static void take(const struct option_row *row)
{
    if (row->argument)
        *row->value = optarg;
    else
        *row->flag = true;
}

static bool is_built_in(const struct option_row *row)
{
    return row >= built_in && row < built_in + sizeof built_in / sizeof *built_in;
}

int options_read(const struct option_table *table, int argc, char **argv)
{
    size_t rows = (size_t)count_rows(table);
    char *letters = memory_new(2 * rows + 1, 1);
    struct option *names = memory_new(rows + 1, sizeof *names);
    describe(table, letters, names);
    optind = 0; /* glibc: start afresh */
    int found;
    const struct option_row *last = NULL;
    while (!last && (found = getopt_long(argc, argv, letters, names, NULL)) != -1) {
        const struct option_row *row = row_of(table, found);
        /* getopt has said what is wrong. */
        if (row == NULL) die_user("try '%s --help'", table->program);
        if (is_built_in(row))
            last = row;
        else
            take(row);
    }
    const int first = optind;
    free(letters);
    free(names);
    if (last) leave_by(table, last, optarg);
    return first;
}

const char *options_version(void)
{
    static char text[512];
    snprintf(text, sizeof text, "%s %s\n%s\n%s\n%s\n%s\n", die_program(), hs_version, COMPILER,
             exodus_library(), deck_library(), random_library());
    return text;
}

/* $'a\\nb': of one line, whatever is in it. */
static char *quoted_controls(const char *word)
{
    char *text = memory_new(4 * strlen(word) + 4, 1), *end = stpcpy(text, "$'");
    for (; *word != '\0'; word++) {
        const unsigned char c = (unsigned char)*word;
        if (c == '\'' || c == '\\') *end++ = '\\';
        if (c < 0x20 || c == 0x7f)
            end += sprintf(end, "\\%03o", c);
        else
            *end++ = *word;
    }
    *end = '\'';
    return text;
}

static bool has_controls(const char *word)
{
    for (; *word != '\0'; word++)
        if ((unsigned char)*word < 0x20 || *word == 0x7f) return true;
    return false;
}

/* In single quotes unless the shell would read it unchanged. */
static char *quoted(const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                "0123456789_-+=./,:@%";
    if (*word != '\0' && strspn(word, plain) == strlen(word)) return memory_text(word);
    if (has_controls(word)) return quoted_controls(word);
    char *text = memory_new(4 * strlen(word) + 3, 1), *end = text;
    *end++ = '\'';
    for (; *word != '\0'; word++) {
        if (*word == '\'')
            end = stpcpy(end, "'\\''");
        else
            *end++ = *word;
    }
    *end = '\'';
    return text;
}

char *options_command(int argc, char **argv)
{
    char *command = memory_text("");
    for (int i = 0; i < argc; i++) {
        char *word = quoted(argv[i]);
        command = memory_append(command, "%s%s", i > 0 ? " " : "", word);
        free(word);
    }
    return command;
}
