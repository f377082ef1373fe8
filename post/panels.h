/* panels.h - a picture of particle fields: one panel a variable, each with its colour bar. */
#ifndef HS_PANELS_H
#define HS_PANELS_H

#include "snapshot.h"

/* Draws the slice of all fields of the snapshot into request->picture. */
void panels_draw(const struct snapshot *snapshot, const struct view_request *request);

#endif
