#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 200000000, MOST_PHASES = 16, UNSEEN = 255 };

static char title[] = "hstools domain", radius[] = "RADIUS", volume[] = "VOLUME";

/* --- writing ---------------------------------------------------------------------------------- */

/* The nodes of one phase, in lattice order, from 1. */
static int64_t *nodes_of(const struct domain *domain, int phase, int64_t *count)
{
    int64_t *nodes = memory_new((size_t)domain->n_nodes, sizeof *nodes);
    *count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++)
        if (domain->phase[i] == phase) nodes[(*count)++] = i + 1;
    return nodes;
}

static void put_attributes(const struct exodus_file *file, const struct domain *domain, int block,
                           int64_t count, const int64_t *nodes)
{
    char *names[] = {radius, volume};
    double *values = memory_new(2 * (size_t)count, sizeof *values);
    for (int64_t i = 0; i < count; i++) {
        double v = domain->volume[nodes[i] - 1];
        values[2 * i] = cbrt(0.75 * v / acos(-1));
        values[2 * i + 1] = v;
    }
    exodus_wrote(file, ex_put_attr_names(file->id, EX_ELEM_BLOCK, block, names), "names");
    exodus_wrote(file, ex_put_attr(file->id, EX_ELEM_BLOCK, block, values), "the volumes");
    free(values);
}

static void put_block(const struct exodus_file *file, const struct domain *domain, int phase)
{
    int64_t count;
    int block = phase + 1;
    int64_t *nodes = nodes_of(domain, phase, &count);
    exodus_check_name(file, domain->phase_names[phase]);
    exodus_wrote(file, ex_put_block(file->id, EX_ELEM_BLOCK, block, "SPHERE", count, 1, 0, 0, 2),
                 "a block");
    if (count > 0) {
        exodus_wrote(file, ex_put_conn(file->id, EX_ELEM_BLOCK, block, nodes, NULL, NULL),
                     "a block");
        put_attributes(file, domain, block, count, nodes);
    }
    free(nodes);
}

static void put_set(const struct exodus_file *file, const struct node_set *set, int number)
{
    int64_t *nodes = memory_new((size_t)set->count, sizeof *nodes);
    for (int64_t i = 0; i < set->count; i++) nodes[i] = set->nodes[i] + 1;
    exodus_check_name(file, set->name);
    exodus_wrote(file, ex_put_set_param(file->id, EX_NODE_SET, number, set->count, 0), set->name);
    if (set->count > 0)
        exodus_wrote(file, ex_put_set(file->id, EX_NODE_SET, number, nodes, NULL), set->name);
    exodus_wrote(file, ex_put_name(file->id, EX_NODE_SET, number, set->name), set->name);
    free(nodes);
}

void exodus_put_domain(const struct exodus_file *file, const struct domain *domain)
{
    char x[] = "x", y[] = "y", z[] = "z", *axes[] = {x, y, z};
    if (domain->n_nodes > MOST_NODES)
        die_run("%s: %lld nodes, the format holds at most %d", file->shown,
                (long long)domain->n_nodes, MOST_NODES);
    exodus_wrote(file,
                 ex_put_init(file->id, title, 3, domain->n_nodes, domain->n_nodes, domain->n_phases,
                             domain->n_sets, 0),
                 "the sizes");
    exodus_wrote(file, ex_put_coord(file->id, domain->x, domain->y, domain->z), "the positions");
    exodus_wrote(file, ex_put_coord_names(file->id, axes), "the axes");
    for (int i = 0; i < domain->n_phases; i++) put_block(file, domain, i);
    exodus_wrote(file, ex_put_names(file->id, EX_ELEM_BLOCK, domain->phase_names), "the phases");
    for (int i = 0; i < domain->n_sets; i++) put_set(file, &domain->sets[i], i + 1);
}

void exodus_write_domain(const struct spool *output, const struct domain *domain)
{
    struct exodus_file file = exodus_create(output, &domain->attributes);
    exodus_put_domain(&file, domain);
    exodus_finish(&file);
}

/* --- reading ---------------------------------------------------------------------------------- */

static ex_init_params read_sizes(const struct exodus_file *file)
{
    ex_init_params sizes;
    exodus_read(file, ex_get_init_ext(file->id, &sizes), "the sizes");
    if (sizes.num_nodes == 0)
        die_user("%s: no nodes in it, expected a domain as hsgen writes", file->shown);
    if (sizes.num_dim != 3)
        die_user("%s: %lld dimensions, expected 3", file->shown, (long long)sizes.num_dim);
    /* Three coordinates and a volume a node, in single precision at least. */
    exodus_bound(file, sizes.num_nodes, 16, "nodes");
    exodus_bound(file, sizes.num_node_sets, 4, "node sets");
    if (sizes.num_elem != sizes.num_nodes)
        die_user("%s: %lld elements on %lld nodes, expected one SPHERE a node", file->shown,
                 (long long)sizes.num_elem, (long long)sizes.num_nodes);
    if (sizes.num_elem_blk < 1 || sizes.num_elem_blk > MOST_PHASES)
        die_user("%s: %lld element blocks, expected 1 to %d", file->shown,
                 (long long)sizes.num_elem_blk, MOST_PHASES);
    return sizes;
}

/* The place of the volume among the attributes of an element. */
static int volume_attribute(const struct exodus_file *file, const ex_block *block)
{
    int found = -1;
    exodus_bound(file, block->num_attribute, 4, "attributes");
    char **names = exodus_names(block->num_attribute);
    exodus_read(file, ex_get_attr_names(file->id, EX_ELEM_BLOCK, block->id, names), "names");
    for (int i = 0; i < block->num_attribute && found < 0; i++)
        if (strcasecmp(names[i], volume) == 0) found = i;
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

static void read_elements(const struct exodus_file *file, struct domain *domain, uint8_t phase,
                          const ex_block *block)
{
    size_t count = (size_t)block->num_entry;
    int64_t *nodes = memory_new(count, sizeof *nodes);
    double *volumes = read_volumes(file, block);
    exodus_read(file, ex_get_conn(file->id, EX_ELEM_BLOCK, block->id, nodes, NULL, NULL),
                "a block");
    for (size_t i = 0; i < count; i++) {
        int64_t node = nodes[i] - 1;
        if (node < 0 || node >= domain->n_nodes || domain->phase[node] != UNSEEN)
            die_user("%s: damaged: element with node %lld, which is unknown or taken", file->shown,
                     (long long)nodes[i]);
        if (!(volumes[i] > 0) || !isfinite(volumes[i]))
            die_user("%s: volume %g of node %lld, expected a positive one", file->shown, volumes[i],
                     (long long)nodes[i]);
        domain->phase[node] = phase;
        domain->volume[node] = volumes[i];
    }
    free(nodes);
    free(volumes);
}

static void read_block(const struct exodus_file *file, struct domain *domain, int phase, int64_t id)
{
    ex_block block = {.id = id, .type = EX_ELEM_BLOCK};
    char name[EXODUS_NAME + 1] = "";
    exodus_read(file, ex_get_block_param(file->id, &block), "a block");
    exodus_read(file, ex_get_name(file->id, EX_ELEM_BLOCK, id, name), "a block's name");
    domain->phase_names[phase] =
        *name ? memory_text(name) : memory_print("block_%lld", (long long)id);
    if (block.num_entry == 0) return;
    if (strncasecmp(block.topology, "SPHERE", 6) != 0 || block.num_nodes_per_entry != 1)
        die_user("%s: block '%s' holds '%s' elements, expected SPHERE", file->shown,
                 domain->phase_names[phase], block.topology);
    exodus_bound(file, block.num_entry, 8, "elements");
    read_elements(file, domain, (uint8_t)phase, &block);
}

static void read_blocks(const struct exodus_file *file, struct domain *domain)
{
    int64_t ids[MOST_PHASES];
    exodus_read(file, ex_get_ids(file->id, EX_ELEM_BLOCK, ids), "the blocks");
    domain->phase_names = memory_new((size_t)domain->n_phases, sizeof *domain->phase_names);
    memset(domain->phase, UNSEEN, (size_t)domain->n_nodes);
    for (int i = 0; i < domain->n_phases; i++) read_block(file, domain, i, ids[i]);
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        if (domain->phase[i] == UNSEEN)
            die_user("%s: node %lld belongs to no element", file->shown, (long long)i + 1);
        if (!isfinite(domain->x[i] + domain->y[i] + domain->z[i]))
            die_user("%s: node %lld has no finite position", file->shown, (long long)i + 1);
    }
}

static int compare_nodes(const void *a, const void *b)
{
    int64_t first = *(const int64_t *)a, second = *(const int64_t *)b;
    return (first > second) - (first < second);
}

static void read_set(const struct exodus_file *file, struct domain *domain, int64_t id)
{
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
        if (nodes[i] < 1 || nodes[i] > domain->n_nodes || (i > 0 && nodes[i] - 1 == nodes[i - 1]))
            die_user("%s: node set '%s' has node %lld, which is unknown or there twice",
                     file->shown, name, (long long)nodes[i]);
        nodes[i]--;
    }
    char *own = *name ? memory_text(name) : memory_print("set_%lld", (long long)id);
    domain_add_set(domain, own, count, nodes);
    free(own);
    free(nodes);
}

struct domain exodus_read_domain(const struct spool *input)
{
    struct exodus_file file = exodus_open(input, true);
    ex_init_params sizes = read_sizes(&file);
    size_t nodes = (size_t)sizes.num_nodes, sets = (size_t)sizes.num_node_sets;
    struct domain domain = {.n_nodes = sizes.num_nodes, .n_phases = (int)sizes.num_elem_blk};
    domain.x = memory_new(nodes, sizeof(double));
    domain.y = memory_new(nodes, sizeof(double));
    domain.z = memory_new(nodes, sizeof(double));
    domain.volume = memory_new(nodes, sizeof(double));
    domain.phase = memory_new(nodes, 1);
    exodus_read(&file, ex_get_coord(file.id, domain.x, domain.y, domain.z), "the positions");
    read_blocks(&file, &domain);
    int64_t *ids = memory_new(sets, sizeof *ids);
    if (sets > 0) exodus_read(&file, ex_get_ids(file.id, EX_NODE_SET, ids), "the node sets");
    for (size_t i = 0; i < sets; i++) read_set(&file, &domain, ids[i]);
    free(ids);
    domain.attributes = exodus_read_attributes(&file);
    exodus_close(&file);
    return domain;
}
