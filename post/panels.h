/* panels.h - a picture of particle fields: one panel a variable, each with its colour bar. */
#ifndef HS_PANELS_H
#define HS_PANELS_H

#include "canvas.h"
#include "snapshot.h"

/* What all panels of all frames share: the particles drawn, where, and in which colours. */
struct panels {
    int axes[2], normal; /* right, up, across */
    double position;     /* m of the layer */
    int64_t count, *nodes;
    double low[2], high[2]; /* m, around all that is drawn, right and up */
    double scale;           /* points a m */
    double body[2];         /* points, right and up */
    double height;          /* of body or colour bar */
    int columns, rows;
    bool marked;           /* grips and gauge planes, below the body */
    double (*ranges)[2];   /* SI, of each field */
    double margin, legend; /* points, around all and beside each body */
    double size[2];        /* points, of the whole picture */
};

/* Of the frames first to last (from 1), for which the snapshot goes through them: bounds, and the
 * ranges that are not given, are those of all of them.  longest: points of the longer side of a
 * body; 0: by their number.  Dies (exit 2) at more variables than a picture takes. */
struct panels panels_make(struct snapshot *snapshot, const struct view_request *request,
                          double longest, int64_t first, int64_t last);
void panels_free(struct panels *panels);

/* The range of the first field's colours, of all particles of this frame where none is given. */
void panels_read_range(const struct snapshot *snapshot, const struct view_request *request,
                       double range[2]);

/* Draws the frame that the snapshot is at, from the canvas' origin; words: below it, NULL: which
 * layer, frame and time it is. */
void panels_draw(const struct panels *panels, const struct snapshot *snapshot,
                 const struct view_request *request, struct canvas *canvas, const char *words);

#endif
