#include "view_request.h"

#include "canvas.h"
#include "die.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void view_request_options(struct option_row rows[], struct view_request *r)
{
    const struct option_row own[VIEW_OPTION_COUNT] = {
        {0, "frames", "FILE", "particle fields of hssolve -o instead of curves", NULL, &r->frames},
        {0, "picture", "FILE", "draw them (.png, .svg, .pdf)", NULL, &r->picture},
        {0, "csv", NULL, "print them: position and values", &r->csv, NULL},
        {0, "variables", "A,B", "of the frames; a vector's name: its magnitude", NULL,
         &r->variables},
        {0, "frame", "N", "from 1, 'last' (last), or 'all': a picture each", NULL, &r->frame},
        {0, "time", "TIME", "the frame nearest to it", NULL, &r->time},
        {0, "slice", "AXIS=POSITION", "layer of particles to draw (z, middle of the body)", NULL,
         &r->slice},
        {0, "isometric", NULL, "the body in three dimensions, cut open, instead of a layer",
         &r->isometric, NULL},
        {0, "deformed", "FACTOR", "of the displacements in the picture (0)", NULL, &r->deformed},
        {0, "range", "A:B,...",
         "of the colours, for all variables or for each; 'all': of all frames", NULL, &r->range},
    };
    memcpy(rows, own, sizeof own);
}

static double read_number(const char *option, const char *text, const char *unit)
{
    double value;
    const char *wrong = units_read(text, unit, &value);
    if (wrong) die_user("--%s: %s", option, wrong);
    return value;
}

static void read_frame(struct view_request *r)
{
    if (!r->frame || strcmp(r->frame, "last") == 0) return;
    r->every_frame = strcmp(r->frame, "all") == 0;
    if (r->every_frame && !r->picture) die_user("--frame all is for pictures; give --picture FILE");
    if (r->every_frame) return;
    char *end;
    r->frame_number = strtol(r->frame, &end, 10);
    if (end == r->frame || *end != '\0' || r->frame_number < 1)
        die_user("--frame %s: expected a number from 1, 'last' or 'all'", r->frame);
}

static void read_slice(struct view_request *r)
{
    if (!r->slice) return;
    r->normal = r->slice[0] - 'x';
    if (r->normal < 0 || r->normal > 2 || (r->slice[1] != '=' && r->slice[1] != '\0'))
        die_user("--slice %s: expected x, y or z, or one with a position as in z=0.1mm", r->slice);
    if (r->slice[1] == '=') r->position = read_number("slice", r->slice + 2, "m");
}

void view_request_check(struct view_request *r, bool report)
{
    r->at_time = r->position = NAN;
    r->normal = 2;
    if (!r->frames) {
        const char *const texts[] = {r->picture, r->variables, r->frame, r->time,
                                     r->slice,   r->deformed,  r->range};
        bool any = r->csv || r->isometric;
        for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) any = any || texts[i];
        if (any)
            die_user("--picture, --csv, --variables, --frame, --time, --slice, --isometric, "
                     "--deformed and "
                     "--range are about particle fields; name their file by --frames FILE");
        return;
    }
    if (r->picture) canvas_check_name("picture", r->picture);
    if (r->picture && !r->variables) die_user("--picture needs --variables: what to draw");
    if (report && (r->picture || r->csv || r->frame || r->time || r->isometric))
        die_user(
            "--picture, --csv, --frame, --time and --isometric are for a call without --report");
    if (!r->picture && !report && (r->deformed || r->range))
        die_user("--deformed and --range are about a picture; give --picture FILE");
    if (r->isometric && (!r->picture || r->slice || r->deformed || strchr(r->variables, ',')))
        die_user("--isometric is for a picture of one variable at rest; do without --slice and "
                 "--deformed");
    if (r->frame && r->time) die_user("--frame and --time both choose the frame");
    read_frame(r);
    r->common = r->range && strcmp(r->range, "all") == 0;
    if (r->common) r->range = NULL;
    if (r->time) r->at_time = read_number("time", r->time, "s");
    read_slice(r);
    if (r->deformed) r->factor = read_number("deformed", r->deformed, "1");
}
