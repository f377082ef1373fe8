/* Node sets and side sets of a mesh, as sets of particles: every element with a node in the node
 * set, as Peridigm has it, and every element with a side in the side set. */
#include "die.h"
#include "exodus_mesh.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

struct kind {
    ex_entity_type type;
    const char *words, *unnamed, *alias; /* names of its sets: without one, and by their number */
};
static const struct kind node_sets = {EX_NODE_SET, "node set", "set", "nodelist"},
                         side_sets = {EX_SIDE_SET, "side set", "surface", "surface"};

/* A set as it is in the file: entries from 1, of side sets elements and their sides. */
struct entries {
    const struct kind *kind;
    char *name, *alias;
    int64_t count, *items, *sides;
};

static struct entries read_entries(const struct exodus_file *file, const struct kind *kind,
                                   int64_t id)
{
    struct entries set = {.kind = kind};
    int64_t factors;
    char name[EXODUS_NAME + 1] = "";
    exodus_read(file, ex_get_set_param(file->id, kind->type, id, &set.count, &factors),
                kind->words);
    exodus_bound(file, set.count, 4, "members of a set");
    set.items = memory_new((size_t)set.count, sizeof *set.items);
    set.sides = memory_new((size_t)set.count, sizeof *set.sides);
    if (set.count > 0)
        exodus_read(file,
                    ex_get_set(file->id, kind->type, id, set.items,
                               kind->type == EX_SIDE_SET ? set.sides : NULL),
                    kind->words);
    exodus_read(file, ex_get_name(file->id, kind->type, id, name), kind->words);
    set.name = *name ? memory_text(name) : memory_print("%s_%lld", kind->unnamed, (long long)id);
    set.alias = memory_print("%s_%lld", kind->alias, (long long)id);
    return set;
}

static void free_entries(struct entries *set)
{
    free(set->name);
    free(set->alias);
    free(set->items);
    free(set->sides);
}

/* A side set beside a node set of its name, as meshers write both, goes by its number alone. */
static void add_set(struct domain *domain, const struct entries *set, const uint8_t *chosen,
                    int64_t n)
{
    int64_t *list = NULL, count = 0;
    for (int64_t i = 0; i < n; i++) {
        if (!chosen[i]) continue;
        list = memory_grow(list, count, sizeof *list);
        list[count++] = i;
    }
    const bool taken = domain_set(domain, set->name) != NULL;
    domain_add_set(domain, taken ? set->alias : set->name, count, list);
    if (!taken) domain_alias_set(domain, set->alias);
    free(list);
}

static void add_nodes(const struct mesh *mesh, const struct entries *set, struct domain *domain)
{
    uint8_t *chosen = memory_new((size_t)mesh->n_nodes, 1);
    for (int64_t i = 0; i < set->count; i++) {
        const int64_t node = set->items[i] - 1;
        if (node < 0 || node >= mesh->n_nodes || chosen[node])
            die_user("%s: node set '%s' has node %lld, which is unknown or there twice",
                     mesh->file->shown, set->name, (long long)node + 1);
        chosen[node] = 1;
    }
    if (mesh->on_nodes) {
        add_set(domain, set, chosen, domain->n_nodes);
    } else {
        uint8_t *own = memory_new((size_t)domain->n_nodes, 1);
        for (int64_t p = 0; p < domain->n_nodes; p++)
            for (int c = 0; c < mesh->elements[p].corners; c++)
                own[p] |= chosen[mesh->elements[p].nodes[c]];
        add_set(domain, set, own, domain->n_nodes);
        free(own);
    }
    if (domain->corners) add_set(domain->corners, set, chosen, mesh->n_nodes);
    free(chosen);
}

enum { SIDES = 6, SIDE_CORNERS = 4 };

/* Corners of a hexahedron's sides: Schoof, Yarberry, EXODUS II: a finite element data model,
 * SAND92-2137, 1994, table of the side numbering. */
static const int sides[SIDES][SIDE_CORNERS] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                               {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};

static void add_sides(const struct mesh *mesh, const struct entries *set, struct domain *domain)
{
    uint8_t *own = memory_new((size_t)domain->n_nodes, 1),
            *nodes = memory_new((size_t)mesh->n_nodes, 1);
    for (int64_t i = 0; i < set->count; i++) {
        const int64_t element = set->items[i] - 1, side = set->sides[i] - 1;
        if (element < 0 || element >= mesh->n_elements || side < 0 || side >= SIDES)
            die_user("%s: side set '%s' has side %lld of element %lld, which is unknown",
                     mesh->file->shown, set->name, (long long)side + 1, (long long)element + 1);
        const int64_t particle = mesh->particle[element];
        if (particle < 0) continue;
        own[particle] = 1;
        for (int c = 0; domain->corners && c < SIDE_CORNERS; c++)
            nodes[mesh->elements[particle].nodes[sides[side][c]]] = 1;
    }
    add_set(domain, set, own, domain->n_nodes);
    if (domain->corners) add_set(domain->corners, set, nodes, mesh->n_nodes);
    free(own);
    free(nodes);
}

static void read_kind(const struct mesh *mesh, const struct kind *kind, int64_t count,
                      struct domain *domain)
{
    const struct exodus_file *file = mesh->file;
    exodus_bound(file, count, 4, kind->words);
    if (mesh->on_nodes && kind == &side_sets) return; /* spheres have none */
    int64_t *ids = memory_new((size_t)count, sizeof *ids);
    if (count > 0) exodus_read(file, ex_get_ids(file->id, kind->type, ids), kind->words);
    for (int64_t i = 0; i < count; i++) {
        struct entries set = read_entries(file, kind, ids[i]);
        (kind == &node_sets ? add_nodes : add_sides)(mesh, &set, domain);
        free_entries(&set);
    }
    free(ids);
}

void exodus_read_sets(const struct mesh *mesh, const ex_init_params *sizes, struct domain *domain)
{
    read_kind(mesh, &node_sets, sizes->num_node_sets, domain);
    read_kind(mesh, &side_sets, sizes->num_side_sets, domain);
}
