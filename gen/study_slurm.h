/* study_slurm.h - a study as a job array of Slurm. */
#ifndef HS_STUDY_SLURM_H
#define HS_STUDY_SLURM_H

#include <stdio.h>

/* The script for a study of so many runs, beside its Makefile, whose recipes it uses. */
void study_slurm_write(FILE *file, int runs);

#endif
