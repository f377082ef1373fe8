#include "outline.h"

#include "die.h"
#include "polygon.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

bool outline_holds(const struct specimen *specimen, const double point[3])
{
    /* Rounding must not decide about a node on the outline. */
    const double slack = 1e-6 * specimen->spacing[1];
    const double c = cos(specimen->angle), s = sin(specimen->angle);
    const double x = c * point[0] + s * point[1], y = c * point[1] - s * point[0];
    const double half = specimen_half_width(specimen, x) + slack;
    if (fabs(x) > 0.5 * specimen->size[0] + slack) return false;
    if (specimen_is_round(specimen)) return hypot(y, point[2]) <= half;
    const double *hole = specimen->hole_centre, radius = 0.5 * specimen->hole_diameter;
    return fabs(y) <= half && !(hypot(x - hole[0], y - hole[1]) < radius - slack);
}

/* --- flat bodies ------------------------------------------------------------------------------ */

/* Area of a polygon that a pocket takes away on one side (sign: of y). */
static double area_in_pocket(const struct polygon *whole, const struct pocket *pocket, double sign)
{
    const double length = pocket->length, radius = pocket->radius;
    const double middle = sign * (pocket->bottom + radius);
    struct polygon part = polygon_below(whole, 1, -sign, sign * pocket->bottom);
    part = polygon_below(&part, 1, sign, sign * pocket->top);
    struct polygon inner = polygon_below(&part, 0, 1, length);
    inner = polygon_below(&inner, 0, -1, -length);
    double area = polygon_area(&inner);
    for (int end = -1; end <= 1; end += 2) {
        const double centre[2] = {end * length, middle};
        const struct polygon outer = polygon_below(&part, 0, -end, centre[0]);
        const struct polygon arc = polygon_below(&outer, 1, sign, middle);
        struct polygon wall = polygon_below(&outer, 1, -sign, middle);
        wall = polygon_below(&wall, 0, end, end * (length + radius));
        area += polygon_in_disc(&arc, centre, radius) + polygon_area(&wall);
    }
    return area;
}

static double flat_area(const struct specimen *specimen, const struct polygon *cell)
{
    struct polygon part = *cell;
    for (int axis = 0; axis < 2; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            part = polygon_below(&part, axis, sign, sign * 0.5 * specimen->size[axis]);
    struct pocket pockets[2];
    const int count = specimen_pockets(specimen, pockets);
    double area = polygon_area(&part);
    for (int i = 0; i < count; i++)
        area -= area_in_pocket(&part, &pockets[i], 1) + area_in_pocket(&part, &pockets[i], -1);
    if (specimen->hole_diameter > 0)
        area -= polygon_in_disc(&part, specimen->hole_centre, 0.5 * specimen->hole_diameter);
    return area;
}

/* --- round bodies ----------------------------------------------------------------------------- */

/* A prism: a polygon of the body's x and y from one z to another. */
struct prism {
    const struct specimen *specimen;
    struct polygon base;
    double z[2];
};

/* The rectangle that a plane x cuts out of a prism: from y[0] to y[1]. */
static void chord(const struct prism *prism, double x, double y[2])
{
    const struct polygon *base = &prism->base;
    y[0] = INFINITY;
    y[1] = -INFINITY;
    for (int i = 0; i < base->count; i++) {
        const double *a = base->at[i], *b = base->at[(i + 1) % base->count];
        const double over_a = a[0] - x, over_b = b[0] - x;
        if (over_a * over_b > 0) continue;
        const double t = over_a == over_b ? 0 : over_a / (over_a - over_b);
        y[0] = fmin(y[0], a[1] + t * (b[1] - a[1]));
        y[1] = fmax(y[1], a[1] + t * (b[1] - a[1]));
    }
}

/* The area of that rectangle in the body. */
static double round_area(double x, void *data)
{
    const struct prism *prism = data;
    static const double axis[2] = {0, 0};
    double y[2];
    chord(prism, x, y);
    const struct polygon cut = polygon_box(y[0], y[1], prism->z[0], prism->z[1]);
    return polygon_in_disc(&cut, axis, specimen_half_width(prism->specimen, x));
}

/* Where the integrand has corners. */
enum { MOST_BREAKS = 300 };
struct breaks {
    int count;
    double at[MOST_BREAKS];
};

static void add_break(struct breaks *breaks, double x)
{
    if (breaks->count < MOST_BREAKS) breaks->at[breaks->count++] = x;
}

static int compare_numbers(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

static void sort_breaks(struct breaks *breaks)
{
    qsort(breaks->at, (size_t)breaks->count, sizeof *breaks->at, compare_numbers);
}

/* Corners of the base and ends of arcs, within the body. */
static void find_ends(const struct prism *prism, struct breaks *breaks)
{
    struct pocket pockets[2];
    const int n_pockets = specimen_pockets(prism->specimen, pockets);
    const double end = 0.5 * prism->specimen->size[0];
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < prism->base.count; i++) {
        const double x = fmax(-end, fmin(end, prism->base.at[i][0]));
        low = fmin(low, x);
        high = fmax(high, x);
        add_break(breaks, x);
    }
    for (int i = 0; i < n_pockets; i++) {
        const struct pocket *pocket = &pockets[i];
        const double rise = fmin(pocket->top - pocket->bottom, pocket->radius);
        const double arc = sqrt(rise * (2 * pocket->radius - rise));
        const double ends[] = {-pocket->length - arc, -pocket->length, pocket->length,
                               pocket->length + arc};
        for (int k = 0; k < 4; k++)
            if (ends[k] > low && ends[k] < high) add_break(breaks, ends[k]);
    }
    sort_breaks(breaks);
}

/* How far the circle reaches beyond a corner of the rectangle, or beyond a side's line: which % 3
 * is y's end or neither, which / 3 is z's. */
static double beyond_corner(const struct prism *prism, double x, int which)
{
    double y[2];
    chord(prism, x, y);
    const double across = which % 3 < 2 ? y[which % 3] : 0;
    const double up = which / 3 < 2 ? prism->z[which / 3] : 0;
    return specimen_half_width(prism->specimen, x) - hypot(across, up);
}

/* Where the circle passes a corner or touches a side between two ends; by samples, of which two
 * that are on different sides enclose such a place. */
static void find_passages(const struct prism *prism, double from, double to, struct breaks *breaks)
{
    enum { SAMPLES = 32, HALVINGS = 50, WAYS = 8 };
    for (int which = 0; which < WAYS; which++) {
        double before = beyond_corner(prism, from, which);
        for (int i = 1; i <= SAMPLES; i++) {
            double low = from + (to - from) * (i - 1) / SAMPLES, high = low + (to - from) / SAMPLES;
            const double after = beyond_corner(prism, fmin(high, to), which);
            for (int k = 0; before * after < 0 && k < HALVINGS; k++) {
                const double middle = 0.5 * (low + high);
                *(before * beyond_corner(prism, middle, which) > 0 ? &low : &high) = middle;
            }
            if (before * after < 0) add_break(breaks, low);
            before = after;
        }
    }
}

static double integrate(struct prism *prism)
{
    enum { INTERVALS = 100 };
    const gsl_function area = {round_area, prism};
    const double small = 1e-13 * specimen_node_volume(prism->specimen);
    struct breaks breaks = {0};
    double sum = 0;
    find_ends(prism, &breaks);
    for (int i = 0, ends = breaks.count; i + 1 < ends; i++)
        if (breaks.at[i + 1] > breaks.at[i])
            find_passages(prism, breaks.at[i], breaks.at[i + 1], &breaks);
    sort_breaks(&breaks);
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_integration_cquad_workspace *work = gsl_integration_cquad_workspace_alloc(INTERVALS);
    for (int i = 0; i + 1 < breaks.count; i++) {
        const double from = breaks.at[i], to = breaks.at[i + 1];
        double part;
        if (!(to > from)) continue;
        if (!work || gsl_integration_cquad(&area, from, to, small, 1e-13, work, &part, NULL, NULL))
            die_run("the volume of a cell at x = %g m could not be integrated", from);
        sum += part;
    }
    gsl_integration_cquad_workspace_free(work);
    gsl_set_error_handler(handler);
    return sum;
}

/* Smallest and largest distance of an interval from 0. */
static void distances(double low, double high, double distance[2])
{
    distance[0] = fmax(0, fmax(low, -high));
    distance[1] = fmax(high, -low);
}

static double round_volume(struct prism *prism)
{
    const struct polygon *base = &prism->base;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, x[2], y[2], z[2];
    for (int i = 0; i < base->count; i++)
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], base->at[i][axis]);
            high[axis] = fmax(high[axis], base->at[i][axis]);
        }
    distances(low[0], high[0], x);
    distances(low[1], high[1], y);
    distances(prism->z[0], prism->z[1], z);
    /* The half width never falls away from the middle. */
    const double least = specimen_half_width(prism->specimen, x[0]);
    const double most = specimen_half_width(prism->specimen, x[1]);
    const bool within = x[1] <= 0.5 * prism->specimen->size[0] * (1 + 1e-12);
    if (hypot(y[0], z[0]) >= most) return 0;
    if (within && hypot(y[1], z[1]) <= least)
        return polygon_area(base) * (prism->z[1] - prism->z[0]);
    if (within && least == most && prism->specimen->angle == 0)
        return round_area(low[0], prism) * (high[0] - low[0]);
    return integrate(prism);
}

/* --- cells ------------------------------------------------------------------------------------ */

double outline_of_cell(const struct specimen *specimen, const double centre[3])
{
    static const int sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double c = cos(specimen->angle), s = sin(specimen->angle);
    const double *edge = specimen->spacing;
    struct prism prism = {specimen, {.count = 4}, {0, 0}};
    for (int i = 0; i < 4; i++) {
        const double x = centre[0] + 0.5 * sign[i][0] * edge[0];
        const double y = centre[1] + 0.5 * sign[i][1] * edge[1];
        prism.base.at[i][0] = c * x + s * y;
        prism.base.at[i][1] = c * y - s * x;
    }
    prism.z[0] = centre[2] - 0.5 * edge[2];
    prism.z[1] = centre[2] + 0.5 * edge[2];
    return specimen_is_round(specimen) ? round_volume(&prism)
                                       : flat_area(specimen, &prism.base) * edge[2];
}

double outline_between(const struct specimen *specimen, double length)
{
    const double half = 0.5 * length, y = specimen->size[1], z = specimen->size[2];
    struct prism prism = {specimen, polygon_box(-half, half, -y, y), {-z, z}};
    return specimen_is_round(specimen) ? integrate(&prism) : flat_area(specimen, &prism.base) * z;
}

double outline_section(const struct specimen *specimen, const struct sites *sites)
{
    const bool gauge = specimen->gauge_length > 0;
    const double length = gauge ? specimen->gauge_length : specimen->size[0];
    const bool *half = specimen->symmetry;
    if (specimen->volumes == VOLUMES_CUT)
        return outline_between(specimen, length) / length * (half[1] ? 0.5 : 1) *
               (half[2] ? 0.5 : 1);
    const bool turned = specimen->angle != 0;
    int64_t layer[2] = {0, sites->count[0] - 1}, between = 0;
    if (gauge) specimen_gauge_layers(specimen, layer);
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        const int64_t i = sites->site[node] % sites->count[0];
        double at[3];
        sites_in_body(sites, node, at);
        between += turned ? fabs(at[0]) <= 0.5 * length : i >= layer[0] && i <= layer[1];
    }
    if (turned) return (double)between * sites_volume(sites, 0) / length;
    const double layers = (double)(layer[1] - layer[0] + 1) * (half[0] ? 0.5 : 1);
    return (double)between / layers * sites->spacing[1] * sites->spacing[2];
}
