/* bonds.h - every pair of particles in each other's family, once.
 *
 * Bonds come in strips of at most BOND_LANES, listed in an order that the whole body fixes, so that
 * a sum over the bonds of a node has the same terms in the same order on any number of ranks.  On a
 * lattice the bonds of a strip share their offset and their ends lie side by side; between
 * scattered particles a strip has one lower end, and its upper ends, each another one, lie
 * anywhere.  A bond across a cut is on the list of both ranks.
 *
 * The weight of a bond is what its material multiplies it by: influence function, partial volume
 * and surface correction; 0 once it is broken, or where a crack has cut it from the start.  It is
 * one number for a whole strip of a lattice until something makes the bonds of the strip differ. */
#ifndef HS_BONDS_H
#define HS_BONDS_H

#include "body.h"
#include "simd.h"

#include <stdbool.h>
#include <string.h>

/* Strips are cut where the global x of the lower ends is a multiple of it: long enough for most
 * bodies' lines, which a kernel then goes through at once.  Those between scattered particles have
 * up to LANES bonds. */
enum { BOND_LANES = 512 };

struct bond_strip {
    int count;
    int offset; /* on a lattice: number of the half offset; else -1 */
    int line;   /* on a lattice: the strips whose lower ends lie on the same line along x; else its
                   own */
    int64_t i;  /* on a lattice: site of the first lower end; else: first entry of the lists */
    int64_t store;  /* sum of the strides before it: room for one number a bond */
    double *weight; /* [count] of its own, or NULL: all have the offset's */
};

struct bond_geometry {
    double xi[3], length; /* m */
    double weight;
    int64_t shift; /* from i to j */
    bool apart;    /* see struct bond_view */
};

struct bonds {
    const struct body *body;
    int64_t count;
    int64_t points; /* sum of the strides */
    int lines;
    bool changed;    /* some weight has changed since the shape tensors were made */
    int64_t changes; /* of weights so far */
    struct bond_strip *strips;
    /* Of a lattice. */
    struct bond_geometry *geometry; /* [half offsets] */
    double volume[1];
    /* Between scattered particles: of each bond. */
    int64_t *lower, *upper;
    double *xi[3], *length, *volume_lower, *volume_upper;
};

/* A strip as a kernel reads it: element k of an array is array[k * geometry_step]. */
struct bond_view {
    int count;
    int stride;          /* count rounded up to whole vectors */
    int geometry_step;   /* 0: one number for all bonds */
    int weight_step;     /* the same of the weight */
    const double *xi[3]; /* m */
    const double *length;
    const double *volume_i, *volume_j; /* of the ends, m^3 */
    const double *weight;
    int64_t i, j;                 /* sites of the first ends on a lattice */
    const int64_t *lower, *upper; /* sites of the ends, or NULL on a lattice */
    bool apart;                   /* no site is an end of two bonds: sums may go there directly */
};

/* Frees what bonds_new (bond_search.h) has made. */
void bonds_free(struct bonds *bonds);

static inline int bonds_stride(int count)
{
    return (count + 7) / 8 * 8;
}

struct bond_view bonds_view(const struct bonds *bonds, const struct bond_strip *strip);

/* Bonds first to first + count - 1 of a view. */
struct bond_view bonds_part(const struct bond_view *view, int first, int count);

/* The strip's weights as an array of its own, which may be changed. */
double *bonds_own_weights(struct bonds *bonds, struct bond_strip *strip);

/* The weight of bond k of a strip before corrections, cuts and breaks. */
double bonds_first_weight(const struct bonds *bonds, const struct bond_strip *strip, int k);

/* Sites of the ends of bond k of a view. */
static inline int64_t bond_lower(const struct bond_view *view, int k)
{
    return view->lower ? view->lower[k] : view->i + k;
}
static inline int64_t bond_upper(const struct bond_view *view, int k)
{
    return view->upper ? view->upper[k] : view->j + k;
}

/* A field at the lower or the upper ends: where it lies, or gathered into the buffer [BOND_LANES].
 */
static inline const double *bond_gather(const struct bond_view *view, bool upper,
                                        const double *field, double *buffer)
{
    const int64_t *ends = upper ? view->upper : view->lower;
    if (!ends) return field + (upper ? view->j : view->i);
    for (int k = 0; k < view->count; k++) buffer[k] = field[ends[upper ? k : 0]];
    return buffer;
}

/* Where a kernel may add what it gives to the ends: the field itself, or the cleared buffer
 * [BOND_LANES], which bond_scatter then adds in the order of the bonds.  Of a lattice strip the
 * lower ends are always apart from each other; the upper ones are the lower ends of others in the
 * strip when the offset runs along x. */
static inline double *bond_target(const struct bond_view *view, bool upper, double *field,
                                  double *buffer)
{
    if (!view->lower && (!upper || view->apart)) return field + (upper ? view->j : view->i);
    memset(buffer, 0, (size_t)view->count * sizeof *buffer);
    return buffer;
}

/* The one lower end of a scattered strip is summed up in a register: through memory each term would
 * wait for the one before, half of the time of such a strip. */
static inline void bond_scatter(const struct bond_view *view, bool upper, double *field,
                                const double *buffer)
{
    if (!view->lower && (!upper || view->apart)) return;
    if (upper) {
        for (int k = 0; k < view->count; k++) field[bond_upper(view, k)] += buffer[k];
    } else {
        double sum = field[view->lower[0]];
        for (int k = 0; k < view->count; k++) sum += buffer[k];
        field[view->lower[0]] = sum;
    }
}

/* Bonds of the whole body.  Collective. */
int64_t bonds_total(const struct bonds *bonds);

/* terms[k] of bond k of a strip becomes 0 where another rank counts it: the owner of its lower end.
 */
void bonds_only_owned(const struct bonds *bonds, const struct bond_strip *strip, double *terms);

#endif
