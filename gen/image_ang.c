/* EBSD map of EDAX/TSL (.ang) and of others that write it: rows of points, lengths in micrometres.
 * The grid follows from the points; its head is believed where it agrees with them. */
#include "image_ebsd.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { LINE = 4096 };

static void read_head(const char *line, int *phase, struct ebsd_head *head, struct image *image)
{
    char name[LINE];
    int number;
    const char *rest = line + strspn(line, "# \t");
    sscanf(rest, "XSTEP: %lf", &head->step[0]);
    sscanf(rest, "YSTEP: %lf", &head->step[1]);
    sscanf(rest, "NCOLS_ODD: %lf", &head->count[0]);
    sscanf(rest, "NROWS: %lf", &head->count[1]);
    if (sscanf(rest, "Phase %d", &number) == 1) *phase = number;
    if (sscanf(rest, "MaterialName %4095[^\n]", name) == 1) {
        for (size_t n = strlen(name); n > 0 && strchr(" \t\r", name[n - 1]);) name[--n] = '\0';
        image_add_name(image, *phase > 0 ? *phase : 1, name);
    }
}

void image_ang_read(const struct image_source *source, struct image *image)
{
    /* The format gives its columns no names; these are those of its manual. */
    static char names[16][12] = {
        "phi1", "Phi", "phi2",     "x",        "y",        "iq",       "ci",       "phase",
        "sem",  "fit", "column11", "column12", "column13", "column14", "column15", "column16"};
    char *list[16], line[LINE], *fields[16];
    struct image_text text = image_text_of(source), before = text;
    struct ebsd_head head = {{0, 0}, {0, 0}};
    int phase = 0;
    while (image_line(&text, line, sizeof line) && (*line == '#' || *line == '\0')) {
        read_head(line, &phase, &head, image);
        before = text;
    }
    const int count = image_split(line, fields, 16);
    if (count < 8)
        image_refuse(&before,
                     "%d columns in the first row, expected 8 at least (angles, x, y, image "
                     "quality, confidence, phase)",
                     count);
    for (int i = 0; i < 16; i++) list[i] = names[i];
    const struct ebsd_columns columns = {count < 16 ? count : 16, list, 3, 4};
    ebsd_read(&before, &columns, &head, image);
}
