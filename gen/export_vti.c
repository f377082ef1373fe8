/* VTK's XML image, as DAMASK and ParaView read it: a voxel a cell with its phase as `material`,
 * counted from 0 in the order of the deck, and its `grain` where ids are known.  Cells without a
 * node have the number behind the last phase, and the grain 0. */
#include "export.h"

#include "die.h"
#include "memory.h"
#include "scalars.h"

#include <stdlib.h>
#include <string.h>

/* Blocks that are packed one by one, as VTK does. */
enum { BLOCK = 1 << 15, WORD = 8 };

static void put_word(unsigned char *bytes, uint64_t word)
{
    for (int i = 0; i < WORD; i++) bytes[i] = (unsigned char)(word >> 8 * i);
}

static void write_text(FILE *file, const unsigned char *bytes, size_t length)
{
    char *text = scalars_base64_text(bytes, length);
    fputs(text, file);
    free(text);
}

/* Whole numbers of 8 bytes, the lowest first: a head with the number of blocks, their length, that
 * of a shorter last one, the packed lengths; then the blocks. */
static void write_array(FILE *file, const char *name, const unsigned char *bytes, size_t length)
{
    enum { ROOM = BLOCK + BLOCK / 64 + 64 }; /* of a packed block, whatever is in it */
    const size_t blocks = (length + BLOCK - 1) / BLOCK;
    unsigned char *head = memory_new((3 + blocks) * WORD, 1);
    unsigned char *packed = memory_new(blocks * ROOM, 1);
    size_t total = 0;
    put_word(head, blocks);
    put_word(head + WORD, BLOCK);
    put_word(head + 2 * WORD, length % BLOCK);
    for (size_t b = 0; b < blocks; b++) {
        const size_t left = length - b * BLOCK;
        size_t wide;
        unsigned char *part =
            scalars_deflate(bytes + b * BLOCK, left < BLOCK ? left : BLOCK, &wide);
        put_word(head + (3 + b) * WORD, wide);
        memcpy(packed + total, part, wide);
        free(part);
        total += wide;
    }
    fprintf(file, "        <DataArray type=\"Int64\" Name=\"%s\" format=\"binary\">\n          ",
            name);
    write_text(file, head, (3 + blocks) * WORD);
    write_text(file, packed, total);
    fprintf(file, "\n        </DataArray>\n");
    free(head);
    free(packed);
}

static void write_values(const struct export_source *source, FILE *file, bool grains)
{
    const struct structure *structure = source->structure;
    const struct sites *sites = structure->sites;
    const int64_t number = sites_number(sites->count);
    unsigned char *bytes = memory_new((size_t)number, WORD);
    for (int64_t site = 0; site < number; site++) {
        const int64_t node = sites->node[site];
        const int64_t none = grains ? 0 : source->recipe->n_phases;
        const int64_t value = node < 0 ? none
                              : grains ? structure->grain[node]
                                       : structure->phase[node];
        put_word(bytes + (size_t)site * WORD, (uint64_t)value);
    }
    write_array(file, grains ? "grain" : "material", bytes, (size_t)number * WORD);
    free(bytes);
}

void export_vti(const struct export_source *source, FILE *file)
{
    const struct sites *sites = source->structure->sites;
    const int64_t *count = sites->count;
    const double *edge = sites->spacing;
    double low[3];
    for (int axis = 0; axis < 3; axis++) low[axis] = -0.5 * (double)count[axis] * edge[axis];
    fprintf(
        file,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
        "  <ImageData Unit=\"m\" WholeExtent=\"0 %lld 0 %lld 0 %lld\" Origin=\"%.17g %.17g %.17g\" "
        "Spacing=\"%.17g %.17g %.17g\">\n    <Piece Extent=\"0 %lld 0 %lld 0 %lld\">\n      "
        "<CellData "
        "Scalars=\"material\">\n",
        (long long)count[0], (long long)count[1], (long long)count[2], low[0], low[1], low[2],
        edge[0], edge[1], edge[2], (long long)count[0], (long long)count[1], (long long)count[2]);
    write_values(source, file, false);
    if (source->structure->grain) write_values(source, file, true);
    fprintf(file,
            "      </CellData>\n      <PointData/>\n    </Piece>\n  </ImageData>\n</VTKFile>\n");
    for (int phase = 0; phase < source->recipe->n_phases; phase++)
        note("material %d is %s", phase, source->recipe->phase_names[phase]);
    if (sites->n_nodes < sites_number(count))
        note("material %d is no material: cells without a node", source->recipe->n_phases);
}
