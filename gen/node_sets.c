#include "specimen.h"

#include "keys.h"
#include "memory.h"
#include "symmetry.h"

#include <math.h>
#include <stdlib.h>

struct box_set {
    const char *name;
    struct deck_node box;
};

static const struct key set_rows[] = {
    {"name", KEY_TEXT, offsetof(struct box_set, name), .required = true, .help = "not in use yet"},
    {"box", KEY_NODE, offsetof(struct box_set, box),
     .form = "[[x, y, z], [x, y, z]], m or spacings", .required = true,
     .help = "two corners; the body is centred at the origin"},
};

const struct section specimen_set = {
    .path = "domain.sets[]",
    .help = "Further node sets, for boundary and initial: the nodes in a box.",
    .keys = KEYS(set_rows),
};

/* Nodes between two corners of lattice indices, both included. */
static void add_box(const struct sites *sites, const char *name, const int64_t low[3],
                    const int64_t high[3], struct domain *out)
{
    int64_t *nodes = memory_new((size_t)sites->n_nodes, sizeof *nodes);
    int64_t count = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t index[3];
        sites_index(sites, node, index);
        bool in_box = true;
        for (int axis = 0; axis < 3; axis++)
            in_box = in_box && index[axis] >= low[axis] && index[axis] <= high[axis];
        if (in_box) nodes[count++] = node;
    }
    domain_add_set(out, name, count, nodes);
    free(nodes);
}

/* Nodes whose centres lie from x = low to high (m) in the frame of the body. */
static void add_slab(const struct sites *sites, const char *name, double low, double high,
                     struct domain *out)
{
    int64_t *nodes = memory_new((size_t)sites->n_nodes, sizeof *nodes);
    int64_t count = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        double at[3];
        sites_in_body(sites, node, at);
        if (at[0] >= low && at[0] <= high) nodes[count++] = node;
    }
    domain_add_set(out, name, count, nodes);
    free(nodes);
}

/* First layer whose coordinate is not below the length, or last one that is not above it. */
static int64_t layer_of(const struct sites *sites, int axis, double length, int last)
{
    int64_t i = 0;
    double slack = 1e-6 * sites->spacing[axis];
    if (last) {
        while (i < sites->count[axis] && sites_coordinate(sites, axis, i) <= length + slack) i++;
        return i - 1;
    }
    while (i < sites->count[axis] && sites_coordinate(sites, axis, i) < length - slack) i++;
    return i;
}

static void add_deck_set(const struct specimen *specimen, const struct sites *sites,
                         struct deck_node map, struct domain *out)
{
    struct box_set set;
    keys_read(map, &specimen_set, 0, sites->spacing[0], &set, NULL);
    if (domain_set(out, set.name))
        deck_error(deck_get(map, "name"), "there is a node set '%s' already", set.name);
    struct deck_node box = set.box;
    int64_t corner[2][3];
    for (int end = 0; end < 2; end++) {
        if (!deck_is_list(box) || deck_count(box) != 2 || !deck_is_list(deck_item(box, end)) ||
            deck_count(deck_item(box, end)) != 3)
            deck_error(box, "a box is two corners: [[x, y, z], [x, y, z]]");
        for (int axis = 0; axis < 3; axis++) {
            struct deck_node item = deck_item(deck_item(box, end), axis);
            double length = deck_length(item, sites->spacing[axis], -1e6, 1e6);
            corner[end][axis] = layer_of(sites, axis, length, end);
        }
    }
    for (int axis = 0; axis < 3; axis++)
        symmetry_check_layers(box, specimen, axis, corner[0][axis], corner[1][axis]);
    add_box(sites, set.name, corner[0], corner[1], out);
    if (out->sets[out->n_sets - 1].count == 0)
        deck_error(box, "no node lies in this box; the body is centred at the origin");
}

void specimen_add_sets(const struct specimen *specimen, const struct sites *sites,
                       struct deck_node sets, struct domain *out)
{
    const double end = specimen->size[0], grip = 0.5 * end - specimen->grip_length;
    if (specimen->grip_length > 0) {
        if (!specimen->symmetry[0]) add_slab(sites, "grip_left", -end, -grip, out);
        add_slab(sites, "grip_right", grip, end, out);
    }
    if (specimen->gauge_length > 0) {
        /* One layer; across the lattice the nodes within half a cell's thickness of the plane. */
        const double *turn = sites->turn, *edge = sites->spacing;
        double plane = 0.5 * specimen->gauge_length;
        double half = (0.5 + 1e-6) * hypot(turn[0] * edge[0], turn[1] * edge[1]);
        int64_t layer[2];
        specimen_gauge_layers(specimen, layer);
        if (specimen->angle == 0) {
            plane = sites_coordinate(sites, 0, layer[1]);
            half = 0.5 * half;
        }
        if (!specimen->symmetry[0])
            add_slab(sites, "gauge_left", -plane - half, -plane + half, out);
        add_slab(sites, "gauge_right", plane - half, plane + half, out);
    }
    if (sets.index == 0) return;
    if (!deck_is_list(sets))
        deck_error(sets, "sets is a list of {name: ..., box: [[x, y, z], [x, y, z]]}");
    for (int i = 0; i < deck_count(sets); i++)
        add_deck_set(specimen, sites, deck_item(sets, i), out);
}
