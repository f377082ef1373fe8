/* exodus_mesh.h - what the readers of a mesh's elements and of its sets share. */
#ifndef HS_EXODUS_MESH_H
#define HS_EXODUS_MESH_H

#include "exodus_file.h"

enum { MOST_CORNERS = 8, MOST_ORDERS = 3 };

/* Corners of a particle's element, from 0. */
struct element {
    int64_t nodes[MOST_CORNERS];
    int corners;
};

struct mesh {
    const struct exodus_file *file;
    int64_t n_nodes, n_elements;
    int64_t n_particles;      /* the elements but for surfaces and lines */
    double *x, *y, *z;        /* [n_nodes] m */
    bool on_nodes;            /* spheres only, one a node: particles keep the nodes' numbers */
    struct element *elements; /* [n_particles]; NULL where on_nodes */
    int64_t *particle;        /* [n_elements] of each element, -1 of surfaces and lines */
    int64_t n_hexahedra;
};

/* Which elements are particles, by the name of their shape. */
struct element_shape {
    const char *name; /* as it begins, in any case */
    int corners;
    int nodes[MOST_ORDERS];       /* an element of it may have, corners first; 0: no more */
    int hexahedron[MOST_CORNERS]; /* its corners as those of a hexahedron, some of which coincide */
};

/* Name, shape, number of elements and of their attributes; the name is a new text. */
ex_block exodus_read_block(const struct exodus_file *file, int64_t id, char **name);
/* The place of an attribute of that name, in any case, among those of an element; -1: none. */
int exodus_attribute(const struct exodus_file *file, const ex_block *block, const char *name);
/* The place of the volume among the attributes of an element; dies (exit 2) where it has none. */
int exodus_volume_attribute(const struct exodus_file *file, const ex_block *block);

/* NULL: a surface or a line.  Dies (exit 2), naming the block, where it is none of what is known,
 * or has too few nodes. */
const struct element_shape *element_shape(const struct exodus_file *file, const ex_block *block,
                                          const char *name);

/* Volume [m^3] and centroid [m] of an element with straight edges and faces that are planes or
 * ruled by them bilinearly: exact. */
double element_volume(const struct mesh *mesh, const struct element_shape *shape,
                      const int64_t nodes[], double centroid[3]);

/* Node sets and side sets of the file become sets of the domain's particles and of its mesh's
 * nodes. */
void exodus_read_sets(const struct mesh *mesh, const ex_init_params *sizes, struct domain *domain);

#endif
