#include "image.h"

#include "die.h"
#include "memory.h"
#include "nearest.h"
#include "spool.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { LONGEST_FILE = 2000000000, MOST_VOXELS = INT32_MAX };

/* --- formats ------------------------------------------------------------------------------------
 */

/* By the first bytes, the first row that fits; `holds` stands somewhere in the first lines too,
 * NULL: nothing.  Without a reader: what is known and not read, and what would help. */
static const struct {
    const char *begins, *holds, *name;
    image_reader *read;
    const char *advice;
} formats[] = {
    {"<?xml", "\"ImageData\"", "VTI", image_vti_read, NULL},
    {"<VTKFile", "\"ImageData\"", "VTI", image_vti_read, NULL},
    {"# vtk DataFile", NULL, "legacy VTK", image_vtk_read, NULL},
    {"NRRD", NULL, "NRRD", image_nrrd_read, NULL},
    {"II*", NULL, "TIFF", image_tiff_read, NULL},
    {"II+", NULL, "TIFF", image_tiff_read, NULL},
    {"MM", NULL, "TIFF", image_tiff_read, NULL},
    {"\x89PNG", NULL, "PNG", image_png_read, NULL},
    {"\x89HDF", NULL, "DREAM3D", image_dream3d_read, NULL},
    {"***tesr", NULL, "Neper's tesr", image_tesr_read, NULL},
    {"Channel Text File", NULL, "EBSD map (ctf)", image_ctf_read, NULL},
    {"***tess", NULL, "a tessellation of Neper into polyhedra", NULL,
     "neper -T ... -format tesr writes voxels of it"},
    {"*", NULL, "Abaqus input (inp)", image_inp_read, NULL},
    {"<?xml", "<VTKFile", "a VTK file without a regular grid", NULL, "ImageData (.vti) is read"},
    {"<VTKFile", NULL, "a VTK file without a regular grid", NULL, "ImageData (.vti) is read"},
    {"<?xml", "<Xdmf", "XDMF, which points to a file with the data", NULL, "name that file"},
    {"<Xdmf", NULL, "XDMF, which points to a file with the data", NULL, "name that file"},
    {"<?xml", NULL, "XML", NULL, "VTI is read"},
    {"$MeshFormat", NULL, "a mesh of Gmsh", NULL, "a mesh is no image; write voxels"},
    {"CDF", NULL, "netCDF, Exodus perhaps", NULL,
     "a mesh is no image; hssolve reads Exodus itself"},
    {"solid ", NULL, "a surface in STL", NULL, "fill it with voxels first"},
    {"\xFF\xD8\xFF", NULL, "a picture in JPEG, whose values are smeared", NULL,
     "take what it was made of, as PNG or TIFF"},
    {"GIF8", NULL, "a picture in GIF", NULL, "save it as PNG"},
    {"BM", NULL, "a picture in BMP", NULL, "save it as PNG"},
    {"%PDF", NULL, "a PDF", NULL, "an image is needed: PNG, TIFF"},
    {"PK\3\4", NULL, "a zip archive", NULL, "unpack it"},
    {"\x1F\x8B", NULL, "compressed by gzip", NULL, "unpack it"},
    {"BZh", NULL, "compressed by bzip2", NULL, "unpack it"},
    {"\xFD"
     "7zXZ",
     NULL, "compressed by xz", NULL, "unpack it"},
    {"\x93NUMPY", NULL, "an array of NumPy", NULL,
     "write it by tofile() and describe it under raw"},
    {"MATLAB", NULL, "a MATLAB file", NULL, "write the array as raw or TIFF"},
    {"ObjectType", NULL, "MetaImage", NULL, "describe its data file under raw"},
    {"#", NULL, "EBSD map (ang)", image_ang_read, NULL},
};

bool image_begins(const struct image_source *source, const char *text)
{
    const size_t n = strlen(text);
    return source->length >= n && strncasecmp((const char *)source->bytes, text, n) == 0;
}

static bool holds(const struct image_source *source, const char *text)
{
    enum { HEAD = 4096 };
    const size_t head = source->length < HEAD ? source->length : HEAD;
    return !text || memmem(source->bytes, head, text, strlen(text));
}

static _Noreturn void refuse(const struct image_source *source)
{
    char *known = memory_text("");
    const char *last = "";
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (!formats[i].read || strcmp(formats[i].name, last) == 0) continue;
        last = formats[i].name;
        known = memory_append(known, "%s%s", *known ? ", " : "", last);
    }
    die_user("%s: not an image by its first bytes; %s are read, and values without a head where "
             "'raw' of the deck describes them",
             source->path, known);
}

static void read_by_format(const struct image_source *source, struct image *image)
{
    if (source->raw) {
        image->format = "raw";
        image_raw_read(source, image);
        return;
    }
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (!image_begins(source, formats[i].begins) || !holds(source, formats[i].holds)) continue;
        if (!formats[i].read)
            die_user("%s is %s: %s", source->path, formats[i].name, formats[i].advice);
        image->format = formats[i].name;
        formats[i].read(source, image);
        return;
    }
    refuse(source);
}

struct image image_read(const char *path, const char *array, const struct image_raw *raw)
{
    return image_is_stack(path) ? image_read_stack(path, array, raw)
                                : image_read_file(path, array, raw);
}

struct image image_read_file(const char *path, const char *array, const struct image_raw *raw)
{
    struct stat status;
    if (stat(path, &status) != 0) die_user("cannot read the image %s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode) || status.st_size > LONGEST_FILE)
        die_user("%s: images are read from a file of at most %d bytes", path, LONGEST_FILE);
    long length;
    char *text = spool_text(path, (long)status.st_size, &length);
    struct image_source source = {path, array, raw, (const unsigned char *)text, (size_t)length};
    struct image image = {0};
    /* Some editors put a mark of UTF-8 in front of text. */
    static const char mark[] = "\xEF\xBB\xBF";
    if (!raw && image_begins(&source, mark)) {
        source.bytes += strlen(mark);
        source.length -= strlen(mark);
    }
    read_by_format(&source, &image);
    free(text);
    return image;
}

void image_free(struct image *image)
{
    for (int i = 0; i < image->n_names; i++) free(image->names[i].name);
    free(image->names);
    free(image->value);
    *image = (struct image){0};
}

/* --- for readers --------------------------------------------------------------------------------
 */

int64_t image_voxels(const struct image *image)
{
    return image->count[0] * image->count[1] * image->count[2];
}

void image_size(const struct image_source *source, struct image *image, const double count[3],
                double most)
{
    const double voxels = count[0] * count[1] * count[2];
    for (int axis = 0; axis < 3; axis++)
        if (!(count[axis] >= 1) || count[axis] > MOST_VOXELS || count[axis] != floor(count[axis]))
            die_user("%s: %g x %g x %g voxels, expected whole numbers of 1 at least", source->path,
                     count[0], count[1], count[2]);
    if (voxels > MOST_VOXELS)
        die_user("%s: %.0f voxels are more than %d, which a domain can have", source->path, voxels,
                 MOST_VOXELS);
    if (voxels > most)
        die_user("%s: damaged or cut off: %g x %g x %g voxels cannot be in a file of %zu bytes",
                 source->path, count[0], count[1], count[2], source->length);
    for (int axis = 0; axis < 3; axis++) image->count[axis] = (int64_t)count[axis];
    image->value = memory_new((size_t)image_voxels(image), sizeof *image->value);
}

void image_add_name(struct image *image, double value, const char *name)
{
    image->names = memory_grow(image->names, image->n_names, sizeof *image->names);
    image->names[image->n_names++] = (struct image_name){value, memory_text(name)};
}

const char *image_name_of(const struct image *image, double value)
{
    for (int i = 0; i < image->n_names; i++)
        if (image->names[i].value == value) return image->names[i].name;
    return NULL;
}

/* "Phases, FeatureIds"; the caller frees it. */
static char *list_arrays(const struct image_array *arrays, int count)
{
    const char **names = memory_new((size_t)count + 1, sizeof *names);
    int n = 0;
    for (int i = 0; i < count; i++)
        if (arrays[i].components == 1) names[n++] = arrays[i].name;
    char *list = n ? nearest_list(names, n) : memory_text("none of one number a voxel");
    free(names);
    return list;
}

int image_choose(const struct image_source *source, const struct image_array *arrays, int count)
{
    int found = -1, scalars = 0;
    for (int i = 0; i < count; i++) {
        const bool wanted = source->array && strcmp(arrays[i].name, source->array) == 0;
        if (wanted && arrays[i].components != 1)
            die_user("%s: '%s' has %d numbers a voxel, one is needed", source->path, source->array,
                     arrays[i].components);
        if (arrays[i].components != 1 || (source->array && !wanted)) continue;
        if (scalars++ == 0) found = i;
    }
    char *list = list_arrays(arrays, count);
    if (source->array && found < 0)
        die_user("%s: there is no array '%s' in it (there are: %s)", source->path, source->array,
                 list);
    if (scalars != 1)
        die_user("%s: say by 'array' which one is meant; there are: %s", source->path, list);
    free(list);
    return found;
}
