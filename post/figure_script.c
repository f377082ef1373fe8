#include "figure_script.h"

#include "canvas.h"
#include "die.h"
#include "encoding.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double mega = 1e6, percent = 100;

/* Distinguishable for all readers: Okabe and Ito (2008). */
static const char *const colours[] = {"#000000", "#0072B2", "#D55E00", "#009E73",
                                      "#CC79A7", "#56B4E9", "#E69F00"};
static const char *const dashes[] = {"1", "(10,4)", "(10,4,2,4)", "(2,4)"};
static const char mixture_dash[] = "2";
enum {
    COLOURS = sizeof colours / sizeof *colours,
    DASHES = sizeof dashes / sizeof *dashes,
    LONG_TITLE = 30,
    SHORT_TITLE = 20,
    PANEL_COLUMNS = 3,
    MOST_PANELS = 99,
};

/* gnuplot's single quotes: nothing is special in them but the quote, which is doubled; other bytes
 * than UTF-8 would be in the figure as they are. */
static void write_quoted(FILE *gnuplot, const char *text)
{
    const char *set;
    char *known = encoding_to_utf8(text, (long)strlen(text), &set);
    fputc('\'', gnuplot);
    for (const char *c = known ? known : ""; *c; c++) {
        if (*c == '\'') fputc('\'', gnuplot);
        fputc((unsigned char)*c < 0x20 ? ' ' : *c, gnuplot);
    }
    fputc('\'', gnuplot);
    free(known);
}

/* Behind its last point the force falls to nothing. */
static long points_of(const struct figure_series *series, const struct figure_style *style)
{
    const struct analysis *analysis = series->analysis;
    if (style->whole || !analysis || !analysis->record.broken) return series->curve->n;
    return analysis->rows[analysis->measures.fracture] + 1;
}

static void write_points(FILE *gnuplot, int index, const struct figure_series *series,
                         const struct figure_style *style)
{
    const struct curve *curve = series->curve;
    const double *strain = style->true_curve ? curve->true_strain : curve->strain;
    const double *stress = style->true_curve ? curve->true_stress : curve->stress;
    const long n = points_of(series, style);
    fprintf(gnuplot, "$curve%d << EOD\n", index);
    for (long i = 0; i < n; i++) {
        if (isnan(strain[i]) || isnan(stress[i])) continue;
        double x = style->true_curve ? strain[i] : percent * strain[i];
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
          "set offsets graph 0.02, graph 0.02, graph 0.05, 0\n",
          gnuplot);
    /* Of one column gnuplot finds room for any length of title only where it is a vertical one. */
    fprintf(gnuplot, "set key outside top center %s Left reverse samplen 2 width 1 maxcols %d\n",
            columns > 1 ? "horizontal" : "vertical", columns);
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

/* Length of what all titles begin with, to a comma and a blank, where they are too long for the
 * legend; 0. */
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

/* The band, where it has one, and the line; a title follows. */
static void write_line(FILE *gnuplot, int index, bool band, const char *colour, const char *dash)
{
    if (band)
        fprintf(gnuplot,
                "$curve%d using 1:3:4 with filledcurves lc rgb '%s' fs transparent solid 0.2 "
                "noborder notitle, ",
                index, colour);
    fprintf(gnuplot, "$curve%d using 1:2 with lines dt %s lw 1.5 lc rgb '%s'", index, dash, colour);
}

/* No two of FIGURE_MOST_LINES have colour and, side by side, dashes in common. */
static void write_series(FILE *gnuplot, int index, const struct figure_series *series,
                         size_t shared)
{
    const bool mixture = series->curve && attributes_text(&series->curve->provenance, "mixture");
    write_line(gnuplot, index, series->group, colours[index % COLOURS],
               mixture ? mixture_dash : dashes[index % DASHES]);
    char *words = series->group && !shared ? words_of(series) : memory_text("");
    char *title = memory_print("%s%s%s", series->title + shared, *words ? ", " : "", words);
    fputs(" title ", gnuplot);
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
        write_series(gnuplot, i, &series[i], shared);
    }
    if (marks)
        fprintf(gnuplot, ", $marks with points pt 6 ps 1.2 lw 1.2 lc rgb '#404040' title '%s'",
                true_curve ? "dσ/dε = σ" : "{/:Italic R}_m");
    fputc('\n', gnuplot);
}

/* The largest of both axes, which all panels share. */
static void find_ends(const struct figure_series series[], int count,
                      const struct figure_style *style, double ends[2])
{
    for (int i = 0; i < count; i++) {
        const struct group *group = series[i].group;
        const struct curve *curve = series[i].curve;
        const double *x = group               ? group->strain
                          : style->true_curve ? curve->true_strain
                                              : curve->strain;
        const double *y = group               ? group->mean
                          : style->true_curve ? curve->true_stress
                                              : curve->stress;
        const long n = group ? group->n : points_of(&series[i], style);
        for (long k = 0; k < n; k++) {
            ends[0] = fmax(ends[0], style->true_curve ? x[k] : percent * x[k]);
            ends[1] = fmax(ends[1], (y[k] + (group ? group->deviation[k] : 0)) / mega);
        }
    }
}

int figure_rows(int count)
{
    if (count <= FIGURE_MOST_LINES) return 0;
    return ((count < MOST_PANELS ? count : MOST_PANELS) + PANEL_COLUMNS - 1) / PANEL_COLUMNS;
}

/* Two to five of them along the axis, round, so that their numbers do not touch. */
static void write_ticks(FILE *gnuplot, double length)
{
    if (length > 0) fprintf(gnuplot, "set xtics %g\n", canvas_bar_length(3 * length));
}

/* One series a panel, with the axes of all, and of the first one a grey line to compare with. */
static void write_panels(FILE *gnuplot, const struct figure_series series[], int count,
                         const struct figure_style *style)
{
    double ends[2] = {0, 0};
    const int rows = figure_rows(count), shown = count < MOST_PANELS ? count : MOST_PANELS;
    const size_t shared = shared_words(series, count);
    if (shown < count) warn("figure: %d of %d curves drawn", shown, count);
    find_ends(series, count, style, ends);
    const double usual[2][2] = {{0, ends[0]}, {0, 1.05 * ends[1]}};
    const double *x = isnan(style->x_range[0]) ? usual[0] : style->x_range;
    fputs("set encoding utf8\nset border 3 lw 0.8\nset tics nomirror out scale 0.5\n"
          "set grid lt 1 lw 0.5 lc rgb '#d0d0d0'\nset key off\n",
          gnuplot);
    write_range(gnuplot, "x", x);
    write_range(gnuplot, "y", isnan(style->y_range[0]) ? usual[1] : style->y_range);
    write_ticks(gnuplot, x[1] - x[0]);
    fprintf(gnuplot, "set multiplot layout %d,%d margins 0.16,0.98,%g,%g spacing 0.03,%g\n", rows,
            PANEL_COLUMNS, 0.42 / rows, 1 - 0.2 / rows, 0.26 / rows);
    for (int i = 0; i < shown; i++) {
        const bool left = i % PANEL_COLUMNS == 0, bottom = i + PANEL_COLUMNS >= shown;
        fprintf(gnuplot, "set xlabel '%s'\nset format x '%s'\n",
                !bottom             ? ""
                : style->true_curve ? "True strain"
                                    : "Strain (%)",
                bottom ? "%g" : "");
        fprintf(gnuplot, "set ylabel '%s'\nset format y '%s'\nset title ",
                left ? "Stress (MPa)" : "", left ? "%g" : "");
        write_quoted(gnuplot, series[i].title + shared);
        fputs(" noenhanced offset 0,-0.9\nplot ", gnuplot);
        if (i > 0) fputs("$curve0 using 1:2 with lines lw 0.8 lc rgb '#909090', ", gnuplot);
        write_line(gnuplot, i, series[i].group, colours[1], dashes[0]);
        fputc('\n', gnuplot);
    }
    fputs("unset multiplot\n", gnuplot);
}

static int legend_columns(const struct figure_series series[], int count)
{
    return longest_title(series, count) > shared_words(series, count) + SHORT_TITLE ? 1 : 2;
}

int figure_legend_rows(const struct figure_series series[], int count)
{
    if (figure_rows(count)) return 0;
    const int columns = legend_columns(series, count), titled = shared_words(series, count) > 0;
    return (count + columns - 1) / columns + titled;
}

/* All of them in one plot. */
static void write_together(FILE *gnuplot, const struct figure_series series[], int count,
                           const struct figure_style *style)
{
    double ends[2] = {0, 0};
    find_ends(series, count, style, ends);
    bool marks = write_marks(gnuplot, series, count, style->true_curve);
    const size_t shared = shared_words(series, count);
    write_axes(gnuplot, style->true_curve, legend_columns(series, count));
    if (shared) write_heading(gnuplot, series, shared);
    write_range(gnuplot, "x", style->x_range);
    write_range(gnuplot, "y", style->y_range);
    if (style->true_curve && isnan(style->x_range[0])) write_ticks(gnuplot, ends[0]);
    if (!isnan(style->x_range[0]) || !isnan(style->y_range[0]))
        fputs("set offsets 0, 0, 0, 0\n", gnuplot);
    write_plot(gnuplot, series, count, style->true_curve, marks, shared);
}

void figure_write_curves(FILE *gnuplot, const struct figure_series series[], int count,
                         const struct figure_style *style)
{
    for (int i = 0; i < count; i++) {
        if (series[i].group)
            write_band(gnuplot, i, series[i].group);
        else
            write_points(gnuplot, i, &series[i], style);
    }
    if (figure_rows(count))
        write_panels(gnuplot, series, count, style);
    else
        write_together(gnuplot, series, count, style);
}

static int loops_columns(const struct figure_loops series[], int count)
{
    for (int i = 0; i < count; i++)
        if (strlen(series[i].title) > SHORT_TITLE) return 1;
    return 2;
}

int figure_loops_legend_rows(const struct figure_loops series[], int count)
{
    const int columns = loops_columns(series, count), stresses = 2;
    return (count + stresses + columns - 1) / columns;
}

void figure_write_loops(FILE *gnuplot, const struct figure_loops series[], int count)
{
    for (int i = 0; i < count; i++) {
        fprintf(gnuplot, "$loops%d << EOD\n", i);
        for (long k = 0; k < series[i].count; k++) {
            const struct loop *l = &series[i].loops[k];
            fprintf(gnuplot, "%.10g %.10g %.10g %.10g\n", percent * l->strain, l->flow / mega,
                    l->back / mega, l->effective / mega);
        }
        fputs("EOD\n", gnuplot);
    }
    write_axes(gnuplot, true, loops_columns(series, count));
    fputs("set xlabel 'True strain (%)'\nset yrange [*:*]\nset datafile missing 'nan'\nplot ",
          gnuplot);
    for (int i = 0; i < count; i++) {
        if (series[i].count == 0) continue;
        const char *colour = colours[i % COLOURS];
        fprintf(gnuplot, "$loops%d using 1:2 with lines lw 1.5 lc rgb '%s' title ", i, colour);
        write_quoted(gnuplot, series[i].title);
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
