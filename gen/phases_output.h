/* phases_output.h - a structure of any number of phases in numbers: what does not suppose cores. */
#ifndef HS_PHASES_OUTPUT_H
#define HS_PHASES_OUTPUT_H

#include "structure.h"

#include <stdio.h>

/* Text for people, line by line through note(). */
void phases_print(const struct recipe *recipe, const struct structure *structure);

/* Rows of the table of statistics: quantity,axis or phase,,value,unit. */
void phases_write(const struct recipe *recipe, const struct structure *structure, FILE *file);

#endif
