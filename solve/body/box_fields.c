#include "box_fields.h"

#include "memory.h"

#include <stdlib.h>

/* A third of a page of 64 lines: three components apart, and most of nine. */
enum { LINE = 8, PAGE = 64 * LINE, APART = 21 * LINE };

void box_fields_new(double *fields[], int count, int64_t n_sites)
{
    const size_t stride = ((size_t)n_sites / PAGE + 1) * PAGE + APART;
    double *block = memory_new((size_t)count * stride, sizeof *block);
    for (int k = 0; k < count; k++) fields[k] = block + (size_t)k * stride;
}

void box_fields_free(double *first)
{
    free(first);
}
