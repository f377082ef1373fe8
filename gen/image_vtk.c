/* VTK's legacy file with the data set STRUCTURED_POINTS, as text or as big-endian numbers, versions
 * 1 to 5: one array of cells, or of points, which are then taken for the middles of voxels. */
#include "image_text.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_ARRAYS = 256, WORD = 256 };

/* One array, and where its values begin. */
struct array {
    char name[WORD];
    enum scalar type;
    int components;
    bool of_cells;
    double tuples;
    struct image_text at;
};

struct vtk {
    struct image_text text;
    bool binary, of_cells, have_data;
    double dimensions[3], edge[3], tuples;
    int n_arrays;
    struct array arrays[MOST_ARRAYS];
};

/* --- arrays -------------------------------------------------------------------------------------
 */

static enum scalar type_of(struct vtk *vtk, const char *word)
{
    static const struct {
        const char *name;
        enum scalar type;
    } types[] = {
        {"char", SCALAR_INT8},          {"unsigned_char", SCALAR_UINT8},
        {"short", SCALAR_INT16},        {"unsigned_short", SCALAR_UINT16},
        {"int", SCALAR_INT32},          {"unsigned_int", SCALAR_UINT32},
        {"long", SCALAR_INT64},         {"unsigned_long", SCALAR_UINT64},
        {"vtktypeint64", SCALAR_INT64}, {"vtktypeuint64", SCALAR_UINT64},
        {"vtkIdType", SCALAR_INT32},    {"float", SCALAR_FLOAT32},
        {"double", SCALAR_FLOAT64},     {"signed_char", SCALAR_INT8},
    };
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcasecmp(types[i].name, word) == 0) return types[i].type;
    image_refuse(&vtk->text, "values of the type '%.40s' are not read (char to double are)", word);
}

/* Passes over `count` values behind this line. */
static void skip_values(struct vtk *vtk, double count, size_t size)
{
    char word[WORD];
    const double left = (double)(vtk->text.source->length - vtk->text.at);
    /* A number and its blank, which the last one may be without. */
    if (count * (vtk->binary ? (double)size : 2) > left + !vtk->binary)
        image_refuse(&vtk->text, "the file ends within an array: damaged or cut off");
    if (vtk->binary)
        vtk->text.at += (size_t)count * size;
    else
        for (double i = 0; i < count; i++)
            if (!image_word(&vtk->text, word, sizeof word))
                image_refuse(&vtk->text, "the file ends within an array");
}

static void add_array(struct vtk *vtk, const char *name, const char *type, double components,
                      double tuples)
{
    if (!(components >= 1) || components > 1e6 || !(tuples >= 0))
        image_refuse(&vtk->text, "an array of %g numbers a place", components);
    if (vtk->n_arrays == MOST_ARRAYS) image_refuse(&vtk->text, "more than 256 arrays");
    struct array *array = &vtk->arrays[vtk->n_arrays++];
    snprintf(array->name, sizeof array->name, "%s", name);
    array->type = type_of(vtk, type);
    /* A field may hold what is not of the cells: it cannot be taken. */
    array->components = tuples == vtk->tuples ? (int)components : 0;
    array->of_cells = vtk->of_cells;
    array->tuples = tuples;
    array->at = vtk->text;
    skip_values(vtk, components * tuples, scalar_size(array->type));
}

static void read_scalars(struct vtk *vtk, char *fields[], int count)
{
    char line[WORD], *words[3];
    const double components = count > 3 ? strtod(fields[3], NULL) : 1;
    const struct image_text before = vtk->text;
    /* Version 1 has the table's line too; a file without it goes on with the values. */
    if (!image_line(&vtk->text, line, sizeof line) || image_split(line, words, 3) < 1 ||
        strcasecmp(words[0], "LOOKUP_TABLE") != 0)
        vtk->text = before;
    add_array(vtk, fields[1], fields[2], components, vtk->tuples);
}

static void read_field(struct vtk *vtk, double arrays)
{
    for (double i = 0; i < arrays; i++) {
        char line[WORD], *words[4];
        int count = 0;
        do {
            if (!image_line(&vtk->text, line, sizeof line))
                image_refuse(&vtk->text, "the file ends within a field");
            count = image_split(line, words, 4);
        } while (count == 0);
        if (count < 4)
            image_refuse(&vtk->text, "expected an array's name, components, number and type");
        add_array(vtk, words[0], words[3], strtod(words[1], NULL), strtod(words[2], NULL));
    }
}

/* --- the file -----------------------------------------------------------------------------------
 */

static void read_three(struct vtk *vtk, char *fields[], int count, double out[3])
{
    if (count < 4) image_refuse(&vtk->text, "expected three numbers behind %.40s", fields[0]);
    for (int axis = 0; axis < 3; axis++) out[axis] = strtod(fields[axis + 1], NULL);
}

static void begin_data(struct vtk *vtk, const char *tuples, bool of_cells)
{
    double expected = 1;
    for (int axis = 0; axis < 3; axis++)
        expected *= of_cells ? fmax(vtk->dimensions[axis] - 1, 1) : vtk->dimensions[axis];
    vtk->tuples = strtod(tuples, NULL);
    vtk->of_cells = of_cells;
    vtk->have_data = true;
    if (vtk->tuples != expected)
        image_refuse(&vtk->text, "%.40s values, the dimensions say %.0f", tuples, expected);
}

static void skip_description(struct vtk *vtk)
{
    char line[WORD], *words[1];
    while (image_line(&vtk->text, line, sizeof line) && image_split(line, words, 1) > 0) continue;
}

static void take_attribute(struct vtk *vtk, char *fields[], int count)
{
    const struct {
        const char *name;
        int components;
    } fixed[] = {{"VECTORS", 3}, {"NORMALS", 3}, {"TENSORS", 9}};
    const char *keyword = fields[0];
    for (int i = 0; i < 3; i++)
        if (strcasecmp(keyword, fixed[i].name) == 0 && count >= 3) {
            add_array(vtk, fields[1], fields[2], fixed[i].components, vtk->tuples);
            return;
        }
    if (strcasecmp(keyword, "SCALARS") == 0 && count >= 3)
        read_scalars(vtk, fields, count);
    else if (strcasecmp(keyword, "FIELD") == 0 && count >= 3)
        read_field(vtk, strtod(fields[2], NULL));
    else if (strcasecmp(keyword, "TEXTURE_COORDINATES") == 0 && count >= 4)
        add_array(vtk, fields[1], fields[3], strtod(fields[2], NULL), vtk->tuples);
    else if (strcasecmp(keyword, "COLOR_SCALARS") == 0 && count >= 3)
        skip_values(vtk, strtod(fields[2], NULL) * vtk->tuples, 1);
    else if (strcasecmp(keyword, "LOOKUP_TABLE") == 0 && count >= 3)
        skip_values(vtk, 4 * strtod(fields[2], NULL), 1);
    else
        image_refuse(&vtk->text, "found '%.40s', expected SCALARS, FIELD or another attribute",
                     keyword);
}

static void take_line(struct vtk *vtk, char *fields[], int count)
{
    const char *keyword = fields[0];
    if (strcasecmp(keyword, "DATASET") == 0) {
        if (count < 2 || strcasecmp(fields[1], "STRUCTURED_POINTS") != 0)
            image_refuse(&vtk->text,
                         "the data set %.40s is no regular grid: STRUCTURED_POINTS is read",
                         count < 2 ? "" : fields[1]);
    } else if (strcasecmp(keyword, "DIMENSIONS") == 0) {
        read_three(vtk, fields, count, vtk->dimensions);
    } else if (strcasecmp(keyword, "SPACING") == 0 || strcasecmp(keyword, "ASPECT_RATIO") == 0) {
        read_three(vtk, fields, count, vtk->edge);
    } else if (strcasecmp(keyword, "ORIGIN") == 0) {
        return;
    } else if (strcasecmp(keyword, "METADATA") == 0) {
        skip_description(vtk);
    } else if (strcasecmp(keyword, "CELL_DATA") == 0 && count > 1) {
        begin_data(vtk, fields[1], true);
    } else if (strcasecmp(keyword, "POINT_DATA") == 0 && count > 1) {
        begin_data(vtk, fields[1], false);
    } else if (!vtk->have_data && strcasecmp(keyword, "FIELD") == 0 && count > 2) {
        vtk->tuples = -1; /* of the whole file, none of the cells */
        read_field(vtk, strtod(fields[2], NULL));
    } else {
        take_attribute(vtk, fields, count);
    }
}

static void read_all(struct vtk *vtk)
{
    char line[WORD], *fields[6];
    image_line(&vtk->text, line, sizeof line); /* the version */
    image_line(&vtk->text, line, sizeof line); /* a title */
    char word[WORD];
    while (image_line(&vtk->text, line, sizeof line) && sscanf(line, "%255s", word) != 1) continue;
    vtk->binary = strncasecmp(line, "BINARY", 6) == 0;
    if (!vtk->binary && strncasecmp(line, "ASCII", 5) != 0)
        image_refuse(&vtk->text, "found '%.40s', expected ASCII or BINARY", line);
    while (image_line(&vtk->text, line, sizeof line)) {
        const int count = image_split(line, fields, 6);
        if (count > 0) take_line(vtk, fields, count < 6 ? count : 6);
    }
}

static const struct array *choose(const struct vtk *vtk)
{
    const struct array *offered[MOST_ARRAYS];
    struct image_array names[MOST_ARRAYS];
    int of_cells = 0, n = 0;
    for (int i = 0; i < vtk->n_arrays; i++)
        of_cells += vtk->arrays[i].of_cells && vtk->arrays[i].components == 1;
    for (int i = 0; i < vtk->n_arrays; i++) {
        const struct array *array = &vtk->arrays[i];
        if (!vtk->text.source->array && of_cells > 0 && !array->of_cells) continue;
        offered[n] = array;
        names[n++] = (struct image_array){array->name, array->components};
    }
    return offered[image_choose(vtk->text.source, names, n)];
}

void image_vtk_read(const struct image_source *source, struct image *image)
{
    struct vtk *vtk = memory_new(1, sizeof *vtk);
    double count[3];
    vtk->text = image_text_of(source);
    read_all(vtk);
    struct array array = *choose(vtk);
    for (int axis = 0; axis < 3; axis++) {
        image->edge[axis] = vtk->edge[axis];
        count[axis] = array.of_cells ? fmax(vtk->dimensions[axis] - 1, 1) : vtk->dimensions[axis];
    }
    image_size(source, image, count, (double)source->length);
    const int64_t voxels = image_voxels(image);
    if (array.tuples != (double)voxels)
        image_refuse(&array.at, "%.0f values, the dimensions say %lld", array.tuples,
                     (long long)voxels);
    if (vtk->binary)
        scalars_decode(source->bytes + array.at.at, voxels, array.type, true, image->value);
    else
        image_numbers(&array.at, "a number", voxels, image->value);
    free(vtk);
}
