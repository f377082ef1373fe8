/* peridigm.h - the text discretisation that Peridigm reads. */
#ifndef HS_PERIDIGM_H
#define HS_PERIDIGM_H

#include "domain.h"

/* Writes BASENAME.txt ("x y z block volume" a line, m and m^3, blocks from 1) and one
 * BASENAME_<set>.txt of node numbers from 1 for each node set. */
void peridigm_write(const struct domain *domain, const char *basename);

#endif
