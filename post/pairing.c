#include "pairing.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool are_sisters(const struct label *a, const struct label *b)
{
    return strcmp(a->varied, b->varied) == 0;
}

static bool has_sister(const struct label labels[], int count, const bool usable[], int k,
                       const char *title)
{
    for (int i = 0; i < count; i++)
        if ((!usable || usable[i]) && strcmp(labels[i].title, title) == 0 &&
            are_sisters(&labels[i], &labels[k]))
            return true;
    return false;
}

struct pairing pairing_make(const struct label labels[], int count, const bool usable[],
                            const char *const titles[], int n)
{
    struct pairing pairing = {.n = n};
    pairing.curves = memory_new((size_t)n, sizeof *pairing.curves);
    pairing.each = memory_new((size_t)n, sizeof *pairing.each);
    for (int t = 0; t < n; t++) {
        pairing.curves[t] = memory_new((size_t)count, sizeof **pairing.curves);
        const int members = group_members(labels, count, titles[t], pairing.curves[t]);
        for (int i = 0; i < members; i++) {
            const int k = pairing.curves[t][i];
            bool paired = true;
            for (int other = 0; other < n; other++)
                paired = paired && has_sister(labels, count, usable, k, titles[other]);
            if (usable && !usable[k]) continue;
            if (paired)
                pairing.curves[t][pairing.each[t]++] = k;
            else
                pairing.left_out++;
        }
    }
    return pairing;
}

struct pairing pairing_of(const struct properties lists[], const struct label labels[], int count,
                          const char *name, const char *const titles[], int n)
{
    bool *usable = memory_new((size_t)count, sizeof *usable);
    for (int k = 0; k < count; k++) usable[k] = isfinite(properties_value(&lists[k], name));
    const struct pairing pairing = pairing_make(labels, count, usable, titles, n);
    free(usable);
    return pairing;
}

void pairing_free(struct pairing *pairing)
{
    for (int t = 0; t < pairing->n; t++) free(pairing->curves[t]);
    free(pairing->curves);
    free(pairing->each);
    *pairing = (struct pairing){0};
}

struct statistic pairing_change(const struct pairing *pairing, const struct properties lists[],
                                const struct label labels[], const char *name, int t)
{
    const int n = pairing->each[t];
    double *changes = memory_new((size_t)n, sizeof *changes);
    for (int i = 0; i < n; i++) {
        const int k = pairing->curves[t][i];
        for (int j = 0; j < pairing->each[0]; j++) {
            const int base = pairing->curves[0][j];
            if (!are_sisters(&labels[base], &labels[k])) continue;
            changes[i] = properties_value(&lists[k], name) - properties_value(&lists[base], name);
            break;
        }
    }
    const struct statistic change = statistic_of(changes, n);
    free(changes);
    return change;
}
