#include "specimen.h"

#include "keys.h"
#include "memory.h"

#include <math.h>
#include <string.h>

enum { MOST_LAYERS = 1000000 };

#define THINNEST 1e-12 /* m, sheet */
#define THICKEST 1e3

/* --- the deck --------------------------------------------------------------------------------- */

const char *const specimen_shapes[] = {"plate", "dogbone", "rod", "round_dogbone", NULL};
const char *const specimen_volumes[] = {"whole", "cut", NULL};

static const struct shape {
    struct variant deck;
    bool round, heads;
} shapes[] = {
    [SPECIMEN_PLATE] = {{.name = "plate"}, false, false},
    [SPECIMEN_DOGBONE] = {{.name = "dogbone"}, false, true},
    [SPECIMEN_ROD] = {{.name = "rod"}, true, false},
    [SPECIMEN_ROUND_DOGBONE] = {{.name = "round_dogbone"}, true, true},
};
enum { N_SHAPES = sizeof shapes / sizeof *shapes };

static const struct variant *shape_variant(int i)
{
    return i < N_SHAPES ? &shapes[i].deck : NULL;
}

#define LENGTH(member) .kind = KEY_SPACINGS, .place = offsetof(struct specimen, member)
#define HEADS          (1u << SPECIMEN_DOGBONE | 1u << SPECIMEN_ROUND_DOGBONE)

static const struct key gauge_rows[] = {
    {"length", LENGTH(gauge_length), .low = 1, .high = HUGE_VAL, .required = true,
     .help = "between the sets gauge_left and gauge_right, centred"},
    {"width", LENGTH(gauge_width), .low = 1, .high = HUGE_VAL, .required = true, .users = HEADS,
     .help = "of the parallel part, at most that of the heads; of a round one its diameter"},
    {"fillet", LENGTH(fillet), .low = 0, .high = HUGE_VAL, .required = true, .users = HEADS,
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

static const struct key notch_rows[] = {
    {"radius", LENGTH(notch_radius), .low = 0.1, .high = HUGE_VAL, .required = true,
     .help = "of its ground"},
    {"depth", LENGTH(notch_depth), .low = 0.1, .high = HUGE_VAL, .required = true,
     .help = "from the surface; where it is more than the radius, with walls along y"},
};

const struct section specimen_notch = {
    .path = "domain.notch",
    .help = "Notches in the middle: on both sides along y of a flat body, around a round one.",
    .keys = KEYS(notch_rows),
};

static const struct key hole_rows[] = {
    {"centre", .kind = KEY_LENGTH, .place = offsetof(struct specimen, hole_centre),
     .low = -HUGE_VAL, .high = HUGE_VAL, .size = 2, .help = "x and y, from the body's centre"},
    {"diameter", LENGTH(hole_diameter), .low = 0.1, .high = HUGE_VAL, .required = true,
     .help = "all of it lies inside the body"},
};

const struct section specimen_hole = {
    .path = "domain.hole",
    .help = "A round hole through a flat body, along z.",
    .keys = KEYS(hole_rows),
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

/* A length that lies across the lattice: any one. */
static void read_free(struct deck_node item, int axis, struct specimen *specimen)
{
    const double spacing = specimen->spacing[axis];
    specimen->size[axis] = deck_length(item, spacing, spacing, spacing * MOST_LAYERS);
}

static void read_thickness(struct deck_node item, struct specimen *specimen)
{
    const double said = specimen->spacing[2];
    specimen->count[2] = 1;
    specimen->size[2] = deck_length(item, specimen->spacing[0], THINNEST, THICKEST);
    specimen->spacing[2] = specimen->size[2];
    if (said != specimen->spacing[0] && fabs(said / specimen->size[2] - 1) > 1e-6)
        deck_error(item,
                   "a sheet is one cell thick: the thickness %g m is not the third spacing, %g m",
                   specimen->size[2], said);
}

/* As many cells as hold a box that is turned by the angle. */
static void count_cells(struct specimen *specimen, bool round)
{
    const double c = fabs(cos(specimen->angle)), s = fabs(sin(specimen->angle));
    const double *size = specimen->size;
    const double box[3] = {c * size[0] + s * size[1], s * size[0] + c * size[1], size[2]};
    for (int axis = specimen->angle == 0 ? 1 : 0; axis < (round ? 3 : 2); axis++)
        specimen->count[axis] = (int64_t)fmax(1, ceil(box[axis] / specimen->spacing[axis] - 1e-6));
}

static void read_round_size(struct deck_node domain, struct deck_node size,
                            struct specimen *specimen)
{
    if (specimen_is_sheet(specimen))
        deck_error(deck_get(domain, "dimensions"), "a round body has three dimensions");
    if (deck_is_list(size)) deck_error(size, "the size of a round body is its length alone");
    (void)deck_get(domain, "diameter"); /* dies where it is missing */
    specimen->size[1] = specimen->size[2] = specimen->diameter;
    if (specimen->angle == 0)
        read_layers(size, 0, specimen);
    else
        read_free(size, 0, specimen);
    count_cells(specimen, true);
}

static void read_flat_size(struct deck_node domain, struct deck_node size,
                           struct specimen *specimen)
{
    if (deck_has(domain, "diameter"))
        deck_error(deck_get(domain, "diameter"), "a %s has no diameter",
                   specimen_shapes[specimen->shape]);
    if (!deck_is_list(size) || deck_count(size) != 3)
        deck_error(size, "size is a list of three lengths: [along x, along y, along z]");
    for (int axis = 0; axis < 2; axis++)
        if (specimen->angle == 0)
            read_layers(deck_item(size, axis), axis, specimen);
        else
            read_free(deck_item(size, axis), axis, specimen);
    if (specimen_is_sheet(specimen))
        read_thickness(deck_item(size, 2), specimen);
    else
        read_layers(deck_item(size, 2), 2, specimen);
    if (specimen->angle != 0) count_cells(specimen, false);
}

/* Ranges that depend on other keys. */
static void check_length(struct deck_node map, const char *key, double length, double low,
                         double high)
{
    if (length < low || length > high)
        deck_error(deck_get(map, key), "%g m is out of range, expected %g to %g m", length, low,
                   high);
}

static void check_heads(struct deck_node gauge, const struct specimen *specimen)
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
    if (shapes[specimen->shape].heads) check_heads(gauge, specimen);
}

static void read_grips(struct deck_node map, struct specimen *specimen)
{
    struct grips grips;
    const double spacing = specimen->spacing[0];
    keys_read(map, &specimen_grips, 0, spacing, &grips, NULL);
    check_length(map, "length", grips.length, spacing, 0.5 * (specimen->size[0] - spacing));
    const bool turned = specimen->angle != 0;
    specimen->grip_length = turned ? grips.length : round(grips.length / spacing) * spacing;
    specimen->grip_phase = strcmp(grips.phase, "structure") == 0 ? NULL : grips.phase;
    double plane = 0.5 * specimen->gauge_length;
    int64_t layer[2];
    specimen_gauge_layers(specimen, layer);
    if (!turned) plane = ((double)layer[1] + 0.5) * spacing - 0.5 * specimen->size[0];
    if (specimen->gauge_length > 0 && plane > 0.5 * specimen->size[0] - specimen->grip_length)
        deck_error(map, "the gauge planes (%g m apart) lie in the grips (%g m long each)",
                   specimen->gauge_length, grips.length);
}

static void read_notch(struct deck_node map, struct specimen *specimen)
{
    const double half = specimen_half_width(specimen, 0);
    const bool heads = shapes[specimen->shape].heads;
    keys_read(map, &specimen_notch, 0, specimen->spacing[0], specimen, NULL);
    check_length(map, "depth", specimen->notch_depth, 0, half - 0.5 * specimen->spacing[1]);
    const double radius = specimen->notch_radius, depth = fmin(specimen->notch_depth, radius);
    if (sqrt(depth * (2 * radius - depth)) >
        0.5 * (heads ? specimen->gauge_length : specimen->size[0]))
        deck_error(map, "the notch is wider than the body's parallel part is long");
}

static void read_hole(struct deck_node map, struct specimen *specimen)
{
    enum { PARTS = 1000 };
    if (specimen_is_round(specimen)) deck_error(map, "a round body has no hole");
    keys_read(map, &specimen_hole, 0, specimen->spacing[0], specimen, NULL);
    const double *centre = specimen->hole_centre, radius = 0.5 * specimen->hole_diameter;
    bool inside = fabs(centre[0]) + radius < 0.5 * specimen->size[0];
    for (int i = -PARTS; i <= PARTS; i++) {
        const double beside = radius * i / PARTS;
        const double up = fabs(centre[1]) + sqrt(radius * radius - beside * beside);
        inside = inside && up < specimen_half_width(specimen, centre[0] + beside);
    }
    if (!inside) deck_error(map, "the hole leaves the body");
}

void specimen_read(struct specimen *specimen, struct deck_node domain)
{
    const struct deck_node size = deck_find(domain, "size"), gauge = deck_find(domain, "gauge"),
                           grips = deck_find(domain, "grips"), notch = deck_find(domain, "notch"),
                           hole = deck_find(domain, "hole");
    if (size.index && specimen_is_round(specimen))
        read_round_size(domain, size, specimen);
    else if (size.index)
        read_flat_size(domain, size, specimen);
    if (shapes[specimen->shape].heads) deck_get(domain, "gauge"); /* dies where it is missing */
    if (gauge.index) read_gauge(gauge, specimen);
    if (grips.index) read_grips(grips, specimen);
    if (notch.index) read_notch(notch, specimen);
    if (hole.index) read_hole(hole, specimen);
}

/* --- the body --------------------------------------------------------------------------------- */

bool specimen_is_sheet(const struct specimen *specimen)
{
    return specimen->dimensions == 2;
}

bool specimen_is_round(const struct specimen *specimen)
{
    return shapes[specimen->shape].round;
}

bool specimen_is_block(const struct specimen *specimen)
{
    struct pocket pockets[2];
    return !specimen_is_round(specimen) && specimen_pockets(specimen, pockets) == 0 &&
           !(specimen->hole_diameter > 0) && specimen->angle == 0;
}

int specimen_pockets(const struct specimen *specimen, struct pocket pockets[2])
{
    double half = 0.5 * specimen->size[1];
    int count = 0;
    if (shapes[specimen->shape].heads) {
        pockets[count++] = (struct pocket){0.5 * specimen->gauge_length,
                                           0.5 * specimen->gauge_width, specimen->fillet, half};
        half = 0.5 * specimen->gauge_width;
    }
    if (specimen->notch_depth > 0)
        pockets[count++] =
            (struct pocket){0, half - specimen->notch_depth, specimen->notch_radius, half};
    return count;
}

double specimen_half_width(const struct specimen *specimen, double x)
{
    struct pocket pockets[2];
    const int count = specimen_pockets(specimen, pockets);
    double half = 0.5 * specimen->size[1];
    for (int i = 0; i < count; i++) {
        const struct pocket *pocket = &pockets[i];
        const double beyond = fabs(x) - pocket->length, radius = pocket->radius;
        double here = half;
        if (beyond <= 0)
            here = pocket->bottom;
        else if (beyond < radius)
            here = pocket->bottom + radius - sqrt(radius * radius - beyond * beyond);
        half = fmin(half, here);
    }
    return half;
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

void specimen_repeats(const struct specimen *specimen, struct sites *sites)
{
    for (int axis = 0; axis < 3; axis++) {
        sites->periodic[axis] = specimen->periodic[axis];
        sites->mirrored[axis] = specimen->symmetry[axis];
    }
}

uint8_t *specimen_counted(const struct specimen *specimen, const struct sites *sites)
{
    uint8_t *counted = memory_new((size_t)sites->n_nodes, sizeof *counted);
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        double at[3];
        sites_in_body(sites, node, at);
        counted[node] = !(specimen->grip_length > 0) ||
                        fabs(at[0]) < 0.5 * specimen->size[0] - specimen->grip_length;
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
