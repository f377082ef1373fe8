/* exact_sum.h - sums over the whole body with the same bits for any number of ranks.
 *
 * Each term is cut to two fixed grids, multiples of ulp(high) and ulp(low); sums of such multiples
 * are exact in double precision as long as they stay below the extractor, so their order is free
 * (pre-rounding: Rump, Ogita, Oishi, SIAM J. Sci. Comput. 31 (2008) 189; Demmel & Nguyen, IEEE
 * Trans. Comput. 64 (2015) 2060).  With bound >= the sum of all |terms| over all ranks, what is
 * lost of each term is below 2^-74 bound, for up to 2^30 terms: what the first grid cuts off them,
 * up to 2^-51 bound each, must fit into 53 bits of the second. */
#ifndef HS_EXACT_SUM_H
#define HS_EXACT_SUM_H

struct exact_sum {
    double high, low;   /* extractors, powers of two times 1.5 */
    double top, bottom; /* the two partial sums */
};

struct exact_sum exact_sum_new(double bound);

/* The most that is lost of a term: half a unit in the last place of the fine extractor, which is
 * 2^-53 of it or less. */
static inline double exact_sum_loss(const struct exact_sum *sum)
{
    return 0x1p-53 * sum->low;
}

static inline void exact_sum_add(struct exact_sum *sum, double term)
{
    double top = (term + sum->high) - sum->high;
    double bottom = ((term - top) + sum->low) - sum->low;
    sum->top += top;
    sum->bottom += bottom;
}

/* Adds scale * terms[i], i < count. */
void exact_sum_add_strip(struct exact_sum *sum, int count, const double *terms, double scale);

/* Adds up count sums over all ranks; values[i] = result.  One message. */
void exact_sum_finish(const struct exact_sum *sums, int count, double *values);

#endif
