/* damage.c - finds what has to break, and breaks it (damage.h).
 *
 * Testing every bond at every step would cost as much as a force.  But a bond's margin shrinks at
 * most by the ways of its two ends: each strip notes how far nodes may move until its closest bond
 * could be due, and is passed over until they have. How far they have moved is bounded from above
 * twice, by the distance since the last test and by the steps' own ways, with factors that outweigh
 * the rounding: a strip is passed over only where no bond of it can break, so the bits are those of
 * testing all.  What is found and what breaks are two calls: an equilibrium breaks the worst alone,
 * and then looks again. */
#include "damage.h"

#include "broken.h"
#include "checkpoint.h"
#include "interface.h"
#include "memory.h"
#include "profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct damage {
    struct damage_view see;
    struct body *body;
    struct bonds *bonds;
    struct damage_rules rules;
    double broken, removed; /* bonds and nodes of the whole body */
    double *spent;          /* box field: 1 where all bonds of a node are to break */
    bool test_all;
    /* A strip is tested again only when its ends may have closed the margin of its closest bond:
     * due is what the way of its ends must be beyond, soonest the least of all.  No node is farther
     * from where it was at any test than the way has grown since: by the largest distance from one
     * test to the next. */
    double travelled, *due, soonest; /* travelled: the way at the last test */
    double *last[3];                 /* box fields: u at the last test */
    double last_mean[9];
    double reach; /* bound on the distance of any node from last, m */
    double moved; /* bound on the motion of any node since damage_find, m; below 0: unknown */
    /* What damage_find has found: bond number place of a strip, or, strip being -1, the node at
     * that site; how far it is beyond its limit, as a stretch or a share of it; 1 where this rank
     * counts it. */
    struct found {
        int64_t strip, place;
        double excess, count;
    } * found;
    int64_t n_found;
};

/* The volume of its family that each node is bonded to, now or without what has been cut and
 * broken: adds that of the other end to both, for bonds of weight over 0. */
static double *family_volumes(const struct damage *damage, bool whole)
{
    const struct bonds *bonds = damage->bonds;
    double *volumes = memory_new((size_t)damage->body->grid.n_sites, sizeof *volumes);
    for (int64_t s = 0; s < bonds->count; s++) {
        const struct bond_view view = bonds_view(bonds, &bonds->strips[s]);
        const int g = view.geometry_step;
        for (int k = 0; k < view.count; k++) {
            const double weight = whole ? bonds_first_weight(bonds, &bonds->strips[s], k)
                                        : view.weight[k * view.weight_step];
            if (!(weight > 0)) continue;
            volumes[bond_lower(&view, k)] += view.volume_j[k * g];
            volumes[bond_upper(&view, k)] += view.volume_i[k * g];
        }
    }
    return volumes;
}

struct damage *damage_new(struct deck_node root, const struct model *model,
                          const struct materials *materials, struct body *body, struct bonds *bonds)
{
    struct damage *damage = memory_new(1, sizeof *damage);
    const size_t sites = (size_t)body->grid.n_sites;
    const struct deck_node solver = deck_find(root, "solver");
    damage->see = (struct damage_view){model, materials, body, bonds,
                                       solver.index ? interface_read(solver) : true};
    damage->body = body;
    damage->bonds = bonds;
    damage->rules = damage_rules_read(deck_find(root, "damage"), &damage->see);
    const bool nodes = damage->rules.n_node_laws > 0;
    const bool corners = materials->formulation->corners;
    if ((damage->rules.bonds || nodes) && !corners) body_need_gradient(body);
    if (damage->rules.degrading || (nodes && corners))
        body->integrity = integrity_new(body, materials->count, damage->rules.integrity);
    if (nodes) damage->spent = memory_new(sites, sizeof(double));
    if (!damage->rules.bonds) return damage;
    damage->due = memory_new((size_t)bonds->count, sizeof(double));
    damage->soonest = damage->moved = -1;
    for (int64_t s = 0; s < bonds->count; s++) damage->due[s] = -1;
    for (int a = 0; a < 3; a++) damage->last[a] = memory_new(sites, sizeof(double));
    return damage;
}

void damage_free(struct damage *damage)
{
    if (!damage) return;
    broken_free(damage->body->broken);
    integrity_free(damage->body->integrity);
    damage_rules_free(&damage->rules);
    free(damage->spent);
    free(damage->due);
    free(damage->found);
    for (int a = 0; a < 3; a++) free(damage->last[a]);
    free(damage);
}

void damage_test_all(struct damage *damage)
{
    damage->test_all = true;
}

double damage_broken_bonds(const struct damage *damage)
{
    return damage->broken;
}

double damage_removed_nodes(const struct damage *damage)
{
    return damage->removed;
}

void damage_index(const struct damage *damage, double *index)
{
    double *whole = family_volumes(damage, true), *now = family_volumes(damage, false);
    const struct integrity *integrity = damage->body->integrity;
    for (int64_t i = 0; i < damage->body->grid.n_sites; i++) {
        index[i] = whole[i] > 0 ? 1 - now[i] / whole[i] : 0;
        if (integrity) index[i] = fmax(index[i], 1 - integrity->node[i]);
    }
    free(whole);
    free(now);
}

/* most[i] = the larger of itself and the square of the distance of node i from where it was. */
HS_SIMD static void longer_ways(int count, const double *restrict x, const double *restrict y,
                                const double *restrict z, const double *restrict px,
                                const double *restrict py, const double *restrict pz,
                                double *restrict most)
{
    for (int i = 0; i < count; i++) {
        double a = x[i] - px[i], b = y[i] - py[i], d = z[i] - pz[i];
        double square = a * a + b * b + d * d;
        most[i] = square > most[i] ? square : most[i];
    }
}

/* Half of what the mean gradient may have moved the ends of a bond apart since then. */
static double mean_distance(const struct damage *damage)
{
    const struct body *body = damage->body;
    double square = 0;
    for (int k = 0; k < 9; k++) {
        const double change = body->mean_gradient[k] - damage->last_mean[k];
        square += change * change;
    }
    return 0.5 * sqrt(square) * body->family->horizon * body->lattice->spacing;
}

/* How far any node that this rank knows is from where it was at the last test. */
static double distance(const struct damage *damage)
{
    double *const *u = damage->body->u, *const *last = damage->last;
    const int64_t sites = damage->body->grid.n_sites;
    double most[LANES] = {0}, square = 0;
    for (int64_t i = 0; i < sites; i += LANES)
        longer_ways((int)(sites - i < LANES ? sites - i : LANES), u[0] + i, u[1] + i, u[2] + i,
                    last[0] + i, last[1] + i, last[2] + i, most);
    for (int k = 0; k < LANES; k++) square = fmax(square, most[k]);
    return (sqrt(square) + mean_distance(damage)) * (1 + 0x1p-48);
}

/* The way at a distance far from the last test.  The factors outweigh the rounding: it never grows
 * by less than a node has moved. */
static double way(const struct damage *damage, double far)
{
    return (damage->travelled + far) * (1 + 0x1p-51);
}

void damage_moved(struct damage *damage, double most)
{
    damage->moved = fmax(damage->moved, 0) + most;
}

/* Whether a rank has to look where its nodes are: one message, of how far nodes have moved and of
 * how far they may go. Collective. */
static bool may_be_due(struct damage *damage)
{
    const double moved = damage->moved < 0 || damage->test_all ? INFINITY : damage->moved;
    double least[] = {-moved, INFINITY};
    if (damage->soonest < INFINITY)
        least[1] = damage->soonest * (1 - 0x1p-48) - way(damage, damage->reach);
    damage->moved = -1;
    ranks_minimum(least, 2);
    damage->reach = (damage->reach - least[0]) * (1 + 0x1p-48);
    return !(-least[0] * (1 + 0x1p-48) < least[1]);
}

/* Margin of each bond of a strip; INFINITY where it is broken or never breaks. */
static void find_margins(const struct damage *damage, const struct bond_strip *strip,
                         const struct bond_view *view, double *margins)
{
    const struct damage_rules *rules = &damage->rules;
    const uint8_t *phase = damage->body->grid.phase;
    const struct damage_law *law[BOND_LANES];
    double value[BOND_LANES], some[BOND_LANES];
    for (int k = 0; k < view->count; k++) {
        const int pair = phase[bond_lower(view, k)] * rules->n_phases + phase[bond_upper(view, k)];
        law[k] = view->weight[k * view->weight_step] > 0 ? rules->law[pair] : NULL;
        value[k] = rules->value[pair];
        margins[k] = INFINITY;
    }
    for (int first = 0; first < view->count; first++) {
        const struct damage_law *one = law[first];
        if (!one) continue;
        one->margin(&damage->see, strip, value, some);
        for (int k = first; k < view->count; k++) {
            if (law[k] != one) continue;
            margins[k] = some[k];
            law[k] = NULL;
        }
    }
}

/* 1 where this rank counts the bond. */
static double count_bond(const struct damage *damage, const struct bond_view *view, int k)
{
    return damage->body->grid.flags[bond_lower(view, k)] & SITE_OWNED ? 1 : 0;
}

static void add_found(struct damage *damage, struct found found)
{
    damage->found = memory_grow(damage->found, damage->n_found, sizeof found);
    damage->found[damage->n_found++] = found;
}

/* Half of the closest bond's margin, less what rounding may hide, is how far a node may go until
 * the next test. */
static void test_strip(struct damage *damage, int64_t s)
{
    const struct bond_strip *strip = &damage->bonds->strips[s];
    const struct bond_view view = bonds_view(damage->bonds, strip);
    double margins[BOND_LANES], least = INFINITY;
    find_margins(damage, strip, &view, margins);
    for (int k = 0; k < view.count; k++) {
        const double length = view.length[k * view.geometry_step];
        if (margins[k] < 0)
            add_found(damage,
                      (struct found){s, k, -margins[k] / length, count_bond(damage, &view, k)});
        least = fmin(least, margins[k] - 1e-13 * length);
    }
    damage->due[s] = damage->travelled + 0.5 * least * (1 - 0x1p-48);
}

/* Returns how many strips have been tested. */
static int64_t test_bonds(struct damage *damage)
{
    const struct body *body = damage->body;
    damage->reach = distance(damage);
    const double travelled = way(damage, damage->reach);
    int64_t tested = 0;
    if (!(travelled > damage->soonest || damage->test_all)) return 0;
    damage->travelled = travelled;
    damage->reach = 0;
    damage->soonest = INFINITY;
    for (int a = 0; a < 3; a++)
        memcpy(damage->last[a], body->u[a], (size_t)body->grid.n_sites * sizeof(double));
    memcpy(damage->last_mean, body->mean_gradient, sizeof damage->last_mean);
    for (int64_t s = 0; s < damage->bonds->count; s++) {
        if (travelled > damage->due[s] || damage->test_all) {
            test_strip(damage, s);
            tested++;
        }
        damage->soonest = fmin(damage->soonest, damage->due[s]);
    }
    return tested;
}

HS_SIMD static int64_t any_beyond(int count, const double *restrict p, double limit)
{
    int64_t any = 0;
    for (int i = 0; i < count; i++) any |= p[i] > limit;
    return any;
}

/* What is done to an owned node beyond the least of its rule, whose law gets these states; a change
 * is summed up as the least of all. */
typedef double node_action(struct damage *damage, int64_t site, const struct node_rule *rule,
                           const double state[]);

static double act_on_strip(struct damage *damage, const struct node_law *used,
                           const struct strip *strip, const double *const state[], node_action *act)
{
    const struct grid *grid = &damage->body->grid;
    double change = 0, at[DAMAGE_STATES];
    for (int i = 0; i < strip->count; i++) {
        const int64_t site = strip->site + i;
        const struct node_rule *rule = &damage->rules.node[grid->phase[site]];
        if (rule->law != used->law || !(state[0][i] > rule->least) ||
            !(grid->flags[site] & SITE_OWNED))
            continue;
        for (int k = 0; k < used->count; k++) at[k] = state[k][i];
        change = fmin(change, act(damage, site, rule, at));
    }
    return change;
}

/* Returns how many strips had to be looked at. */
static int64_t act_on_nodes(struct damage *damage, const struct node_law *used, node_action *act,
                            double *change)
{
    const struct model *model = damage->see.model;
    const struct strips *strips = model_strips(model, damage->body);
    int64_t seen = 0;
    for (int64_t s = 0; s < strips->count; s++) {
        const struct strip *strip = &strips->items[s];
        double buffer[DAMAGE_STATES][LANES];
        const double *state[DAMAGE_STATES] = {
            model_state(model, strip, used->state[0], 0, buffer[0])};
        if (!any_beyond(strip->count, state[0], used->least)) continue;
        for (int k = 1; k < used->count; k++)
            state[k] = model_state(model, strip, used->state[k], 0, buffer[k]);
        *change = fmin(*change, act_on_strip(damage, used, strip, state, act));
        seen++;
    }
    return seen;
}

static double degrade(struct damage *damage, int64_t site, const struct node_rule *rule,
                      const double state[])
{
    double *integrity = &damage->body->integrity->node[site];
    const double now = fmax(1 - rule->law->degradation(rule->own, state), 0),
                 change = now - *integrity;
    *integrity = now;
    return -fabs(change);
}

double damage_grow(struct damage *damage)
{
    struct body *body = damage->body;
    double change = 0;
    if (!body->integrity) return 0;
    for (int k = 0; k < damage->rules.n_node_laws; k++) {
        const struct node_law *used = &damage->rules.node_laws[k];
        if (used->law->degradation) act_on_nodes(damage, used, degrade, &change);
    }
    ranks_minimum(&change, 1);
    if (!(change < 0)) return 0;
    body->integrity->whole = false;
    halo_exchange(body->displacement_halo, &body->integrity->node, 1);
    return -change;
}

static double find_spent(struct damage *damage, int64_t site, const struct node_rule *rule,
                         const double state[])
{
    const double limit = rule->law->limit(rule->own, state);
    if (state[0] > limit && !(damage->spent[site] > 0))
        add_found(damage, (struct found){-1, site, state[0] / limit - 1, 1});
    return 0;
}

static void test_nodes(struct damage *damage)
{
    const double strips = (double)model_strips(damage->see.model, damage->body)->count;
    for (int k = 0; k < damage->rules.n_node_laws; k++) {
        double change = 0;
        const int64_t seen = act_on_nodes(damage, &damage->rules.node_laws[k], find_spent, &change);
        profile_count(damage->body->profile, WORK_NODE_TESTS, (double)seen, strips);
    }
}

/* Particles between corners have no bonds to lose: their stress goes. */
static void remove_spent(struct body *body, const double *spent)
{
    struct integrity *integrity = body->integrity;
    for (int64_t i = 0; i < body->grid.n_sites; i++)
        if (spent[i] > 0) integrity->node[i] = 0;
    integrity->whole = false;
    halo_exchange(body->displacement_halo, &integrity->node, 1);
}

static double break_spent(struct damage *damage)
{
    double broken = 0;
    halo_exchange(damage->body->displacement_halo, &damage->spent, 1);
    for (int64_t s = 0; s < damage->bonds->count; s++) {
        struct bond_strip *strip = &damage->bonds->strips[s];
        const struct bond_view view = bonds_view(damage->bonds, strip);
        for (int k = 0; k < strip->count; k++) {
            if (!(damage->spent[bond_lower(&view, k)] + damage->spent[bond_upper(&view, k)] > 0) ||
                !(view.weight[k * view.weight_step] > 0))
                continue;
            broken += count_bond(damage, &view, k);
            broken_add(damage->body, damage->bonds, strip, k);
        }
    }
    return broken;
}

/* How many are at least so far beyond their limits. */
static double count_beyond(const struct damage *damage, double excess)
{
    double count = 0;
    for (int64_t n = 0; n < damage->n_found; n++)
        count += damage->found[n].excess >= excess ? damage->found[n].count : 0;
    ranks_sum(&count, 1);
    return count;
}

bool damage_find(struct damage *damage)
{
    const struct damage_rules *rules = &damage->rules;
    const bool nodes = rules->n_node_laws > 0;
    damage->n_found = 0;
    if (!rules->bonds && !nodes) return false;
    const enum profile_part before = profile_enter(damage->body->profile, PART_DAMAGE);
    const bool due = rules->bonds && may_be_due(damage);
    const int64_t tested = due ? test_bonds(damage) : 0;
    if (rules->bonds)
        profile_count(damage->body->profile, WORK_BOND_TESTS, (double)tested,
                      (double)damage->bonds->count);
    if (nodes) test_nodes(damage);
    const bool found = (due || nodes) && count_beyond(damage, -1) > 0;
    profile_enter(damage->body->profile, before);
    return found;
}

void damage_choose(struct damage *damage, double most)
{
    double low = INFINITY, high = 0;
    if (count_beyond(damage, -1) <= most) return;
    for (int64_t n = 0; n < damage->n_found; n++) {
        low = fmin(low, damage->found[n].excess);
        high = fmin(high, -damage->found[n].excess);
    }
    ranks_minimum(&low, 1);
    ranks_minimum(&high, 1);
    high = -high;
    /* An excess of low or more have enough, of high or more too few, or all have one value. */
    for (int halving = 0; halving < 60 && low < high; halving++) {
        const double middle = 0.5 * (low + high);
        *(count_beyond(damage, middle) >= most ? &low : &high) = middle;
    }
    int64_t kept = 0;
    for (int64_t n = 0; n < damage->n_found; n++)
        if (damage->found[n].excess >= low) damage->found[kept++] = damage->found[n];
    damage->n_found = kept;
}

void damage_break(struct damage *damage)
{
    double counts[2] = {0, 0}; /* bonds, nodes */
    for (int64_t n = 0; n < damage->n_found; n++) {
        const struct found *found = &damage->found[n];
        counts[found->strip < 0] += found->count;
        if (found->strip < 0)
            damage->spent[found->place] = 1;
        else
            broken_add(damage->body, damage->bonds, &damage->bonds->strips[found->strip],
                       (int)found->place);
    }
    damage->n_found = 0;
    ranks_sum(counts, 2);
    if (counts[1] > 0) {
        if (damage->body->lattice->corner) remove_spent(damage->body, damage->spent);
        double broken = break_spent(damage);
        ranks_sum(&broken, 1);
        counts[0] += broken;
    }
    damage->broken += counts[0];
    damage->removed += counts[1];
    broken_shapes(damage->body, damage->see.materials->formulation->stress_of == STRESS_OF_NODES);
}

/* Which strips are due is not kept: all are tested after a restart, which finds the same. */
void damage_visit(struct damage *damage, struct checkpoint *checkpoint)
{
    struct integrity *integrity = damage->body->integrity;
    broken_visit(damage->body, damage->bonds, checkpoint);
    checkpoint_numbers(checkpoint, "damage: bonds", &damage->broken, 1);
    checkpoint_numbers(checkpoint, "damage: nodes", &damage->removed, 1);
    if (damage->spent) checkpoint_fields(checkpoint, "damage: spent nodes", &damage->spent, 1);
    if (!integrity) return;
    checkpoint_flag(checkpoint, "integrity: all are sound", &integrity->whole);
    checkpoint_fields(checkpoint, "integrity", &integrity->node, 1);
}
