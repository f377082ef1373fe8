/* Reading a domain: particles from elements.  A SPHERE is the particle on its node with the volume of its
 * attribute; a hexahedron is a particle at its centroid with its volume. */
#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "hexahedron.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PHASES = 16, CORNERS = 8, UNSEEN = 255 };

/* Corners of a particle's element, from 0. */
struct element {
    int64_t nodes[CORNERS];
    int corners; /* 1 or 8 */
};

struct mesh {
    const struct exodus_file *file;
    int64_t n_nodes, n_elements;
    double *x, *y, *z;        /* [n_nodes] m */
    bool on_nodes;            /* spheres only, one a node: particles keep the nodes' numbers */
    struct element *elements; /* [n_elements] of the particles; NULL where on_nodes */
    int64_t read;             /* elements so far */
    int64_t n_hexahedra;
};

static ex_init_params read_sizes(const struct exodus_file *file)
{
    ex_init_params sizes;
    exodus_read(file, ex_get_init_ext(file->id, &sizes), "the sizes");
    if (sizes.num_nodes == 0)
        die_user("%s: no nodes in it, expected a domain as hsgen writes", file->shown);
    if (sizes.num_elem == 0)
        die_user("%s: no elements in it, expected SPHERE or HEX ones", file->shown);
    if (sizes.num_dim != 3)
        die_user("%s: %lld dimensions, expected 3", file->shown, (long long)sizes.num_dim);
    /* Three coordinates a node, a node and a volume an element, in single precision at least. */
    exodus_bound(file, sizes.num_nodes, 12, "nodes");
    exodus_bound(file, sizes.num_elem, 8, "elements");
    exodus_bound(file, sizes.num_node_sets, 4, "node sets");
    if (sizes.num_elem_blk < 1 || sizes.num_elem_blk > MOST_PHASES)
        die_user("%s: %lld element blocks, expected 1 to %d", file->shown,
                 (long long)sizes.num_elem_blk, MOST_PHASES);
    return sizes;
}

/* --- blocks ----------------------------------------------------------------------------------- */

/* Corners of a block's elements; dies where they are neither spheres nor hexahedra. */
static int corners_of(const struct exodus_file *file, const ex_block *block, const char *name)
{
    if (strncasecmp(block->topology, "SPHERE", 6) == 0 && block->num_nodes_per_entry == 1) return 1;
    if (strncasecmp(block->topology, "HEX", 3) == 0 && block->num_nodes_per_entry == CORNERS)
        return CORNERS;
    die_user(
        "%s: block '%s' holds '%s' elements of %lld nodes, expected SPHERE (of one) or HEX (of "
        "eight)",
        file->shown, name, block->topology, (long long)block->num_nodes_per_entry);
}

static ex_block read_block_sizes(const struct exodus_file *file, int64_t id, char **name)
{
    ex_block block = {.id = id, .type = EX_ELEM_BLOCK};
    char given[EXODUS_NAME + 1] = "";
    exodus_read(file, ex_get_block_param(file->id, &block), "a block");
    exodus_read(file, ex_get_name(file->id, EX_ELEM_BLOCK, id, given), "a block's name");
    *name = *given ? memory_text(given) : memory_print("block_%lld", (long long)id);
    return block;
}

/* The place of the volume among the attributes of an element. */
static int volume_attribute(const struct exodus_file *file, const ex_block *block)
{
    int found = -1;
    exodus_bound(file, block->num_attribute, 4, "attributes");
    char **names = exodus_names(block->num_attribute);
    exodus_read(file, ex_get_attr_names(file->id, EX_ELEM_BLOCK, block->id, names), "names");
    for (int i = 0; i < block->num_attribute && found < 0; i++)
        if (strcasecmp(names[i], "VOLUME") == 0) found = i;
    free(names);
    if (found < 0)
        die_user("%s: block %lld has no attribute VOLUME", file->shown, (long long)block->id);
    return found;
}

/* All attributes at once: netCDF is slow at picking one out of the interleaved ones. */
static double *read_volumes(const struct exodus_file *file, const ex_block *block)
{
    int64_t place = volume_attribute(file, block), each = block->num_attribute;
    exodus_bound(file, block->num_entry, 4 * each, "attributes");
    double *values = memory_new((size_t)(block->num_entry * each), sizeof *values);
    exodus_read(file, ex_get_attr(file->id, EX_ELEM_BLOCK, block->id, values), "the volumes");
    for (int64_t i = 0; i < block->num_entry; i++) values[i] = values[i * each + place];
    return values;
}

static int64_t *read_corners(const struct mesh *mesh, const ex_block *block, int corners)
{
    exodus_bound(mesh->file, block->num_entry, 4 * corners, "elements");
    int64_t *nodes = memory_new((size_t)(block->num_entry * corners), sizeof *nodes);
    exodus_read(mesh->file,
                ex_get_conn(mesh->file->id, EX_ELEM_BLOCK, block->id, nodes, NULL, NULL),
                "a block");
    for (int64_t i = 0; i < block->num_entry * corners; i++)
        if (nodes[i] < 1 || nodes[i] > mesh->n_nodes)
            die_user("%s: damaged: element with node %lld, which is unknown or taken",
                     mesh->file->shown, (long long)nodes[i]);
    return nodes;
}

static double hexahedron_of(const struct mesh *mesh, const int64_t nodes[CORNERS],
                            double centroid[3])
{
    struct hexahedron hexahedron;
    for (int c = 0; c < CORNERS; c++) {
        hexahedron.corner[c][0] = mesh->x[nodes[c] - 1];
        hexahedron.corner[c][1] = mesh->y[nodes[c] - 1];
        hexahedron.corner[c][2] = mesh->z[nodes[c] - 1];
    }
    return hexahedron_volume(&hexahedron, centroid);
}

static void add_spheres(struct mesh *mesh, const ex_block *block, uint8_t phase,
                        struct domain *domain)
{
    int64_t *nodes = read_corners(mesh, block, 1);
    double *volumes = read_volumes(mesh->file, block);
    for (int64_t i = 0; i < block->num_entry; i++) {
        const int64_t node = nodes[i] - 1, particle = mesh->on_nodes ? node : mesh->read;
        if (domain->phase[particle] != UNSEEN)
            die_user("%s: damaged: element with node %lld, which is unknown or taken",
                     mesh->file->shown, (long long)nodes[i]);
        if (!(volumes[i] > 0) || !isfinite(volumes[i]))
            die_user("%s: volume %g of node %lld, expected a positive one", mesh->file->shown,
                     volumes[i], (long long)nodes[i]);
        domain->phase[particle] = phase;
        domain->volume[particle] = volumes[i];
        domain->x[particle] = mesh->x[node];
        domain->y[particle] = mesh->y[node];
        domain->z[particle] = mesh->z[node];
        if (!mesh->on_nodes) mesh->elements[particle] = (struct element){{node}, 1};
        mesh->read++;
    }
    free(nodes);
    free(volumes);
}

static void add_hexahedra(struct mesh *mesh, const ex_block *block, uint8_t phase,
                          struct domain *domain)
{
    int64_t *nodes = read_corners(mesh, block, CORNERS);
    for (int64_t i = 0; i < block->num_entry; i++) {
        const int64_t particle = mesh->read++, *own = nodes + CORNERS * i;
        double x[3], volume = hexahedron_of(mesh, own, x);
        if (!(volume > 0) || !isfinite(volume))
            die_user("%s: element %lld (from node %lld on) has the volume %g, expected a positive "
                     "one: four corners around a face, then the four above them",
                     mesh->file->shown, (long long)particle + 1, (long long)own[0], volume);
        domain->phase[particle] = phase;
        domain->volume[particle] = volume;
        domain->x[particle] = x[0];
        domain->y[particle] = x[1];
        domain->z[particle] = x[2];
        mesh->elements[particle].corners = CORNERS;
        mesh->n_hexahedra++;
        for (int c = 0; c < CORNERS; c++) mesh->elements[particle].nodes[c] = own[c] - 1;
    }
    free(nodes);
}

/* Names and sizes of all blocks first: they say whether particles keep the nodes' numbers. */
static void read_blocks(struct mesh *mesh, struct domain *domain)
{
    const struct exodus_file *file = mesh->file;
    int64_t ids[MOST_PHASES], elements = 0;
    int corners[MOST_PHASES] = {0};
    ex_block blocks[MOST_PHASES];
    exodus_read(file, ex_get_ids(file->id, EX_ELEM_BLOCK, ids), "the blocks");
    domain->phase_names = memory_new((size_t)domain->n_phases, sizeof *domain->phase_names);
    mesh->on_nodes = true;
    for (int i = 0; i < domain->n_phases; i++) {
        blocks[i] = read_block_sizes(file, ids[i], &domain->phase_names[i]);
        exodus_bound(file, blocks[i].num_entry, 8, "elements");
        elements += blocks[i].num_entry;
        if (blocks[i].num_entry > 0)
            corners[i] = corners_of(file, &blocks[i], domain->phase_names[i]);
        mesh->on_nodes = mesh->on_nodes && corners[i] != CORNERS;
    }
    if (mesh->on_nodes && mesh->n_elements != mesh->n_nodes)
        die_user("%s: %lld elements on %lld nodes, expected one SPHERE a node", file->shown,
                 (long long)mesh->n_elements, (long long)mesh->n_nodes);
    if (elements > mesh->n_elements)
        die_user("%s: damaged: %lld elements in blocks, %lld in all", file->shown,
                 (long long)elements, (long long)mesh->n_elements);
    if (!mesh->on_nodes)
        mesh->elements = memory_new((size_t)mesh->n_elements, sizeof *mesh->elements);
    for (int i = 0; i < domain->n_phases; i++) {
        if (corners[i] == 1) add_spheres(mesh, &blocks[i], (uint8_t)i, domain);
        if (corners[i] == CORNERS) add_hexahedra(mesh, &blocks[i], (uint8_t)i, domain);
    }
}

static void check_particles(const struct mesh *mesh, const struct domain *domain)
{
    const char *kind = mesh->on_nodes ? "node" : "element";
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        if (domain->phase[i] == UNSEEN)
            die_user("%s: %s %lld belongs to no %s", mesh->file->shown, kind, (long long)i + 1,
                     mesh->on_nodes ? "element" : "block");
        if (!isfinite(domain->x[i] + domain->y[i] + domain->z[i]))
            die_user("%s: %s %lld has no finite position", mesh->file->shown, kind,
                     (long long)i + 1);
    }
}

/* --- sets ------------------------------------------------------------------------------------- */

static int compare_nodes(const void *a, const void *b)
{
    int64_t first = *(const int64_t *)a, second = *(const int64_t *)b;
    return (first > second) - (first < second);
}

/* The particles at least half of whose corners are among the nodes: a face of a hexahedron. */
static void add_particles(const struct mesh *mesh, const char *name, const int64_t *nodes,
                          int64_t count, struct domain *domain)
{
    uint8_t *chosen = memory_new((size_t)mesh->n_nodes, 1);
    int64_t *particles = memory_new((size_t)domain->n_nodes, sizeof *particles), n = 0;
    for (int64_t i = 0; i < count; i++) chosen[nodes[i]] = 1;
    for (int64_t p = 0; p < domain->n_nodes; p++) {
        const struct element *element = &mesh->elements[p];
        int in_set = 0;
        for (int c = 0; c < element->corners; c++) in_set += chosen[element->nodes[c]];
        if (2 * in_set >= element->corners) particles[n++] = p;
    }
    domain_add_set(domain, name, n, particles);
    free(particles);
    free(chosen);
}

static void read_set(const struct mesh *mesh, int64_t id, struct domain *domain)
{
    const struct exodus_file *file = mesh->file;
    int64_t count, factors;
    char name[EXODUS_NAME + 1] = "";
    exodus_read(file, ex_get_set_param(file->id, EX_NODE_SET, id, &count, &factors), "a node set");
    exodus_bound(file, count, 4, "nodes of a set");
    int64_t *nodes = memory_new((size_t)count, sizeof *nodes);
    if (count > 0)
        exodus_read(file, ex_get_set(file->id, EX_NODE_SET, id, nodes, NULL), "a node set");
    exodus_read(file, ex_get_name(file->id, EX_NODE_SET, id, name), "a node set's name");
    qsort(nodes, (size_t)count, sizeof *nodes, compare_nodes);
    for (int64_t i = 0; i < count; i++) {
        if (nodes[i] < 1 || nodes[i] > mesh->n_nodes || (i > 0 && nodes[i] - 1 == nodes[i - 1]))
            die_user("%s: node set '%s' has node %lld, which is unknown or there twice",
                     file->shown, name, (long long)nodes[i]);
        nodes[i]--;
    }
    char *own = *name ? memory_text(name) : memory_print("set_%lld", (long long)id);
    if (mesh->on_nodes)
        domain_add_set(domain, own, count, nodes);
    else
        add_particles(mesh, own, nodes, count, domain);
    if (domain->corners) domain_add_set(domain->corners, own, count, nodes);
    free(own);
    free(nodes);
}

static void read_sets(const struct mesh *mesh, int64_t count, struct domain *domain)
{
    int64_t *ids = memory_new((size_t)count, sizeof *ids);
    if (count > 0)
        exodus_read(mesh->file, ex_get_ids(mesh->file->id, EX_NODE_SET, ids), "the node sets");
    for (int64_t i = 0; i < count; i++) read_set(mesh, ids[i], domain);
    free(ids);
}

/* Where all particles are hexahedra, the domain keeps their corners; it takes over the positions. */
static void keep_corners(struct mesh *mesh, struct domain *domain)
{
    if (mesh->n_hexahedra < mesh->n_elements) return;
    domain->hexahedra = memory_new(CORNERS * (size_t)domain->n_nodes, sizeof(int64_t));
    for (int64_t p = 0; p < domain->n_nodes; p++)
        memcpy(domain->hexahedra + CORNERS * p, mesh->elements[p].nodes, CORNERS * sizeof(int64_t));
    domain->corners = memory_new(1, sizeof *domain->corners);
    *domain->corners =
        (struct domain){.n_nodes = mesh->n_nodes, .x = mesh->x, .y = mesh->y, .z = mesh->z};
    mesh->x = mesh->y = mesh->z = NULL;
}

/* --- the domain ------------------------------------------------------------------------------- */

static struct mesh mesh_new(const struct exodus_file *file, const ex_init_params *sizes)
{
    const size_t nodes = (size_t)sizes->num_nodes;
    struct mesh mesh = {.file = file,
                        .n_nodes = sizes->num_nodes,
                        .n_elements = sizes->num_elem,
                        .x = memory_new(nodes, sizeof(double)),
                        .y = memory_new(nodes, sizeof(double)),
                        .z = memory_new(nodes, sizeof(double))};
    exodus_read(file, ex_get_coord(file->id, mesh.x, mesh.y, mesh.z), "the positions");
    return mesh;
}

static void mesh_free(struct mesh *mesh)
{
    free(mesh->x);
    free(mesh->y);
    free(mesh->z);
    free(mesh->elements);
}

struct domain exodus_read_domain(const struct spool *input)
{
    struct exodus_file file = exodus_open(input, true);
    ex_init_params sizes = read_sizes(&file);
    struct mesh mesh = mesh_new(&file, &sizes);
    const size_t particles = (size_t)sizes.num_elem;
    struct domain domain = {.n_nodes = sizes.num_elem, .n_phases = (int)sizes.num_elem_blk};
    domain.x = memory_new(particles, sizeof(double));
    domain.y = memory_new(particles, sizeof(double));
    domain.z = memory_new(particles, sizeof(double));
    domain.volume = memory_new(particles, sizeof(double));
    domain.phase = memory_new(particles, 1);
    memset(domain.phase, UNSEEN, particles);
    read_blocks(&mesh, &domain);
    check_particles(&mesh, &domain);
    keep_corners(&mesh, &domain);
    read_sets(&mesh, sizes.num_node_sets, &domain);
    mesh_free(&mesh);
    domain.attributes = exodus_read_attributes(&file);
    exodus_close(&file);
    return domain;
}
