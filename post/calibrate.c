#include "calibrate.h"

#include "csv.h"
#include "die.h"
#include "memory.h"
#include "taken.h"
#include "text_output.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BISECTIONS = 7 };

static const double spacing = 25e-6;  /* m, of both bodies */
static const double load_step = 2e-4; /* so that records lie close enough around the knee */
static const double full_share = 1.5; /* of onset, where a node carries nothing */
static const double proportional =
    5.65; /* L0 over the root of S0, where the specimen does not say */

/* --- running
 * ----------------------------------------------------------------------------------- */

/* Folder of this program, with a slash at the end; "" where it is not known. */
static char *own_folder(void)
{
    char path[4096];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    if (length <= 0) return memory_text("");
    path[length] = '\0';
    char *slash = strrchr(path, '/');
    if (slash) slash[1] = '\0';
    char *program = memory_print("%shssolve", path);
    const bool there = access(program, X_OK) == 0;
    free(program);
    return memory_text(slash && there ? path : "");
}

/* In single quotes of the shell. */
static char *quoted(const char *text)
{
    char *all = memory_text("'");
    for (; *text; text++)
        all = *text == '\'' ? memory_append(all, "'\\''") : memory_append(all, "%c", *text);
    return memory_append(all, "'");
}

/* Runs directory/name.yaml to directory/name.e, with what is said in name.log. */
static struct curve run_deck(const char *directory, const char *name, const struct choices *choices)
{
    char *stem = memory_print("%s/%s", directory, name), *file = quoted(stem),
         *folder = own_folder();
    char *programs = quoted(folder);
    char *command = memory_print(
        "set -o pipefail 2>/dev/null; { %shsgen %s.yaml | %shssolve -q -j 1 -H %s.e; } 2>%s.log",
        programs, file, programs, file, file);
    char *bash = quoted(command), *line = memory_print("bash -c %s", bash);
    if (system(line) != 0) die_run("the run of %s.yaml failed; %s.log says why", stem, stem);
    char *history = memory_print("%s.e", stem);
    struct input input = input_read(history, NULL);
    struct curve curve = curve_make(&input, choices);
    input_free(&input);
    char *texts[] = {stem, file, folder, programs, command, bash, line, history};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) free(texts[i]);
    return curve;
}

/* --- decks
 * ------------------------------------------------------------------------------------- */

/* A plate with the material, gauge [m] long between shoulders and grips; its section has 8 by 4
 * particles. */
static struct text_output begin_deck(const char *directory, const char *name,
                                     const struct material *m, const struct curve *curve,
                                     long gauge)
{
    char *path = memory_print("%s/%s.yaml", directory, name);
    taken_again(path); /* each trial has the deck of the one before */
    struct text_output deck = text_output_open(path);
    const long grip = 4, shoulder = 8;
    fprintf(deck.file,
            "title: %s\ndomain:\n  specimen: plate\n  size: [%ld spacings, 8 spacings, 4 "
            "spacings]\n  spacing: %g um\n"
            "  topology: homogeneous\n  phase: %s\n  grips: {length: %ld spacings, phase: %s}\n  "
            "gauge: {length: %ld spacings}\n",
            name, gauge + 2 * (grip + shoulder), 1e6 * spacing, m->name, grip, m->name, gauge);
    material_print(deck.file, m, curve, "correspondence");
    free(path);
    return deck;
}

static void write_plate(const char *directory, const struct material *m,
                        const struct measured *measured, double end)
{
    struct text_output deck = begin_deck(directory, "uniform", m, measured->curve, 8);
    fprintf(deck.file,
            "boundary:\n  - {set: grip_left, direction: x, velocity: -1 m/s}\n  - {set: "
            "grip_right, direction: x, velocity: 1 m/s}\n"
            "solver: {type: quasi_static, horizon: 1, stabilisation: {law: mix, share: 0.1}, "
            "step: %g, end_strain: %.6g}\n"
            "output: {history: 1000}\n",
            load_step, end);
    text_output_close(&deck);
}

/* --- uniform part
 * ------------------------------------------------------------------------------ */

static double stress_at(const struct curve *curve, double strain)
{
    for (long i = 1; i < curve->n; i++) {
        const double *e = curve->strain + i, *s = curve->stress + i;
        if (e[-1] <= strain && strain <= e[0] && e[0] > e[-1])
            return s[-1] + (strain - e[-1]) / (e[0] - e[-1]) * (s[0] - s[-1]);
    }
    return NAN;
}

struct misfit {
    double root_mean_square, largest; /* over Rm, of the rows that have yielded */
    double all;                       /* root mean square, with the elastic rows */
    long count;                       /* of the rows that have yielded */
};

/* At the rows of the measured curve up to maximum force, its toe removed; rows go to misfit.csv. */
static struct misfit compare(const char *directory, const struct measured *measured,
                             const struct curve *run)
{
    const struct analysis *a = measured->analysis;
    const struct curve *curve = &a->envelope;
    const double toe = a->measures.line.toe, strength = a->measures.maximum.stress;
    char *path = memory_print("%s/misfit.csv", directory);
    struct text_output table = text_output_open(path);
    struct misfit misfit = {0, 0, 0, 0};
    const long first = material_first_row(a);
    long all = 0;
    fputs("engineering_strain,measured_MPa,simulated_MPa\n", table.file);
    for (long i = 0; i <= a->measures.uniform; i++) {
        const double strain = curve->strain[i] - toe, stress = stress_at(run, strain);
        if (isnan(stress)) continue;
        const double off = (stress - curve->stress[i]) / strength;
        fprintf(table.file, "%.9g,%.9g,%.9g\n", strain, curve->stress[i] / 1e6, stress / 1e6);
        misfit.all += off * off;
        all++;
        if (i <= first) continue;
        misfit.root_mean_square += off * off;
        misfit.largest = fmax(misfit.largest, fabs(off));
        misfit.count++;
    }
    text_output_close(&table);
    free(path);
    misfit.root_mean_square = sqrt(misfit.root_mean_square / (double)misfit.count);
    misfit.all = sqrt(misfit.all / (double)all);
    return misfit;
}

/* --- fracture
 * ---------------------------------------------------------------------------------- */

/* Elongation at fracture, without the elastic part, of a bar with the gauge length of the
 * specimen over the root of its section; INFINITY where it does not part. */
static double elongation(const char *directory, const struct material *m,
                         const struct measured *measured, double onset, double most)
{
    const double ratio = measured->curve->gauge_length / sqrt(measured->curve->section);
    const long gauge = 2 * lround((ratio > 0 ? ratio : proportional) * sqrt(8 * 4) / 2);
    struct text_output deck = begin_deck(directory, "fracture", m, measured->curve, gauge);
    fprintf(deck.file,
            "    flaw: {centre: [0, 0, 0], radius: %g um, reduction: 0.02}\n"
            "damage:\n  - {phase: %s, law: ductile, onset: %.6g, full: %.6g}\n"
            "boundary:\n  - {set: grip_left, direction: x, velocity: -10 m/s}\n  - {set: "
            "grip_right, direction: x, velocity: 10 m/s}\n"
            "solver: {type: explicit, horizon: 1, stabilisation: {law: mix, share: 0.1}, start: "
            "affine, end_strain: %.6g}\n"
            "output: {history: 1000}\n",
            4e6 * spacing, m->name, onset, full_share * onset, most);
    text_output_close(&deck);
    struct curve run = run_deck(directory, "fracture", measured->choices);
    struct choices choices = *measured->choices;
    choices.modulus = m->youngs_modulus;
    struct analysis analysis = analysis_make(&run, &choices, false);
    const double found = analysis.measures.value[MEASURE_FRACTURE];
    const bool broken = analysis.record.broken;
    note("  onset %.4g: %s at %.4g %%", onset, broken ? "parts" : "holds", 100 * found);
    analysis_free(&analysis);
    curve_free(&run);
    return broken ? found : INFINITY;
}

/* Bisection of the logarithm: the later damage sets in, the further the bar goes.  *reached: its
 * elongation there. */
static double find_onset(const char *directory, const struct material *m,
                         const struct measured *measured, double *reached)
{
    const double wanted = measured->analysis->measures.value[MEASURE_FRACTURE];
    double low = 0.5 * log1p(measured->analysis->measures.value[MEASURE_EXTENSION]), high = 4,
           best = NAN;
    *reached = INFINITY;
    for (int i = 0; i < BISECTIONS; i++) {
        const double onset = sqrt(low * high),
                     found = elongation(directory, m, measured, onset, 1.3 * wanted + 0.02);
        if (fabs(found - wanted) < fabs(*reached - wanted)) {
            *reached = found;
            best = onset;
        }
        *(found < wanted ? &low : &high) = onset;
    }
    return best;
}

static void add_fracture(FILE *file, const char *directory, const struct material *m,
                         const struct measured *measured)
{
    const struct measures *measures = &measured->analysis->measures;
    const bool parted = measured->analysis->record.broken &&
                        measured->analysis->strained == measured->analysis->envelope.n - 1 &&
                        measures->maximum.reached;
    if (!parted) {
        fputs("# The record does not reach the fracture: no damage can be told from it.\n", file);
        return;
    }
    double reached;
    const double onset = find_onset(directory, m, measured, &reached);
    if (isnan(onset)) {
        fputs("# No onset of ductile damage was found that parts the bar.\n", file);
        return;
    }
    fprintf(file,
            "# At measured %.4g %%, run %.4g %%, for a spacing of %g um and a horizon of one "
            "spacing: what damage softens is a band of\n"
            "# the lattice's width, so calibrate anew for another spacing (docs/theory.md, key "
            "length).\n"
            "damage:\n  - {phase: %s, law: ductile, onset: %.4g, full: %.4g}\n",
            100 * measures->value[MEASURE_FRACTURE], 100 * reached, 1e6 * spacing, m->name, onset,
            full_share * onset);
}

void calibrate(FILE *file, const char *directory, const struct material *m,
               const struct measured *measured)
{
    const double agt = measured->analysis->measures.value[MEASURE_EXTENSION];
    if (mkdir(directory, 0777) != 0 && errno != EEXIST)
        die_user("--calibrate: cannot make the directory %s: %s", directory, strerror(errno));
    write_plate(directory, m, measured, 1.01 * agt);
    struct curve run = run_deck(directory, "uniform", measured->choices);
    const struct misfit misfit = compare(directory, measured, &run);
    note("misfit of %ld rows from yield to maximum force: root mean square %.3f %% of Rm, largest "
         "%.3f %%; "
         "with the elastic rows %.3f %%",
         misfit.count, 100 * misfit.root_mean_square, 100 * misfit.largest, 100 * misfit.all);
    material_print(file, m, measured->curve, "correspondence");
    fprintf(file,
            "# Its test by hssolve is off the curve by %.3f %% of Rm (root mean square of %ld rows "
            "from yield to maximum force),\n"
            "# at most %.3f %%; with the elastic rows by %.3f %%.\n",
            100 * misfit.root_mean_square, misfit.count, 100 * misfit.largest, 100 * misfit.all);
    add_fracture(file, directory, m, measured);
    curve_free(&run);
}
