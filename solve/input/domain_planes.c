/* Grips and gauge planes of a body that brings none. */
#include "domain_facts.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A section that is said and that of the body may be apart by this factor: a notch between the
 * gauge planes has less. */
static const double MOST_SECTION = 1.5;
/* Of a length, in shares of it. */
static const double SLACK = 1e-6;

struct layer {
    const char *name;
    double from, to;   /* m along the axis */
    double node_slack; /* m by which nodes of a mesh, half an element beside particles, may lie
                          outside */
};

/* Body along the axis of the test, from the faces of its outermost nodes; mirrored: with its image
 * below the plane of symmetry, which is the middle then. */
struct extent {
    int axis;
    double low, high, middle, spacing; /* m */
    bool mirrored;
};

static const double *along(const struct domain *domain, int axis)
{
    return axis == 0 ? domain->x : axis == 1 ? domain->y : domain->z;
}

/* What else may be wrong with lengths that do not fit: the caller frees it. */
static char *other_axis(const struct domain *domain, int axis)
{
    int longest = axis;
    double length[3];
    for (int a = 0; a < 3; a++) {
        const double *x = along(domain, a);
        length[a] = domain_largest(x, domain->n_nodes) - domain_smallest(x, domain->n_nodes);
        if (length[a] > length[longest]) longest = a;
    }
    if (longest == axis) return memory_text("");
    return memory_print("; it is longest along %c: 'axis: %c' of domain tests it along that",
                        'x' + longest, 'x' + longest);
}

/* Of the particles and of a mesh's nodes; a set that the file has stands.  where: of the deck. */
static void add_layer(struct domain *domain, struct deck_node where, int axis, struct layer layer)
{
    struct domain *const both[2] = {domain, domain->corners};
    for (int k = 0; k < 2 && both[k]; k++) {
        const double *x = along(both[k], axis);
        int64_t *nodes = memory_new((size_t)both[k]->n_nodes, sizeof *nodes), count = 0;
        for (int64_t i = 0; i < both[k]->n_nodes; i++)
            if (x[i] >= layer.from - k * layer.node_slack &&
                x[i] <= layer.to + k * layer.node_slack)
                nodes[count++] = i;
        if (count == 0)
            deck_error(where, "no particle lies in %s, %c = %g to %g m", layer.name, 'x' + axis,
                       layer.from, layer.to);
        domain_add_set(both[k], layer.name, count, nodes);
        free(nodes);
    }
}

/* The layer of nodes next to a position; of two equally near the one farther from the middle, as
 * hsgen has it. */
static double nearest_layer(const struct domain *domain, const struct extent *e, double position,
                            double slack)
{
    const double *all = along(domain, e->axis);
    double best = INFINITY;
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        double x = all[i], gain = fabs(best - position) - fabs(x - position);
        bool outer = fabs(x - e->middle) > fabs(best - e->middle) + slack;
        if (gain > slack || (gain > -slack && outer)) best = x;
    }
    return best;
}

static struct extent extent_of(const struct domain *domain, int axis)
{
    static const char *const edges[] = {"spacing_m", "spacing_y_m", "spacing_z_m"};
    const double *x = along(domain, axis);
    struct extent e = {
        .axis = axis,
        .low = domain_smallest(x, domain->n_nodes),
        .high = domain_largest(x, domain->n_nodes),
        .spacing = attributes_number(&domain->attributes, edges[axis], domain_spacing(domain))};
    e.middle = 0.5 * (e.low + e.high);
    e.low -= 0.5 * e.spacing;
    e.high += 0.5 * e.spacing;
    const char *planes = attributes_text(&domain->attributes, "symmetry");
    e.mirrored = planes && strchr(planes, 'x' + axis);
    if (!e.mirrored) return e;
    e.middle = e.low;
    e.low = e.middle - (e.high - e.middle);
    return e;
}

/* By place, of one place by volume, so that the order of the file does not matter. */
static int by_place(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return p[0] != q[0] ? (p[0] > q[0]) - (p[0] < q[0]) : (p[1] > q[1]) - (p[1] < q[1]);
}

/* Section of scattered particles between two places: the slope of their summed volume along the
 * axis, each counted to its middle, by least squares.  It does not depend on how many layers happen
 * to lie between, as the quotient of volume and length does. */
static double slope_of_volume(const struct domain *domain, int axis, double left, double right)
{
    double(*all)[2] = memory_new((size_t)domain->n_nodes, sizeof *all), sum = 0;
    double n = 0, x = 0, v = 0, xx = 0, xv = 0;
    int64_t count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        const double at = along(domain, axis)[i];
        if (at < left || at > right) continue;
        all[count][0] = at - left;
        all[count++][1] = domain->volume[i];
    }
    qsort(all, (size_t)count, sizeof *all, by_place);
    for (int64_t i = 0; i < count; i++) {
        const double at = all[i][0], volume = sum + 0.5 * all[i][1];
        sum += all[i][1];
        n++;
        x += at;
        v += volume;
        xx += at * at;
        xv += at * volume;
    }
    free(all);
    const double spread = n * xx - x * x;
    return spread > 0 ? (n * xv - x * v) / spread : 0;
}

/* Where a list of two lengths says, or, without one, a length from the middle. */
static bool two_planes(struct deck_node map, const struct extent *e, double planes[2])
{
    static const struct key row = {"planes",    KEY_LENGTH, .low = -1e6,
                                   .high = 1e6, .size = 2,  .rising = true};
    const struct deck_node given = deck_find(map, "planes"), length = deck_find(map, "length");
    if (given.index && length.index)
        deck_error(length, "'length' beside 'planes', expected one of them");
    if (!given.index) return false;
    keys_list(&row, given, e->spacing, planes);
    if (e->mirrored && fabs(planes[0] + planes[1] - 2 * e->middle) > SLACK * e->spacing)
        deck_error(given, "the two planes are not images of each other across the plane of "
                          "symmetry: say their 'length'");
    return true;
}

static double length_of(struct deck_node map, const struct extent *e)
{
    return deck_length(deck_get(map, "length"), e->spacing, 0, 1e6);
}

static void add_grips(struct domain *domain, struct deck_node grips, const struct extent *e)
{
    double planes[2];
    if (!two_planes(grips, e, planes)) {
        planes[0] = e->low + length_of(grips, e);
        planes[1] = e->high - length_of(grips, e);
    }
    if (planes[1] - planes[0] < (1 - SLACK) * e->spacing)
        deck_error(grips,
                   "the grips, to %g m and from %g m on, leave none of the body free, which is %g "
                   "m long along %c%s",
                   planes[0], planes[1], e->high - e->low, 'x' + e->axis,
                   other_axis(domain, e->axis));
    if (!e->mirrored)
        add_layer(domain, grips, e->axis, (struct layer){"grip_left", -INFINITY, planes[0], 0});
    add_layer(domain, grips, e->axis, (struct layer){"grip_right", planes[1], INFINITY, 0});
}

static void check_gauge(const struct domain *domain, struct deck_node gauge, const struct extent *e,
                        const double planes[2], double slack)
{
    if (planes[0] < e->low - slack || planes[1] > e->high + slack)
        deck_error(gauge,
                   "the gauge planes, %g and %g m, are not both in the body, which is from %g to "
                   "%g m along %c%s",
                   planes[0], planes[1], e->low, e->high, 'x' + e->axis,
                   other_axis(domain, e->axis));
    if (planes[1] - planes[0] < (1 - SLACK) * e->spacing)
        deck_error(gauge, "the gauge planes, %g m apart, are less than a spacing apart, %g m",
                   planes[1] - planes[0], e->spacing);
}

/* To the layer that is next to it, which is half a spacing away at most. */
static double snapped(const struct domain *domain, struct deck_node gauge, const struct extent *e,
                      double plane, double slack)
{
    const double layer = nearest_layer(domain, e, plane, slack);
    if (fabs(layer - plane) > 0.5 * e->spacing + slack)
        deck_error(gauge,
                   "no layer of particles is within half a spacing of the gauge plane at %g m; the "
                   "nearest is at %g m",
                   plane, layer);
    return layer;
}

/* The innermost place of a grip along the axis, minus infinity where there is none; sense: 1 of the
 * left one, -1 of the right one, mirrored. */
static double grip_end(const struct domain *domain, int axis, const char *name, double sense)
{
    const struct domain *const both[2] = {domain, domain->corners};
    double end = -INFINITY;
    for (int k = 0; k < 2 && both[k]; k++) {
        const struct node_set *set = domain_set(both[k], name);
        for (int64_t i = 0; set && i < set->count; i++)
            end = fmax(end, sense * along(both[k], axis)[set->nodes[i]]);
    }
    return end;
}

/* A plane in a grip moves with it: the strain would be that of less of the body. */
static void check_free(const struct domain *domain, struct deck_node gauge, const struct extent *e,
                       const double planes[2], double slack)
{
    const double left = grip_end(domain, e->axis, "grip_left", 1),
                 right = -grip_end(domain, e->axis, "grip_right", -1);
    if (planes[0] <= left + slack || planes[1] >= right - slack)
        deck_error(gauge,
                   "the gauge planes (%g m apart, at %g and %g m) lie in the grips (to %g m and "
                   "from %g m on): shorten the gauge or the grips",
                   planes[1] - planes[0], planes[0], planes[1], left, right);
}

/* The planes of a lattice are layers of nodes; of scattered ones a spacing's width of them. */
static void add_gauge(const struct domain_facts *facts, bool lattice, const struct extent *e,
                      struct domain *domain)
{
    const double slack = (lattice ? 1e-3 : 0.5) * e->spacing;
    const double *x = along(domain, e->axis);
    double planes[2], volume = 0;
    if (!two_planes(facts->gauge, e, planes)) {
        const double length = length_of(facts->gauge, e);
        planes[0] = e->middle - 0.5 * length;
        planes[1] = e->middle + 0.5 * length;
    }
    check_gauge(domain, facts->gauge, e, planes, slack);
    if (e->mirrored) planes[0] = e->middle;
    for (int k = e->mirrored; k < 2 && lattice; k++)
        planes[k] = snapped(domain, facts->gauge, e, planes[k], slack);
    check_free(domain, facts->gauge, e, planes, 1e-3 * e->spacing);
    const double more = (lattice ? 0.5 : 1e-3) * e->spacing;
    const struct layer left = {"gauge_left", planes[0] - slack, planes[0] + slack, more},
                       right = {"gauge_right", planes[1] - slack, planes[1] + slack, more};
    if (!e->mirrored) add_layer(domain, facts->gauge, e->axis, left);
    add_layer(domain, facts->gauge, e->axis, right);
    for (int64_t i = 0; lattice && i < domain->n_nodes; i++)
        if (x[i] >= planes[0] && x[i] < planes[1] - slack)
            volume += domain->volume[i];
        else if (e->mirrored && x[i] < planes[1] + slack) /* to the middle of the layer */
            volume += 0.5 * domain->volume[i];
    if (planes[1] > planes[0])
        attributes_set_number(&domain->attributes, "section_m2",
                              lattice ? volume / (planes[1] - planes[0])
                                      : slope_of_volume(domain, e->axis, planes[0], planes[1]));
}

static bool has(const struct domain *domain, const char *left, const char *right)
{
    return domain_set(domain, left) || domain_set(domain, right);
}

void domain_facts_planes(const struct domain_facts *facts, bool lattice, struct domain *domain)
{
    const bool grips = facts->grips.index && !has(domain, "grip_left", "grip_right"),
               gauge = facts->gauge.index && !has(domain, "gauge_left", "gauge_right");
    if (grips || gauge) {
        domain_hold(domain);
        const struct extent e = extent_of(domain, facts->axis);
        if (grips) add_grips(domain, facts->grips, &e);
        if (gauge) add_gauge(facts, lattice, &e, domain);
    }
    const double own = attributes_number(&domain->attributes, "section_m2", 0);
    if (!(facts->section > 0)) return;
    if (own > 0 && fmax(own / facts->section, facts->section / own) > MOST_SECTION)
        warn("domain.section is %.4g mm2, and the body has %.4g mm2 between the gauge planes: "
             "stress is the force over the first",
             1e6 * facts->section, 1e6 * own);
    attributes_set_number(&domain->attributes, "section_m2", facts->section);
}
