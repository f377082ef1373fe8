/* export.h - the finished structure in formats of other programs, one voxel or element a cell. */
#ifndef HS_EXPORT_H
#define HS_EXPORT_H

#include "structure.h"

#include <stdio.h>

/* What is written. */
struct export_source {
    const struct recipe *recipe;
    const struct structure *structure;
    const struct domain *domain; /* of the same nodes, with its sets */
};

/* Dies (exit 2) where the name has no ending of a format. */
void export_check_name(const char *path);

/* Writes the format that the name ends with.  Cells that are cut are the user's error: whole ones
 * alone are voxels. */
void export_write(const struct export_source *source, const char *path);

/* One format each; see the files. */
typedef void export_format(const struct export_source *source, FILE *file);
export_format export_vti, export_inp;

#endif
