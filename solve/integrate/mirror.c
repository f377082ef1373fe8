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

int64_t *mirror_nodes(const struct scene *scene, const struct body *body, int axis, int64_t *count)
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
