#include "specimen.h"

#include "memory.h"

#include <math.h>
#include <string.h>

static const char *const shapes[] = {"plate", "dogbone"};
static const char *const gauge_keys_plate[] = {"length", NULL};
static const char *const gauge_keys_dogbone[] = {"length", "width", "fillet", NULL};
static const char *const grip_keys[] = {"length", "phase", NULL};

enum { MOST_LAYERS = 1000000 };

#define THINNEST 1e-12 /* m, sheet */
#define THICKEST 1e3

/* A length that the lattice fills with whole layers. */
static void read_layers(struct deck_node item, int axis, struct specimen *specimen)
{
    double spacing = specimen->spacing;
    double length = deck_length(item, spacing, spacing * 0.5, spacing * MOST_LAYERS);
    double layers = round(length / spacing);
    if (layers < 1) layers = 1;
    if (fabs(length / spacing - layers) > 1e-6)
        deck_error(item,
                   "%.9g m is %.6f spacings of %.9g m; the lattice fills the size exactly: use "
                   "%.9g m or %.9g m, or the spacing %.9g m",
                   length, length / spacing, spacing, floor(length / spacing) * spacing,
                   ceil(length / spacing) * spacing, length / layers);
    specimen->count[axis] = (int64_t)layers;
    specimen->size[axis] = layers * spacing;
}

static void read_size(struct deck_node domain, struct specimen *specimen)
{
    struct deck_node size = deck_get(domain, "size");
    if (!deck_is_list(size) || deck_count(size) != 3)
        deck_error(size, "size is a list of three lengths: [along x, along y, along z]");
    for (int axis = 0; axis < specimen->dimensions; axis++)
        read_layers(deck_item(size, axis), axis, specimen);
    if (specimen->dimensions == 3) return;
    specimen->count[2] = 1;
    specimen->size[2] = deck_length(deck_item(size, 2), specimen->spacing, THINNEST, THICKEST);
}

static void read_dogbone(struct deck_node gauge, struct specimen *specimen)
{
    double spacing = specimen->spacing;
    double head = specimen->size[1];
    specimen->gauge_width = deck_length(deck_get(gauge, "width"), spacing, spacing, head);
    double step = 0.5 * (head - specimen->gauge_width);
    specimen->fillet = deck_length(deck_get(gauge, "fillet"), spacing, step, 1e3 * head);
    double arc = sqrt(step * (2 * specimen->fillet - step));
    if (specimen->gauge_length + 2 * arc > specimen->size[0])
        deck_error(gauge,
                   "the gauge (%g m) with two fillets of %g m each is longer than the "
                   "specimen (%g m)",
                   specimen->gauge_length, arc, specimen->size[0]);
}

static void read_gauge(struct deck_node domain, struct specimen *specimen)
{
    bool dogbone = specimen->shape == SPECIMEN_DOGBONE;
    if (!dogbone && !deck_has(domain, "gauge")) return;
    struct deck_node gauge = deck_get(domain, "gauge");
    deck_keys(gauge, dogbone ? gauge_keys_dogbone : gauge_keys_plate);
    specimen->gauge_length = deck_length(deck_get(gauge, "length"), specimen->spacing,
                                         specimen->spacing, specimen->size[0]);
    if (dogbone) read_dogbone(gauge, specimen);
}

static void read_grips(struct deck_node domain, struct specimen *specimen)
{
    if (!deck_has(domain, "grips")) return;
    struct deck_node grips = deck_get(domain, "grips");
    deck_keys(grips, grip_keys);
    double length = deck_length(deck_get(grips, "length"), specimen->spacing, specimen->spacing,
                                0.5 * (specimen->size[0] - specimen->spacing));
    specimen->grip_layers = (int64_t)llround(length / specimen->spacing);
    const char *phase = deck_string(deck_get(grips, "phase"));
    specimen->grip_phase = strcmp(phase, "structure") == 0 ? NULL : phase;
    int64_t layer[2];
    specimen_gauge_layers(specimen, layer);
    if (specimen->gauge_length > 0 && layer[0] < specimen->grip_layers)
        deck_error(grips, "the gauge planes (%g m apart) lie in the grips (%g m long each)",
                   specimen->gauge_length, length);
}

struct specimen specimen_read(struct deck_node domain)
{
    struct specimen specimen = {.dimensions = 3};
    specimen.shape = (enum specimen_shape)deck_choice(deck_get(domain, "specimen"), shapes, 2);
    specimen.spacing = deck_number(deck_get(domain, "spacing"), "m", 1e-12, 1e3);
    if (deck_has(domain, "dimensions"))
        specimen.dimensions = (int)deck_integer(deck_get(domain, "dimensions"), 2, 3);
    read_size(domain, &specimen);
    read_gauge(domain, &specimen);
    read_grips(domain, &specimen);
    return specimen;
}

double specimen_half_width(const struct specimen *specimen, double x)
{
    double head = 0.5 * specimen->size[1];
    if (specimen->shape == SPECIMEN_PLATE) return head;
    double beyond = fabs(x) - 0.5 * specimen->gauge_length;
    double parallel = 0.5 * specimen->gauge_width;
    double radius = specimen->fillet;
    if (beyond <= 0) return parallel;
    if (beyond >= radius) return head;
    return fmin(head, parallel + radius - sqrt(radius * radius - beyond * beyond));
}

static bool inside(const void *specimen, const double point[3])
{
    const struct specimen *s = specimen;
    /* Rounding must not decide about a node on the outline. */
    return fabs(point[1]) <= specimen_half_width(s, point[0]) + 1e-6 * s->spacing;
}

struct sites specimen_sites(const struct specimen *specimen)
{
    return sites_new(specimen->count, specimen->spacing, inside, specimen);
}

bool specimen_is_sheet(const struct specimen *specimen)
{
    return specimen->dimensions == 2;
}

double specimen_node_volume(const struct specimen *specimen)
{
    double square = specimen->spacing * specimen->spacing;
    return square * (specimen_is_sheet(specimen) ? specimen->size[2] : specimen->spacing);
}

void specimen_extent(const struct specimen *specimen, double extent[3])
{
    for (int axis = 0; axis < 3; axis++) extent[axis] = specimen->size[axis];
    if (specimen_is_sheet(specimen)) extent[2] = 0;
}

uint8_t *specimen_counted(const struct specimen *specimen, const struct sites *sites)
{
    uint8_t *counted = memory_new((size_t)sites->n_nodes, sizeof *counted);
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t layer = sites->site[node] % sites->count[0];
        counted[node] =
            layer >= specimen->grip_layers && layer < sites->count[0] - specimen->grip_layers;
    }
    return counted;
}

void specimen_gauge_layers(const struct specimen *specimen, int64_t layer[2])
{
    /* Of two layers equally near, the outer one; the left plane mirrors the right one. */
    double right = 0.5 * (specimen->gauge_length / specimen->spacing + (double)specimen->count[0]);
    layer[1] = (int64_t)floor(right + 1e-6);
    if (layer[1] > specimen->count[0] - 1) layer[1] = specimen->count[0] - 1;
    layer[0] = specimen->count[0] - 1 - layer[1];
}

double specimen_section(const struct specimen *specimen, const struct sites *sites)
{
    int64_t layer[2] = {0, sites->count[0] - 1};
    if (specimen->gauge_length > 0) specimen_gauge_layers(specimen, layer);
    int64_t between = 0;
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t i = sites->site[node] % sites->count[0];
        between += i >= layer[0] && i <= layer[1];
    }
    double height = specimen_is_sheet(specimen) ? specimen->size[2] : sites->spacing;
    return (double)between / (double)(layer[1] - layer[0] + 1) * sites->spacing * height;
}
