/* study_output.h - what hspost writes of curves. */
#ifndef HS_STUDY_OUTPUT_H
#define HS_STUDY_OUTPUT_H

#include "study.h"

/* Prints, and writes whatever the request asks for. */
void study_write(const struct request *request, const struct study *study);

#endif
