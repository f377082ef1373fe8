#include "gauge.h"

#include "die.h"
#include "members.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

struct gauge {
    int n_phases;
    struct members left, right; /* of a periodic body empty */
    double from, to;            /* of the planes along the axis of the test, m */
    double *fraction;           /* [n_phases] */
    double *volume;             /* [n_phases] of the nodes between the planes, in mean volumes */
    double *layer; /* [layers] volume of the particles of the body in each layer, in mean volumes */
};

const struct gauge_mean gauge_means[] = {
    {"stress", "Pa", offsetof(struct node_state, nominal), 1e13,
     "nominal axial stress (first Piola-Kirchhoff)"},
    {"true_stress", "Pa", offsetof(struct node_state, cauchy), 1e13, "axial Cauchy stress"},
    {"strain", "1", offsetof(struct node_state, H), 1e3, "axial nominal strain F - 1"},
    {"plastic_strain", "1", offsetof(struct node_state, plastic), 1e3, "equivalent plastic strain"},
};
enum { MEANS = sizeof gauge_means / sizeof *gauge_means };
const int gauge_mean_count = MEANS;

static bool between(const struct gauge *gauge, const struct lattice *lattice, double x)
{
    double slack = 1e-6 * lattice->spacing;
    return x >= gauge->from - slack && x <= gauge->to + slack;
}

static double thickness_of_layer(const struct lattice *lattice)
{
    return lattice_is_row(lattice) ? lattice->spacing : lattice->edge[lattice->axis];
}
/* Layers of nodes along the axis of the test: those of the lattice, or slices as thick. */
static int layers(const struct lattice *lattice)
{
    return (int)lround(lattice_extent(lattice, lattice->axis) / thickness_of_layer(lattice)) + 1;
}
/* x, at: of a particle and of its site. */
static int layer(const struct lattice *lattice, const double x[3], const int at[3])
{
    const int a = lattice->axis;
    return lattice_is_row(lattice) ? (int)lround((x[a] - lattice->origin[a]) / lattice->spacing)
                                   : at[a];
}

/* Volume of a node over the mean one. */
static double relative_volume(const struct lattice *lattice, int64_t site)
{
    return lattice->volume ? lattice->volume[site] / lattice->node_volume : 1;
}

static void count_phases(struct gauge *gauge, const struct body *body)
{
    const struct lattice *lattice = body->lattice;
    double all = 0;
    for (int64_t site = 0; site < lattice->n_sites; site++) {
        int at[3];
        double x[3];
        if (lattice->phase[site] == ABSENT) continue;
        lattice_position(lattice, site, at);
        lattice_particle(lattice, at, x);
        const double volume = relative_volume(lattice, site);
        gauge->layer[layer(lattice, x, at)] += volume;
        if (!between(gauge, lattice, x[lattice->axis])) continue;
        gauge->volume[lattice->phase[site]] += volume;
        all += volume;
    }
    for (int p = 0; p < gauge->n_phases; p++) gauge->fraction[p] = gauge->volume[p] / all;
}

/* A body that is periodic along x is a gauge as a whole; a plane of symmetry is the left one. */
static void find_planes(struct gauge *gauge, const struct body *body, const struct domain *domain)
{
    const struct lattice *lattice = body->lattice;
    const int axis = lattice->axis;
    if (lattice->periodic[axis]) {
        gauge->from = lattice->origin[axis];
        gauge->to = lattice->origin[axis] + lattice_period(lattice, axis);
        return;
    }
    gauge->right = members_new(body, domain, "gauge_right");
    if (lattice->mirror[axis])
        gauge->from = lattice->origin[axis];
    else {
        gauge->left = members_new(body, domain, "gauge_left");
        gauge->from = gauge->left.mean;
    }
    gauge->to = gauge->right.mean;
}

struct gauge *gauge_new(const struct body *body, const struct domain *domain, int n_phases)
{
    bool wanted = domain && (domain_set(domain, "gauge_left") || domain_set(domain, "gauge_right"));
    ranks_share(&wanted, sizeof wanted);
    const int axis = body->lattice->axis;
    if (!wanted && !body->lattice->periodic[axis]) return NULL;
    struct gauge *gauge = memory_new(1, sizeof *gauge);
    gauge->n_phases = n_phases;
    find_planes(gauge, body, domain);
    const char letter = "xyz"[axis];
    if (!(gauge->to > gauge->from))
        die_user("the gauge planes are not apart: gauge_left at %c = %g m, gauge_right at %g m",
                 letter, gauge->from, gauge->to);
    gauge->fraction = memory_new((size_t)n_phases, sizeof *gauge->fraction);
    gauge->volume = memory_new((size_t)n_phases, sizeof *gauge->volume);
    gauge->layer = memory_new((size_t)layers(body->lattice), sizeof *gauge->layer);
    count_phases(gauge, body);
    return gauge;
}

void gauge_free(struct gauge *gauge)
{
    if (!gauge) return;
    members_free(&gauge->left);
    members_free(&gauge->right);
    free(gauge->fraction);
    free(gauge->volume);
    free(gauge->layer);
    free(gauge);
}

double gauge_length(const struct gauge *gauge)
{
    return gauge->to - gauge->from;
}

double gauge_fraction(const struct gauge *gauge, int phase)
{
    return gauge->fraction[phase];
}

/* A node in a plane of symmetry stands for one, others for two. */
static double images_of(const struct body *body, int64_t site)
{
    double images = 1;
    int at[3];
    grid_position(&body->grid, site, at);
    for (int a = 0; a < 3; a++)
        if (body->lattice->mirror[a] && at[a] > 0) images *= 2;
    return images;
}

struct gauge_planes gauge_displacements(const struct gauge *gauge, const struct body *body)
{
    const struct members *sets[2] = {&gauge->left, &gauge->right};
    const int axis = body->lattice->axis;
    const double reach = 100 * (lattice_extent(body->lattice, axis) + body->lattice->spacing);
    struct exact_sum sums[4];
    if (body->lattice->periodic[axis])
        return (struct gauge_planes){0, body->mean_gradient[4 * axis] * gauge_length(gauge)};
    for (int k = 0; k < 2; k++) {
        sums[k] = exact_sum_new(8 * (double)sets[k]->n_all * reach);
        sums[2 + k] = exact_sum_new(8 * (double)sets[k]->n_all);
        for (int64_t i = 0; i < sets[k]->count; i++) {
            const double images = images_of(body, sets[k]->sites[i]);
            exact_sum_add(&sums[k], images * body->u[axis][sets[k]->sites[i]]);
            exact_sum_add(&sums[2 + k], images);
        }
    }
    double values[4];
    exact_sum_finish(sums, 4, values);
    const bool fixed = body->lattice->mirror[axis]; /* the left plane */
    return (struct gauge_planes){fixed ? 0 : values[0] / values[2], values[1] / values[3]};
}

/* Of tensors the component along the axis of the test twice. */
static const double *member(const struct node_state *node, size_t offset, int axis)
{
    if (offset == offsetof(struct node_state, H)) return node->H[4 * axis];
    if (offset == offsetof(struct node_state, cauchy)) return node->cauchy[axis];
    return (const double *)((const char *)node + offset);
}

static void add_strip(const struct gauge *gauge, const struct body *body, const struct strip *strip,
                      const struct node_state *node, struct exact_sum *sums,
                      struct exact_sum *sections)
{
    const int axis = body->lattice->axis, b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (int i = 0; i < strip->count; i++) {
        int64_t site = strip->site + i;
        if (!(body->grid.flags[site] & SITE_OWNED)) continue;
        double x[3];
        int at[3];
        body_particle_position(body, site, x);
        grid_position(&body->grid, site, at);
        const double volume = body_particle_volume(body, site) / body->volume,
                     section = (1 + node->H[4 * b][i]) * (1 + node->H[4 * c][i]) -
                               node->H[3 * b + c][i] * node->H[3 * c + b][i];
        exact_sum_add(&sections[layer(body->lattice, x, at)], volume * section);
        if (!between(gauge, body->lattice, x[axis])) continue;
        struct exact_sum *phase = sums + body->grid.phase[site] * MEANS;
        for (int k = 0; k < MEANS; k++)
            exact_sum_add(&phase[k], volume * member(node, gauge_means[k].member, axis)[i]);
    }
}

/* What is seen becomes that along the axes of the test. */
static void turn(const struct body *body, struct node_state *node)
{
    static const int cauchy[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
    for (int i = 0; i < node->count; i++) {
        double H[9], stress[9], turned[9];
        for (int k = 0; k < 9; k++) {
            H[k] = node->H[k][i];
            stress[k] = node->cauchy[cauchy[k]][i];
        }
        body_to_test(body, H, turned);
        for (int k = 0; k < 9; k++) node->H[k][i] = turned[k];
        body_to_test(body, stress, turned);
        for (int k = 0; k < 9; k++) node->cauchy[cauchy[k]][i] = turned[k];
    }
}

static struct gauge_section smallest_section(const struct gauge *gauge, const struct body *body,
                                             const double *sections)
{
    const struct lattice *lattice = body->lattice;
    struct gauge_section smallest = {INFINITY, 0};
    const double thick = thickness_of_layer(lattice),
                 first = lattice->origin[lattice->axis] +
                         (lattice->corner && !lattice_is_row(lattice) ? 0.5 * thick : 0);
    for (int x = 0; x < layers(lattice); x++) {
        const double volume = gauge->layer[x];
        if (!(volume > 0) || sections[x] / volume >= smallest.ratio) continue;
        smallest = (struct gauge_section){sections[x] / volume, first + x * thick};
    }
    return smallest;
}

void gauge_measure(const struct gauge *gauge, struct model *model, const struct body *body,
                   double *means, struct gauge_section *section)
{
    const int n_sums = gauge->n_phases * MEANS, n_layers = layers(body->lattice);
    struct exact_sum *sums = memory_new((size_t)(n_sums + n_layers), sizeof *sums);
    const double nodes = (double)body->lattice->n_particles;
    for (int k = 0; k < n_sums; k++) sums[k] = exact_sum_new(nodes * gauge_means[k % MEANS].most);
    /* Ratios of sections stay below 1e3. */
    for (int k = 0; k < n_layers; k++) sums[n_sums + k] = exact_sum_new(nodes * 1e3);

    const struct strips *strips = model_strips(model, body);
    for (int64_t s = 0; s < strips->count; s++) {
        const struct strip *strip = &strips->items[s];
        struct node_state node;
        model_observe(model, body, strip, &node);
        if (body->turned) turn(body, &node);
        add_strip(gauge, body, strip, &node, sums, sums + n_sums);
    }
    double *values = memory_new((size_t)(n_sums + n_layers), sizeof *values);
    exact_sum_finish(sums, n_sums + n_layers, values);
    for (int k = 0; k < n_sums; k++) {
        const double volume = gauge->volume[k / MEANS];
        means[k] = values[k] / (volume > 0 ? volume : 1);
    }
    *section = smallest_section(gauge, body, values + n_sums);
    free(sums);
    free(values);
}
