/* study_folder.h - a study as a folder: a folder a run with its deck, the table of runs, and a
 * Makefile, for a batch system with a script beside it. */
#ifndef HS_STUDY_FOLDER_H
#define HS_STUDY_FOLDER_H

#include "deck.h"

#include <stdbool.h>

/* Makes or mends the folder.  A deck that is there already keeps its number, and its file
 * untouched, so that its results stay valid; a new one takes a number of which there is no folder;
 * one that is no longer of the study goes, its results stay.  All decks are checked before one is
 * written. */
void study_folder_write(const struct deck *deck, const char *folder, bool slurm);

/* Checks all decks and says what there would be. */
void study_folder_check(const struct deck *deck);

#endif
