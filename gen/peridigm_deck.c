#include "peridigm_deck.h"

#include "die.h"
#include "memory.h"
#include "spool.h"
#include "xml_deck.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_DECK = 1000000 };

static const char *const why[] = {
    "Verbose",
    "hssolve says less with --quiet",
    "Hourglass Coefficient",
    "solver.stabilisation is of its own kind, with its defaults",
    "Apply Automatic Differentiation Jacobian",
    "equilibria are found without a matrix",
    "Absolute Tolerance",
    "residuals are relative: solver.accuracy, or tolerance",
    "Relative Tolerance",
    "solver.accuracy, or tolerance, bounds the residual",
    "Maximum Solver Iterations",
    "solver.most_evaluations bounds the evaluations of the force",
    "Fixed dt",
    "the explicit step follows from the body's stiffness; see solver.safety",
    "Force",
    "as a field forces are per volume: Force_Density",
    "Parallel Write",
    "any number of ranks writes one file",
    "Output Format",
    "fields are Exodus files",
    "Omit Bonds Between Blocks",
    "bonds between all phases are kept",
    "Contact",
    "bodies do not touch each other",
    NULL,
};

static struct deck *read_deck(const char *path)
{
    struct spool input = spool_input(path);
    const char *name = path && strcmp(path, "-") != 0 ? path : "standard input";
    long length;
    char *text = spool_text(input.path, LONGEST_DECK, &length), *yaml = NULL;
    spool_close(&input);
    const char *first = text + strspn(text, " \t\r\n");
    if (*first == '<') yaml = xml_deck_yaml(text, (size_t)length, name);
    struct deck *deck = deck_parse(yaml ? yaml : text, yaml ? strlen(yaml) : (size_t)length, name);
    free(text);
    free(yaml);
    return deck;
}

/* Newer decks have one list around all. */
static struct deck_node root_of(const struct deck *deck)
{
    const struct deck_node root = deck_root(deck);
    if (!deck_is_map(root)) die_user("%s is no deck of Peridigm: no lists in it", deck_name(deck));
    const struct deck_node inner = deck_find(root, "Peridigm");
    const struct deck_node lists = inner.index ? inner : root;
    if (!deck_is_map(lists) || !deck_has(lists, "Discretization"))
        die_user("%s is no deck of Peridigm: no list 'Discretization' in it", deck_name(deck));
    return lists;
}

static void add_blocks(struct translation *t, struct peridigm_blocks *blocks,
                       struct deck_node entry, double usual_horizon)
{
    const char *names = take_text(t, entry, "Block Names");
    if (!names) names = take_text(t, entry, "Block Name");
    struct peridigm_block block = {.where = entry,
                                   .material = take_text(t, entry, "Material"),
                                   .damage = take_text(t, entry, "Damage Model"),
                                   .horizon = usual_horizon};
    if (!names || !block.material) deck_error(entry, "expected 'Block Names' and 'Material'");
    if (block.damage && strcmp(block.damage, "None") == 0) block.damage = NULL;
    take_number(t, entry, "Horizon", t->length, &block.horizon);
    block.words = memory_text(names);
    char *rest = block.words;
    while ((block.phase = strsep(&rest, " ,\t\n")))
        if (*block.phase) {
            blocks->items = memory_grow(blocks->items, blocks->count, sizeof block);
            blocks->items[blocks->count++] = block;
        }
}

struct peridigm_blocks peridigm_blocks_read(struct translation *t)
{
    struct peridigm_blocks blocks = {0};
    const struct deck_node all = take(t, t->root, "Blocks"),
                           mesh = take(t, t->root, "Discretization");
    double usual = 0;
    take_number(t, mesh, "Horizon", t->length, &usual);
    if (all.index == 0) deck_error(t->root, "no 'Blocks' in this deck");
    for (int i = 0; i < deck_count(all); i++) {
        t->taken[deck_value(all, i).index] = true;
        add_blocks(t, &blocks, deck_value(all, i), usual);
    }
    if (blocks.count == 0) deck_error(all, "expected a block");
    return blocks;
}

static double largest_horizon(const struct peridigm_blocks *blocks, const struct translation *t)
{
    double largest = 0;
    bool differ = false;
    for (int i = 0; i < blocks->count; i++) {
        const double horizon = blocks->items[i].horizon;
        differ |= i > 0 && horizon != blocks->items[0].horizon;
        if (horizon > largest) largest = horizon;
    }
    if (differ)
        warn("%s:%d: blocks have different horizons: the largest is taken for all",
             deck_name(t->deck), deck_line(blocks->items[0].where));
    return largest;
}

static void write_domain(struct translation *t)
{
    const struct deck_node mesh = take(t, t->root, "Discretization");
    const char *type = take_text(t, mesh, "Type"), *file = take_text(t, mesh, "Input Mesh File");
    if (!type || !file || (strcmp(type, "Exodus") != 0 && strcmp(type, "Text File") != 0))
        deck_error(mesh, "expected 'Type' Exodus or Text File, and 'Input Mesh File'");
    char *name = quoted(file);
    fprintf(t->out, "# hssolve --deck THIS --input %s\ntitle: %s\n", file, name);
    fprintf(t->out, "domain:\n  length_unit: %s\n", t->unit[0]);
    if (peridigm_axis(t) > 0) fprintf(t->out, "  axis: %c\n", "xyz"[peridigm_axis(t)]);
    peridigm_node_sets(t);
    free(name);
}

static void write_solver(struct translation *t, double horizon, bool ordinary)
{
    const struct deck_node solver = take(t, t->root, "Solver"),
                           statics = take(t, solver, "QuasiStatic"),
                           verlet = take(t, solver, "Verlet");
    double start = 0, end, steps, safety;
    if (statics.index == 0 && verlet.index == 0)
        deck_error(solver.index ? solver : t->root, "expected 'Solver' with QuasiStatic or Verlet");
    take_number(t, solver, "Initial Time", t->time, &start);
    if (!take_number(t, solver, "Final Time", t->time, &end) || !(end > start))
        deck_error(solver, "expected 'Final Time', a number above 'Initial Time'");
    if (start != 0)
        warn("%s:%d: the run starts at 0, not at 'Initial Time': expressions in t are as they were",
             deck_name(t->deck), deck_line(solver));
    fprintf(t->out, "solver:\n  type: %s\n  end_time: %.15g\n",
            statics.index ? "quasi_static" : "explicit", end);
    if (horizon > 0) fprintf(t->out, "  horizon: %.15g m\n", horizon);
    if (ordinary) fprintf(t->out, "  influence: constant\n");
    if (take_number(t, statics, "Number of Load Steps", 1, &steps) && steps >= 1)
        fprintf(t->out, "  step: %.15g\n", (end - start) / steps);
    if (take_number(t, verlet, "Safety Factor", 1, &safety))
        fprintf(t->out, "  safety: %.15g\n", safety);
}

void peridigm_deck_translate(const char *path, const char *units, const char *output)
{
    struct deck *deck = read_deck(path);
    struct spool spool = spool_output(output);
    FILE *out = fopen(spool.path, "w");
    if (!out) die_run("%s: %s", spool.path, strerror(errno));
    struct translation t = translation_new(deck, root_of(deck), units, out);
    fprintf(out, "# From %s, a deck of Peridigm in %s, %s, %s.\n", deck_name(deck), t.unit[0],
            t.unit[1], t.unit[2]);
    struct peridigm_blocks blocks = peridigm_blocks_read(&t);
    write_domain(&t);
    const bool ordinary = peridigm_materials(&t, &blocks);
    peridigm_boundary(&t);
    write_solver(&t, largest_horizon(&blocks, &t), ordinary);
    peridigm_output(&t);
    say_what_is_left(&t, why);
    if (fclose(out) != 0) die_run("%s: %s", spool.path, strerror(errno));
    spool_finish(&spool);
    /* Names of one entry are parts of one text. */
    for (int i = 0; i < blocks.count; i++)
        if (i == 0 || blocks.items[i].words != blocks.items[i - 1].words)
            free(blocks.items[i].words);
    free(blocks.items);
    translation_free(&t);
    deck_free(deck);
}
