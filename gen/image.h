/* image.h - measured structures: a value on each voxel of a box, read from files of other programs.
 *
 * A format is one file gen/image_FORMAT.c and one row of the table in image.c, by which it is known
 * from its first bytes.  A reader takes what it understands, whole, and refuses all else by name:
 * exit 2, with what would do. */
#ifndef HS_IMAGE_H
#define HS_IMAGE_H

#include "scalars.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A value that has a name in the file: a phase, a segment, a set of elements. */
struct image_name {
    double value;
    char *name;
};

struct image {
    const char *format; /* of the file, for people */
    int64_t count[3];   /* voxels along x, y, z; a picture in the plane has one along z */
    double edge[3];     /* of a voxel; 0: the file does not say */
    const char *unit;   /* of the edges, such as "um"; NULL: the file does not say */
    double *value;      /* [count[0] * count[1] * count[2]] x fastest, then y, then z */
    int n_names;
    struct image_name *names;
};

/* How a file without a head is written. */
struct image_raw {
    int64_t count[3];
    enum scalar type;
    bool big_endian;
    int64_t skip; /* bytes before the first value */
};

/* What is read, and of it which array. */
struct image_source {
    const char *path;  /* in messages */
    const char *array; /* NULL: the only one that there is */
    const struct image_raw *raw;
    const unsigned char *bytes; /* the whole file */
    size_t length;
};

/* Reads a file in whatever format it is, or a stack of files with a layer each, whose path is a
 * pattern with * or ?; raw: NULL where the file says itself what it holds. */
struct image image_read(const char *path, const char *array, const struct image_raw *raw);
struct image image_read_file(const char *path, const char *array, const struct image_raw *raw);
bool image_is_stack(const char *path);
struct image image_read_stack(const char *pattern, const char *array, const struct image_raw *raw);
void image_free(struct image *image);

int64_t image_voxels(const struct image *image);

/* The name of a value, NULL where it has none. */
const char *image_name_of(const struct image *image, double value);

/* --- for readers --------------------------------------------------------------------------------
 */

/* Enters the size of the image and makes room for its values.  Dies unless there is a voxel at
 * least and no more than `most` (what the file can hold) or fit into a domain. */
void image_size(const struct image_source *source, struct image *image, const double count[3],
                double most);

void image_add_name(struct image *image, double value, const char *name);

/* One array that a file offers. */
struct image_array {
    const char *name;
    int components; /* of one value, which alone can be taken */
};

/* Index of the array that the source asks for; without a wish the only one of one component.  Dies
 * naming those that there are. */
int image_choose(const struct image_source *source, const struct image_array *arrays, int count);

bool image_begins(const struct image_source *source, const char *text);

/* Each reads all of the image or dies. */
typedef void image_reader(const struct image_source *source, struct image *image);
#define IMAGE_READERS(DO)                                                                          \
    DO(vti), DO(vtk), DO(raw), DO(nrrd), DO(tiff), DO(png), DO(dream3d), DO(tesr), DO(ctf),        \
        DO(ang), DO(inp)
#define IMAGE_READER(format) image_##format##_read
extern image_reader IMAGE_READERS(IMAGE_READER);

#endif
