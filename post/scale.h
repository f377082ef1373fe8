/* scale.h - the numbers beside a colour bar: range, SI prefix, ticks. */
#ifndef HS_SCALE_H
#define HS_SCALE_H

enum { MOST_TICKS = 16 };

struct scale {
    double low, high; /* SI; low < high */
    double factor;    /* SI value per shown number: 1e6 for MPa */
    char *unit;       /* as shown, "" where there is none */
    int n_ticks;
    double ticks[MOST_TICKS]; /* SI */
    int decimals;             /* of the shown numbers; -1: in powers of ten */
};

/* A range of values that were found: 0 to 1 where there are none or all are 0; wider where they are
 * all the same. */
void scale_widen(double range[2]);

/* Up to about most_ticks round numbers (1, 2 or 5 times a power of ten apart) within the range. */
struct scale scale_make(const double range[2], const char *unit, int most_ticks);
void scale_free(struct scale *scale);

/* A number in the shown unit; the caller frees it. */
char *scale_text(const struct scale *scale, double value);

/* A single value with prefix and unit: "3.41 µs"; the caller frees it. */
char *scale_quantity(double value, const char *unit);

#endif
