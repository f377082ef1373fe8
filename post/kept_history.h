/* kept_history.h - a history that came through a pipe outlives a hspost that fails. */
#ifndef HS_KEPT_HISTORY_H
#define HS_KEPT_HISTORY_H

#include "spool.h"

/* From here on, if the program dies, of an error or of SIGINT, SIGTERM or SIGHUP, what was read
 * goes to hspost-history.e (with a number where that is taken) in the working directory, else in
 * that of temporary files, and its name is told.  A file that was read needs nothing. */
void kept_history(const struct spool *spool);

#endif
