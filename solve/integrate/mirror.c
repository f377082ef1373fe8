#include "mirror.h"

#include "memory.h"

#include <stdlib.h>

/* Whether a set of the deck holds each node along an axis: [n_nodes]. */
static bool *held_by_deck(const struct scene *scene, const struct lattice *lattice, int axis)
{
    bool *held = memory_new((size_t)lattice->n_nodes, sizeof *held);
    for (int b = 0; b < scene->n_boundary; b++) {
        const struct scene_entry *entry = &scene->boundary[b];
        if (!scene_holds(entry->kind) || entry->direction != axis) continue;
        for (int64_t i = 0; i < entry->nodes.count; i++) held[entry->nodes.numbers[i]] = true;
    }
    return held;
}

/* Numbers of the nodes in the plane, on rank 0. */
static int64_t *nodes_in_plane(const struct scene *scene, const struct body *body, int axis,
                               int64_t *count)
{
    const struct lattice *lattice = body->lattice;
    *count = 0;
    if (body->ranks.rank != 0) return NULL;
    bool *held = held_by_deck(scene, lattice, axis);
    int64_t *nodes = memory_new((size_t)lattice->n_nodes, sizeof *nodes), node = 0;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        if (!lattice_has_node(lattice, site)) continue;
        lattice_position(lattice, site, at);
        if (at[axis] == 0 && !held[node]) nodes[(*count)++] = node;
        node++;
    }
    free(held);
    return nodes;
}

void mirror_add(struct boundary *boundary, const struct scene *scene, const struct body *body,
                double largest_stress)
{
    const struct lattice *lattice = body->lattice;
    const double area = lattice_largest_face(lattice);
    for (int a = 0; a < 3; a++) {
        int64_t count, any;
        if (!lattice->mirror[a]) continue;
        int64_t *nodes = nodes_in_plane(scene, body, a, &count);
        any = count;
        ranks_share(&any, sizeof any);
        if (any > 0) {
            struct boundary_set *set = &boundary->sets[boundary->count++];
            *set = (struct boundary_set){.where = scene->solver,
                                         .direction = a,
                                         .kind = SCENE_DISPLACEMENT,
                                         .members = members_of_nodes(body, nodes, count)};
            set->inner = set->members.high_x;
            set->zero = exact_sum_new((double)set->members.n_all * largest_stress * area);
        }
        free(nodes);
    }
}
