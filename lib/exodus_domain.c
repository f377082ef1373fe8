#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 200000000 };

static char title[] = "hstools domain", radius[] = "RADIUS", volume[] = "VOLUME", grain[] = "GRAIN";

/* The nodes of one phase, in lattice order, from 1. */
static int64_t *nodes_of(const struct domain *domain, int phase, int64_t *count)
{
    int64_t *nodes = memory_new((size_t)domain->n_nodes, sizeof *nodes);
    *count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++)
        if (domain->phase[i] == phase) nodes[(*count)++] = i + 1;
    return nodes;
}

/* A third one where grains are known. */
static int attributes_of(const struct domain *domain)
{
    return domain->grain ? 3 : 2;
}

static void put_attributes(const struct exodus_file *file, const struct domain *domain, int block,
                           int64_t count, const int64_t *nodes)
{
    char *names[] = {radius, volume, grain};
    const int64_t each = attributes_of(domain);
    double *values = memory_new((size_t)(each * count), sizeof *values);
    for (int64_t i = 0; i < count; i++) {
        double v = domain->volume[nodes[i] - 1];
        values[each * i] = cbrt(0.75 * v / acos(-1));
        values[each * i + 1] = v;
        if (domain->grain) values[each * i + 2] = domain->grain[nodes[i] - 1];
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
    exodus_wrote(file,
                 ex_put_block(file->id, EX_ELEM_BLOCK, block, "SPHERE", count, 1, 0, 0,
                              attributes_of(domain)),
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
