#include "box.h"

#include <math.h>

/* Position of a site along the axes, sites. */
static void find_position(const struct body *body, int64_t site, double at[3])
{
    const struct lattice *lattice = body->lattice;
    int place[3];
    grid_position(&body->grid, site, place);
    for (int b = 0; b < 3; b++) {
        at[b] = place[b];
        if (!lattice_is_row(lattice)) continue;
        const double width = lattice->periodic[b] ? lattice->period[b] / lattice_places(lattice, b)
                                                  : lattice->spacing;
        at[b] = (lattice->point[b][place[0]] - lattice->origin[b]) / width;
        if (!lattice->hexahedron) at[b] = floor(at[b] + 0.5);
    }
}

enum { ANY_HELD = 12, ENDS };

/* least[b], least[3 + b]: lowest position and highest, negative, of all nodes; behind them those of
 * the free ones; and 0 where one is held. */
static void find_ends(const struct unknowns *unknowns, int a, double least[ENDS])
{
    const struct strips *owned = &unknowns->body->owned;
    const uint8_t *free_nodes = unknowns->free + a * unknowns->n_nodes;
    int64_t node = 0;
    for (int k = 0; k < ENDS; k++) least[k] = INFINITY;
    for (int64_t s = 0; s < owned->count; s++)
        for (int i = 0; i < owned->items[s].count; i++, node++) {
            double at[3];
            find_position(unknowns->body, owned->items[s].site + i, at);
            least[ANY_HELD] = fmin(least[ANY_HELD], free_nodes[node]);
            for (int b = 0; b < 3; b++)
                for (int only_free = 0; only_free <= (free_nodes[node] > 0); only_free++) {
                    double *ends = least + (only_free ? 6 : 0);
                    ends[b] = fmin(ends[b], at[b]);
                    ends[3 + b] = fmin(ends[3 + b], -at[b]);
                }
        }
    ranks_minimum(least, ENDS);
}

/* Free nodes between places count for those on either side, but for what lies where the body is
 * held. */
struct box box_new(const struct unknowns *unknowns, int a)
{
    static const double slack = 1e-6; /* spacings, of places of a mesh */
    const struct lattice *lattice = unknowns->body->lattice;
    struct box box = {.count = 1};
    double least[ENDS];
    find_ends(unknowns, a, least);
    for (int b = 0; b < 3; b++) {
        const double low = least[6 + b], high = -least[9 + b];
        if (low <= high) {
            box.held[b][0] = least[b] < low - slack;
            box.held[b][1] = -least[3 + b] > high + slack;
            box.low[b] = (int)(box.held[b][0] ? ceil(low - slack) : floor(low + slack));
            const int last = (int)(box.held[b][1] ? floor(high + slack) : ceil(high - slack));
            box.size[b] = last >= box.low[b] ? last - box.low[b] + 1 : 0;
        }
        box.periodic[b] = lattice->periodic[b];
        if (lattice->periodic[b]) {
            box.low[b] = 0;
            box.size[b] = lattice_places(lattice, b);
        }
        box.count *= box.size[b];
    }
    box.floats = least[ANY_HELD] > 0;
    return box;
}

int box_places(const struct box *box, const struct body *body, int64_t site,
               int places[BOX_PLACES][3], float shares[BOX_PLACES])
{
    double at[3];
    int count = 0;
    find_position(body, site, at);
    for (int k = 0; k < (body->lattice->hexahedron ? BOX_PLACES : 1); k++) {
        double share = 1;
        bool within = true;
        for (int b = 0; b < 3; b++) {
            const double below = floor(at[b]), beyond = at[b] - below;
            places[count][b] = (int)below + (k >> b & 1) - box->low[b];
            if (box->periodic[b]) places[count][b] %= box->size[b];
            within &= places[count][b] >= 0 && places[count][b] < box->size[b];
            if (body->lattice->hexahedron) share *= k >> b & 1 ? beyond : 1 - beyond;
        }
        shares[count] = (float)share;
        count += within;
    }
    return count;
}
