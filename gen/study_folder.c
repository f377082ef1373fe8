#include "study_folder.h"

#include "die.h"
#include "expansion.h"
#include "memory.h"
#include "output.h"
#include "study_make.h"
#include "study_slurm.h"
#include "taken.h"

#include <dirent.h>
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The decks of a study. */
struct runs {
    int count;
    char **texts;
    char **cores;  /* [count] file of the cores that the run takes; NULL: its own */
    long *numbers; /* [count] */
    bool *known;   /* [count] the deck is there already */
};

/* A folder of before with a deck, by its text. */
struct old_deck {
    char *text;
    long number;
    bool used; /* is of the study still */
    bool bare; /* there is nothing else in the folder */
};

/* What a folder holds of before. */
struct contents {
    int count, n_taken;
    struct old_deck *decks; /* [count] sorted by text */
    long *taken;            /* [n_taken] numbers that no new deck may have, rising */
};

static char *path_of(const char *folder, long number, const char *file)
{
    return memory_print("%s/%04ld%s%s", folder, number, *file ? "/" : "", file);
}

/* --- what is there ---------------------------------------------------------------------------- */

static long number_of(const char *name)
{
    const size_t digits = strspn(name, "0123456789");
    return digits >= 4 && !name[digits] && digits < 10 ? strtol(name, NULL, 10) : 0;
}

static int by_text(const void *a, const void *b)
{
    const struct old_deck *first = a, *second = b;
    return strcmp(first->text, second->text);
}

static int rising(const void *a, const void *b)
{
    const long first = *(const long *)a, second = *(const long *)b;
    return (first > second) - (first < second);
}

static void take_number(struct contents *contents, long number)
{
    contents->taken = memory_grow(contents->taken, contents->n_taken, sizeof *contents->taken);
    contents->taken[contents->n_taken++] = number;
}

static int count_entries(const char *path)
{
    DIR *directory = opendir(path);
    int count = 0;
    while (directory && readdir(directory)) count++;
    if (directory) closedir(directory);
    return count - 2;
}

static struct contents contents_of(const char *folder)
{
    struct contents contents = {0};
    DIR *directory = opendir(folder);
    const struct dirent *entry;
    while (directory && (entry = readdir(directory))) {
        const long number = number_of(entry->d_name);
        if (number <= 0) continue;
        char *run = path_of(folder, number, ""), *path = path_of(folder, number, "deck.yaml");
        struct stat status;
        if (stat(path, &status) == 0) {
            long length;
            contents.decks = memory_grow(contents.decks, contents.count, sizeof *contents.decks);
            contents.decks[contents.count++] =
                (struct old_deck){spool_text(path, status.st_size + 1, &length), number, false,
                                  count_entries(run) == 1};
        } else {
            take_number(&contents, number);
        }
        free(path);
        free(run);
    }
    if (directory) closedir(directory);
    if (contents.count)
        qsort(contents.decks, (size_t)contents.count, sizeof *contents.decks, by_text);
    return contents;
}

static void contents_free(struct contents *contents)
{
    for (int i = 0; i < contents->count; i++) free(contents->decks[i].text);
    free(contents->decks);
    free(contents->taken);
}

/* --- numbers ---------------------------------------------------------------------------------- */

/* The number of the deck of before that says the same; 0. */
static long known_number(struct contents *contents, const char *text)
{
    const struct old_deck wanted = {.text = (char *)text};
    if (contents->count == 0) return 0;
    struct old_deck *found = bsearch(&wanted, contents->decks, (size_t)contents->count,
                                     sizeof *contents->decks, by_text);
    if (!found || found->used) return 0;
    found->used = true;
    return found->number;
}

/* Results keep their numbers, and so do decks that are used. */
static void take_numbers(struct contents *contents)
{
    for (int i = 0; i < contents->count; i++)
        if (contents->decks[i].used || !contents->decks[i].bare)
            take_number(contents, contents->decks[i].number);
    if (contents->n_taken)
        qsort(contents->taken, (size_t)contents->n_taken, sizeof *contents->taken, rising);
}

/* The least number above the last one given that is not taken. */
static long free_number(const struct contents *contents, long last)
{
    for (last++; contents->n_taken && bsearch(&last, contents->taken, (size_t)contents->n_taken,
                                              sizeof *contents->taken, rising);)
        last++;
    return last;
}

/* Of the deck that makes the cores: the same deck, the same name (FNV-1a). */
static char *name_of_cores(const char *text)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (; *text; text++) hash = (hash ^ (unsigned char)*text) * 0x100000001b3u;
    return memory_print("cores/%016llx", (unsigned long long)hash);
}

static void make_texts(const struct expansion *expansion, struct runs *runs)
{
    for (int i = 0; i < runs->count; i++)
        if (expansion_maker(expansion, i) == i) runs->texts[i] = expansion_text(expansion, i, NULL);
    for (int i = 0; i < runs->count; i++) {
        if (runs->texts[i]) continue;
        runs->cores[i] = name_of_cores(runs->texts[expansion_maker(expansion, i)]);
        runs->texts[i] = expansion_text(expansion, i, runs->cores[i]);
    }
}

static struct runs make_runs(const struct expansion *expansion, struct contents *contents)
{
    const size_t n = (size_t)expansion->variations.runs;
    struct runs runs = {(int)n, memory_new(n, sizeof *runs.texts),
                        memory_new(n, sizeof *runs.cores), memory_new(n, sizeof *runs.numbers),
                        memory_new(n, sizeof *runs.known)};
    long last = 0;
    make_texts(expansion, &runs);
    for (size_t i = 0; i < n; i++) runs.numbers[i] = known_number(contents, runs.texts[i]);
    take_numbers(contents);
    for (size_t i = 0; i < n; i++) {
        runs.known[i] = runs.numbers[i] > 0;
        if (!runs.known[i]) runs.numbers[i] = last = free_number(contents, last);
    }
    return runs;
}

static void runs_free(struct runs *runs)
{
    for (int i = 0; i < runs->count; i++) {
        free(runs->texts[i]);
        free(runs->cores[i]);
    }
    free(runs->texts);
    free(runs->cores);
    free(runs->numbers);
    free(runs->known);
}

static void check_runs(const struct expansion *expansion, const struct runs *runs)
{
    for (int i = 0; i < runs->count; i++) expansion_check(expansion, i, runs->texts[i]);
}

/* --- writing ---------------------------------------------------------------------------------- */

static void make_folder(const char *path)
{
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        die_user("cannot make the folder %s: %s", path, strerror(errno));
}

static void write_text(const char *path, const char *text)
{
    struct output output = output_open(path);
    fputs(text, output.stream);
    output_close(&output);
}

/* Decks that are no longer of the study, and the folders that have no more in them. */
static void remove_old(const struct contents *contents, const char *folder)
{
    int kept = 0;
    for (int i = 0; i < contents->count; i++) {
        if (contents->decks[i].used) continue;
        char *deck = path_of(folder, contents->decks[i].number, "deck.yaml");
        char *run = path_of(folder, contents->decks[i].number, "");
        if (unlink(deck) != 0) die_run("%s: %s", deck, strerror(errno));
        kept += rmdir(run) != 0;
        free(deck);
        free(run);
    }
    if (kept)
        note("%s: %d runs are no longer of this study; their folders are kept, without a deck",
             folder, kept);
}

static void write_decks(const struct runs *runs, const char *folder)
{
    for (int i = 0; i < runs->count; i++) {
        if (runs->known[i]) continue;
        char *run = path_of(folder, runs->numbers[i], "");
        char *deck = path_of(folder, runs->numbers[i], "deck.yaml");
        make_folder(run);
        write_text(deck, runs->texts[i]);
        free(deck);
        free(run);
    }
}

/* A field of CSV. */
static void write_field(FILE *file, const char *text)
{
    const bool plain = !text[strcspn(text, ",\"\r\n")];
    if (plain) {
        fputs(text, file);
        return;
    }
    fputc('"', file);
    for (; *text; text++) fprintf(file, *text == '"' ? "\"\"" : "%c", *text);
    fputc('"', file);
}

static void write_table(const struct expansion *expansion, const struct runs *runs,
                        const char *folder)
{
    char *path = memory_print("%s/study.csv", folder);
    struct output output = output_open(path);
    for (int i = -1; i < runs->count; i++) {
        struct varied varied = expansion_varied(expansion, i < 0 ? 0 : i);
        if (i < 0)
            fputs("run", output.stream);
        else
            fprintf(output.stream, "%04ld", runs->numbers[i]);
        for (int k = 0; k < varied.count; k++) {
            fputc(',', output.stream);
            write_field(output.stream, i < 0 ? varied.items[k].name : varied.items[k].value);
        }
        fputc('\n', output.stream);
        varied_free(&varied);
    }
    output_close(&output);
    free(path);
}

static bool has_role(const struct variations *variations, enum varied_role role)
{
    bool has = false;
    for (int k = 0; k < variations->count; k++) has = has || variations->items[k].role == role;
    return has;
}

static void write_makefile(const struct expansion *expansion, const struct runs *runs,
                           const char *folder)
{
    const size_t n = (size_t)runs->count;
    struct study_make study = {.count = runs->count,
                               .cores = runs->cores,
                               .resolution = has_role(&expansion->variations, VARIED_RESOLUTION),
                               .sensitivity = has_role(&expansion->variations, VARIED_SENSITIVITY)};
    study.numbers = memory_new(n, sizeof *study.numbers);
    study.makers = memory_new(n, sizeof *study.makers);
    for (size_t i = 0; i < n; i++) {
        study.numbers[i] = runs->numbers[i];
        study.makers[i] = runs->numbers[expansion_maker(expansion, (int64_t)i)];
    }
    char *path = memory_print("%s/Makefile", folder);
    struct output output = output_open(path);
    study_make_write(output.stream, &study);
    output_close(&output);
    free(study.numbers);
    free(study.makers);
    free(path);
}

static void write_slurm(const struct runs *runs, const char *folder)
{
    char *path = memory_print("%s/slurm.sh", folder);
    struct output output = output_open(path);
    study_slurm_write(output.stream, runs->count);
    output_close(&output);
    note("bash %s   queues them as a job array of Slurm", path);
    free(path);
}

static void say_what_varies(const struct variations *variations)
{
    static const char *const roles[] = {"", ", scatter", ", resolution", ", one at a time"};
    for (int k = 0; k < variations->count; k++)
        note("%s: %d values%s", variations->items[k].name, variations->items[k].count,
             roles[variations->items[k].role]);
    note("%lld decks", (long long)variations->runs);
}

/* What stands where a study of ours would be, and is none. */
static void refuse_foreign(const struct contents *contents, const struct deck *deck,
                           const char *folder)
{
    static const char *const names[] = {"Makefile", "study.csv", "study.yaml",
                                        "slurm.sh", "gathered",  "cores"};
    char *makefile = memory_print("%s/Makefile", folder), *found = NULL;
    const bool own = study_make_wrote(makefile);
    for (size_t i = 0; !own && !found && i < sizeof names / sizeof *names; i++) {
        char *path = memory_print("%s/%s", folder, names[i]);
        if (access(path, F_OK) == 0 && !taken_are_one(path, deck_name(deck)))
            found = path;
        else
            free(path);
    }
    if (!own && !found && contents->count)
        found = path_of(folder, contents->decks[0].number, "deck.yaml");
    if (found)
        die_user("%s is there, in a folder without a Makefile of hsgen --study, and would be "
                 "replaced: give another folder, or remove it",
                 found);
    free(makefile);
}

void study_folder_write(const struct deck *deck, const char *folder, bool slurm)
{
    struct expansion expansion = expansion_of(deck);
    struct contents contents = contents_of(folder);
    refuse_foreign(&contents, deck, folder);
    struct runs runs = make_runs(&expansion, &contents);
    check_runs(&expansion, &runs);
    say_what_varies(&expansion.variations);
    make_folder(folder);
    /* First of all: it tells a folder that was left half done from another's. */
    write_makefile(&expansion, &runs, folder);
    remove_old(&contents, folder);
    write_decks(&runs, folder);
    write_table(&expansion, &runs, folder);
    char *copy = memory_print("%s/study.yaml", folder);
    if (!taken_are_one(copy, deck_name(deck))) write_text(copy, deck_text(deck));
    note("make -j2 -C %s   runs them and gathers", folder);
    if (slurm) write_slurm(&runs, folder);
    free(copy);
    runs_free(&runs);
    contents_free(&contents);
    expansion_free(&expansion);
}

void study_folder_check(const struct deck *deck)
{
    struct expansion expansion = expansion_of(deck);
    struct contents contents = {0};
    struct runs runs = make_runs(&expansion, &contents);
    check_runs(&expansion, &runs);
    say_what_varies(&expansion.variations);
    runs_free(&runs);
    expansion_free(&expansion);
}
