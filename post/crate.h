/* crate.h - hspost --crate: a folder that says by itself how what is in it was made, a Process Run
 * Crate 0.5 (https://w3id.org/ro/wfrun/process/0.5) of RO-Crate 1.1. */
#ifndef HS_CRATE_H
#define HS_CRATE_H

#include "study.h"

/* Makes the folder where it is not there; dies (exit 2) where it cannot be, or has files without
 * being a crate of hspost. */
void crate_check(const char *folder);

/* Writes into request->crate: inputs and decks as they were read, the page of --report, curves and
 * properties as CSV, and ro-crate-metadata.json with programs, versions and commands.  The date is
 * that of SOURCE_DATE_EPOCH, else now. */
void crate_write(const struct request *request, const struct study *study);

#endif
