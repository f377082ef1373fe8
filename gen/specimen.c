#include "specimen.h"

#include "keys.h"
#include "memory.h"

#include <math.h>
#include <string.h>

enum { MOST_LAYERS = 1000000 };

#define THINNEST 1e-12 /* m, sheet */
#define THICKEST 1e3

/* --- the deck ----------------------------------------------------------------------------------- */

const char *const specimen_shapes[] = {"plate", "dogbone", NULL};

static const struct variant *shape_variant(int i)
{
    static const struct variant shapes[] = {{.name = "plate"}, {.name = "dogbone"}};
    return i < 2 ? &shapes[i] : NULL;
}

#define LENGTH(member) .kind = KEY_SPACINGS, .place = offsetof(struct specimen, member)
#define DOGBONE        (1u << SPECIMEN_DOGBONE)

static const struct key gauge_rows[] = {
    {"length", LENGTH(gauge_length), .low = 1, .high = HUGE_VAL, .required = true,
     .help = "between the sets gauge_left and gauge_right, centred"},
    {"width", LENGTH(gauge_width), .low = 1, .high = HUGE_VAL, .required = true, .users = DOGBONE,
     .help = "of the parallel part, at most that of the heads"},
    {"fillet", LENGTH(fillet), .low = 0, .high = HUGE_VAL, .required = true, .users = DOGBONE,
     .help = "radius between the parallel part and the heads"},
};

const struct section specimen_gauge = {
    .path = "domain.gauge",
    .help = "Where strain is measured.",
    .keys = KEYS(gauge_rows),
    .chooser = "specimen",
    .variant = shape_variant,
    .outside = true,
};

struct grips {
    double length;
    const char *phase;
};

static const struct key grips_rows[] = {
    {"length", KEY_SPACINGS, offsetof(struct grips, length), .low = 1, .high = HUGE_VAL,
     .required = true, .help = "of either grip, in the sets grip_left and grip_right"},
    {"phase", KEY_TEXT, offsetof(struct grips, phase), .form = "structure, or name of a material",
     .required = true,
     .help =
         "what the grips are made of: the structure that goes on, one of its phases, or a further "
         "material of the deck"},
};

const struct section specimen_grips = {
    .path = "domain.grips",
    .help = "The ends by which the specimen is held; they do not count for the fraction.",
    .keys = KEYS(grips_rows),
};

/* A length that the lattice fills with whole layers. */
static void read_layers(struct deck_node item, int axis, struct specimen *specimen)
{
    double spacing = specimen->spacing[axis];
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

static void read_size(struct deck_node size, struct specimen *specimen)
{
    if (!deck_is_list(size) || deck_count(size) != 3)
        deck_error(size, "size is a list of three lengths: [along x, along y, along z]");
    for (int axis = 0; axis < specimen->dimensions; axis++)
        read_layers(deck_item(size, axis), axis, specimen);
    if (specimen->dimensions == 3) return;
    specimen->count[2] = 1;
    const double said = specimen->spacing[2];
    specimen->size[2] = deck_length(deck_item(size, 2), specimen->spacing[0], THINNEST, THICKEST);
    specimen->spacing[2] = specimen->size[2];
    if (said != specimen->spacing[0] && fabs(said / specimen->size[2] - 1) > 1e-6)
        deck_error(deck_item(size, 2),
                   "a sheet is one cell thick: the thickness %g m is not the third spacing, %g m",
                   specimen->size[2], said);
}

/* Ranges that depend on other keys. */
static void check_length(struct deck_node map, const char *key, double length, double low,
                         double high)
{
    if (length < low || length > high)
        deck_error(deck_get(map, key), "%g m is out of range, expected %g to %g m", length, low,
                   high);
}

static void check_dogbone(struct deck_node gauge, const struct specimen *specimen)
{
    double head = specimen->size[1], step = 0.5 * (head - specimen->gauge_width);
    check_length(gauge, "width", specimen->gauge_width, specimen->spacing[1], head);
    check_length(gauge, "fillet", specimen->fillet, step, 1e3 * head);
    double arc = sqrt(step * (2 * specimen->fillet - step));
    if (specimen->gauge_length + 2 * arc > specimen->size[0])
        deck_error(gauge,
                   "the gauge (%g m) with two fillets of %g m each is longer than the "
                   "specimen (%g m)",
                   specimen->gauge_length, arc, specimen->size[0]);
}

static void read_gauge(struct deck_node gauge, struct specimen *specimen)
{
    keys_read(gauge, &specimen_gauge, (int)specimen->shape, specimen->spacing[0], specimen, NULL);
    check_length(gauge, "length", specimen->gauge_length, specimen->spacing[0], specimen->size[0]);
    if (specimen->shape == SPECIMEN_DOGBONE) check_dogbone(gauge, specimen);
}

static void read_grips(struct deck_node map, struct specimen *specimen)
{
    struct grips grips;
    keys_read(map, &specimen_grips, 0, specimen->spacing[0], &grips, NULL);
    check_length(map, "length", grips.length, specimen->spacing[0],
                 0.5 * (specimen->size[0] - specimen->spacing[0]));
    specimen->grip_layers = (int64_t)llround(grips.length / specimen->spacing[0]);
    specimen->grip_phase = strcmp(grips.phase, "structure") == 0 ? NULL : grips.phase;
    int64_t layer[2];
    specimen_gauge_layers(specimen, layer);
    if (specimen->gauge_length > 0 && layer[0] < specimen->grip_layers)
        deck_error(map, "the gauge planes (%g m apart) lie in the grips (%g m long each)",
                   specimen->gauge_length, grips.length);
}

void specimen_read(struct specimen *specimen, struct deck_node size, struct deck_node gauge,
                   struct deck_node grips)
{
    read_size(size, specimen);
    if (gauge.index) read_gauge(gauge, specimen);
    if (grips.index) read_grips(grips, specimen);
}

/* --- the body ----------------------------------------------------------------------------------- */

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
    return fabs(point[1]) <= specimen_half_width(s, point[0]) + 1e-6 * s->spacing[1];
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
    return specimen->spacing[0] * specimen->spacing[1] * specimen->spacing[2];
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
    double right =
        0.5 * (specimen->gauge_length / specimen->spacing[0] + (double)specimen->count[0]);
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
    return (double)between / (double)(layer[1] - layer[0] + 1) * sites->spacing[1] *
           sites->spacing[2];
}
