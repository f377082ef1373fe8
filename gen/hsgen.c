/* hsgen - from the deck to a domain of particles. */
#include "assemble.h"
#include "die.h"
#include "examples.h"
#include "exodus.h"
#include "export.h"
#include "memory.h"
#include "options.h"
#include "peridigm.h"
#include "peridigm_deck.h"
#include "picture.h"
#include "sections.h"
#include "spool.h"
#include "statistics.h"
#include "study_folder.h"
#include "symmetry_check.h"
#include "topology.h"

#include <stdlib.h>
#include <string.h>

struct arguments {
    const char *deck, *output, *statistics, *peridigm, *picture, *cores, *export;
    const char *example, *from, *units;
    bool study, slurm, examples, override, check, quiet;
};

static _Noreturn void print_examples(const struct arguments *c)
{
    if (c->example)
        example_print(c->example);
    else
        examples_list();
    if (fflush(stdout) != 0 || ferror(stdout)) die_run("cannot write to standard output");
    exit(EXIT_SUCCESS);
}

static struct arguments read_arguments(int argc, char **argv)
{
    static const struct section *const sections[] = {&deck_section, &domain_section, NULL};
    struct arguments c = {.deck = "-"};
    const struct option_row rows[] = {
        {'o', "output", "FILE", "write the domain (Genesis) there, not to the pipe", NULL,
         &c.output},
        {'s', "statistics", "FILE", "write the structure's statistics as CSV", NULL, &c.statistics},
        {'p', "picture", "FILE", "draw the middle sections (.png, .svg, .pdf)", NULL, &c.picture},
        {'c', "cores", "FILE", "write the cores, to be used at other spacings", NULL, &c.cores},
        {0, "export", "FILE", "write the structure as voxels (.vti) or elements (.inp)", NULL,
         &c.export},
        {0, "peridigm", "BASENAME", "write Peridigm's text discretisation", NULL, &c.peridigm},
        {0, "study", NULL,
         "write the decks of a study (vary, refine) and a Makefile into -o FOLDER", &c.study, NULL},
        {0, "slurm", NULL, "with --study: a script beside them, a job array of Slurm", &c.slurm,
         NULL},
        {0, "examples", NULL, "list the decks that --example writes, and leave", &c.examples, NULL},
        {0, "example", examples_names, "write a deck that runs, with comments, and leave", NULL,
         &c.example},
        {0, "from", "PROGRAM", "make a deck of ours of one of another program: peridigm", NULL,
         &c.from},
        {0, "units", "L,M,T", "its units of length, mass and time, as cm,g,s (m,kg,s)", NULL,
         &c.units},
        {0, "override", NULL, "go on though the topology check fails", &c.override, NULL},
        {0, "check", NULL, "check the deck, say what would be made, make nothing", &c.check, NULL},
        {'q', "quiet", NULL, "say nothing but warnings and errors", &c.quiet, NULL},
    };
    const struct option_table table = {
        "hsgen",
        "[deck.yaml] [-o domain.g], or --study study.yaml -o FOLDER",
        "Makes a particle domain with a harmonic, random or homogeneous microstructure.",
        rows,
        sizeof rows / sizeof *rows,
        sections,
    };
    int first = options_read(&table, argc, argv);
    if (first < argc - 1)
        die_user("one deck is enough; found '%s' and '%s'", argv[first], argv[first + 1]);
    if (first < argc) c.deck = argv[first];
    if (c.examples || c.example) print_examples(&c);
    if (c.units && !c.from) die_user("--units belongs to --from");
    if (c.slurm && !c.study) die_user("--slurm belongs to --study");
    note_set_quiet(c.quiet);
    return c;
}

/* NULL where the topology is right; dies where it is not, unless an override is given. */
static char *check_topology(const struct recipe *recipe, const struct findings *findings,
                            bool override)
{
    char *fault = recipe->topology->fault(recipe, findings);
    if (fault && !override)
        die_user("%s.  To go on all the same: --override, or override: true in the deck", fault);
    if (fault) warn("overridden: %s", fault);
    return fault;
}

/* What cannot work is said before the work is done. */
static void check_side_files(const struct arguments *c, const struct recipe *recipe)
{
    const bool *periodic = recipe->specimen.periodic, *planes = recipe->specimen.symmetry;
    if (c->picture) picture_check_name(c->picture);
    if (c->export) export_check_name(c->export);
    if (c->peridigm && (periodic[0] || periodic[1] || periodic[2]))
        die_user("--peridigm %s: that format has no place for a periodic body", c->peridigm);
    if (c->peridigm && (planes[0] || planes[1] || planes[2]))
        die_user("--peridigm %s: that format has no place for planes of symmetry", c->peridigm);
    if (c->cores && recipe->topology->no_cores)
        die_user("--cores %s: a structure of the topology %s has no cores", c->cores,
                 recipe->topology->deck.name);
}

static void write_side_files(const struct arguments *c, const struct recipe *recipe,
                             const struct structure *structure, const struct findings *findings,
                             const struct cores *cores)
{
    if (c->statistics) statistics_write(recipe, structure, findings, c->statistics);
    if (c->picture) picture_write(recipe, structure, c->picture);
    if (c->cores) cores_write(cores, recipe->topology->deck.name, c->cores);
}

static void set_provenance(const struct deck *deck, int argc, char **argv,
                           struct attributes *attributes)
{
    char *command = options_command(argc, argv);
    attributes_set_text(attributes, "deck", deck_text(deck));
    attributes_set_text(attributes, "deck_name", deck_name(deck));
    /* The version line alone: compiler and libraries leave no trace in the domain, which is the
     * same on every machine. */
    const char *version = options_version();
    char *line = memory_print("%.*s", (int)strcspn(version, "\n"), version);
    attributes_set_text(attributes, "program", line);
    free(line);
    attributes_set_text(attributes, "command", command);
    free(command);
}

/* All that can be found wrong without the structure itself, and what would be made. */
static void say_plan(const struct arguments *c, struct recipe *recipe)
{
    enum { NODE_BYTES = 80 }; /* of memory, measured */
    const char *const files[] = {c->output ? c->output : "standard output",
                                 c->statistics,
                                 c->picture,
                                 c->cores,
                                 c->peridigm,
                                 c->export};
    struct sites sites = recipe_sites(recipe);
    struct cores cores = recipe_cores(recipe);
    symmetry_warn(recipe, &cores);
    struct domain domain = {0};
    specimen_add_sets(&recipe->specimen, &sites, recipe->sets, &domain);
    const struct cores_box box = recipe_box(recipe);
    char *cell = sites_cell(&sites), along[4];
    note("%s: %lld x %lld x %lld sites of %s um, %lld nodes, %lld cores%s%s",
         recipe->topology->deck.name, (long long)sites.count[0], (long long)sites.count[1],
         (long long)sites.count[2], cell, (long long)sites.n_nodes, (long long)cores.own,
         *cores_axes(&box, along) ? ", periodic along " : "", along);
    free(cell);
    for (int i = 0; i < recipe->n_phases; i++) note("phase %s", recipe->phase_names[i]);
    for (int i = 0; i < domain.n_sets; i++)
        note("set %s: %lld nodes", domain.sets[i].name, (long long)domain.sets[i].count);
    note("about %.0f MB of memory", 1 + 1e-6 * NODE_BYTES * (double)sites.n_nodes);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (files[i]) note("would write %s", files[i]);
    domain_free(&domain);
    cores_free(&cores);
    sites_free(&sites);
}

static void treat_study(const struct arguments *c, const struct deck *deck)
{
    if (c->statistics || c->picture || c->cores || c->peridigm || c->override)
        die_user("--study makes decks, and takes -o FOLDER and --check alone");
    if (!c->output && !c->check) die_user("--study needs -o FOLDER, where the decks go");
    sections_read(deck);
    if (c->check)
        study_folder_check(deck);
    else
        study_folder_write(deck, c->output, c->slurm);
}

static void translate(const struct arguments *c)
{
    if (strcmp(c->from, "peridigm") != 0)
        die_user("--from '%s' is not known, expected peridigm", c->from);
    peridigm_deck_translate(c->deck, c->units, c->output);
}

int main(int argc, char **argv)
{
    die_set_program("hsgen");
    struct arguments c = read_arguments(argc, argv);
    if (c.from) {
        translate(&c);
        return 0;
    }
    struct deck *deck = deck_read(c.deck);
    if (c.study) {
        treat_study(&c, deck);
        deck_free(deck);
        return 0;
    }
    struct recipe recipe = recipe_read(deck);
    check_side_files(&c, &recipe);
    if (c.check) {
        say_plan(&c, &recipe);
        recipe_free(&recipe);
        deck_free(deck);
        return 0;
    }
    struct spool output = spool_output(c.output);

    struct sites sites = recipe_sites(&recipe);
    struct cores cores = recipe_cores(&recipe);
    symmetry_warn(&recipe, &cores);
    struct structure structure = structure_new(&recipe, &sites, &cores);
    struct findings findings = findings_of(&recipe, &structure, &cores);
    statistics_print(&recipe, &structure, &findings);
    write_side_files(&c, &recipe, &structure, &findings, &cores);
    char *fault = check_topology(&recipe, &findings, c.override || recipe.override);

    struct domain domain = assemble_domain(&recipe, &structure, &findings, fault);
    set_provenance(deck, argc, argv, &domain.attributes);
    if (c.peridigm) peridigm_write(&domain, c.peridigm);
    const struct export_source exported = {&recipe, &structure, &domain};
    if (c.export) export_write(&exported, c.export);
    exodus_write_domain(&output, &domain);
    spool_finish(&output);

    free(fault);
    domain_free(&domain);
    structure_free(&structure);
    cores_free(&cores);
    sites_free(&sites);
    recipe_free(&recipe);
    deck_free(deck);
    return 0;
}
