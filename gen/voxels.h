/* voxels.h - phases and grains of a measured structure, and what of them a cell of the lattice
 * gets.
 *
 * The box of voxels is centred at the origin, like the body. */
#ifndef HS_VOXELS_H
#define HS_VOXELS_H

#include <stdbool.h>
#include <stdint.h>

enum { VOXEL_EMPTY = 255, VOXEL_OUTSIDE = 254, VOXEL_PHASES = 16 };
enum voxels_rule { VOXELS_NEAREST, VOXELS_MAJORITY };

struct voxels {
    int64_t count[3];
    double edge[3]; /* m */
    uint8_t *phase; /* [count[0] * count[1] * count[2]] x fastest; VOXEL_EMPTY: no material */
    int64_t *grain; /* the same; NULL: no ids are known */
};

struct voxel {
    int phase; /* VOXEL_OUTSIDE: beyond the box, VOXEL_EMPTY: no material there */
    int64_t grain;
};

/* What lies in the cell with these edges (m) about a point (m).
 * nearest: the voxel that the point is in.  majority: the phase with the largest part of the cell
 * (of equal ones the first), and of it the grain with the largest part (of equal ones the one met
 * first). */
struct voxel voxels_at(const struct voxels *voxels, const double point[3], const double cell[3],
                       enum voxels_rule rule);

/* Length (m) of the box along an axis. */
double voxels_size(const struct voxels *voxels, int axis);

/* Cuts out the voxels from low up to, without, high, and doubles them by their mirror images along
 * the axes that are asked for: i, then i backwards. */
void voxels_crop(struct voxels *voxels, const int64_t low[3], const int64_t high[3],
                 const bool mirror[3]);

void voxels_free(struct voxels *voxels);

#endif
