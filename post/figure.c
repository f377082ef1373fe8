#include "figure.h"

#include "die.h"
#include "figure_script.h"
#include "memory.h"
#include "spool.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* 12 cm by 9 cm in print; the PNG has 340 dots an inch.  Higher by what rows of the legend have
 * no room above the curves. */
static const struct format {
    const char *ending, *terminal;
    double width, height, row;
    int rows; /* with room */
    const char *unit, *options;
} formats[] = {
    {".svg", "svg", 640, 480, 20, 2, "",
     "font 'Helvetica,15' linewidth 1.2 background 'white' enhanced"},
    {".png", "pngcairo", 1600, 1200, 48, 2, "", "font 'Helvetica,32' linewidth 3 enhanced"},
    {".pdf", "pdfcairo", 12, 9, 0.4, 2, "cm", "font 'Helvetica,11' linewidth 1.6 enhanced"},
};
enum { FORMATS = sizeof formats / sizeof *formats };
/* On a page: on a telephone its letters are still those of small print. */
static const struct format inlined = {
    "", "svg", 440, 310,
    20, 0,     "",  "font 'sans-serif,13' linewidth 1.2 background 'white' enhanced"};
static const double panel_height = 0.34; /* over the width, of a row of panels */

static const struct format *format_of(const char *name)
{
    for (int i = 0; i < FORMATS; i++) {
        size_t n = strlen(name), m = strlen(formats[i].ending);
        if (n > m && strcmp(name + n - m, formats[i].ending) == 0) return &formats[i];
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

void figure_check_gnuplot(const char *name, const char *option)
{
    if (!has_gnuplot())
        die_run("%s: no gnuplot found; install it (gnuplot-nox) or do without --%s", name, option);
}

void figure_check(const char *name)
{
    format_of(name);
    figure_check_gnuplot(name, "plot");
}

/* What a script is written of. */
struct drawing {
    const struct figure_series *series;
    const struct figure_loops *loops; /* NULL: curves */
    int count;
    const struct figure_style *style;
};

/* As a file that gnuplot can open. */
static struct spool script_of(const char *name, const struct format *format,
                              const struct drawing *d)
{
    char *text;
    size_t length;
    const int rows = d->loops ? 0 : figure_rows(d->count),
              legend = (d->loops ? figure_loops_legend_rows(d->loops, d->count)
                                 : figure_legend_rows(d->series, d->count)) -
                       format->rows;
    const double height = format->height + (legend > 0 ? legend * format->row : 0);
    FILE *script = open_memstream(&text, &length);
    if (!script) die_run("%s: %s", name, strerror(errno));
    fprintf(script, "set terminal %s size %g%s,%g%s %s\n", format->terminal, format->width,
            format->unit, fmax(height, rows * panel_height * format->width), format->unit,
            format->options);
    if (d->loops)
        figure_write_loops(script, d->loops, d->count);
    else
        figure_write_curves(script, d->series, d->count, d->style);
    if (fclose(script) != 0) die_run("%s: %s", name, strerror(errno));
    const struct spool spool = spool_bytes(text, length);
    free(text);
    return spool;
}

/* Returns the bytes copied. */
static size_t copy(FILE *from, const char *name, FILE *figure)
{
    char bytes[1 << 14];
    size_t count, all = 0;
    while ((count = fread(bytes, 1, sizeof bytes, from)) > 0) {
        if (fwrite(bytes, 1, count, figure) != count)
            die_run("cannot write %s: %s", name, strerror(errno));
        all += count;
    }
    return all;
}

/* gnuplot's exit status says nothing of a full disk: its bytes come here, and are written where
 * that is seen. */
static void draw(const char *name, FILE *figure, const struct format *format,
                 const struct drawing *drawing)
{
    struct spool script = script_of(name, format, drawing);
    char *command = memory_print("LC_ALL=C.UTF-8 exec gnuplot </proc/%ld/fd/%d", (long)getpid(),
                                 script.descriptor);
    FILE *gnuplot = popen(command, "r");
    if (!gnuplot) die_run("%s: cannot start gnuplot: %s", name, strerror(errno));
    const size_t bytes = copy(gnuplot, name, figure);
    const int status = pclose(gnuplot);
    free(command);
    spool_close(&script);
    if (WIFSIGNALED(status)) die_run("%s: gnuplot was ended by signal %d", name, WTERMSIG(status));
    if (status != 0 || bytes == 0)
        die_run("%s: gnuplot failed (status %d, %zu bytes)", name,
                WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes);
}

static void draw_file(const char *name, const char *path, const struct drawing *drawing)
{
    FILE *figure = fopen(path, "w");
    if (!figure) die_run("cannot write %s: %s", name, strerror(errno));
    draw(name, figure, format_of(name), drawing);
    if (fclose(figure) != 0) die_run("cannot write %s: %s", name, strerror(errno));
}

void figure_draw(const char *name, const char *path, const struct figure_series series[], int count,
                 const struct figure_style *style)
{
    draw_file(name, path, &(struct drawing){series, NULL, count, style});
}

void figure_draw_loops(const char *name, const char *path, const struct figure_loops series[],
                       int count)
{
    draw_file(name, path, &(struct drawing){NULL, series, count, NULL});
}

/* gnuplot gives the same ids in each of its figures. */
static void write_apart(FILE *page, const char *svg, const char *id)
{
    static const char *const ids[] = {"gnuplot_", "gpDot", "gpPt", "textbox", "greybox"};
    for (const char *c = svg; *c; c++) {
        fputc(*c, page);
        for (size_t i = 0; strchr("'\"#", *c) && i < sizeof ids / sizeof *ids; i++)
            if (strncmp(c + 1, ids[i], strlen(ids[i])) == 0) fprintf(page, "%s_", id);
    }
}

static void draw_inline(FILE *page, const char *id, const struct drawing *drawing)
{
    static const char end_of_description[] = "</desc>";
    char *text;
    size_t length;
    FILE *figure = open_memstream(&text, &length);
    if (!figure) die_run("%s: %s", id, strerror(errno));
    draw(id, figure, &inlined, drawing);
    if (fclose(figure) != 0) die_run("%s: %s", id, strerror(errno));
    const char *start = strstr(text, "viewBox"), *body = strstr(text, end_of_description);
    if (!start || !body) die_run("%s: this is no figure of gnuplot's", id);
    fprintf(page, "<svg role=\"img\" aria-labelledby=\"%s-words\" %.*s>\n", id,
            (int)strcspn(start, ">"), start);
    write_apart(page, body + strlen(end_of_description), id);
    free(text);
}

void figure_inline(FILE *page, const char *id, const struct figure_series series[], int count,
                   const struct figure_style *style)
{
    draw_inline(page, id, &(struct drawing){series, NULL, count, style});
}

void figure_inline_loops(FILE *page, const char *id, const struct figure_loops series[], int count)
{
    draw_inline(page, id, &(struct drawing){NULL, series, count, NULL});
}
