#include "completion.h"

#include "die.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Arguments that are names of files or folders; the others have no list. */
static bool is_file(const struct option_row *row)
{
    static const char *const files[] = {"FILE", "LIST", "DIRECTORY", "BASENAME"};
    for (size_t i = 0; row->argument && i < sizeof files / sizeof *files; i++)
        if (strcmp(row->argument, files[i]) == 0) return true;
    return false;
}

/* "iso|astm": the words that it may be. */
static bool has_words(const struct option_row *row)
{
    return row->argument && strchr(row->argument, '|');
}

/* Those words, with blanks between. */
static void print_list(const char *words)
{
    for (; *words; words++) putchar(*words == '|' ? ' ' : *words);
}

static bool takes_word(const struct option_row *row)
{
    return row->argument && *row->argument != '[';
}

/* "-o|--output" of the rows that the test holds for, between bars; returns whether there is one. */
static bool print_pattern(const struct option_row *const rows[], int count, bool files)
{
    bool any = false;
    for (int i = 0; i < count; i++) {
        if (!takes_word(rows[i]) || has_words(rows[i]) || is_file(rows[i]) != files) continue;
        if (rows[i]->letter) printf("%s-%c", any ? "|" : "", rows[i]->letter);
        printf("%s--%s", any || rows[i]->letter ? "|" : "", rows[i]->name);
        any = true;
    }
    return any;
}

static void print_bash(const char *program, const struct option_row *const rows[], int count)
{
    printf("# bash completion for %s, made by %s --completion bash\n_%s()\n{\n", program, program,
           program);
    printf("    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    COMPREPLY=()\n"
           "    case $before in\n    ");
    if (print_pattern(rows, count, true))
        printf(")\n        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n        return ;;\n  "
               "  ");
    if (print_pattern(rows, count, false)) printf(") return ;;\n    ");
    for (int i = 0; i < count; i++) {
        if (!has_words(rows[i])) continue;
        printf("--%s)\n        mapfile -t COMPREPLY < <(compgen -W '", rows[i]->name);
        print_list(rows[i]->argument);
        printf("' -- \"$word\")\n        return ;;\n    ");
    }
    printf("esac\n"
           "    if [[ $word != -* ]]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
           "        return\n"
           "    fi\n"
           "    mapfile -t COMPREPLY < <(compgen -W '");
    for (int i = 0; i < count; i++) {
        if (rows[i]->letter) printf("-%c ", rows[i]->letter);
        printf("--%s%s", rows[i]->name, i + 1 < count ? " " : "");
    }
    printf("' -- \"$word\")\n}\ncomplete -o filenames -F _%s %s\n", program, program);
}

/* Words in the single quotes of a shell, for _arguments, to which brackets and colons are special.
 */
static void print_words(const char *words)
{
    for (; *words; words++) {
        if (strchr("[]:\\", *words)) putchar('\\');
        fputs(*words == '\'' ? "'\\''" : (char[]){*words, '\0'}, stdout);
    }
}

static void print_zsh_row(const struct option_row *row, char letter)
{
    printf(" \\\n    '");
    if (letter)
        printf("-%c", letter);
    else
        printf("--%s%s", row->name, takes_word(row) ? "=" : row->argument ? "=-" : "");
    putchar('[');
    print_words(row->help);
    putchar(']');
    if (takes_word(row)) {
        putchar(':');
        print_words(has_words(row) ? row->name : row->argument);
        fputs(is_file(row) ? ":_files" : has_words(row) ? ":(" : ": ", stdout);
        if (has_words(row)) print_list(row->argument);
        if (has_words(row)) putchar(')');
    }
    putchar('\'');
}

static void print_zsh(const char *program, const struct option_row *const rows[], int count)
{
    printf("#compdef %s\n# made by %s --completion zsh\n_arguments -s", program, program);
    for (int i = 0; i < count; i++) {
        if (rows[i]->letter) print_zsh_row(rows[i], rows[i]->letter);
        print_zsh_row(rows[i], '\0');
    }
    printf(" \\\n    '*:file:_files'\n");
}

void completion_print(const char *shell, const char *program, const struct option_row *const rows[],
                      int count)
{
    if (strcmp(shell, "bash") == 0)
        print_bash(program, rows, count);
    else if (strcmp(shell, "zsh") == 0)
        print_zsh(program, rows, count);
    else
        die_user("--completion %s: expected bash or zsh", shell);
}
