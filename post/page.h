/* page.h - hspost --report: all that is known of one curve or several as one page that needs
 * nothing beside it, and no script. */
#ifndef HS_PAGE_H
#define HS_PAGE_H

#include "study.h"

/* Writes the page to a file. */
void page_write(const struct request *request, const struct study *study, const char *file);

#endif
