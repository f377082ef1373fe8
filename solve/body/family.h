/* family.h - who belongs to a node's family: one table of lattice offsets for all nodes.
 *
 *   family of i: sites with 0 < |xi| <= horizon                                     (family.1)
 *   K_i = sum_j w V xi (x) xi,  s_i = sum_j w V xi                                  (family.2)
 *
 * Silling, Epton, Weckner, Xu, Askari, J. Elasticity 88 (2007) 151, eq. (112) (shape tensor).  All
 * in lattice units (spacing 1, V = 1): V cancels in the deformation gradient and in the force. */
#ifndef HS_FAMILY_H
#define HS_FAMILY_H

#include "deck.h"
#include "lattice.h"

#include <stdbool.h>

/* One member of the half family: xi in spacings, its weight. */
struct offset {
    int step[3];
    double weight;
};

/* Members with the same y and z lie on one column along x. */
struct column {
    int y, z;
    double weight; /* what it has more than at the next |x|; times y or z */
};

/* Columns that a family meets at one |x|, one of each pair +-(y, z). */
struct columns {
    double own; /* the same weight of the site's own column, y = z = 0 */
    int count;
    struct column *items;
};

struct family {
    double horizon; /* in spacings */
    int influence;
    bool partial;
    bool scattered; /* among particles that lie on no lattice: whoever makes it says so */
    int reach;      /* largest |step| along an axis */
    int n_half;     /* one of each pair +-xi: z > 0, or z = 0 and y > 0, or y = z = 0 and x > 0 */
    struct offset *half;
    struct columns *columns[3]; /* see family_sums.h: [component][|x| up to reach] */
};

/* influence: a name of the table in family.c.  partial: the volume of a member near the horizon
 * counts by the part of its cell within it, 1/2 + horizon - |xi| (in spacings) between 0 and 1
 * (Parks, Lehoucq, Plimpton, Silling, Comput. Phys. Commun. 179 (2008) 777, eq. (19)). */
struct family family_new(double horizon, int influence, bool partial);
void family_free(struct family *family);
extern const char *const family_influences[]; /* ended by NULL */
int family_influence(const char *name);       /* its number */

/* Number of a step among the half offsets, -1 where it is not one. */
int family_number(const struct family *family, const int step[3]);

/* Integral of w r^power over 0 <= r <= horizon, in spacings: the moments of the continuum. Infinite
 * for the steep function. */
double family_moment(const struct family *family, int power);

/* Influence function times partial volume at a length in spacings. */
double family_weight(const struct family *family, double length);

/* K^-1 of a symmetric K (xx yy zz xy yz zx), in a plane of its part there with (xx + yy)/2 for zz;
 * zero, and false, where det K < 1e-4 (tr K/3)^3. */
bool family_invert_shape(const double members[6], int dimensions, double inverse[6]);

/* Inverse shape tensor (xx yy zz xy yz zx) and s_i of the site at (x, y, z).  Where the members
 * present do not span space (det K < 1e-4 (tr K/3)^3) the inverse is zero and the answer false:
 * such a node has no deformation gradient and carries no stress. */
bool family_shape(const struct family *family, const struct lattice *lattice, const int at[3],
                  double inverse[6], double first[3]);

/* One member's part of K and s; sign -1: the one at -xi. */
void family_add_shape(const struct offset *offset, int sign, double K[6], double first[3]);

#endif
