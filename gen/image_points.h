/* image_points.h - values at scattered places that are the places of a regular grid: found out from
 * the places alone, whatever a head says. */
#ifndef HS_IMAGE_POINTS_H
#define HS_IMAGE_POINTS_H

#include "image.h"

struct image_points {
    int64_t count;
    double (*at)[3]; /* [count] */
    double *value;   /* [count] */
};

void image_points_add(struct image_points *points, double x, double y, double z, double value);
void image_points_free(struct image_points *points);

/* Enters size, edges and values of the grid.  Places may be off by a tenth of an edge, as files
 * round them; missing: value of a grid's place without a point, NaN: it is not to be.  Dies where
 * they are no grid; advice: what would help. */
void image_points_fill(const struct image_source *source, const struct image_points *points,
                       double missing, const char *advice, struct image *image);

#endif
