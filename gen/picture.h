/* picture.h - the three middle sections (of a sheet, the one) as an image: a figure without further
 * software. */
#ifndef HS_PICTURE_H
#define HS_PICTURE_H

#include "structure.h"

/* path ends in .png, .svg or .pdf, else the user's error (exit 2). */
void picture_check_name(const char *path);
void picture_write(const struct recipe *recipe, const struct structure *structure,
                   const char *path);

#endif
