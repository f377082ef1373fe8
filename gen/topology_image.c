/* A measured structure: a label or a grey value on each voxel of an image, which say what phase is
 * where.  Nothing is made up: size, spacing and fractions are those of the image. */
#include "findings.h"
#include "image.h"
#include "image_labels.h"
#include "memory.h"
#include "periodic.h"
#include "recipe.h"
#include "topology.h"
#include "units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MEMBER(member) .place = offsetof(struct recipe, measured.member)

static const char *const rules[] = {"nearest", "majority", NULL};
static const char *const orders[] = {"little", "big", NULL};

/* --- a file without a head ----------------------------------------------------------------------
 */

struct raw_keys {
    struct deck_node count;
    int type, order;
    int64_t skip;
};

#define RAW(member) .place = offsetof(struct raw_keys, member)
static const struct key raw_rows[] = {
    {"voxels", KEY_NODE, RAW(count), .form = "[along x, along y, along z]", .required = true,
     .help = "how many there are; x runs fastest in the file, then y, then z"},
    {"type", KEY_CHOICE, RAW(type), .names = scalar_names, .required = true,
     .help = "of the values"},
    {"order", KEY_CHOICE, RAW(order), .names = orders, .help = "of the bytes of a value"},
    {"skip", KEY_INTEGER, RAW(skip), .low = 0, .high = 2e9, .help = "bytes before the first value"},
};

static const struct section raw_section = {
    .path = "domain.raw",
    .help = "What a file without a head holds.",
    .keys = KEYS(raw_rows),
};

/* Whole numbers, as many as there are axes. */
static void read_counts(struct deck_node list, const char *key, long least, int64_t out[3])
{
    if (!deck_is_list(list) || deck_count(list) != 3)
        deck_error(list, "'%s' has three whole numbers: [along x, along y, along z]", key);
    for (int axis = 0; axis < 3; axis++)
        out[axis] = deck_integer(deck_item(list, axis), least, INT32_MAX);
}

static struct image_raw read_raw(struct deck_node map)
{
    struct raw_keys keys;
    keys_read(map, &raw_section, 0, 0, &keys, NULL);
    struct image_raw raw = {
        .type = (enum scalar)keys.type, .big_endian = keys.order == 1, .skip = keys.skip};
    read_counts(keys.count, "voxels", 1, raw.count);
    return raw;
}

/* --- keys ---------------------------------------------------------------------------------------
 */

static const struct key rows[] = {
    {"image", KEY_TEXT, MEMBER(file), .form = "file", .required = true,
     .help = "known by its first bytes; a pattern such as slices/s*.tif is a stack of files with a "
             "layer each, in the order of the numbers in their names"},
    {"array", KEY_TEXT, MEMBER(array), .form = "name", .otherwise = "the only one",
     .help = "which array of the file says what phase is where"},
    {"labels", KEY_NODE, MEMBER(words.labels), .form = "{material: label or [labels], ...}",
     .help = "the phases, in their order, and the values that are theirs: numbers, ranges such as "
             "1..12, names that the file has, colours such as #ff8000, or rest for all others; "
             "required without threshold"},
    {"threshold", KEY_NODE, MEMBER(words.threshold), .section = &image_threshold_section,
     .help = "phases of a grey image, in place of labels"},
    {"empty", KEY_NODE, MEMBER(words.empty), .form = "label or [labels]", .otherwise = "none",
     .help = "values of voxels without material, which get no node"},
    {"grains", KEY_TEXT, MEMBER(grains), .form = "name", .otherwise = "labels",
     .help =
         "array of the file with the ids that the nodes keep; without it their labels are kept"},
    {"voxel", KEY_NODE, MEMBER(voxel), .form = "m, or [x, y, z]", .otherwise = "of the file",
     .help = "edges of a voxel; one length is that along x, the others in the proportion that the "
             "file has.  Required where the file has no unit"},
    {"raw", KEY_NODE, MEMBER(raw), .section = &raw_section,
     .help = "what a file without a head holds"},
    {"crop", KEY_NODE, MEMBER(crop), .form = "[[x, y, z], [x, y, z]]", .otherwise = "all of it",
     .help = "the first voxel that is taken, counted from 0, and the first one that is not"},
    {"mirror", KEY_NODE, MEMBER(mirror), .form = "list of x, y, z", .otherwise = "none",
     .help = "axes along which the image is doubled by its mirror image, so that both ends fit "
             "where the body is periodic"},
    {"thickness", KEY_LENGTH, MEMBER(thickness), .low = 1e-12, .high = 1e3, .usual = NAN,
     .otherwise = "none", .help = "along z, of an image that is one voxel thick; required there"},
    {"resample", KEY_CHOICE, MEMBER(rule), .names = rules,
     .help = "where the spacing is not the voxel's edge.  nearest: a node is of the voxel that its "
             "centre is in; majority: of the phase, and in it of the grain, with the largest part "
             "of its cell"},
};

/* --- size ---------------------------------------------------------------------------------------
 */

static double in_metres(struct deck_node where, double edge, const char *unit)
{
    double metres = 0;
    char *text = memory_print("%.17g %s", edge, unit);
    const char *fault = units_read(text, "m", &metres);
    if (fault) deck_error(where, "the file's unit of length: %s", fault);
    free(text);
    return metres;
}

/* Edges of a voxel: the deck's word, else the file's. */
static void read_edges(struct deck_node domain, const struct measured *measured,
                       const struct image *image, double edge[3])
{
    const struct deck_node said = measured->voxel;
    const bool known = image->edge[0] > 0 && image->edge[1] > 0 && image->edge[2] > 0;
    const double least = 1e-12, most = 1e3;
    if (said.index && deck_is_list(said)) {
        if (deck_count(said) != 3) deck_error(said, "'voxel' is one length or three of them");
        for (int axis = 0; axis < 3; axis++)
            edge[axis] = deck_number(deck_item(said, axis), "m", least, most);
    } else if (said.index) {
        edge[0] = deck_number(said, "m", least, most);
        for (int axis = 1; axis < 3; axis++)
            edge[axis] = edge[0] * (known ? image->edge[axis] / image->edge[0] : 1);
    } else if (known && image->unit) {
        for (int axis = 0; axis < 3; axis++)
            edge[axis] = in_metres(deck_get(domain, "image"), image->edge[axis], image->unit);
    } else if (known) {
        deck_error(deck_get(domain, "image"),
                   "%s says that a voxel is %.9g x %.9g x %.9g, and not in what unit: add 'voxel', "
                   "such as voxel: %.9g um, or %.9g m",
                   measured->file, image->edge[0], image->edge[1], image->edge[2], image->edge[0],
                   image->edge[0]);
    } else {
        deck_error(deck_get(domain, "image"),
                   "%s does not say how large a voxel is: add 'voxel', such as voxel: 0.5 um",
                   measured->file);
    }
}

static void read_crop(const struct measured *measured, const struct image *image, int64_t low[3],
                      int64_t high[3])
{
    const struct deck_node crop = measured->crop;
    const int64_t *count = image->count;
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = 0;
        high[axis] = count[axis];
    }
    if (!crop.index) return;
    if (!deck_is_list(crop) || deck_count(crop) != 2)
        deck_error(crop, "'crop' is two corners in voxels: [[x, y, z], [x, y, z]]");
    read_counts(deck_item(crop, 0), "crop", 0, low);
    read_counts(deck_item(crop, 1), "crop", 0, high);
    for (int axis = 0; axis < 3; axis++)
        if (low[axis] >= high[axis] || high[axis] > count[axis])
            deck_error(crop,
                       "voxels %lld up to %lld along %c are not in an image of %lld x %lld x %lld",
                       (long long)low[axis], (long long)high[axis], "xyz"[axis],
                       (long long)count[0], (long long)count[1], (long long)count[2]);
}

static void set_thickness(struct deck_node domain, const struct recipe *recipe,
                          struct voxels *voxels)
{
    const double thickness = recipe->measured.thickness;
    const struct deck_node image = deck_get(domain, "image");
    if (voxels->count[2] > 1 && specimen_is_sheet(&recipe->specimen))
        deck_error(deck_get(domain, "dimensions"),
                   "the image is %lld voxels thick along z: crop it to one for a sheet",
                   (long long)voxels->count[2]);
    if (voxels->count[2] > 1 && !isnan(thickness))
        deck_error(deck_get(domain, "thickness"), "the image is %lld voxels thick along z itself",
                   (long long)voxels->count[2]);
    if (voxels->count[2] == 1 && isnan(thickness))
        deck_error(image, "the image is one voxel thick: say by 'thickness' how far the body goes "
                          "on along z");
    if (voxels->count[2] == 1) voxels->edge[2] = thickness;
}

/* Layers of another material beyond the image are added; those of the structure are within it. */
static double grips_beyond(struct deck_node domain, double spacing)
{
    const struct deck_node grips = deck_find(domain, "grips");
    if (!grips.index || strcmp(deck_string(deck_get(grips, "phase")), "structure") == 0) return 0;
    const double length = deck_length(deck_get(grips, "length"), spacing, spacing, 1e6 * spacing);
    return 2 * round(length / spacing) * spacing;
}

static void set_size(struct deck_node domain, struct recipe *recipe)
{
    struct specimen *specimen = &recipe->specimen;
    const struct voxels *voxels = &recipe->voxels;
    const bool sheet = specimen_is_sheet(specimen);
    const bool given = !isnan(specimen->spacing[0]);
    for (int axis = 0; axis < 3; axis++)
        if (!given || (axis == 2 && sheet)) specimen->spacing[axis] = voxels->edge[axis];
    if (!given && voxels->count[2] == 1 && !sheet) specimen->spacing[2] = voxels->edge[0];
    for (int axis = 0; axis < 3; axis++) {
        const double spacing = specimen->spacing[axis], size = voxels_size(voxels, axis);
        const double layers = fmax(1, round(size / spacing));
        if (fabs(size / spacing - layers) > 1e-6)
            deck_error(deck_get(domain, given ? "spacing" : "thickness"),
                       "the image is %.9g m long along %c, %.6f spacings of %.9g m: crop it to a "
                       "whole number of them, or take the spacing %.9g m",
                       size, "xyz"[axis], size / spacing, spacing, size / layers);
        specimen->count[axis] = (int64_t)layers;
        specimen->spacing[axis] = size / layers;
        specimen->size[axis] = size;
    }
    const double beyond = grips_beyond(domain, specimen->spacing[0]);
    specimen->size[0] += beyond;
    specimen->count[0] += (int64_t)llround(beyond / specimen->spacing[0]);
}

/* --- reading ------------------------------------------------------------------------------------
 */

static int64_t *read_grains(struct deck_node domain, const struct measured *measured,
                            const struct image_raw *raw, const struct image *labels)
{
    const double most = 9007199254740992.0; /* 2^53: whole numbers up to it are exact */
    const struct image *image = labels;
    struct image ids = {0};
    if (measured->grains) {
        ids = image_read(measured->file, measured->grains, raw);
        image = &ids;
        if (memcmp(ids.count, labels->count, sizeof ids.count) != 0)
            deck_error(deck_get(domain, "grains"), "the two arrays are not of one size");
    } else if (!measured->words.labels.index) {
        return NULL;
    }
    const int64_t voxels = image_voxels(image);
    int64_t *grain = memory_new((size_t)voxels, sizeof *grain);
    for (int64_t i = 0; i < voxels; i++) {
        const double value = image->value[i];
        if (!(fabs(value) <= most) || value != floor(value))
            deck_error(deck_get(domain, measured->grains ? "grains" : "labels"),
                       "the value %.9g is no whole number: no id of a grain", value);
        grain[i] = (int64_t)value;
    }
    image_free(&ids);
    return grain;
}

static void measure(struct deck_node domain, struct recipe *recipe)
{
    struct measured *measured = &recipe->measured;
    int64_t low[3], high[3];
    bool mirror[3] = {false, false, false};
    struct image_raw raw;
    if (recipe->specimen.shape != SPECIMEN_PLATE)
        deck_error(deck_get(domain, "specimen"), "an image is a plate");
    if (recipe->specimen.angle != 0)
        deck_error(deck_get(domain, "angle"), "an image lies along the lattice");
    recipe->n_phases =
        image_phases(domain, &measured->words, VOXEL_PHASES - 1, recipe->phase_names);
    if (measured->raw.index) raw = read_raw(measured->raw);
    const struct image_raw *described = measured->raw.index ? &raw : NULL;
    struct image image = image_read(measured->file, measured->array, described);
    struct voxels *voxels = &recipe->voxels;
    memcpy(voxels->count, image.count, sizeof voxels->count);
    read_edges(domain, measured, &image, voxels->edge);
    voxels->phase = image_label(&image, measured->file, &measured->words, VOXEL_EMPTY);
    voxels->grain = read_grains(domain, measured, described, &image);
    read_crop(measured, &image, low, high);
    if (measured->mirror.index) keys_axes(measured->mirror, "mirror", mirror);
    voxels_crop(voxels, low, high, mirror);
    set_thickness(domain, recipe, voxels);
    set_size(domain, recipe);
    measured->format = image.format;
    image_free(&image);
}

static char *no_fault(const struct recipe *recipe, const struct findings *findings)
{
    (void)recipe, (void)findings;
    return NULL;
}

static char *describe(const struct recipe *recipe, const struct findings *findings)
{
    const struct voxels *voxels = &recipe->voxels;
    (void)findings;
    return memory_print("image %s (%s), %lld x %lld x %lld voxels of %.6g x %.6g x %.6g um, %s",
                        recipe->measured.file, recipe->measured.format, (long long)voxels->count[0],
                        (long long)voxels->count[1], (long long)voxels->count[2],
                        1e6 * voxels->edge[0], 1e6 * voxels->edge[1], 1e6 * voxels->edge[2],
                        rules[recipe->measured.rule]);
}

const struct topology topology_image = {
    .deck = {.name = "image",
             .help = "a measured structure: phases from the labels or grey values of an image",
             .keys = KEYS(rows)},
    .no_cores = true,
    .measure = measure,
    .fault = no_fault,
    .describe = describe,
};
