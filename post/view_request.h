/* view_request.h - the part of hspost's command line that is about frames of particle fields. */
#ifndef HS_VIEW_REQUEST_H
#define HS_VIEW_REQUEST_H

#include "options.h"

#include <stdbool.h>

enum { VIEW_OPTION_COUNT = 10 };

struct view_request {
    const char *frames;    /* file of hssolve -o; NULL: nothing of this is asked for */
    const char *picture;   /* NULL: none */
    bool csv;              /* values as text */
    bool isometric;        /* the whole body in place of a layer */
    const char *variables; /* "A,B"; NULL: not given */
    const char *frame;     /* number from 1, "last" or "all"; NULL: not given */
    const char *time, *slice, *deformed, *range;
    /* read from these by view_request_check */
    long frame_number; /* from 1; 0: the last, or that of the time */
    bool every_frame;  /* a picture of each */
    bool common;       /* colours and bounds of all frames */
    double at_time;    /* s; NAN where not given */
    int normal;        /* axis across the slice, 0 to 2 */
    double position;   /* m of the slice; NAN: middle of the body */
    double factor;     /* of the displacements in the positions drawn */
};

/* Fills VIEW_OPTION_COUNT rows of the option table. */
void view_request_options(struct option_row rows[], struct view_request *request);

/* Reads the texts; dies (exit 2) at what is wrong or does not go together.  report: for a page,
 * which has pictures of its own. */
void view_request_check(struct view_request *request, bool report);

#endif
