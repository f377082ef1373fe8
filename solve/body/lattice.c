#include "lattice.h"

#include "die.h"
#include "memory.h"
#include "ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int compare_numbers(const void *a, const void *b)
{
    double s = *(const double *)a, t = *(const double *)b;
    return (s > t) - (s < t);
}

/* Smallest distance above a threshold of neighbours in one coordinate, averaged over the layers
 * between the ends so that the rounding of two positions does not decide; 0 where there is none. */
static double layer_distance(const double *values, int64_t count, double threshold)
{
    double *sorted = memory_new((size_t)count, sizeof *sorted), gap = INFINITY;
    memcpy(sorted, values, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare_numbers);
    for (int64_t i = 1; i < count; i++) {
        double distance = sorted[i] - sorted[i - 1];
        if (distance > threshold) gap = fmin(gap, distance);
    }
    double span = sorted[count - 1] - sorted[0];
    free(sorted);
    return gap < INFINITY ? span / round(span / gap) : 0;
}

/* What the box of a plane set gives to each particle.  A lattice that fills 1/64 of its box at
 * least has a spacing of 1/8 of it or more. */
static double plane_distance(const double span[3], int64_t count)
{
    double n = (double)count, longest = fmax(span[0], span[1]);
    return fmax(sqrt(span[0] * span[1] / n), longest / n);
}

static double plane_spacing(const struct domain *domain, const double span[3])
{
    double threshold = plane_distance(span, domain->n_nodes) / 16;
    double spacing = layer_distance(domain->x, domain->n_nodes, threshold);
    return spacing > 0 ? spacing : layer_distance(domain->y, domain->n_nodes, threshold);
}

/* Dimensions, spacing, thickness and volume that the domain says or implies; volume: its smallest
 * one. */
static void choose_scale(const struct domain *domain, const double span[3], double volume,
                         struct lattice *lattice)
{
    const struct attributes *facts = &domain->attributes;
    const double said = attributes_number(facts, "dimensions", 0);
    double spacing = attributes_number(facts, "spacing_m", 0);
    const bool given = spacing > 0;
    const double near = given ? spacing : plane_distance(span, domain->n_nodes);
    lattice->dimensions = said == 2 ? 2 : 3;
    if (span[2] <= 1e-6 * near) {
        if (!given) spacing = plane_spacing(domain, span);
        bool cube = !(spacing > 0) || fabs(volume / (spacing * spacing * spacing) - 1) <= 1e-6;
        if (said == 0 && !cube) lattice->dimensions = 2;
    }
    if (!(spacing > 0) || (!given && lattice->dimensions == 3)) spacing = cbrt(volume);
    lattice->spacing = lattice->edge[0] = spacing;
    lattice->edge[1] = attributes_number(facts, "spacing_y_m", spacing);
    lattice->edge[2] = attributes_number(facts, "spacing_z_m", spacing);
    const double area = spacing * lattice->edge[1];
    lattice->node_volume = area * lattice->edge[2];
    if (lattice->dimensions == 3) return;
    lattice->edge[2] = spacing;
    lattice->thickness = attributes_number(facts, "thickness_m", volume / area);
    lattice->node_volume = area * lattice->thickness;
}

/* Size and origin; false where they are none of a lattice. */
static bool fit_box(const struct domain *domain, struct lattice *lattice)
{
    struct domain_nodes nodes = {0};
    double high[3], span[3], volume = INFINITY;
    for (int a = 0; a < 3; a++) high[a] = -(lattice->origin[a] = INFINITY);
    while (domain_next(domain, &nodes)) {
        volume = fmin(volume, domain_smallest(nodes.volume, nodes.count));
        for (int a = 0; a < 3; a++) {
            lattice->origin[a] = fmin(lattice->origin[a], domain_smallest(nodes.x[a], nodes.count));
            high[a] = fmax(high[a], domain_largest(nodes.x[a], nodes.count));
        }
    }
    for (int a = 0; a < 3; a++) span[a] = high[a] - lattice->origin[a];
    choose_scale(domain, span, volume, lattice);
    lattice->n_sites = 1;
    for (int a = 0; a < 3; a++) {
        double steps = span[a] / lattice->edge[a];
        if (!(steps < 1e6)) return false;
        lattice->size[a] = (int)lround(steps) + 1;
        lattice->n_sites *= lattice->size[a];
    }
    if (lattice->dimensions == 2 && lattice->size[2] > 1) return false;
    return lattice->n_sites <= 64 * lattice->n_nodes + 1000000;
}

/* Place of a node in spacings from the origin; false where it is off the lattice. */
static bool place(const struct lattice *lattice, const double x[3], int at[3])
{
    bool fits = true;
    for (int a = 0; a < 3; a++) {
        double steps = (x[a] - lattice->origin[a]) / lattice->edge[a];
        at[a] = (int)lround(steps);
        fits = fits && fabs(steps - at[a]) <= 1e-6 * fmax(1, lattice->size[a]);
    }
    return fits;
}

int64_t lattice_nearest(const struct lattice *lattice, const double x[3])
{
    int at[3];
    place(lattice, x, at);
    return lattice_site(lattice, at[0], at[1], at[2]);
}

double lattice_whole_volume(const struct lattice *lattice)
{
    bool whole = true;
    double box = 1, particles = 0;
    for (int a = 0; a < lattice->dimensions; a++) {
        whole = whole && lattice->periodic[a];
        box *= lattice_period(lattice, a);
    }
    if (whole) return lattice->dimensions == 2 ? box * lattice->thickness : box;
    for (int64_t site = 0; site < lattice->n_sites; site++)
        if (lattice->phase[site] != ABSENT) particles += lattice_volume(lattice, site);
    return particles;
}

/* Whether the nodes lie on sites of their own, with the volume of a site; they take them. */
static bool fit_nodes(const struct domain_nodes *nodes, struct lattice *lattice, int64_t *last)
{
    for (int64_t i = 0; i < nodes->count; i++) {
        const double x[3] = {nodes->x[0][i], nodes->x[1][i], nodes->x[2][i]};
        int at[3];
        if (!place(lattice, x, at)) return false;
        const double share = nodes->volume[i] / lattice->node_volume;
        if (lattice->volume ? !(share > 0) : !(fabs(share - 1) <= 1e-6)) return false;
        const int64_t site = lattice_site(lattice, at[0], at[1], at[2]);
        if (lattice->phase[site] != ABSENT) return false;
        lattice->phase[site] = nodes->phase[i];
        if (lattice->volume) lattice->volume[site] = nodes->volume[i];
        if (lattice->grain) lattice->grain[site] = nodes->grain[i];
        lattice->sorted = lattice->sorted && site > *last;
        *last = site;
    }
    return true;
}

/* The axes that a text of the domain names by their letters. */
static void find_axes(const struct domain *domain, const char *name, bool axes[3])
{
    const char *letters = attributes_text(&domain->attributes, name);
    for (int a = 0; letters && a < 3; a++) axes[a] = strchr(letters, 'x' + a) != NULL;
}

void lattice_periods(const struct domain *domain, double period[3])
{
    static const char *const names[] = {"period_x_m", "period_y_m", "period_z_m"};
    bool axes[3] = {false};
    find_axes(domain, "periodic", axes);
    for (int a = 0; a < 3; a++)
        period[a] = axes[a] ? attributes_number(&domain->attributes, names[a], NAN) : 0;
}

/* Along which axes the domain says that it is periodic, and across which it is mirrored; dies where
 * its sites are not as many as its period has. */
static void find_symmetry(const struct domain *domain, struct lattice *lattice)
{
    double periods[3];
    lattice_periods(domain, periods);
    find_axes(domain, "symmetry", lattice->mirror);
    find_axes(domain, "periodic", lattice->periodic);
    for (int a = 0; a < 3; a++) {
        const double period = periods[a], sites = period / lattice->edge[a];
        if (lattice->periodic[a] && lattice->mirror[a])
            die_user("the domain is periodic along %c and has a plane of symmetry across it, "
                     "expected one of them",
                     'x' + a);
        /* A file from elsewhere has no more than its particles. */
        if (!lattice->periodic[a] || isnan(period)) continue;
        if (!(fabs(sites - lattice->size[a]) <= 1e-6 * lattice->size[a]))
            die_user(
                "the domain is periodic along %c after %g m, %g spacings, and has %d layers of "
                "particles there, expected as many as spacings",
                'x' + a, period, sites, lattice->size[a]);
    }
}

bool lattice_recognise(const struct domain *domain, struct lattice *lattice)
{
    *lattice = (struct lattice){
        .n_nodes = domain->n_nodes, .n_particles = domain->n_nodes, .sorted = true};
    struct domain_nodes nodes = {0};
    int64_t last = -1;
    bool fits = fit_box(domain, lattice);
    if (fits) {
        lattice->phase = memory_new((size_t)lattice->n_sites, 1);
        memset(lattice->phase, ABSENT, (size_t)lattice->n_sites);
        const char *volumes = attributes_text(&domain->attributes, "volumes");
        if (volumes && strcmp(volumes, "cut") == 0)
            lattice->volume = memory_new((size_t)lattice->n_sites, sizeof(double));
        if (domain_has_grains(domain))
            lattice->grain = memory_new((size_t)lattice->n_sites, sizeof(double));
    }
    while (fits && domain_next(domain, &nodes)) fits = fit_nodes(&nodes, lattice, &last);
    if (fits)
        find_symmetry(domain, lattice);
    else
        lattice_free(lattice);
    return fits;
}

/* Of particles that lie on no lattice, between the outermost of which this lies. */
static void find_periods(const struct domain *domain, struct lattice *lattice)
{
    bool mirror[3] = {false};
    find_axes(domain, "symmetry", mirror);
    find_axes(domain, "periodic", lattice->periodic);
    lattice_periods(domain, lattice->period);
    for (int a = 0; a < 3; a++) {
        const double period = lattice->period[a];
        if (mirror[a])
            die_user("the domain has a plane of symmetry across %c, and its particles lie on no "
                     "lattice, which such a body needs",
                     'x' + a);
        if (isnan(period))
            die_user("the domain is periodic along %c, and its particles lie on no lattice: after "
                     "what length they repeat themselves says domain.period of the deck",
                     'x' + a);
        if (lattice->periodic[a] && !(period > lattice->extent[a]))
            die_user("the domain is periodic along %c after %g m, and its particles lie %g m "
                     "apart there, expected less: an image of a particle is none of them",
                     'x' + a, period, lattice->extent[a]);
    }
}

/* Tells of periods that the particles do not fill: as a whole, or, where the body ends along other
 * axes, by the gap between the last ones and the images of the first. */
static void check_periods(const struct lattice *lattice)
{
    static const double rounding = 0.02, gap = 3; /* of the volume of irregular ones; spacings */
    const double share =
        lattice->node_volume * (double)lattice->n_nodes / lattice_whole_volume(lattice);
    bool whole = true;
    for (int a = 0; a < lattice->dimensions; a++) whole = whole && lattice->periodic[a];
    if (whole && !(fabs(share - 1) <= rounding))
        warn("the particles have %.4g %% of the volume of the domain's periods: where no pores "
             "are meant, domain.period or the volumes are others",
             100 * share);
    for (int a = 0; !whole && a < lattice->dimensions; a++) {
        const double between = (lattice->period[a] - lattice->extent[a]) / lattice->spacing;
        if (lattice->periodic[a] && between > gap)
            warn("along %c the particles end %.3g spacings before the images of the first ones: "
                 "is domain.period what it should be?",
                 'x' + a, between);
    }
}

struct lattice lattice_scattered(const struct domain *domain, double thickness)
{
    const int64_t n = domain->n_nodes;
    const double *const position[3] = {domain->x, domain->y, domain->z};
    struct lattice lattice = {
        .size = {(int)n, 1, 1}, .dimensions = 3, .n_sites = n, .n_nodes = n, .n_particles = n};
    if (n > INT32_MAX) die_user("more than 2^31 scattered particles");
    lattice.phase = memory_new((size_t)n, 1);
    lattice.volume = memory_new((size_t)n, sizeof(double));
    memcpy(lattice.phase, domain->phase, (size_t)n);
    memcpy(lattice.volume, domain->volume, (size_t)n * sizeof(double));
    if (domain->grain) {
        lattice.grain = memory_new((size_t)n, sizeof(double));
        memcpy(lattice.grain, domain->grain, (size_t)n * sizeof(double));
    }
    for (int64_t i = 0; i < n; i++) lattice.node_volume += domain->volume[i];
    lattice.node_volume /= (double)n;
    for (int a = 0; a < 3; a++) {
        lattice.point[a] = memory_new((size_t)n, sizeof(double));
        memcpy(lattice.point[a], position[a], (size_t)n * sizeof(double));
        lattice.origin[a] = domain_smallest(position[a], n);
        lattice.extent[a] = domain_largest(position[a], n) - lattice.origin[a];
    }
    find_periods(domain, &lattice);
    lattice.spacing = domain_spacing(domain);
    for (int a = 0; a < 3; a++) lattice.edge[a] = lattice.spacing;
    if (thickness > 0 && lattice.extent[2] < 1e-6 * lattice.spacing) {
        lattice.dimensions = 2;
        lattice.thickness = thickness;
    }
    check_periods(&lattice);
    return lattice;
}

/* An array that some lattices have. */
static void *share_array(void *own, int64_t count, size_t size, int rank)
{
    if (!own) return NULL;
    if (rank != 0) own = memory_new((size_t)count, size);
    ranks_share(own, (size_t)count * size);
    return own;
}

void lattice_share(struct lattice *lattice, int rank)
{
    /* Elsewhere its pointers say no more than which arrays there are. */
    ranks_share(lattice, sizeof *lattice);
    const int64_t n = lattice->n_sites;
    lattice->phase = share_array(lattice->phase, n, 1, rank);
    lattice->corner = share_array(lattice->corner, (int64_t)lattice_corner_bytes(lattice), 1, rank);
    lattice->volume = share_array(lattice->volume, n, sizeof(double), rank);
    lattice->grain = share_array(lattice->grain, n, sizeof(double), rank);
    for (int a = 0; a < 3; a++)
        lattice->point[a] = share_array(lattice->point[a], n, sizeof(double), rank);
    lattice->hexahedron = share_array(lattice->hexahedron, 8 * n, sizeof(int32_t), rank);
}

void lattice_free(struct lattice *lattice)
{
    free(lattice->phase);
    free(lattice->corner);
    free(lattice->volume);
    free(lattice->grain);
    for (int a = 0; a < 3; a++) free(lattice->point[a]);
    free(lattice->hexahedron);
    *lattice = (struct lattice){0};
}
