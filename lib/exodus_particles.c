/* Reading a domain: particles from elements.  A SPHERE is the particle on its node with the volume
 * of its attribute; a hexahedron, tetrahedron, wedge or pyramid is one at its centroid with its
 * volume. */
#include "die.h"
#include "exodus.h"
#include "exodus_mesh.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PHASES = 16, UNSEEN = 255 };

static ex_init_params read_sizes(const struct exodus_file *file)
{
    ex_init_params sizes;
    exodus_read(file, ex_get_init_ext(file->id, &sizes), "the sizes");
    if (sizes.num_nodes == 0)
        die_user("%s: no nodes in it, expected a domain as hsgen writes", file->shown);
    if (sizes.num_elem == 0)
        die_user("%s: no elements in it, expected SPHERE, HEX, TETRA, WEDGE or PYRAMID ones",
                 file->shown);
    if (sizes.num_dim != 3)
        die_user("%s: %lld dimensions, expected 3", file->shown, (long long)sizes.num_dim);
    /* Three coordinates a node, a node and a volume an element, in single precision at least. */
    exodus_bound(file, sizes.num_nodes, 12, "nodes");
    exodus_bound(file, sizes.num_elem, 8, "elements");
    if (sizes.num_elem_blk < 1 || sizes.num_elem_blk > MOST_PHASES)
        die_user("%s: %lld element blocks, expected 1 to %d", file->shown,
                 (long long)sizes.num_elem_blk, MOST_PHASES);
    return sizes;
}

/* --- blocks ----------------------------------------------------------------------------------- */

ex_block exodus_read_block(const struct exodus_file *file, int64_t id, char **name)
{
    ex_block block = {.id = id, .type = EX_ELEM_BLOCK};
    char given[EXODUS_NAME + 1] = "";
    exodus_read(file, ex_get_block_param(file->id, &block), "a block");
    exodus_read(file, ex_get_name(file->id, EX_ELEM_BLOCK, id, given), "a block's name");
    *name = *given ? memory_text(given) : memory_print("block_%lld", (long long)id);
    return block;
}

int exodus_attribute(const struct exodus_file *file, const ex_block *block, const char *name)
{
    int found = -1;
    exodus_bound(file, block->num_attribute, 4, "attributes");
    char **names = exodus_names(block->num_attribute);
    exodus_read(file, ex_get_attr_names(file->id, EX_ELEM_BLOCK, block->id, names), "names");
    for (int i = 0; i < block->num_attribute && found < 0; i++)
        if (strcasecmp(names[i], name) == 0) found = i;
    free(names);
    return found;
}

int exodus_volume_attribute(const struct exodus_file *file, const ex_block *block)
{
    const int found = exodus_attribute(file, block, "VOLUME");
    if (found < 0)
        die_user("%s: block %lld has no attribute VOLUME", file->shown, (long long)block->id);
    return found;
}

/* All attributes at once: netCDF is slow at picking one out of the interleaved ones. */
static double *read_attribute(const struct exodus_file *file, const ex_block *block, int place)
{
    const int64_t each = block->num_attribute;
    exodus_bound(file, block->num_entry, 4 * each, "attributes");
    double *values = memory_new((size_t)(block->num_entry * each), sizeof *values);
    exodus_read(file, ex_get_attr(file->id, EX_ELEM_BLOCK, block->id, values), "attributes");
    for (int64_t i = 0; i < block->num_entry; i++) values[i] = values[i * each + place];
    return values;
}

static int64_t *read_corners(const struct mesh *mesh, const ex_block *block)
{
    const int64_t corners = block->num_nodes_per_entry;
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

struct block {
    ex_block sizes;
    const struct element_shape *shape; /* NULL: surfaces or lines, or none */
};

/* The particles that follow from a block, under the next numbers. */
static void add_spheres(struct mesh *mesh, const struct block *block, uint8_t phase,
                        struct domain *domain)
{
    int64_t *nodes = read_corners(mesh, &block->sizes);
    const int place = exodus_attribute(mesh->file, &block->sizes, "GRAIN");
    double *volumes = read_attribute(mesh->file, &block->sizes,
                                     exodus_volume_attribute(mesh->file, &block->sizes)),
           *grains = place < 0 ? NULL : read_attribute(mesh->file, &block->sizes, place);
    if (grains && !domain->grain)
        domain->grain = memory_new((size_t)domain->n_nodes, sizeof *domain->grain);
    for (int64_t i = 0; i < block->sizes.num_entry; i++) {
        const int64_t node = nodes[i] - 1, particle = mesh->on_nodes ? node : mesh->n_particles;
        if (domain->phase[particle] != UNSEEN)
            die_user("%s: damaged: element with node %lld, which is unknown or taken",
                     mesh->file->shown, (long long)nodes[i]);
        if (!(volumes[i] > 0) || !isfinite(volumes[i]))
            die_user("%s: volume %g of node %lld, expected a positive one", mesh->file->shown,
                     volumes[i], (long long)nodes[i]);
        domain->phase[particle] = phase;
        domain->volume[particle] = volumes[i];
        if (grains) domain->grain[particle] = grains[i];
        domain->x[particle] = mesh->x[node];
        domain->y[particle] = mesh->y[node];
        domain->z[particle] = mesh->z[node];
        if (!mesh->on_nodes) mesh->elements[particle] = (struct element){{node}, 1};
        mesh->n_particles++;
    }
    free(nodes);
    free(volumes);
    free(grains);
}

static void add_solids(struct mesh *mesh, const struct block *block, int64_t first, uint8_t phase,
                       struct domain *domain)
{
    const struct element_shape *shape = block->shape;
    int64_t *nodes = read_corners(mesh, &block->sizes);
    for (int64_t i = 0; i < block->sizes.num_entry; i++) {
        const int64_t particle = mesh->n_particles++,
                      *own = nodes + block->sizes.num_nodes_per_entry * i;
        double x[3], volume = element_volume(mesh, shape, own, x);
        if (!(volume > 0) || !isfinite(volume))
            die_user("%s: element %lld (from node %lld on) has the volume %g, expected a positive "
                     "one: corners counter-clockwise around the lowest face seen from the others, "
                     "then those",
                     mesh->file->shown, (long long)(first + i) + 1, (long long)own[0], volume);
        domain->phase[particle] = phase;
        domain->volume[particle] = volume;
        domain->x[particle] = x[0];
        domain->y[particle] = x[1];
        domain->z[particle] = x[2];
        mesh->elements[particle].corners = shape->corners;
        mesh->n_hexahedra += shape->corners == MOST_CORNERS;
        for (int c = 0; c < shape->corners; c++) mesh->elements[particle].nodes[c] = own[c] - 1;
    }
    free(nodes);
}

/* Names and sizes of all blocks first: they say whether particles keep the nodes' numbers.  Blocks
 * without particles are no phases, but for empty ones. */
static int64_t read_shapes(struct mesh *mesh, struct block blocks[], struct domain *domain)
{
    const struct exodus_file *file = mesh->file;
    int64_t ids[MOST_PHASES], elements = 0, particles = 0;
    exodus_read(file, ex_get_ids(file->id, EX_ELEM_BLOCK, ids), "the blocks");
    domain->phase_names = memory_new((size_t)domain->n_phases, sizeof *domain->phase_names);
    mesh->on_nodes = true;
    for (int i = 0; i < domain->n_phases; i++) {
        struct block *block = &blocks[i];
        block->sizes = exodus_read_block(file, ids[i], &domain->phase_names[i]);
        exodus_bound(file, block->sizes.num_entry, 8, "elements");
        elements += block->sizes.num_entry;
        if (block->sizes.num_entry == 0) continue;
        block->shape = element_shape(file, &block->sizes, domain->phase_names[i]);
        if (block->shape) particles += block->sizes.num_entry;
        mesh->on_nodes = mesh->on_nodes && block->shape && block->shape->corners == 1;
    }
    if (elements > mesh->n_elements)
        die_user("%s: damaged: %lld elements in blocks, %lld in all", file->shown,
                 (long long)elements, (long long)mesh->n_elements);
    if (mesh->on_nodes && mesh->n_elements != mesh->n_nodes)
        die_user("%s: %lld elements on %lld nodes, expected one SPHERE a node", file->shown,
                 (long long)mesh->n_elements, (long long)mesh->n_nodes);
    /* Elements of no block are found below. */
    particles += mesh->n_elements - elements;
    if (particles == 0)
        die_user("%s: no element has a volume, expected SPHERE, HEX, TETRA, WEDGE or PYRAMID ones",
                 file->shown);
    return particles;
}

static void forget_block(struct domain *domain, int phase)
{
    free(domain->phase_names[phase]);
    domain->n_phases--;
    for (int i = phase; i < domain->n_phases; i++)
        domain->phase_names[i] = domain->phase_names[i + 1];
}

static void make_room(struct mesh *mesh, int64_t particles, struct domain *domain)
{
    const size_t n = (size_t)particles;
    domain_make_room(domain, particles);
    memset(domain->phase, UNSEEN, n);
    if (!mesh->on_nodes) mesh->elements = memory_new(n, sizeof *mesh->elements);
    mesh->particle = memory_new((size_t)mesh->n_elements, sizeof *mesh->particle);
    for (int64_t i = 0; i < mesh->n_elements; i++) mesh->particle[i] = -1;
}

static void read_blocks(struct mesh *mesh, struct domain *domain)
{
    struct block blocks[MOST_PHASES] = {{.shape = NULL}};
    const int n_blocks = domain->n_phases;
    int64_t first = 0;
    int phase = 0;
    make_room(mesh, read_shapes(mesh, blocks, domain), domain);
    for (int i = 0; i < n_blocks; i++) {
        const struct block *block = &blocks[i];
        const int64_t count = block->sizes.num_entry, before = mesh->n_particles;
        if (block->shape && block->shape->corners == 1)
            add_spheres(mesh, block, (uint8_t)phase, domain);
        else if (block->shape)
            add_solids(mesh, block, first, (uint8_t)phase, domain);
        for (int64_t e = 0; block->shape && e < count; e++) mesh->particle[first + e] = before + e;
        first += count;
        if (count > 0 && !block->shape)
            forget_block(domain, phase);
        else
            phase++;
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

/* Where all particles are hexahedra, the domain keeps their corners; it takes over the positions.
 */
static void keep_corners(struct mesh *mesh, struct domain *domain)
{
    if (mesh->n_hexahedra < domain->n_nodes) return;
    domain->hexahedra = memory_new(MOST_CORNERS * (size_t)domain->n_nodes, sizeof(int64_t));
    for (int64_t p = 0; p < domain->n_nodes; p++)
        memcpy(domain->hexahedra + MOST_CORNERS * p, mesh->elements[p].nodes,
               MOST_CORNERS * sizeof(int64_t));
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
    free(mesh->particle);
}

struct domain exodus_read_domain(const struct spool *input)
{
    struct exodus_file file = exodus_open(input, true);
    ex_init_params sizes = read_sizes(&file);
    struct mesh mesh = mesh_new(&file, &sizes);
    struct domain domain = {.n_phases = (int)sizes.num_elem_blk};
    read_blocks(&mesh, &domain);
    check_particles(&mesh, &domain);
    keep_corners(&mesh, &domain);
    exodus_read_sets(&mesh, &sizes, &domain);
    mesh_free(&mesh);
    domain.attributes = exodus_read_attributes(&file);
    exodus_close(&file);
    return domain;
}
