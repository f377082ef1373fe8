/* DREAM3D's HDF5 (.dream3d, FileVersion 7 of SIMPL, 8 of DREAM3D-NX): an array of cells, shaped
 * (z, y, x, 1), by its name or path; or one of features, shaped (features, 1), such as their
 * phases, which the cells' FeatureIds then look up. */
#include "image.h"

#include "die.h"
#include "memory.h"

#define H5_USE_110_API /* one signature of H5Ovisit with all versions */
#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SETS = 1024 };

struct data_set {
    char *path;
    int rank;
    hsize_t shape[4];
};

struct dream3d {
    const struct image_source *source;
    hid_t file;
    int count;
    struct data_set sets[MOST_SETS];
};

static _Noreturn void refuse(const struct dream3d *dream3d, const char *what)
{
    die_user("%s: %s", dream3d->source->path, what);
}

/* --- the tree -----------------------------------------------------------------------------------
 */

static const char *last_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Keeps arrays of numbers: cells have four dimensions, features two. */
static herr_t visit(hid_t at, const char *name, const H5O_info_t *info, void *all)
{
    struct dream3d *dream3d = all;
    if (info->type != H5O_TYPE_DATASET || dream3d->count == MOST_SETS) return 0;
    const hid_t set = H5Dopen(at, name, H5P_DEFAULT);
    if (set < 0) return 0;
    const hid_t space = H5Dget_space(set), type = H5Dget_type(set);
    const H5T_class_t class = H5Tget_class(type);
    const int rank = H5Sget_simple_extent_ndims(space);
    if ((rank == 4 || rank == 2) && (class == H5T_INTEGER || class == H5T_FLOAT)) {
        struct data_set *found = &dream3d->sets[dream3d->count++];
        found->path = memory_print("/%s", name);
        found->rank = rank;
        H5Sget_simple_extent_dims(space, found->shape, NULL);
    }
    H5Tclose(type);
    H5Sclose(space);
    H5Dclose(set);
    return 0;
}

static bool is_cells(const struct data_set *set)
{
    return set->rank == 4;
}

static bool has_cells(const struct dream3d *dream3d)
{
    bool any = false;
    for (int i = 0; i < dream3d->count; i++) any = any || is_cells(&dream3d->sets[i]);
    return any;
}

/* By its name, or by the end of its path from some group on. */
static bool is_named(const struct data_set *set, const char *name)
{
    const size_t path = strlen(set->path), wanted = strlen(name);
    const char *end = set->path + (path > wanted ? path - wanted : 0);
    return strcmp(end, name) == 0 && (path <= wanted || *name == '/' || end[-1] == '/');
}

/* Of arrays with one name those of cells come first; two of them are told apart by their paths. */
static const struct data_set *choose(const struct dream3d *dream3d)
{
    struct image_array *arrays = memory_new(MOST_SETS, sizeof *arrays);
    const char *wanted = dream3d->source->array;
    const struct data_set *chosen[2] = {NULL, NULL}; /* of cells, of features */
    int n = 0, twice = 0;
    for (int i = 0; i < dream3d->count; i++) {
        const struct data_set *set = &dream3d->sets[i];
        const bool one = set->shape[set->rank - 1] == 1, cells = is_cells(set);
        if (cells)
            arrays[n++] =
                (struct image_array){wanted ? set->path : last_name(set->path), one ? 1 : 3};
        if (!wanted || !one || !is_named(set, wanted)) continue;
        twice += cells && chosen[0];
        chosen[cells ? 0 : 1] = set;
    }
    if (twice)
        die_user("%s: several arrays are called '%s': say its whole path", dream3d->source->path,
                 wanted);
    if (wanted && !chosen[0] && !chosen[1]) image_choose(dream3d->source, arrays, n); /* dies */
    if (!wanted) {
        const char *name = arrays[image_choose(dream3d->source, arrays, n)].name;
        for (int i = 0; i < dream3d->count; i++)
            if (is_cells(&dream3d->sets[i]) && is_named(&dream3d->sets[i], name))
                chosen[0] = &dream3d->sets[i];
    }
    free(arrays);
    return chosen[0] ? chosen[0] : chosen[1];
}

/* --- numbers ------------------------------------------------------------------------------------
 */

static double *read_set(const struct dream3d *dream3d, const struct data_set *set, int64_t *count)
{
    const hid_t at = H5Dopen(dream3d->file, set->path, H5P_DEFAULT);
    double number = 1;
    for (int i = 0; i < set->rank; i++) number *= (double)set->shape[i];
    if (at < 0 || !(number >= 1) || number > (double)INT32_MAX ||
        number > SCALARS_INFLATION * (double)dream3d->source->length)
        refuse(dream3d, "damaged or cut off: an array is larger than the file can hold");
    double *values = memory_new((size_t)number, sizeof *values);
    if (H5Dread(at, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        refuse(dream3d, "damaged: an array cannot be read");
    H5Dclose(at);
    *count = (int64_t)number;
    return values;
}

/* Up to `most` numbers of a small array or attribute; returns how many, 0 where there are none. */
static int read_few(hid_t at, const char *name, bool attribute, int most, double *out)
{
    const hid_t item = attribute ? H5Aopen(at, name, H5P_DEFAULT) : H5Dopen(at, name, H5P_DEFAULT);
    if (item < 0) return 0;
    const hid_t space = attribute ? H5Aget_space(item) : H5Dget_space(item);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    int read = 0;
    if (count > 0 && count <= most) {
        const herr_t status =
            attribute ? H5Aread(item, H5T_NATIVE_DOUBLE, out)
                      : H5Dread(item, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out);
        read = status < 0 ? 0 : (int)count;
    }
    H5Sclose(space);
    if (attribute)
        H5Aclose(item);
    else
        H5Dclose(item);
    return read;
}

/* The edge of layers between bounds, which has to be one for all of them. */
static double edge_of(const struct dream3d *dream3d, const double *bound, int bounds)
{
    const double edge = (bound[bounds - 1] - bound[0]) / (bounds - 1);
    for (int i = 1; i < bounds; i++)
        if (fabs(bound[i] - bound[i - 1] - edge) > 1e-3 * edge)
            refuse(dream3d, "its grid has layers of different thickness (RectGrid): resample it to "
                            "an ImageGeom");
    return edge;
}

/* The group of an array's container, or of its geometry. */
static hid_t container_of(const struct dream3d *dream3d, const struct data_set *set)
{
    char *path = memory_text(set->path);
    for (int up = 0; up < 2; up++) {
        char *slash = strrchr(path, '/');
        if (slash && slash != path) *slash = '\0';
    }
    const hid_t group = H5Gopen(dream3d->file, path, H5P_DEFAULT);
    free(path);
    return group;
}

static void read_edges(const struct dream3d *dream3d, const struct data_set *set,
                       struct image *image)
{
    enum { MOST_BOUNDS = 100001 };
    static const char *const bounds[] = {"xBounds", "yBounds", "zBounds"};
    const hid_t container = container_of(dream3d, set);
    if (container < 0) return;
    hid_t geometry = H5Gopen(container, "_SIMPL_GEOMETRY", H5P_DEFAULT);
    double edge[3];
    if (read_few(container, "_SPACING", true, 3, edge) == 3 ||
        (geometry >= 0 && read_few(geometry, "SPACING", false, 3, edge) == 3))
        memcpy(image->edge, edge, sizeof edge);
    double *bound = memory_new(MOST_BOUNDS, sizeof *bound);
    for (int axis = 0; geometry >= 0 && axis < 3; axis++) {
        const int n = read_few(geometry, bounds[axis], false, MOST_BOUNDS, bound);
        if (n > 1) image->edge[axis] = edge_of(dream3d, bound, n);
    }
    free(bound);
    if (geometry >= 0) H5Gclose(geometry);
    H5Gclose(container);
}

/* --- names of phases -----------------------------------------------------------------------------
 */

/* Strings of whatever length HDF5 has them in; the caller frees each and the list. */
static char **read_strings(hid_t set, int count)
{
    const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    char **strings = memory_new((size_t)count, sizeof *strings);
    if (H5Tis_variable_str(type) > 0) {
        char **read = memory_new((size_t)count, sizeof *read);
        if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read) >= 0)
            for (int i = 0; i < count; i++) strings[i] = memory_text(read[i] ? read[i] : "");
        H5Dvlen_reclaim(type, space, H5P_DEFAULT, read);
        free(read);
    } else {
        const size_t size = H5Tget_size(type);
        char *read = memory_new((size_t)count, size + 1);
        if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read) >= 0)
            for (int i = 0; i < count; i++)
                strings[i] = memory_print("%.*s", (int)size, read + (size_t)i * size);
        free(read);
    }
    H5Sclose(space);
    H5Tclose(type);
    return strings;
}

/* PhaseName of the ensembles of the array's container: a name a phase, from 0 (none) on. */
static void name_phases(const struct dream3d *dream3d, const struct data_set *set,
                        struct image *image)
{
    enum { MOST_PHASES = 1000, LONGEST = 1000 };
    const hid_t container = container_of(dream3d, set);
    const hid_t names =
        container < 0 ? -1 : H5Dopen(container, "CellEnsembleData/PhaseName", H5P_DEFAULT);
    if (names >= 0) {
        const hid_t space = H5Dget_space(names), type = H5Dget_type(names);
        const hssize_t count = H5Sget_simple_extent_npoints(space);
        if (count > 0 && count <= MOST_PHASES && H5Tget_class(type) == H5T_STRING &&
            H5Tget_size(type) <= LONGEST) {
            char **strings = read_strings(names, (int)count);
            for (int i = 0; i < (int)count; i++) {
                if (strings[i] && *strings[i]) image_add_name(image, i, strings[i]);
                free(strings[i]);
            }
            free(strings);
        }
        H5Tclose(type);
        H5Sclose(space);
        H5Dclose(names);
    }
    if (container >= 0) H5Gclose(container);
}

/* --- the image ----------------------------------------------------------------------------------
 */

static const struct data_set *feature_ids(const struct dream3d *dream3d)
{
    const struct data_set *found = NULL;
    for (int i = 0; i < dream3d->count; i++)
        if (is_cells(&dream3d->sets[i]) &&
            strcmp(last_name(dream3d->sets[i].path), "FeatureIds") == 0)
            found = &dream3d->sets[i];
    if (!found)
        refuse(dream3d, "an array of features needs FeatureIds of the cells, which are not there");
    return found;
}

static void look_up(const struct dream3d *dream3d, const struct data_set *table,
                    struct image *image)
{
    int64_t features;
    double *values = read_set(dream3d, table, &features);
    for (int64_t i = 0; i < image_voxels(image); i++) {
        const double id = image->value[i];
        if (!(id >= 0) || id >= (double)features)
            die_user("%s: the feature %g of a cell is not in %s, which has %lld",
                     dream3d->source->path, id, table->path, (long long)features);
        image->value[i] = values[(int64_t)id];
    }
    free(values);
}

void image_dream3d_read(const struct image_source *source, struct image *image)
{
    struct dream3d *dream3d = memory_new(1, sizeof *dream3d);
    dream3d->source = source;
    H5Eset_auto(H5E_DEFAULT, NULL, NULL);
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access, 1 << 16, false);
    H5Pset_file_image(access, (void *)(uintptr_t)source->bytes, source->length);
    /* HDF5 wants a name that no file has. */
    dream3d->file = H5Fopen("//in memory", H5F_ACC_RDONLY, access);
    if (dream3d->file < 0) refuse(dream3d, "damaged or cut off: HDF5 cannot open it");
    if (H5Ovisit(dream3d->file, H5_INDEX_NAME, H5_ITER_NATIVE, visit, dream3d) < 0)
        refuse(dream3d, "damaged: HDF5 cannot list it");
    if (!has_cells(dream3d))
        refuse(dream3d, "HDF5 without arrays of cells shaped (z, y, x, components), as DREAM3D has "
                        "them: netCDF-4, or the data file of XDMF, perhaps");
    const struct data_set *chosen = choose(dream3d);
    const struct data_set *cells = is_cells(chosen) ? chosen : feature_ids(dream3d);
    const double count[3] = {(double)cells->shape[2], (double)cells->shape[1],
                             (double)cells->shape[0]};
    image_size(source, image, count, SCALARS_INFLATION * (double)source->length);
    free(image->value);
    int64_t read;
    image->value = read_set(dream3d, cells, &read);
    if (chosen != cells) look_up(dream3d, chosen, image);
    read_edges(dream3d, cells, image);
    if (strcmp(last_name(chosen->path), "Phases") == 0) name_phases(dream3d, cells, image);
    H5Fclose(dream3d->file);
    H5Pclose(access);
    for (int i = 0; i < dream3d->count; i++) free(dream3d->sets[i].path);
    free(dream3d);
}
