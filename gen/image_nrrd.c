/* NRRD, as 3D Slicer, ITK and pynrrd write it: two or three dimensions, raw, gzip, bzip2 or text,
 * attached or in files of their own. */
#include "image_text.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { LINE = 8192, MOST_DIMENSIONS = 4 };

struct nrrd {
    struct image_text text;
    enum scalar type;
    bool have_type, have_sizes, big_endian, have_order;
    int dimensions;
    double sizes[MOST_DIMENSIONS];
    double edge[MOST_DIMENSIONS]; /* 0: not said */
    bool colour[MOST_DIMENSIONS]; /* an axis of components, which has no direction */
    char encoding[32], file[1024], unit[32];
    double line_skip, byte_skip;
};

static void read_type(struct nrrd *nrrd, const char *value)
{
    static const struct {
        const char *name;
        enum scalar type;
    } types[] = {
        {"signed char", SCALAR_INT8},
        {"int8", SCALAR_INT8},
        {"int8_t", SCALAR_INT8},
        {"uchar", SCALAR_UINT8},
        {"unsigned char", SCALAR_UINT8},
        {"uint8", SCALAR_UINT8},
        {"uint8_t", SCALAR_UINT8},
        {"short", SCALAR_INT16},
        {"short int", SCALAR_INT16},
        {"signed short", SCALAR_INT16},
        {"int16", SCALAR_INT16},
        {"int16_t", SCALAR_INT16},
        {"ushort", SCALAR_UINT16},
        {"unsigned short", SCALAR_UINT16},
        {"unsigned short int", SCALAR_UINT16},
        {"uint16", SCALAR_UINT16},
        {"uint16_t", SCALAR_UINT16},
        {"int", SCALAR_INT32},
        {"signed int", SCALAR_INT32},
        {"int32", SCALAR_INT32},
        {"int32_t", SCALAR_INT32},
        {"uint", SCALAR_UINT32},
        {"unsigned int", SCALAR_UINT32},
        {"uint32", SCALAR_UINT32},
        {"uint32_t", SCALAR_UINT32},
        {"longlong", SCALAR_INT64},
        {"long long", SCALAR_INT64},
        {"int64", SCALAR_INT64},
        {"int64_t", SCALAR_INT64},
        {"ulonglong", SCALAR_UINT64},
        {"unsigned long long", SCALAR_UINT64},
        {"uint64", SCALAR_UINT64},
        {"uint64_t", SCALAR_UINT64},
        {"float", SCALAR_FLOAT32},
        {"double", SCALAR_FLOAT64},
    };
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcasecmp(types[i].name, value) == 0) {
            nrrd->type = types[i].type;
            nrrd->have_type = true;
            return;
        }
    image_refuse(&nrrd->text, "the type '%.40s' is not read (signed char to double are)", value);
}

static void read_list(struct nrrd *nrrd, const char *value, double out[MOST_DIMENSIONS])
{
    const char *rest = value;
    for (int i = 0; i < nrrd->dimensions; i++) {
        char *end;
        out[i] = strtod(rest, &end); /* takes "nan" too, of an axis without a length */
        if (end == rest)
            image_refuse(&nrrd->text, "expected %d numbers, found '%.60s'", nrrd->dimensions,
                         value);
        rest = end;
    }
}

/* "(1,0,0) (0,1,0) none": the length of each vector, which has to lie along an axis of its own. */
static void read_directions(struct nrrd *nrrd, const char *value)
{
    const char *rest = value;
    for (int i = 0, axis = 0; i < nrrd->dimensions; i++) {
        rest += strspn(rest, " \t");
        if (strncasecmp(rest, "none", 4) == 0) {
            nrrd->colour[i] = true;
            rest += 4;
            continue;
        }
        double across = 0, along = 0;
        const char *close = strchr(rest, ')');
        if (*rest != '(' || !close)
            image_refuse(&nrrd->text, "expected vectors such as (1,0,0), found '%.60s'", rest);
        rest++;
        for (int k = 0; rest < close; k++) {
            char *end;
            const double part = strtod(rest, &end);
            if (end == rest) break;
            if (k == axis)
                along = fabs(part);
            else
                across += fabs(part);
            rest = end + strspn(end, ", \t");
        }
        if (across > 1e-6 * along)
            image_refuse(
                &nrrd->text,
                "its axes are turned (space directions): resample it along x, y and z first");
        nrrd->edge[i] = along;
        rest = close + 1;
        axis++;
    }
}

/* "Segment0_Name:=bone" and "Segment0_LabelValue:=1" of 3D Slicer. */
static void read_segment(const struct nrrd *nrrd, const char *line, struct image *image)
{
    int number = 0, length = 0;
    if (sscanf(line, "Segment%d_Name:=%n", &number, &length) < 1 || length == 0) return;
    char *key = memory_print("\nSegment%d_LabelValue:=", number);
    const unsigned char *found =
        memmem(nrrd->text.source->bytes, nrrd->text.source->length, key, strlen(key));
    double value = number + 1;
    if (found) {
        struct image_text at = nrrd->text;
        at.at = (size_t)(found - at.source->bytes) + strlen(key);
        value = image_number(&at, "the value of a segment");
    }
    free(key);
    image_add_name(image, value, line + length);
}

static void read_dimension(struct nrrd *nrrd, const char *value)
{
    nrrd->dimensions = atoi(value);
    if (nrrd->dimensions < 2 || nrrd->dimensions > MOST_DIMENSIONS)
        image_refuse(&nrrd->text, "%.20s dimensions, 2 and 3 are read", value);
}

static void take_field(struct nrrd *nrrd, const char *key, const char *value)
{
    if (strcasecmp(key, "type") == 0) read_type(nrrd, value);
    if (strcasecmp(key, "dimension") == 0) read_dimension(nrrd, value);
    if (strcasecmp(key, "sizes") == 0) {
        if (nrrd->dimensions == 0) image_refuse(&nrrd->text, "sizes before dimension");
        read_list(nrrd, value, nrrd->sizes);
        nrrd->have_sizes = true;
    }
    if (strcasecmp(key, "spacings") == 0) read_list(nrrd, value, nrrd->edge);
    if (strcasecmp(key, "space directions") == 0) read_directions(nrrd, value);
    if (strcasecmp(key, "endian") == 0) {
        nrrd->have_order = true;
        nrrd->big_endian = strcasecmp(value, "big") == 0;
    }
    if (strcasecmp(key, "encoding") == 0)
        snprintf(nrrd->encoding, sizeof nrrd->encoding, "%s", value);
    if (strcasecmp(key, "data file") == 0 || strcasecmp(key, "datafile") == 0)
        snprintf(nrrd->file, sizeof nrrd->file, "%s", value);
    if (strcasecmp(key, "space units") == 0 || strcasecmp(key, "units") == 0)
        sscanf(value, " \"%31[^\"]\"", nrrd->unit);
    if (strcasecmp(key, "line skip") == 0 || strcasecmp(key, "lineskip") == 0)
        nrrd->line_skip = strtod(value, NULL);
    if (strcasecmp(key, "byte skip") == 0 || strcasecmp(key, "byteskip") == 0)
        nrrd->byte_skip = strtod(value, NULL);
}

static void read_head(struct nrrd *nrrd, struct image *image)
{
    char line[LINE];
    image_line(&nrrd->text, line, LINE); /* NRRD000x */
    while (image_line(&nrrd->text, line, LINE) && *line) {
        char *colon = strchr(line, ':');
        if (*line == '#' || !colon) continue;
        if (colon[1] == '=') {
            read_segment(nrrd, line, image);
            continue;
        }
        *colon = '\0';
        char *value = colon + 1 + strspn(colon + 1, " \t");
        for (size_t n = strlen(value); n > 0 && (value[n - 1] == ' ' || value[n - 1] == '\t');)
            value[--n] = '\0';
        take_field(nrrd, line, value);
    }
    if (!nrrd->have_type || !nrrd->have_sizes || !*nrrd->encoding)
        image_refuse(&nrrd->text, "the head ends without type, sizes and encoding");
    if (scalar_size(nrrd->type) > 1 && !nrrd->have_order &&
        strcasecmp(nrrd->encoding, "ascii") != 0 && strcasecmp(nrrd->encoding, "txt") != 0 &&
        strcasecmp(nrrd->encoding, "text") != 0)
        image_refuse(&nrrd->text, "the head does not say the order of bytes (endian)");
}

/* --- data ---------------------------------------------------------------------------------------
 */

static char *read_detached(const struct nrrd *nrrd, size_t *length)
{
    const char *path = nrrd->text.source->path;
    if (strchr(nrrd->file, '%') || strncasecmp(nrrd->file, "LIST", 4) == 0)
        die_user("%s: its data lie in several files: make one of them", path);
    char *folder = memory_folder(path);
    const bool absolute = *nrrd->file == '/';
    char *name = absolute ? memory_text(nrrd->file) : memory_print("%s/%s", folder, nrrd->file);
    struct stat status;
    if (stat(name, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size > 2000000000)
        die_user("%s: cannot read its data file %s: %s", path, name,
                 errno ? strerror(errno) : "no plain file of at most 2e9 bytes");
    long bytes;
    char *text = spool_text(name, (long)status.st_size, &bytes);
    *length = (size_t)bytes;
    free(name);
    free(folder);
    return text;
}

static void take_values(const struct nrrd *nrrd, const struct image_source *data,
                        struct image *image)
{
    const int64_t voxels = image_voxels(image);
    const size_t wanted = (size_t)voxels * scalar_size(nrrd->type);
    const char *path = data->path, *encoding = nrrd->encoding;
    const bool gzip = strcasecmp(encoding, "gzip") == 0 || strcasecmp(encoding, "gz") == 0;
    size_t skip = nrrd->byte_skip > 0 ? (size_t)nrrd->byte_skip : 0;
    if (strcasecmp(encoding, "raw") == 0) {
        if (nrrd->byte_skip == -1 && data->length >= wanted) skip = data->length - wanted;
        if (skip > data->length || data->length - skip < wanted)
            die_user("%s: damaged or cut off: %zu bytes of values, expected %zu", path,
                     data->length, wanted + skip);
        scalars_decode(data->bytes + skip, voxels, nrrd->type, nrrd->big_endian, image->value);
    } else if (gzip || strcasecmp(encoding, "bzip2") == 0 || strcasecmp(encoding, "bz2") == 0) {
        unsigned char *values =
            (gzip ? scalars_inflate : scalars_bunzip)(data->bytes, data->length, wanted);
        if (!values) die_user("%s: its packed values are damaged or not those of its sizes", path);
        scalars_decode(values, voxels, nrrd->type, nrrd->big_endian, image->value);
        free(values);
    } else if (strcasecmp(encoding, "ascii") == 0 || strcasecmp(encoding, "text") == 0 ||
               strcasecmp(encoding, "txt") == 0) {
        struct image_text text = image_text_of(data);
        image_numbers(&text, "a number", voxels, image->value);
    } else {
        die_user("%s: encoding %.20s is not read (raw, gzip, bzip2 and ascii are): save it as one "
                 "of these",
                 path, encoding);
    }
}

/* Passes over lines. */
static void skip_lines(const struct nrrd *nrrd, struct image_source *data)
{
    for (double i = 0; i < nrrd->line_skip; i++) {
        const unsigned char *end = memchr(data->bytes, '\n', data->length);
        if (!end) die_user("%s: fewer lines than its 'line skip'", data->path);
        data->length -= (size_t)(end + 1 - data->bytes);
        data->bytes = end + 1;
    }
}

static void set_grid(const struct nrrd *nrrd, struct image *image, double count[3])
{
    int axis = 0;
    for (int i = 0; i < nrrd->dimensions; i++) {
        if (nrrd->colour[i] && nrrd->sizes[i] == 1) continue;
        if (nrrd->colour[i] || axis == 3)
            image_refuse(&nrrd->text, "more than one value a voxel, one is needed");
        image->edge[axis] = nrrd->edge[i] > 0 ? nrrd->edge[i] : 0;
        count[axis++] = nrrd->sizes[i];
    }
    if (axis == 2) {
        count[2] = 1;
        image->edge[2] = image->edge[0];
    }
}

static const char *unit_of(const char *said)
{
    static const char *const known[][2] = {
        {"um", "um"}, {"micron", "um"}, {"microns", "um"},    {"mm", "mm"},
        {"nm", "nm"}, {"m", "m"},       {"micrometer", "um"}, {"millimeter", "mm"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcasecmp(known[i][0], said) == 0) return known[i][1];
    return NULL;
}

void image_nrrd_read(const struct image_source *source, struct image *image)
{
    struct nrrd nrrd = {.text = image_text_of(source)};
    double count[3] = {1, 1, 1};
    read_head(&nrrd, image);
    set_grid(&nrrd, image, count);
    image->unit = unit_of(nrrd.unit);
    struct image_source data = *source;
    char *detached = NULL;
    if (*nrrd.file) {
        detached = read_detached(&nrrd, &data.length);
        data.bytes = (unsigned char *)detached;
    } else {
        data.bytes += nrrd.text.at;
        data.length -= nrrd.text.at;
    }
    skip_lines(&nrrd, &data);
    image_size(&data, image, count, (double)data.length * SCALARS_INFLATION);
    if (source->array) die_user("%s: NRRD has one array, without a name", source->path);
    take_values(&nrrd, &data, image);
    free(detached);
}
