/* pairing.h - curves of several titles whose scatter is the same: what differs between the titles
 * is then not that of other seeds. */
#ifndef HS_PAIRING_H
#define HS_PAIRING_H

#include "group.h"

struct pairing {
    int n;        /* titles */
    int **curves; /* [n][each[t]] numbers of curves, those of a title in their order */
    int *each;    /* [n] how many of a title */
    int left_out; /* curves of the titles that have no sister of the same scatter in each other */
};

/* Of the curves that are usable (NULL: all are). */
struct pairing pairing_make(const struct label labels[], int count, const bool usable[],
                            const char *const titles[], int n);
/* Of those that have a value of the property. */
struct pairing pairing_of(const struct properties lists[], const struct label labels[], int count,
                          const char *name, const char *const titles[], int n);
void pairing_free(struct pairing *pairing);

/* Mean and deviation of what a property of title t has more than one of title 0, sister by
 * sister. */
struct statistic pairing_change(const struct pairing *pairing, const struct properties lists[],
                                const struct label labels[], const char *name, int t);

#endif
