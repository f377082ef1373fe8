#include "selection.h"

#include "memory.h"
#include "nearest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct key keys[SELECTORS] = {SELECTION_KEYS(0)};
static const char *const axes[] = {"x", "y", "z"};

/* Of lengths in a deck: no specimen is larger [m]. */
#define FARTHEST 1e6
/* What counts as the same place, in spacings. */
static const double slack = 1e-6;

static void check_box(struct deck_node box)
{
    bool good = deck_is_list(box) && deck_count(box) == 2;
    for (int end = 0; good && end < 2; end++) {
        struct deck_node corner = deck_item(box, end);
        good = deck_is_list(corner) && (deck_count(corner) == 2 || deck_count(corner) == 3) &&
               deck_count(corner) == deck_count(deck_item(box, 0));
    }
    if (!good)
        deck_error(box, "a box is two corners: [[x, y, z], [x, y, z]], or of [x, y] for any z");
}

struct selection selection_read(struct deck_node map, const struct deck_node selector[SELECTORS])
{
    struct selection selection = {0};
    int found = 0;
    for (int k = 0; k < SELECTORS; k++) {
        if (selector[k].index == 0) continue;
        if (found++ > 0)
            deck_error(selector[k],
                       "'%s' beside '%s', expected exactly one of: set, block, box, where",
                       keys[k].name, keys[selection.kind].name);
        selection.kind = (enum selection_kind)k;
        selection.where = selector[k];
    }
    if (!found) deck_error(map, "which nodes? Expected exactly one of: set, block, box, where");
    if (selection.kind == SELECT_BOX)
        check_box(selection.where);
    else if (selection.kind == SELECT_WHERE)
        selection.expression = expression_new(selection.where, axes, 3);
    else
        deck_string(selection.where);
    return selection;
}

void selection_free(struct selection *selection)
{
    expression_free(selection->expression);
    *selection = (struct selection){0};
}

char *selection_name(const struct selection *selection)
{
    if (selection->kind == SELECT_BOX) return memory_text("box");
    return memory_print("%s %s", keys[selection->kind].name, deck_string(selection->where));
}

/* "x = -0.1 to 0.1 m, y = ..." of the nodes. */
static char *extent(const struct domain *domain)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    struct domain_nodes nodes = {0};
    while (domain_next(domain, &nodes))
        for (int a = 0; a < 3; a++) {
            low[a] = fmin(low[a], domain_smallest(nodes.x[a], nodes.count));
            high[a] = fmax(high[a], domain_largest(nodes.x[a], nodes.count));
        }
    return memory_print("x = %g to %g m, y = %g to %g m, z = %g to %g m", low[0], high[0], low[1],
                        high[1], low[2], high[2]);
}

static const struct node_set *find_set(const struct selection *selection,
                                       const struct domain *domain)
{
    const char *name = deck_string(selection->where);
    const struct node_set *set = domain_set(domain, name);
    if (!set) {
        const char **names = memory_new((size_t)domain->n_sets, sizeof *names);
        for (int i = 0; i < domain->n_sets; i++) names[i] = domain->sets[i].name;
        deck_error(selection->where, "no node set '%s' in the domain, which has: %s", name,
                   domain->n_sets ? nearest_list(names, domain->n_sets) : "none");
    }
    if (set->count == 0) deck_error(selection->where, "node set '%s' is empty", name);
    return set;
}

static int find_phase(const struct selection *selection, const struct domain *domain)
{
    const char *name = deck_string(selection->where);
    int phase = 0;
    while (phase < domain->n_phases && strcmp(domain->phase_names[phase], name) != 0) phase++;
    if (phase == domain->n_phases)
        deck_error(selection->where, "no block '%s' in the domain, which has: %s", name,
                   nearest_list((const char *const *)domain->phase_names, domain->n_phases));
    return phase;
}

/* Of a box, slack included; without a z of its own it has any. */
static void find_corners(struct deck_node box, double spacing, double corner[2][3])
{
    const struct key row = {"box", KEY_LENGTH, .low = -FARTHEST, .high = FARTHEST,
                            .size = deck_count(deck_item(box, 0))};
    corner[0][2] = -INFINITY;
    corner[1][2] = INFINITY;
    for (int end = 0; end < 2; end++) keys_list(&row, deck_item(box, end), spacing, corner[end]);
    for (int a = 0; a < row.size; a++) {
        if (corner[0][a] > corner[1][a])
            deck_error(deck_item(deck_item(box, 1), a),
                       "the second corner's %s, %g m, is below the first one's, %g m", axes[a],
                       corner[1][a], corner[0][a]);
        corner[0][a] -= slack * spacing;
        corner[1][a] += slack * spacing;
    }
}

static bool lies_between(double corner[2][3], const double x[3])
{
    bool inside = true;
    for (int a = 0; a < 3; a++) inside = inside && x[a] >= corner[0][a] && x[a] <= corner[1][a];
    return inside;
}

static _Noreturn void refuse_empty(const struct selection *selection, const struct domain *domain)
{
    if (selection->kind == SELECT_BLOCK)
        deck_error(selection->where, "no node is in block '%s'", deck_string(selection->where));
    if (selection->kind == SELECT_BOX)
        deck_error(selection->where, "no node lies in this box; the nodes are at %s",
                   extent(domain));
    deck_error(selection->where, "expression '%.200s' holds at no node; the nodes are at %s",
               deck_string(selection->where), extent(domain));
}

/* Whether a box or an expression holds at a place. */
static bool holds_at(const struct selection *selection, double corner[2][3], const double x[3])
{
    if (selection->kind == SELECT_BOX) return lies_between(corner, x);
    return expression_try(selection->expression, x, "1", -INFINITY, INFINITY) != 0;
}

/* Whether a node that no set lists is meant. */
static bool is_meant(const struct selection *selection, int phase, double corner[2][3],
                     const struct domain_nodes *nodes, int64_t i)
{
    const double x[] = {nodes->x[0][i], nodes->x[1][i], nodes->x[2][i]};
    if (selection->kind == SELECT_BLOCK) return nodes->phase[i] == phase;
    return holds_at(selection, corner, x);
}

int64_t *selection_nodes(const struct selection *selection, const struct domain *domain,
                         double spacing, int64_t *count)
{
    const enum selection_kind kind = selection->kind;
    const struct node_set *set = kind == SELECT_SET ? find_set(selection, domain) : NULL;
    const int phase = kind == SELECT_BLOCK ? find_phase(selection, domain) : 0;
    int64_t *all = NULL;
    double corner[2][3];
    struct domain_nodes nodes = {0};
    if (kind == SELECT_BOX) find_corners(selection->where, spacing, corner);
    *count = 0;
    while (!set && domain_next(domain, &nodes))
        for (int64_t i = 0; i < nodes.count; i++) {
            if (!is_meant(selection, phase, corner, &nodes, i)) continue;
            all = memory_grow(all, *count, sizeof *all);
            all[(*count)++] = nodes.first + i;
        }
    if (!set && *count == 0) refuse_empty(selection, domain);
    if (!set) return all;
    *count = set->count;
    all = memory_new((size_t)set->count, sizeof *all);
    return memcpy(all, set->nodes, (size_t)set->count * sizeof *all);
}

bool selection_is_beyond(const struct selection *selection, const struct domain *domain,
                         double spacing, int axis, double plane)
{
    const enum selection_kind kind = selection->kind;
    bool beyond = false;
    double corner[2][3];
    struct domain_nodes nodes = {0};
    if (kind == SELECT_BOX) find_corners(selection->where, spacing, corner);
    while ((kind == SELECT_BOX || kind == SELECT_WHERE) && domain_next(domain, &nodes))
        for (int64_t i = 0; i < nodes.count; i++) {
            double x[] = {nodes.x[0][i], nodes.x[1][i], nodes.x[2][i]};
            if (fabs(x[axis] - plane) <= slack * spacing || holds_at(selection, corner, x))
                continue;
            x[axis] = 2 * plane - x[axis];
            beyond = beyond || holds_at(selection, corner, x);
        }
    return beyond;
}

bool selection_holds(const struct selection *selection, double spacing, const double x[3])
{
    double corner[2][3];
    if (selection->kind == SELECT_BOX) find_corners(selection->where, spacing, corner);
    return (selection->kind == SELECT_BOX || selection->kind == SELECT_WHERE) &&
           holds_at(selection, corner, x);
}

int64_t selection_nearest(struct deck_node place, const struct domain *domain, double spacing)
{
    static const struct key row = {"nearest", KEY_LENGTH, .low = -FARTHEST, .high = FARTHEST,
                                   .size = 3};
    double x[3], best = INFINITY;
    int64_t node = 0;
    keys_list(&row, place, spacing, x);
    struct domain_nodes nodes = {0};
    while (domain_next(domain, &nodes))
        for (int64_t i = 0; i < nodes.count; i++) {
            const double away =
                hypot(hypot(nodes.x[0][i] - x[0], nodes.x[1][i] - x[1]), nodes.x[2][i] - x[2]);
            if (away >= best - slack * spacing) continue;
            best = away;
            node = nodes.first + i;
        }
    if (best > 2 * spacing)
        deck_error(place, "the nearest node is %g m away, over 2 spacings; the nodes are at %s",
                   best, extent(domain));
    return node;
}
