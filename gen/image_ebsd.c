#include "image_ebsd.h"

#include "die.h"
#include "image_points.h"

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
        "points on a square grid are read; interpolate others, such as hexagonal ones, to one";
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
    image_points_fill(text->source, &points, NAN, advice, image);
    compare_head(text->source, head, image);
    image->unit = "um";
    image_points_free(&points);
}
