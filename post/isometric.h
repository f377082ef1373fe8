/* isometric.h - the body in three dimensions, an eighth of it cut away. */
#ifndef HS_ISOMETRIC_H
#define HS_ISOMETRIC_H

#include "canvas.h"
#include "snapshot.h"

/* The body is so many points large along its longer side; size[2]: those of the picture.  The first
 * field of the snapshot in the range [SI] of its colours, its particles as bricks of their edges in
 * places of rest, seen along (-1, 1, -1), without those of the eighth towards the eye. */
void isometric_size(const struct snapshot *snapshot, double longest, double size[2]);
void isometric_draw(const struct snapshot *snapshot, const double range[2], double longest,
                    struct canvas *canvas);

#endif
