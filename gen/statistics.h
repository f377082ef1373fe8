/* statistics.h - a structure in numbers.  Everything is measured on the nodes of the counted region
 * (outside the grips), for a structure of two phases. */
#ifndef HS_STATISTICS_H
#define HS_STATISTICS_H

#include "findings.h"

/* Probability that both ends of a segment of `lag` spacings along an axis lie in a phase:
 * S2 (Torquato, Random Heterogeneous Materials, 2002, section 2.2).  NaN where none fits.  Along
 * periodic axes the segments go on into the next image of the body. */
double statistics_two_point(const struct structure *structure, int phase, int axis, int64_t lag);

/* Fraction of a phase in layer i along an axis; NaN where no node of the layer is counted. */
double statistics_profile(const struct structure *structure, int phase, int axis, int64_t i);

struct interface {
    double faces;   /* 1/m, faces between unlike nodes per volume: 3/2 too much where isotropic */
    double crofton; /* 1/m, the same from 13 directions, without that bias */
};

/* Interface area per volume.  crofton: twice the mean number of crossings per length of line over
 * the 13 directions of a cubic lattice, each weighted by its share of the sphere of directions
 * (Ohser and Muecklich, Statistical Analysis of Microstructures in Materials Science, 2000,
 * section 4.2; Legland, Kieu and Devaux, Image Analysis and Stereology 26 (2007) 83).  Of a sheet
 * its length of interface per area, which is the area per volume: pi/2 times the mean number of
 * crossings over the 4 directions of a square lattice (same sources); faces are 4/pi too much
 * there.  On oblong cells the directions and their shares are those of the cells.  Of a part of a
 * symmetric body that of the whole one. */
struct interface statistics_interface(const struct structure *structure, bool sheet);

/* Shares of directions nearest to each of clusters_offset on cells with these edges, either sense;
 * of cubes those of faces, edges and corners (of the 6, 12 and 8), in closed form, else by counting
 * directions: 1e-4. */
extern const double statistics_direction_share[3];
void statistics_direction_shares(const double spacing[3], double share[NEIGHBOURS_26]);

/* Local shell thickness in edges along x at up to `most` fine nodes, evenly strided: distances to
 * the nearest coarse nodes of the two nearest cores, added, less a cell (steps_film); a straight
 * film of n layers has n of their edges. thickness: [most].  Returns how many were found (nodes
 * further than 12 edges of a cube of the cell's volume from a second core are passed over). */
int64_t statistics_shell(const struct structure *structure, int64_t most, double *thickness);

/* Text for people, line by line through note(). */
void statistics_print(const struct recipe *recipe, const struct structure *structure,
                      const struct findings *findings);

/* All statistics as a table: quantity,axis,position,value,unit. */
void statistics_write(const struct recipe *recipe, const struct structure *structure,
                      const struct findings *findings, const char *path);

#endif
