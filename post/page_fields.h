/* page_fields.h - the body on a page: its structure, and films of its fields. */
#ifndef HS_PAGE_FIELDS_H
#define HS_PAGE_FIELDS_H

#include "study.h"

#include <stdio.h>

/* Of the fields that the request names by --frames; nothing where it names none.  The middle layer
 * and the whole body by phases, where there are two, then a film each of --variables, or of
 * plastic strain, damage and stress where these are in the file and not 0. */
void page_fields(FILE *page, const struct request *request, const struct study *study);

#endif
