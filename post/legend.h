/* legend.h - what the colours of a picture mean. */
#ifndef HS_LEGEND_H
#define HS_LEGEND_H

#include "canvas.h"
#include "snapshot.h"

/* Points: what it takes in width, and what it needs in height for the phases' names. */
enum { LEGEND_WIDTH = 106 };
double legend_least_height(const struct snapshot *snapshot);

/* "VonMises (MPa)"; the caller frees it. */
char *legend_title(const struct field *field, const double range[2]);

/* A bar with ticks, or of a phase the names, from the origin downwards. */
void legend_draw(struct canvas *canvas, const struct snapshot *snapshot, const struct field *field,
                 const double range[2], double height);

#endif
