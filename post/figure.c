#include "figure.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const double mega = 1e6, percent = 100;

/* 12 cm by 9 cm in print; the PNG has 340 dots an inch. */
static const struct {
    const char *ending, *terminal;
} formats[] = {
    {".svg", "svg size 640,480 font 'Helvetica,15' linewidth 1.2 background 'white' enhanced"},
    {".png", "pngcairo size 1600,1200 font 'Helvetica,32' linewidth 3 enhanced"},
    {".pdf", "pdfcairo size 12cm,9cm font 'Helvetica,11' linewidth 1.6 enhanced"},
};
enum { FORMATS = sizeof formats / sizeof *formats };

/* Distinguishable for all readers: Okabe and Ito (2008). */
static const char *const colours[] = {"#000000", "#0072B2", "#D55E00", "#009E73",
                                      "#CC79A7", "#56B4E9", "#E69F00"};
enum { COLOURS = sizeof colours / sizeof *colours, LONG_TITLE = 30, SHORT_TITLE = 20 };

static const char *terminal_of(const char *name)
{
    for (int i = 0; i < FORMATS; i++) {
        size_t n = strlen(name), m = strlen(formats[i].ending);
        if (n > m && strcmp(name + n - m, formats[i].ending) == 0) return formats[i].terminal;
    }
    die_user("%s: the name of a figure ends in .svg, .png or .pdf", name);
}

/* As a shell looks for it. */
static bool has_gnuplot(void)
{
    const char *path = getenv("PATH");
    bool found = false;
    char *folders = memory_text(path ? path : ""), *rest = folders;
    for (char *folder; !found && (folder = strsep(&rest, ":"));) {
        char *name = memory_print("%s/gnuplot", *folder ? folder : ".");
        found = access(name, X_OK) == 0;
        free(name);
    }
    free(folders);
    return found;
}

void figure_check(const char *name)
{
    terminal_of(name);
    if (!has_gnuplot())
        die_run("%s: no gnuplot found; install it (gnuplot-nox) or do without --plot", name);
}

/* gnuplot's single quotes: nothing is special in them but the quote, which is doubled. */
static void write_quoted(FILE *gnuplot, const char *text)
{
    fputc('\'', gnuplot);
    for (; *text; text++) {
        if (*text == '\'') fputc('\'', gnuplot);
        fputc((unsigned char)*text < 0x20 ? ' ' : *text, gnuplot);
    }
    fputc('\'', gnuplot);
}

static void write_points(FILE *gnuplot, int index, const struct curve *curve, bool true_curve)
{
    const double *strain = true_curve ? curve->true_strain : curve->strain;
    const double *stress = true_curve ? curve->true_stress : curve->stress;
    fprintf(gnuplot, "$curve%d << EOD\n", index);
    for (long i = 0; i < curve->n; i++) {
        if (isnan(strain[i]) || isnan(stress[i])) continue;
        double x = true_curve ? strain[i] : percent * strain[i];
        fprintf(gnuplot, "%.10g %.10g\n", x, stress[i] / mega);
    }
    fputs("EOD\n", gnuplot);
}

/* Rm on the engineering curve, Considere's point on the true one. */
static bool mark_of(const struct figure_series *series, bool true_curve, double *x, double *y)
{
    const struct analysis *analysis = series->analysis;
    if (!analysis) return false;
    *x = true_curve ? analysis->considere.strain : percent * analysis->measures.maximum.strain;
    *y = (true_curve ? analysis->considere.stress : analysis->measures.maximum.stress) / mega;
    return (true_curve || analysis->measures.maximum.reached) && !isnan(*x);
}

static bool write_marks(FILE *gnuplot, const struct figure_series series[], int count,
                        bool true_curve)
{
    bool any = false;
    for (int i = 0; i < count; i++) {
        double x, y;
        if (!mark_of(&series[i], true_curve, &x, &y)) continue;
        if (!any) fputs("$marks << EOD\n", gnuplot);
        any = true;
        fprintf(gnuplot, "%.10g %.10g\n", x, y);
    }
    if (any) fputs("EOD\n", gnuplot);
    return any;
}

/* Of an axis; a bound that is not given is by the data. */
static void write_range(FILE *gnuplot, const char *axis, const double range[2])
{
    if (isnan(range[0]))
        fprintf(gnuplot, "set %srange [0:*]\n", axis);
    else
        fprintf(gnuplot, "set %srange [%.10g:%.10g]\n", axis, range[0], range[1]);
}

/* Of the legend, at most so many columns. */
static void write_axes(FILE *gnuplot, bool true_curve, int columns)
{
    fputs("set encoding utf8\n"
          "set border 3 lw 0.8\n"
          "set tics nomirror out scale 0.7\n"
          "set grid lt 1 lw 0.5 lc rgb '#d0d0d0'\n"
          "set key outside top center horizontal Left reverse samplen 2 width 1\n"
          "set offsets graph 0.02, graph 0.02, graph 0.05, 0\n",
          gnuplot);
    fprintf(gnuplot, "set key maxcols %d\n", columns);
    fputs(true_curve ? "set xlabel 'True strain ε'\nset ylabel 'True stress σ (MPa)'\n"
                     : "set xlabel 'Engineering strain (%)'\n"
                       "set ylabel 'Engineering stress (MPa)'\n",
          gnuplot);
}

/* The band of a group: strain, mean, mean less and plus a deviation. */
static void write_band(FILE *gnuplot, int index, const struct group *group)
{
    fprintf(gnuplot, "$curve%d << EOD\n", index);
    for (long i = 0; i < group->n; i++)
        if (!isnan(group->mean[i]))
            fprintf(gnuplot, "%.10g %.10g %.10g %.10g\n", percent * group->strain[i],
                    group->mean[i] / mega, (group->mean[i] - group->deviation[i]) / mega,
                    (group->mean[i] + group->deviation[i]) / mega);
    fputs("EOD\n", gnuplot);
}

/* What the band of a group is; the caller frees it. */
static char *words_of(const struct figure_series *series)
{
    if (series->words) return memory_text(series->words);
    return series->group->count > 1 ? memory_print("mean and deviation of %d", series->group->count)
                                    : memory_text("");
}

static size_t longest_title(const struct figure_series series[], int count)
{
    size_t longest = 0;
    for (int i = 0; i < count; i++)
        longest = strlen(series[i].title) > longest ? strlen(series[i].title) : longest;
    return longest;
}

/* Length of what all titles begin with, to a comma and a blank, where they are too long for the legend; 0. */
static size_t shared_words(const struct figure_series series[], int count)
{
    if (count < 2 || longest_title(series, count) <= LONG_TITLE) return 0;
    size_t shared = strlen(series[0].title);
    for (int i = 1; i < count; i++) {
        size_t same = 0;
        while (same < shared && series[i].title[same] == series[0].title[same]) same++;
        shared = same;
    }
    while (shared > 1 && strncmp(series[0].title + shared - 2, ", ", 2) != 0) shared--;
    return shared > 1 ? shared : 0;
}

/* What all share stands above the legend, once. */
static void write_heading(FILE *gnuplot, const struct figure_series series[], size_t shared)
{
    char *words = series->group ? words_of(series) : memory_text("");
    char *heading =
        memory_print("%.*s%s%s", (int)shared - 2, series->title, *words ? ": " : "", words);
    fputs("set title ", gnuplot);
    write_quoted(gnuplot, heading);
    fputs(" noenhanced\n", gnuplot);
    free(heading);
    free(words);
}

/* Colour, and dashes where the colours are used up. */
static void write_line(FILE *gnuplot, int index, const struct figure_series *series, size_t shared)
{
    static const int dashes[] = {1, 4, 5, 3};
    const bool mixture = series->curve && attributes_text(&series->curve->provenance, "mixture");
    const int dash = mixture ? 2 : dashes[index / COLOURS % (int)(sizeof dashes / sizeof *dashes)];
    const char *colour = colours[index % COLOURS];
    if (series->group)
        fprintf(gnuplot,
                "$curve%d using 1:3:4 with filledcurves lc rgb '%s' fs transparent solid 0.2 "
                "noborder notitle, ",
                index, colour);
    fprintf(gnuplot, "$curve%d using 1:2 with lines dt %d lw 1.5 lc rgb '%s' title ", index, dash,
            colour);
    char *words = series->group && !shared ? words_of(series) : memory_text("");
    char *title = memory_print("%s%s%s", series->title + shared, *words ? ", " : "", words);
    write_quoted(gnuplot, title);
    free(title);
    free(words);
    fputs(" noenhanced", gnuplot);
}

static void write_plot(FILE *gnuplot, const struct figure_series series[], int count,
                       bool true_curve, bool marks, size_t shared)
{
    fputs("plot ", gnuplot);
    for (int i = 0; i < count; i++) {
        if (i) fputs(", ", gnuplot);
        write_line(gnuplot, i, &series[i], shared);
    }
    if (marks)
        fprintf(gnuplot, ", $marks with points pt 6 ps 1.2 lw 1.2 lc rgb '#404040' title '%s'",
                true_curve ? "dσ/dε = σ" : "{/:Italic R}_m");
    fputc('\n', gnuplot);
}

static void write_script(FILE *gnuplot, const struct figure_series series[], int count,
                         const struct figure_style *style)
{
    for (int i = 0; i < count; i++) {
        if (series[i].group)
            write_band(gnuplot, i, series[i].group);
        else
            write_points(gnuplot, i, series[i].curve, style->true_curve);
    }
    bool marks = write_marks(gnuplot, series, count, style->true_curve);
    const size_t shared = shared_words(series, count);
    write_axes(gnuplot, style->true_curve,
               shared && longest_title(series, count) > shared + SHORT_TITLE ? 1 : 2);
    if (shared) write_heading(gnuplot, series, shared);
    write_range(gnuplot, "x", style->x_range);
    write_range(gnuplot, "y", style->y_range);
    if (!isnan(style->x_range[0]) || !isnan(style->y_range[0]))
        fputs("set offsets 0, 0, 0, 0\n", gnuplot);
    write_plot(gnuplot, series, count, style->true_curve, marks, shared);
}

/* What writes a script to gnuplot. */
struct drawing {
    const struct figure_series *series;
    const struct figure_loops *loops;
    int count;
    const struct figure_style *style;
};

static void write_loops(FILE *gnuplot, const struct drawing *d)
{
    for (int i = 0; i < d->count; i++) {
        fprintf(gnuplot, "$loops%d << EOD\n", i);
        for (long k = 0; k < d->loops[i].count; k++) {
            const struct loop *l = &d->loops[i].loops[k];
            fprintf(gnuplot, "%.10g %.10g %.10g %.10g\n", percent * l->strain, l->flow / mega,
                    l->back / mega, l->effective / mega);
        }
        fputs("EOD\n", gnuplot);
    }
    write_axes(gnuplot, true, 2);
    fputs("set xlabel 'True strain (%)'\nset yrange [*:*]\nset datafile missing 'nan'\nplot ",
          gnuplot);
    for (int i = 0; i < d->count; i++) {
        if (d->loops[i].count == 0) continue;
        const char *colour = colours[i % COLOURS];
        fprintf(gnuplot, "$loops%d using 1:2 with lines lw 1.5 lc rgb '%s' title ", i, colour);
        write_quoted(gnuplot, d->loops[i].title);
        fprintf(gnuplot,
                " noenhanced, $loops%d using 1:3 with linespoints pt 7 ps 0.8 lc rgb '%s' notitle, "
                "$loops%d using 1:4 with linespoints dt 3 pt 6 ps 0.8 lc rgb '%s' notitle, ",
                i, colour, i, colour);
    }
    fputs("NaN with linespoints pt 7 ps 0.8 lc rgb '#404040' title 'back stress', "
          "NaN with linespoints dt 3 pt 6 ps 0.8 lc rgb '#404040' title 'effective stress'",
          gnuplot);
    fputc('\n', gnuplot);
}

static void write_curves(FILE *gnuplot, const struct drawing *d)
{
    write_script(gnuplot, d->series, d->count, d->style);
}

/* As a file that gnuplot can open. */
static struct spool script_of(const char *name, void (*write)(FILE *, const struct drawing *),
                              const struct drawing *drawing)
{
    char *text;
    size_t length;
    FILE *script = open_memstream(&text, &length);
    if (!script) die_run("%s: %s", name, strerror(errno));
    fprintf(script, "set terminal %s\n", terminal_of(name));
    write(script, drawing);
    if (fclose(script) != 0) die_run("%s: %s", name, strerror(errno));
    const struct spool spool = spool_bytes(text, length);
    free(text);
    return spool;
}

/* Returns the bytes copied. */
static size_t copy(FILE *from, const char *name, const char *path)
{
    char bytes[1 << 14];
    size_t count, all = 0;
    FILE *figure = fopen(path, "w");
    if (!figure) die_run("cannot write %s: %s", name, strerror(errno));
    while ((count = fread(bytes, 1, sizeof bytes, from)) > 0) {
        if (fwrite(bytes, 1, count, figure) != count)
            die_run("cannot write %s: %s", name, strerror(errno));
        all += count;
    }
    if (fclose(figure) != 0) die_run("cannot write %s: %s", name, strerror(errno));
    return all;
}

/* gnuplot's exit status says nothing of a full disk: its bytes come here, and are written where
 * that is seen. */
static void draw(const char *name, const char *path, void (*write)(FILE *, const struct drawing *),
                 const struct drawing *drawing)
{
    struct spool script = script_of(name, write, drawing);
    char *command = memory_print("LC_ALL=C.UTF-8 exec gnuplot </proc/%ld/fd/%d", (long)getpid(),
                                 script.descriptor);
    FILE *gnuplot = popen(command, "r");
    if (!gnuplot) die_run("%s: cannot start gnuplot: %s", name, strerror(errno));
    const size_t bytes = copy(gnuplot, name, path);
    const int status = pclose(gnuplot);
    free(command);
    spool_close(&script);
    if (WIFSIGNALED(status)) die_run("%s: gnuplot was ended by signal %d", name, WTERMSIG(status));
    if (status != 0 || bytes == 0)
        die_run("%s: gnuplot failed (status %d, %zu bytes)", name,
                WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes);
}

void figure_draw(const char *name, const char *path, const struct figure_series series[], int count,
                 const struct figure_style *style)
{
    const struct drawing drawing = {series, NULL, count, style};
    draw(name, path, write_curves, &drawing);
}

void figure_draw_loops(const char *name, const char *path, const struct figure_loops series[],
                       int count)
{
    const struct drawing drawing = {NULL, series, count, NULL};
    draw(name, path, write_loops, &drawing);
}
