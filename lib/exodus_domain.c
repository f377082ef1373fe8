#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 200000000 };

static char title[] = "hstools domain", radius[] = "RADIUS", volume[] = "VOLUME", grain[] = "GRAIN";

/* A third one where grains are known. */
static int attributes_of(const struct domain *domain)
{
    return domain_has_grains(domain) ? 3 : 2;
}

static void put_block(const struct exodus_file *file, const struct domain *domain, int phase,
                      int64_t count)
{
    const int block = phase + 1;
    char *names[] = {radius, volume, grain};
    exodus_check_name(file, domain->phase_names[phase]);
    exodus_wrote(file,
                 ex_put_block(file->id, EX_ELEM_BLOCK, block, "SPHERE", count, 1, 0, 0,
                              attributes_of(domain)),
                 "a block");
    if (count > 0)
        exodus_wrote(file, ex_put_attr_names(file->id, EX_ELEM_BLOCK, block, names), "names");
}

/* Exodus has no call for a part of them. */
static void put_connections(const struct exodus_file *file, int block, int64_t first, int64_t count,
                            const long long *nodes)
{
    const size_t start[] = {(size_t)first, 0}, each[] = {(size_t)count, 1};
    char *name = memory_print("connect%d", block);
    int variable = 0;
    exodus_wrote(file, nc_inq_varid(file->id, name, &variable), name);
    exodus_wrote(file, nc_put_vara_longlong(file->id, variable, start, each, nodes), name);
    free(name);
}

/* Those of some nodes that are of a phase, behind so many of before; how many they are. */
static int64_t put_elements(const struct exodus_file *file, const struct domain_nodes *nodes,
                            int phase, int each, int64_t before)
{
    long long *elements = memory_new((size_t)nodes->count, sizeof *elements);
    int64_t count = 0;
    double *values = memory_new((size_t)(each * nodes->count), sizeof *values);
    for (int64_t i = 0; i < nodes->count; i++) {
        if (nodes->phase[i] != phase) continue;
        double *own = values + each * count;
        own[0] = cbrt(0.75 * nodes->volume[i] / acos(-1));
        own[1] = nodes->volume[i];
        if (each > 2) own[2] = nodes->grain[i];
        elements[count++] = nodes->first + i + 1;
    }
    if (count > 0) {
        put_connections(file, phase + 1, before, count, elements);
        exodus_wrote(
            file,
            ex_put_partial_attr(file->id, EX_ELEM_BLOCK, phase + 1, before + 1, count, values),
            "the volumes");
    }
    free(elements);
    free(values);
    return count;
}

void exodus_put_nodes(const struct exodus_file *file, const struct domain *domain)
{
    int64_t *done = memory_new((size_t)domain->n_phases, sizeof *done);
    struct domain_nodes nodes = {0};
    while (domain_next(domain, &nodes)) {
        exodus_wrote(file,
                     ex_put_partial_coord(file->id, nodes.first + 1, nodes.count, nodes.x[0],
                                          nodes.x[1], nodes.x[2]),
                     "the positions");
        for (int p = 0; p < domain->n_phases; p++)
            done[p] += put_elements(file, &nodes, p, attributes_of(domain), done[p]);
    }
    free(done);
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

void exodus_define_domain(const struct exodus_file *file, const struct domain *domain)
{
    char x[] = "x", y[] = "y", z[] = "z", *axes[] = {x, y, z};
    if (domain->n_nodes > MOST_NODES)
        die_run("%s: %lld nodes, the format holds at most %d", file->shown,
                (long long)domain->n_nodes, MOST_NODES);
    exodus_wrote(file,
                 ex_put_init(file->id, title, 3, domain->n_nodes, domain->n_nodes, domain->n_phases,
                             domain->n_sets, 0),
                 "the sizes");
    int64_t *count = memory_new(UINT8_MAX + 1, sizeof *count);
    for (int64_t i = 0; i < domain->n_nodes; i++) count[domain->phase[i]]++;
    exodus_wrote(file, ex_put_coord_names(file->id, axes), "the axes");
    for (int i = 0; i < domain->n_phases; i++) put_block(file, domain, i, count[i]);
    free(count);
    exodus_wrote(file, ex_put_names(file->id, EX_ELEM_BLOCK, domain->phase_names), "the phases");
    for (int i = 0; i < domain->n_sets; i++) put_set(file, &domain->sets[i], i + 1);
}

void exodus_write_domain(const struct spool *output, const struct domain *domain)
{
    struct exodus_file file = exodus_create(output, &domain->attributes);
    exodus_define_domain(&file, domain);
    exodus_put_nodes(&file, domain);
    exodus_finish(&file);
}
