/* Shapes of elements.  All that are particles are hexahedra of which some corners coincide: the map
 * of a hexahedron from the cube is then the one that the shape has of its own, and its quadrature
 * is as exact. */
#include "die.h"
#include "exodus_mesh.h"
#include "hexahedron.h"

#include <string.h>

static const struct element_shape shapes[] = {
    {"SPHERE", 1, {1}, {0}},
    {"HEX", 8, {8, 20, 27}, {0, 1, 2, 3, 4, 5, 6, 7}},
    {"TET", 4, {4, 10}, {0, 1, 2, 2, 3, 3, 3, 3}},
    {"WEDGE", 6, {6, 15}, {0, 1, 2, 2, 3, 4, 5, 5}},
    {"PYR", 5, {5, 13}, {0, 1, 2, 3, 4, 4, 4, 4}},
};

/* What has no volume: surfaces, lines and points without one. */
static const char *const flat[] = {"SHELL", "QUAD", "TRI", "BAR",    "BEAM",  "TRUSS",
                                   "EDGE",  "LINE", "ROD", "SPRING", "POINT", "NSIDED"};

static bool begins(const char *text, const char *with)
{
    return strncasecmp(text, with, strlen(with)) == 0;
}

const struct element_shape *element_shape(const struct exodus_file *file, const ex_block *block,
                                          const char *name)
{
    const char *topology = block->topology;
    for (size_t i = 0; i < sizeof flat / sizeof *flat; i++)
        if (begins(topology, flat[i])) {
            note("%s: block '%s' of %lld '%s' elements has no volume: left out", file->shown, name,
                 (long long)block->num_entry, topology);
            return NULL;
        }
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        const struct element_shape *shape = &shapes[i];
        const int64_t count = block->num_nodes_per_entry;
        bool known = false;
        for (int k = 0; count > 0 && k < MOST_ORDERS; k++) known |= count == shape->nodes[k];
        if (!known || !begins(topology, shape->name)) continue;
        if (count > shape->corners)
            note(
                "%s: block '%s' of '%s' elements of %lld nodes: their edges count as straight from "
                "corner to corner",
                file->shown, name, topology, (long long)count);
        return shape;
    }
    die_user("%s: block '%s' holds '%s' elements of %lld nodes, expected SPHERE (of one), HEX (of "
             "eight), TETRA (four), WEDGE (six) or PYRAMID (five)",
             file->shown, name, topology, (long long)block->num_nodes_per_entry);
}

double element_volume(const struct mesh *mesh, const struct element_shape *shape,
                      const int64_t nodes[], double centroid[3])
{
    struct hexahedron hexahedron;
    for (int c = 0; c < MOST_CORNERS; c++) {
        const int64_t node = nodes[shape->hexahedron[c]] - 1;
        hexahedron.corner[c][0] = mesh->x[node];
        hexahedron.corner[c][1] = mesh->y[node];
        hexahedron.corner[c][2] = mesh->z[node];
    }
    return hexahedron_volume(&hexahedron, centroid);
}
