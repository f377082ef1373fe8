#include "targets.h"

#include "cores.h"
#include "cracks.h"
#include "damage.h"
#include "deck.h"
#include "die.h"
#include "domain_facts.h"
#include "domain_input.h"
#include "domain_order.h"
#include "domain_text.h"
#include "exodus.h"
#include "expansion.h"
#include "expression.h"
#include "image.h"
#include "lattice.h"
#include "material_read.h"
#include "memory.h"
#include "peridigm_deck.h"
#include "recipe.h"
#include "restart.h"
#include "scene.h"
#include "value.h"
#include "value_table.h"

#include <fcntl.h>
#include <math.h>
#include <netcdf.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

/* Where a dying program goes; of this process alone. */
static struct {
    jmp_buf back;
    long accepted;
    const struct target *target;
    char path[64]; /* of the bytes as a file */
    int first;     /* descriptor that is not libFuzzer's own; 0: not known yet */
} fuzz;

static void come_back(int code)
{
    (void)code;
    longjmp(fuzz.back, 1);
}

/* --- the targets: each may die anywhere ------------------------------------------------------- */

/* As for a body of this spacing and horizon, of which the section asks no more. */
static void read_damage(struct deck_node section, const struct materials *materials)
{
    struct lattice lattice = {.spacing = 25e-6};
    struct family family = family_new(3, 0, false);
    const struct body body = {.lattice = &lattice, .family = &family};
    const struct damage_view see = {.materials = materials, .body = &body};
    struct damage_rules rules = damage_rules_read(section, &see);
    damage_rules_free(&rules);
    family_free(&family);
}

static void read_deck(const char *text, size_t size)
{
    static char *phases[] = {"CG", "UFG"};
    struct deck *deck = deck_parse(text, size, "deck");
    const struct deck_node root = deck_root(deck);
    struct recipe recipe = recipe_read(deck);
    recipe_free(&recipe);
    struct cracks cracks = cracks_read(deck_find(root, "cracks"), 25e-6, 3);
    cracks_free(&cracks);
    struct materials materials = materials_read(deck_get(root, "materials"), 2, phases, SPACE);
    read_damage(deck_find(root, "damage"), &materials);
    materials_free(&materials);
    struct scene scene = scene_read(deck);
    scene_free(&scene);
    deck_free(deck);
}

/* Spans of all values lie in the text; the first and the last run of what it varies are decks. */
static void read_study(const char *text, size_t size)
{
    static const char *const none[] = {NULL};
    struct deck *deck = deck_parse(text, size, "deck");
    struct deck_paths paths = deck_paths_list(deck, none);
    for (int i = 0; i < paths.count; i++) {
        const struct deck_span span = deck_span(paths.items[i].node);
        if (span.begin > span.end || span.end > size) abort();
    }
    deck_paths_free(&paths);
    struct expansion expansion = expansion_of(deck);
    const int64_t runs[] = {0, expansion.variations.runs - 1};
    for (int k = 0; k < 2; k++) {
        const bool own = expansion_maker(&expansion, runs[k]) == runs[k];
        char *run = expansion_text(&expansion, runs[k], own ? NULL : "cores/0");
        expansion_check(&expansion, runs[k], run);
        free(run);
    }
    expansion_free(&expansion);
    deck_free(deck);
}

static void read_values(const char *text, size_t size)
{
    (void)text, (void)size;
    struct value_table table = value_table_read(fuzz.path);
    value_table_free(&table);
}

/* In single quotes, which are doubled. */
static void read_expression(const char *text, size_t size)
{
    static const char *const names[] = {"x", "y", "z", "t"};
    static const double at[][4] = {
        {0, 0, 0, 0}, {1e300, -1e300, 1e-300, 1e5}, {0.5, 0.25, -0.125, 3}};
    char *quoted = memory_new(2 * size + 8, 1), *to = stpcpy(quoted, "e: '");
    for (size_t i = 0; i < size && i < 1000; i++) {
        if (text[i] == '\'') *to++ = '\'';
        *to++ = text[i];
    }
    strcpy(to, "'\n");
    struct deck *deck = deck_parse(quoted, strlen(quoted), "deck");
    struct expression *e = expression_new(deck_get(deck_root(deck), "e"), names, 4);
    for (int k = 0; k < 3; k++) {
        const double one = expression_value(e, at[k]), two = expression_value(e, at[k]);
        if (memcmp(&one, &two, sizeof one) != 0 && !(isnan(one) && isnan(two))) abort();
    }
    expression_free(e);
    deck_free(deck);
    free(quoted);
}

static void look_at(struct domain *domain, bool text)
{
    static const char deck_of[] = "domain: {grips: {length: 3 spacings}, gauge: {length: 0.1 mm}}\n"
                                  "materials:\n  CG: {}\n  UFG: {}\n";
    struct lattice lattice;
    const bool regular = domain_sort(domain, &lattice);
    struct deck *deck = deck_parse(deck_of, strlen(deck_of), "deck");
    const struct domain_facts facts = domain_facts_read(deck);
    if (text) domain_facts_planes(&facts, regular, domain);
    if (!regular) lattice = lattice_scattered(domain, 0);
    lattice_free(&lattice);
    deck_free(deck);
    domain_free(domain);
}

static void read_text(const char *text, size_t size)
{
    static const char deck_of[] = "materials:\n  CG: {}\n  UFG: {}\n";
    (void)text, (void)size;
    struct spool input = spool_input(fuzz.path);
    struct deck *deck = deck_parse(deck_of, strlen(deck_of), "deck");
    struct domain domain = domain_text_read(&input, "particles", deck);
    deck_free(deck);
    look_at(&domain, true);
    spool_close(&input);
}

/* A deck with a file that is named in it; the caller frees it. */
static struct deck *deck_naming(const char *before, const char *behind)
{
    char *yaml = memory_print("%s%s%s", before, fuzz.path, behind);
    struct deck *deck = deck_parse(yaml, strlen(yaml), "deck");
    free(yaml);
    return deck;
}

/* Numbers of nodes, of a body of a hundred. */
static void read_numbers(const char *text, size_t size)
{
    (void)text, (void)size;
    struct deck *deck = deck_naming("domain: {node_sets: {some: ", "}}\n");
    struct domain domain = {.n_nodes = 100};
    const struct domain_facts facts = domain_facts_read(deck);
    domain_facts_node_sets(&facts, &domain);
    domain_free(&domain);
    deck_free(deck);
}

/* A load's table of times and values. */
static void read_loads(const char *text, size_t size)
{
    (void)text, (void)size;
    struct deck *deck = deck_naming("load: {table: ", "}\n");
    struct value value =
        value_read(deck_get(deck_root(deck), "load"), "m/s", -1e5, 1e5, VALUE_IN_TIME);
    const double nowhere[3] = {0};
    for (double time = value.times[0]; isfinite(time); time = value_next_row(&value, time))
        if (!isfinite(value_at(&value, nowhere, time))) abort();
    value_free(&value);
    deck_free(deck);
}

/* YAML or XML. */
static void read_peridigm(const char *text, size_t size)
{
    (void)text, (void)size;
    peridigm_deck_translate(fuzz.path, "cm,g,s", "/dev/null");
}

static void read_genesis(const char *text, size_t size)
{
    (void)text, (void)size;
    struct spool input = spool_input(fuzz.path);
    struct domain domain;
    if (exodus_stream_domain(&input, &domain)) {
        struct lattice lattice;
        if (lattice_recognise(&domain, &lattice)) lattice_free(&lattice);
        domain_free(&domain);
    }
    domain = exodus_read_domain(&input);
    look_at(&domain, false);
    spool_close(&input);
}

/* In a process of its own: HDF5 outlives no reader that died within it. */
static void read_netcdf4(const char *text, size_t size)
{
    enum { TAKEN, REFUSED };
    int status;
    const pid_t child = fork();
    if (child < 0) abort();
    if (child == 0) {
        if (setjmp(fuzz.back) != 0) _exit(REFUSED);
        read_genesis(text, size);
        _exit(TAKEN);
    }
    if (waitpid(child, &status, 0) != child) abort();
    if (!WIFEXITED(status) || WEXITSTATUS(status) > REFUSED) abort();
    if (WEXITSTATUS(status) == REFUSED) longjmp(fuzz.back, 1);
}

static void read_cores(const char *text, size_t size)
{
    (void)text, (void)size;
    struct cores cores = cores_read(fuzz.path, "harmonic");
    cores_nearest_pair(&cores, 1e-4);
    cores_free(&cores);
}

/* Any format by its first bytes; of files with several arrays the one that the corpus has. */
static void read_image(const char *text, size_t size)
{
    const bool several = memmem(text, size, "grey", 4) || memmem(text, size, "nothing", 7);
    struct image image = image_read(fuzz.path, several ? "material" : NULL, NULL);
    image_free(&image);
}

static void read_table(const char *text, size_t size)
{
    (void)text, (void)size;
    target_table(fuzz.path);
}

static void read_frames(const char *text, size_t size)
{
    (void)text, (void)size;
    target_frames(fuzz.path);
}

/* What a repair has made whole can be read. */
static void read_unfinished(const char *text, size_t size)
{
    double time;
    (void)text, (void)size;
    if (exodus_repair(fuzz.path, &time) < 1) abort();
    struct spool input = spool_input(fuzz.path);
    struct history history = exodus_read_history(&input);
    history_free(&history);
    spool_close(&input);
}

static void read_checkpoint(const char *text, size_t size)
{
    struct run_texts texts = {.domain = -1};
    (void)text, (void)size;
    struct checkpoint_file *file = checkpoint_file_open(fuzz.path);
    run_texts_visit(&texts, file);
    checkpoint_file_close(file);
    run_texts_free(&texts);
}

static const struct target {
    const char *name;
    void (*read)(const char *text, size_t size);
} targets[] = {{"deck", read_deck},
               {"expression", read_expression},
               {"text", read_text},
               {"genesis", read_genesis},
               {"netcdf4", read_netcdf4},
               {"cores", read_cores},
               {"table", read_table},
               {"history", read_table},
               {"frames", read_frames},
               {"checkpoint", read_checkpoint},
               {"study", read_study},
               {"values", read_values},
               {"image", read_image},
               {"numbers", read_numbers},
               {"loads", read_loads},
               {"peridigm", read_peridigm},
               {"unfinished", read_unfinished}};

/* --- as libFuzzer calls them ------------------------------------------------------------------ */

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    const char *name = getenv("HS_FUZZ");
    (void)argc, (void)argv;
    for (size_t k = 0; name && k < sizeof targets / sizeof *targets; k++)
        if (strcmp(targets[k].name, name) == 0) fuzz.target = &targets[k];
    if (!fuzz.target) {
        fputs("HS_FUZZ names no target\n", stderr);
        exit(2);
    }
    die_set_program("fuzz");
    die_set_exit(come_back);
    note_set_quiet(1);
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    enum { OPEN_FILES = 4, NETCDF_FILE = 1 << 16 };
    char *text = memory_new(size + 1, 1);
    const int file = memfd_create("fuzz", MFD_CLOEXEC);
    memcpy(text, bytes, size);
    if (!fuzz.first) fuzz.first = file;
    if (file < 0 || write(file, bytes, size) != (ssize_t)size || lseek(file, 0, SEEK_SET) != 0)
        abort();
    snprintf(fuzz.path, sizeof fuzz.path, "/proc/self/fd/%d", file);
    if (setjmp(fuzz.back) == 0) {
        fuzz.target->read(text, size);
        fuzz.accepted++;
    }
    /* What a reader that died has left open. */
    for (int k = 1; k < OPEN_FILES; k++) nc_close(k * NETCDF_FILE);
    close_range((unsigned)fuzz.first, ~0u, 0);
    free(text);
    return 0;
}

long targets_accepted(void)
{
    return fuzz.accepted;
}
