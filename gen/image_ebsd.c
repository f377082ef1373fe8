#include "image_ebsd.h"

#include "die.h"
#include "image_points.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LINE = 4096, MOST_COLUMNS = 64 };

static int find_column(const struct image_text *text, const struct ebsd_columns *columns)
{
    const char *wanted = text->source->array ? text->source->array : "phase";
    struct image_array arrays[MOST_COLUMNS];
    for (int i = 0; i < columns->count; i++) {
        if (strcasecmp(columns->names[i], wanted) == 0) return i;
        arrays[i] = (struct image_array){columns->names[i], 1};
    }
    return image_choose(text->source, arrays,
                        columns->count); /* dies naming those that there are */
}

/* A number; a comma in it is a point. */
static double number_of(struct image_text *text, char *word)
{
    char *comma = strchr(word, ','), *end;
    if (comma) *comma = '.';
    const double value = strtod(word, &end);
    if (end == word || *end || !isfinite(value))
        image_refuse(text, "found '%.40s', expected a number", word);
    return value;
}

/* --- hexagonal grids -----------------------------------------------------------------------------
 */

struct row {
    int64_t first, count;
};

/* Points as they stand in the file: a row ends where y changes.  The caller frees the rows. */
static struct row *find_rows(const struct image_points *points, double step, int64_t *count)
{
    struct row *rows = NULL;
    *count = 0;
    for (int64_t i = 0; i < points->count; i++) {
        if (i == 0 || fabs(points->at[i][1] - points->at[i - 1][1]) > 0.1 * step) {
            rows = memory_grow(rows, *count, sizeof *rows);
            rows[(*count)++] = (struct row){i, 0};
        }
        rows[*count - 1].count++;
    }
    return rows;
}

/* Whether every second row is shifted by half a step against the first one. */
static bool are_shifted(const struct image_points *points, const struct row *rows, int64_t count,
                        double step)
{
    bool shifted = count > 1;
    for (int64_t r = 0; r < count; r++) {
        const double shift = (points->at[rows[r].first][0] - points->at[0][0]) / step;
        shifted = shifted && fabs(fabs(shift) - 0.5 * (double)(r % 2)) < 0.1 &&
                  rows[r].count == rows[r % 2].count;
    }
    return shifted && llabs(rows[0].count - rows[1].count) <= 1;
}

/* Makes boxes of the cells of a hexagonal grid, one for each point: shifted rows are moved back. */
static bool straighten(const char *path, struct image_points *points)
{
    const double step = points->count > 1 ? points->at[1][0] - points->at[0][0] : 0;
    const double x = points->count > 0 ? points->at[0][0] : 0;
    int64_t count = 0, kept = 0;
    struct row *rows = step > 0 ? find_rows(points, step, &count) : NULL;
    const bool shifted = step > 0 && are_shifted(points, rows, count, step);
    const int64_t least = shifted ? (int64_t)fmin((double)rows[0].count, (double)rows[1].count) : 0;
    for (int64_t r = 0; shifted && r < count; r++)
        for (int64_t i = 0; i < least; i++, kept++) {
            const int64_t from = rows[r].first + i;
            points->at[kept][0] = x + (double)i * step;
            points->at[kept][1] = points->at[from][1];
            points->value[kept] = points->value[from];
        }
    if (shifted) {
        warn("%s: points on a hexagonal grid: every second row is moved by half a step, %g um%s",
             path, 0.5 * step,
             rows[0].count != rows[1].count ? ", and the last point of longer rows is left out"
                                            : "");
        points->count = kept;
    }
    free(rows);
    return shifted;
}

/* --- the map -------------------------------------------------------------------------------------
 */

static void compare_head(const struct image_source *source, const struct ebsd_head *head,
                         const struct image *image)
{
    bool counts = true, steps = true;
    for (int axis = 0; axis < 2; axis++) {
        const double step = head->step[axis], edge = image->edge[axis];
        if (!(head->count[axis] > 0) || !(step > 0)) return;
        counts = counts && head->count[axis] == (double)image->count[axis];
        steps = steps && (image->count[axis] == 1 || fabs(step - edge) < 0.05 * edge);
    }
    if (counts && steps) return;
    if (steps)
        die_user("%s: cut off: its head says %g x %g points, and there are %lld x %lld",
                 source->path, head->count[0], head->count[1], (long long)image->count[0],
                 (long long)image->count[1]);
    warn("%s: its head says %g x %g points %g x %g um apart; its rows are %lld x %lld points %g x "
         "%g um "
         "apart, and are taken",
         source->path, head->count[0], head->count[1], head->step[0], head->step[1],
         (long long)image->count[0], (long long)image->count[1], image->edge[0], image->edge[1]);
}

void ebsd_read(struct image_text *text, const struct ebsd_columns *columns,
               const struct ebsd_head *head, struct image *image)
{
    static const char advice[] =
        "points on square and hexagonal grids are read; interpolate others to one of these";
    const int column = find_column(text, columns);
    const int needed = 1 + (int)fmax(column, fmax(columns->x, columns->y));
    struct image_points points = {0};
    char line[LINE], *fields[MOST_COLUMNS];
    for (struct image_text at = *text; image_line(text, line, sizeof line); at = *text) {
        const int count = image_split(line, fields, MOST_COLUMNS);
        if (count == 0) continue;
        if (count < needed)
            image_refuse(&at, "%d columns in the row, expected %d at least", count, needed);
        image_points_add(&points, number_of(&at, fields[columns->x]),
                         number_of(&at, fields[columns->y]), 0, number_of(&at, fields[column]));
    }
    const bool hexagonal = straighten(text->source->path, &points);
    image_points_fill(text->source, &points, NAN, advice, image);
    if (!hexagonal) compare_head(text->source, head, image);
    image->unit = "um";
    image_points_free(&points);
}
