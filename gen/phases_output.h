/* phases_output.h - a structure of any number of phases in numbers: what does not suppose cores. */
#ifndef HS_PHASES_OUTPUT_H
#define HS_PHASES_OUTPUT_H

#include "structure.h"

#include <stdio.h>

/* Text for people, line by line through note(). */
void phases_print(const struct recipe *recipe, const struct structure *structure);

/* Rows of the table of statistics: two_point_NAME and profile_NAME of a phase along the axes, to 40
 * spacings. */
void phases_write_along(const struct structure *structure, int phase, const char *name,
                        int dimensions, FILE *file);

/* All rows of all phases. */
void phases_write(const struct recipe *recipe, const struct structure *structure, FILE *file);

#endif
