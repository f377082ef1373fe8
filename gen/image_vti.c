/* VTK's XML image (.vti), as ParaView and DAMASK write it: values as text, in base 64 or appended,
 * raw or packed by zlib, in either order of bytes.  One array of cells, or of points, which are
 * then taken for the middles of voxels; whole or in pieces, of which those of points share planes.
 */
#include "image.h"

#include "die.h"
#include "memory.h"
#include "xml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ARRAYS = 256 };

/* One DataArray. */
struct data_array {
    struct xml_tag tag;
    char *name;
    int components, piece;
    bool of_cells;
};

struct vti {
    const struct image_source *source;
    struct xml_tag file, grid, *pieces, appended;
    int n_pieces, n_arrays;
    struct data_array *arrays;
    bool big_endian, packed, wide; /* wide: lengths of 8 bytes */
};

static _Noreturn void refuse(const struct vti *vti, const char *what)
{
    die_user("%s: %s", vti->source->path, what);
}

/* --- the tags -----------------------------------------------------------------------------------
 */

static void add_array(struct vti *vti, const struct xml_tag *tag, bool of_cells)
{
    if (vti->n_pieces == 1 && vti->n_arrays == MOST_ARRAYS) refuse(vti, "more than 256 arrays");
    vti->arrays = memory_grow(vti->arrays, vti->n_arrays, sizeof *vti->arrays);
    struct data_array *array = &vti->arrays[vti->n_arrays++];
    char *components = xml_attribute(tag, "NumberOfComponents");
    char *name = xml_attribute(tag, "Name");
    *array = (struct data_array){*tag, name ? name : memory_text("without a name"),
                                 components ? atoi(components) : 1, vti->n_pieces - 1, of_cells};
    free(components);
}

static void read_tags(struct vti *vti)
{
    struct xml xml = xml_of((const char *)vti->source->bytes, vti->source->length);
    struct xml_tag tag;
    bool cells = false, points = false;
    while (!vti->appended.name && xml_next(&xml, &tag)) {
        if (xml_is(&tag, "VTKFile")) vti->file = tag;
        if (xml_is(&tag, "ImageData")) vti->grid = tag;
        if (xml_is(&tag, "Piece")) {
            vti->pieces = memory_grow(vti->pieces, vti->n_pieces, sizeof tag);
            vti->pieces[vti->n_pieces++] = tag;
        }
        if (xml_is(&tag, "CellData")) cells = true;
        if (xml_is(&tag, "PointData")) points = true;
        if (xml_is(&tag, "/CellData")) cells = false;
        if (xml_is(&tag, "/PointData")) points = false;
        if (xml_is(&tag, "DataArray") && vti->n_pieces && (cells || points))
            add_array(vti, &tag, cells);
        if (xml_is(&tag, "AppendedData")) vti->appended = tag;
    }
    if (!vti->file.name || !vti->grid.name)
        refuse(vti, "a VTK file that is no ImageData, or cut off");
    if (vti->n_pieces == 0) refuse(vti, "ImageData without a Piece");
}

static bool attribute_is(const struct xml_tag *tag, const char *name, const char *value)
{
    char *found = xml_attribute(tag, name);
    const bool is = found && strcmp(found, value) == 0;
    free(found);
    return is;
}

static void read_flavour(struct vti *vti)
{
    char *compressor = xml_attribute(&vti->file, "compressor");
    if (compressor && strcmp(compressor, "vtkZLibDataCompressor") != 0)
        die_user("%s: packed by %s; vtkZLibDataCompressor is read, and what is not packed",
                 vti->source->path, compressor);
    vti->packed = compressor != NULL;
    free(compressor);
    vti->big_endian = attribute_is(&vti->file, "byte_order", "BigEndian");
    vti->wide = attribute_is(&vti->file, "header_type", "UInt64");
}

static enum scalar read_type(const struct vti *vti, const struct xml_tag *tag)
{
    static const char *const names[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                        "UInt32", "Int64", "UInt64", "Float32", "Float64"};
    for (int i = 0; i < 10; i++)
        if (attribute_is(tag, "type", names[i])) return (enum scalar)i;
    char *type = xml_attribute(tag, "type");
    die_user("%s: values of the type %s, which is no number", vti->source->path,
             type ? type : "(none)");
}

/* --- the grid -----------------------------------------------------------------------------------
 */

static bool read_list(const struct xml_tag *tag, const char *name, int count, double *out)
{
    char *text = xml_attribute(tag, name), *rest = text;
    int found = 0;
    while (rest && found < count) {
        char *end;
        out[found] = strtod(rest, &end);
        if (end == rest || !isfinite(out[found])) break;
        rest = end;
        found++;
    }
    free(text);
    return found == count;
}

/* First voxel and number of voxels of an extent, which counts the planes between cells. */
static void read_extent(const struct vti *vti, const struct xml_tag *tag, const char *name,
                        bool of_cells, double low[3], double count[3])
{
    double extent[6];
    if (!read_list(tag, name, 6, extent))
        die_user("%s: no %s of six numbers", vti->source->path, name);
    for (int axis = 0; axis < 3; axis++) {
        const double cells = extent[2 * axis + 1] - extent[2 * axis];
        low[axis] = extent[2 * axis];
        /* A picture in the plane has no cell along z, and one layer of them. */
        count[axis] = of_cells ? fmax(cells, 1) : cells + 1;
    }
}

static void read_grid(struct vti *vti, struct image *image)
{
    static const double upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    double direction[9];
    if (!read_list(&vti->grid, "Spacing", 3, image->edge))
        image->edge[0] = image->edge[1] = image->edge[2] = 0;
    /* VTK has no word for it: hsgen's own, which others leave aside. */
    if (attribute_is(&vti->grid, "Unit", "m")) image->unit = "m";
    if (read_list(&vti->grid, "Direction", 9, direction) &&
        memcmp(direction, upright, sizeof upright) != 0)
        refuse(vti, "its axes are turned (Direction); resample it along x, y and z first");
}

/* --- values -------------------------------------------------------------------------------------
 */

/* Bytes of the array with their head in front, base 64 undone; the caller frees them. */
static unsigned char *bytes_of(const struct vti *vti, const struct xml_tag *tag, size_t *length)
{
    const char *text = xml_content(tag, length);
    bool raw = false;
    if (attribute_is(tag, "format", "appended")) {
        const char *end = (const char *)vti->source->bytes + vti->source->length;
        double offset;
        const char *from = vti->appended.name
                               ? memchr(vti->appended.end, '_', (size_t)(end - vti->appended.end))
                               : NULL;
        if (!from || !read_list(tag, "offset", 1, &offset) || offset < 0 ||
            offset >= (double)(end - from - 1))
            refuse(vti, "an array's offset leads beyond the file: damaged or cut off");
        text = from + 1 + (size_t)offset;
        *length = (size_t)(end - text);
        raw = attribute_is(&vti->appended, "encoding", "raw");
    }
    if (!raw) return scalars_base64(text, *length, length);
    unsigned char *bytes = memory_new(*length + 1, 1);
    return memcpy(bytes, text, *length);
}

static double head_at(const struct vti *vti, const unsigned char *bytes, size_t i)
{
    const enum scalar type = vti->wide ? SCALAR_UINT64 : SCALAR_UINT32;
    return scalar_at(bytes + i * scalar_size(type), type, vti->big_endian);
}

/* Blocks, each packed on its own: a head with their number, their length, that of the last one
 * where it is less, and the packed lengths. */
static unsigned char *unpack(const struct vti *vti, const unsigned char *bytes, size_t length,
                             size_t wanted)
{
    const size_t word = vti->wide ? 8 : 4;
    const char damaged[] = "damaged or cut off: its packed blocks are not whole";
    if (length < 3 * word) refuse(vti, damaged);
    const double n = head_at(vti, bytes, 0), block = head_at(vti, bytes, 1),
                 last = head_at(vti, bytes, 2);
    const double whole = last > 0 ? n - 1 : n;
    if (n * (double)word + 3 * (double)word > (double)length ||
        whole * block + last != (double)wanted)
        refuse(vti, damaged);
    unsigned char *out = memory_new(wanted + 1, 1);
    size_t from = (3 + (size_t)n) * word, to = 0;
    for (size_t b = 0; b < (size_t)n; b++) {
        const double packed = head_at(vti, bytes, 3 + b);
        const size_t size = (double)b < whole ? (size_t)block : (size_t)last;
        if (packed > (double)(length - from)) refuse(vti, damaged);
        unsigned char *part = scalars_inflate(bytes + from, (size_t)packed, size);
        if (!part) refuse(vti, damaged);
        memcpy(out + to, part, size);
        free(part);
        from += (size_t)packed;
        to += size;
    }
    return out;
}

static void read_bytes(const struct vti *vti, const struct xml_tag *tag, struct image *image)
{
    const enum scalar type = read_type(vti, tag);
    const size_t wanted = (size_t)image_voxels(image) * scalar_size(type);
    const size_t word = vti->wide ? 8 : 4;
    size_t length;
    unsigned char *bytes = bytes_of(vti, tag, &length);
    if (vti->packed) {
        unsigned char *values = unpack(vti, bytes, length, wanted);
        scalars_decode(values, image_voxels(image), type, vti->big_endian, image->value);
        free(values);
    } else {
        if (length < word || head_at(vti, bytes, 0) != (double)wanted || length - word < wanted)
            refuse(vti, "damaged or cut off: an array is not as long as the image");
        scalars_decode(bytes + word, image_voxels(image), type, vti->big_endian, image->value);
    }
    free(bytes);
}

static void read_text(const struct vti *vti, const struct xml_tag *tag, struct image *image)
{
    size_t length;
    const char *text = xml_content(tag, &length);
    char *copy = memory_print("%.*s", (int)length, text), *rest = copy;
    const int64_t voxels = image_voxels(image);
    for (int64_t i = 0; i < voxels; i++) {
        char *end;
        image->value[i] = strtod(rest, &end);
        if (end == rest)
            die_user("%s: %lld numbers of an array, expected %lld", vti->source->path, (long long)i,
                     (long long)voxels);
        rest = end;
    }
    if (rest[strspn(rest, " \t\r\n")])
        die_user("%s: more than the %lld numbers of an array", vti->source->path,
                 (long long)voxels);
    free(copy);
}

/* Arrays of cells where there are any that can be taken, else those of points; a name finds either.
 */
static const struct data_array *choose(const struct vti *vti)
{
    const struct data_array *offered[MOST_ARRAYS];
    struct image_array names[MOST_ARRAYS];
    int of_cells = 0, n = 0;
    for (int i = 0; i < vti->n_arrays; i++)
        of_cells +=
            vti->arrays[i].piece == 0 && vti->arrays[i].of_cells && vti->arrays[i].components == 1;
    for (int i = 0; i < vti->n_arrays; i++) {
        if (vti->arrays[i].piece > 0) continue;
        if (!vti->source->array && of_cells > 0 && !vti->arrays[i].of_cells) continue;
        offered[n] = &vti->arrays[i];
        names[n++] = (struct image_array){vti->arrays[i].name, vti->arrays[i].components};
    }
    return offered[image_choose(vti->source, names, n)];
}

/* --- pieces -------------------------------------------------------------------------------------
 */

static const struct data_array *array_of_piece(const struct vti *vti, const struct data_array *like,
                                               int piece)
{
    for (int i = 0; i < vti->n_arrays; i++) {
        const struct data_array *array = &vti->arrays[i];
        if (array->piece == piece && array->of_cells == like->of_cells &&
            strcmp(array->name, like->name) == 0)
            return array;
    }
    die_user("%s: piece %d has no array '%s'", vti->source->path, piece + 1, like->name);
}

static double most_voxels(const struct vti *vti)
{
    return (double)vti->source->length * (vti->packed ? SCALARS_INFLATION : 1);
}

static void read_values(const struct vti *vti, const struct data_array *array,
                        const double count[3], struct image *image)
{
    image_size(vti->source, image, count, most_voxels(vti));
    (attribute_is(&array->tag, "format", "ascii") ? read_text : read_bytes)(vti, &array->tag,
                                                                            image);
}

/* Puts the values of a piece where they belong: first voxel and number of voxels. */
static void place(const struct vti *vti, int number, bool of_cells, const struct image *piece,
                  const double first[3], struct image *image, bool *seen)
{
    const int64_t *n = image->count;
    int64_t at = 0;
    for (int axis = 0; axis < 3; axis++)
        if (!(first[axis] >= 0 && first[axis] + (double)piece->count[axis] <= (double)n[axis]))
            die_user("%s: piece %d reaches beyond WholeExtent along %c", vti->source->path, number,
                     'x' + axis);
    const int64_t x0 = (int64_t)first[0], y0 = (int64_t)first[1], z0 = (int64_t)first[2];
    for (int64_t z = z0; z < z0 + piece->count[2]; z++)
        for (int64_t y = y0; y < y0 + piece->count[1]; y++)
            for (int64_t x = x0; x < x0 + piece->count[0]; x++, at++) {
                const int64_t voxel = (z * n[1] + y) * n[0] + x;
                double *value = &image->value[voxel];
                if (seen[voxel] && (of_cells || memcmp(value, &piece->value[at], sizeof *value)))
                    die_user("%s: piece %d and one before it both have the voxel (%lld, %lld, "
                             "%lld), counted from 0",
                             vti->source->path, number, (long long)x, (long long)y, (long long)z);
                *value = piece->value[at];
                seen[voxel] = true;
            }
}

static void read_pieces(const struct vti *vti, const struct data_array *like, struct image *image)
{
    const bool of_cells = like->of_cells;
    double origin[3], whole[3], count[3], low[3];
    read_extent(vti, &vti->grid, "WholeExtent", of_cells, origin, whole);
    read_extent(vti, &vti->pieces[0], "Extent", of_cells, low, count);
    if (vti->n_pieces == 1 && memcmp(count, whole, sizeof whole) == 0) {
        read_values(vti, like, whole, image);
        return;
    }
    image_size(vti->source, image, whole, most_voxels(vti));
    const int64_t voxels = image_voxels(image);
    bool *seen = memory_new((size_t)voxels, sizeof *seen);
    for (int p = 0; p < vti->n_pieces; p++) {
        struct image piece = {0};
        read_extent(vti, &vti->pieces[p], "Extent", of_cells, low, count);
        read_values(vti, array_of_piece(vti, like, p), count, &piece);
        for (int axis = 0; axis < 3; axis++) low[axis] -= origin[axis];
        place(vti, p + 1, of_cells, &piece, low, image, seen);
        image_free(&piece);
    }
    for (int64_t i = 0; i < voxels; i++)
        if (!seen[i])
            die_user("%s: none of its %d pieces has the voxel (%lld, %lld, %lld), counted from 0",
                     vti->source->path, vti->n_pieces, (long long)(i % image->count[0]),
                     (long long)(i / image->count[0] % image->count[1]),
                     (long long)(i / image->count[0] / image->count[1]));
    free(seen);
}

void image_vti_read(const struct image_source *source, struct image *image)
{
    struct vti vti = {.source = source};
    read_tags(&vti);
    read_flavour(&vti);
    read_grid(&vti, image);
    read_pieces(&vti, choose(&vti), image);
    for (int i = 0; i < vti.n_arrays; i++) free(vti.arrays[i].name);
    free(vti.arrays);
    free(vti.pieces);
}
