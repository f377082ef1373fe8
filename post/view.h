/* view.h - hspost --frames: particle fields as a picture, as text, or what the file holds. */
#ifndef HS_VIEW_H
#define HS_VIEW_H

#include "view_request.h"

/* output: file of --csv and of the listing, NULL for standard output; maker: "# ..." lines
 * above. */
void view_write(const struct view_request *request, const char *output, const char *maker);

#endif
