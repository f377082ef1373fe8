#include "scale.h"

#include "memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

void scale_widen(double range[2])
{
    double low = range[0], high = range[1];
    double size = fmax(fabs(low), fabs(high));
    if (low > high || size == 0) {
        low = 0;
        high = 1;
    } else if (high - low < 1e-9 * size) { /* the same but for rounding */
        low -= 0.5 * size;
        high += 0.5 * size;
    }
    range[0] = low;
    range[1] = high;
}

/* The SI prefix that leaves one to three digits before the point. */
static const char *prefix_of(double size, double *factor)
{
    static const char *const prefixes[] = {"p", "n", "µ", "m", "", "k", "M", "G", "T", "P"};
    enum { ONE = 4, LAST = sizeof prefixes / sizeof *prefixes - 1 };
    int place = ONE;
    /* a hair above 1: 999.9999999 is shown as 1000 */
    if (size > 0) place += (int)floor(log10(size * (1 + 1e-9)) / 3);
    place = place < 0 ? 0 : place > LAST ? LAST : place;
    *factor = pow(1000, place - ONE);
    return prefixes[place];
}

static char *shown_unit(const char *unit, double size, double *factor)
{
    *factor = 1;
    if (strcmp(unit, "1") == 0) return memory_text("");
    const char *prefix = prefix_of(size, factor);
    bool density = strcmp(unit, "N/m3") == 0;
    return memory_print("%s%s", prefix, density ? "N/m³" : unit);
}

/* 1, 2, 5 or 10 times a power of ten, not below step but for rounding. */
static double round_step(double step)
{
    double power = pow(10, floor(log10(step) + 1e-9)), digit = step / power - 1e-9;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

struct scale scale_make(const double range[2], const char *unit, int most_ticks)
{
    struct scale scale = {.low = range[0], .high = range[1]};
    scale.unit = shown_unit(unit, fmax(fabs(range[0]), fabs(range[1])), &scale.factor);
    double low = range[0] / scale.factor, high = range[1] / scale.factor;
    double step = round_step((high - low) / most_ticks);
    double first = ceil(low / step - 1e-6);
    for (int k = 0; k < MOST_TICKS && (first + k) * step <= high + 1e-6 * step; k++)
        scale.ticks[scale.n_ticks++] = (first + k) * step * scale.factor;
    bool plain = step >= 1e-5 && fmax(fabs(low), fabs(high)) < 1e6;
    scale.decimals = plain ? (int)fmax(0, ceil(-log10(step) - 1e-9)) : -1;
    return scale;
}

void scale_free(struct scale *scale)
{
    free(scale->unit);
    scale->unit = NULL;
}

char *scale_text(const struct scale *scale, double value)
{
    double shown = value / scale->factor;
    if (shown == 0) shown = 0; /* no minus before it */
    return scale->decimals < 0 ? memory_print("%.6g", shown)
                               : memory_print("%.*f", scale->decimals, shown);
}

char *scale_quantity(double value, const char *unit)
{
    double factor;
    char *shown = shown_unit(unit, fabs(value), &factor);
    char *text = memory_print("%.4g%s%s", value / factor, *shown ? " " : "", shown);
    free(shown);
    return text;
}
