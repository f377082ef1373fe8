/* Images in the formats of other programs: each flavour holds one and the same structure. */
#include "dies.h"

#include "directory.h"
#include "image.h"
#include "memory.h"

#include <hdf5.h>
#include <stdlib.h>

/* tests/data/images, as seen from the folder of this test's own */
static char *data;

static char *at(const char *file)
{
    return memory_print("%s/%s", data, file);
}

enum { NX = 4, NY = 3, NZ = 2 };

static void try_read(const void *path)
{
    struct image image = image_read(path, NULL, NULL);
    image_free(&image);
}

/* The files were made from this formula by code that has nothing of hsgen
 * (tests/data/images/README.md). */
static double expected(int64_t i, int64_t j, int64_t k)
{
    return (double)(1 + (i + 2 * j + 3 * k) % 5);
}

struct flavour {
    const char *file, *array;
    double scale, offset; /* of the value; scale 0: 1 */
    bool flat;            /* the layer k = 0 alone */
    bool no_edges;        /* pictures do not say how large a pixel is */
    const char *unit;
    bool open_end; /* nothing in it says how much there is to be, or what does is wrong */
};

static const struct flavour flavours[] = {
    {.file = "text.vti"},
    {.file = "base64.vti"},
    {.file = "packed.vti"},
    {.file = "packed_whole.vti"},
    {.file = "appended_raw.vti", .array = "material"},
    {.file = "appended_raw.vti", .array = "grey", .scale = 0.25},
    {.file = "appended_base64.vti", .array = "material"},
    {.file = "big_endian.vti"},
    {.file = "pieces_text.vti"},
    {.file = "pieces_raw.vti"},
    {.file = "pieces_base64.vti"},
    {.file = "pieces_packed.vti"},
    {.file = "text.vtk"},
    {.file = "binary.vtk", .array = "material"},
    {.file = "field.vtk"},
    {.file = "old.vtk"},
    {.file = "raw.nrrd"},
    {.file = "gzip.nrrd", .unit = "mm"},
    {.file = "bzip2.nrrd"},
    {.file = "text.nrrd"},
    {.file = "detached.nhdr"},
    {.file = "text.tesr"},
    {.file = "binary8.tesr"},
    {.file = "binary16.tesr"},
    {.file = "binary32.tesr"},
    {.file = "flat.tesr", .flat = true},
    {.file = "grey8.png", .flat = true, .no_edges = true},
    {.file = "grey16.png", .flat = true, .no_edges = true, .scale = 256},
    {.file = "grey4.png", .flat = true, .no_edges = true},
    {.file = "palette.png", .flat = true, .no_edges = true},
    {.file = "alpha.png", .flat = true, .no_edges = true},
    {.file = "interlaced.png", .flat = true, .no_edges = true},
    {.file = "colour.png", .flat = true, .no_edges = true, .scale = 256, .offset = 0xff0000},
    {.file = "stack.tif", .no_edges = true},
    {.file = "big_endian.tif", .no_edges = true},
    {.file = "big.tif", .no_edges = true},
    {.file = "tiles.tif", .no_edges = true},
    {.file = "float.tif", .no_edges = true},
    {.file = "nibbles.tif", .no_edges = true},
    {.file = "square.ctf", .flat = true, .unit = "um"},
    {.file = "comma.ctf", .flat = true, .unit = "um"},
    {.file = "hexagonal.ctf", .flat = true, .unit = "um", .open_end = true},
    {.file = "lying_head.ang", .flat = true, .unit = "um", .open_end = true},
    {.file = "voxels.inp", .array = "grain", .open_end = true},
    {.file = "voxels.inp", .open_end = true},
};
enum { N_FLAVOURS = sizeof flavours / sizeof *flavours };

static void check_values(const struct image *image, const struct flavour *flavour)
{
    const double scale = flavour->scale == 0 ? 1 : flavour->scale;
    assert_int_equal(image->count[0], NX);
    assert_int_equal(image->count[1], NY);
    assert_int_equal(image->count[2], flavour->flat ? 1 : NZ);
    for (int64_t v = 0; v < image_voxels(image); v++) {
        const int64_t i = v % NX, j = v / NX % NY, k = v / NX / NY;
        if (image->value[v] != flavour->offset + scale * expected(i, j, k))
            fail_msg("%s: voxel %lld is %g", flavour->file, (long long)v, image->value[v]);
    }
}

/* Edges are written with six digits at least. */
static void every_flavour_holds_the_structure(void **state)
{
    (void)state;
    for (int f = 0; f < N_FLAVOURS; f++) {
        const struct flavour *flavour = &flavours[f];
        char *path = at(flavour->file);
        struct image image = image_read(path, flavour->array, NULL);
        check_values(&image, flavour);
        const double edge[3] = {0.5, 0.25, flavour->flat ? 0.5 : 0.125};
        for (int axis = 0; axis < 3; axis++)
            assert_near(image.edge[axis], flavour->no_edges ? 0 : edge[axis], 1e-9);
        if (flavour->unit)
            assert_string_equal(image.unit, flavour->unit);
        else
            assert_null(image.unit);
        image_free(&image);
        free(path);
    }
}

static void files_without_a_head_are_described(void **state)
{
    (void)state;
    char *path = at("values.raw");
    const struct image_raw raw = {{NX, NY, NZ}, SCALAR_UINT16, true, 8};
    struct image image = image_read(path, NULL, &raw);
    check_values(&image, &(struct flavour){.file = "values.raw"});
    image_free(&image);
    free(path);
}

/* The layer k = 0 as twelve files, of which one is another: in the order of their numbers. */
static void stacks_are_in_the_order_of_their_numbers(void **state)
{
    (void)state;
    for (int l = 0; l < 12; l++) {
        char *name = memory_print("layer%d.img", l),
             *from = at(l == 9 ? "alpha.png" : "grey16.png");
        char *command = memory_print("cp '%s' %s", from, name);
        assert_int_equal(system(command), 0);
        free(command);
        free(from);
        free(name);
    }
    struct image image = image_read("layer*.img", NULL, NULL);
    assert_int_equal(image.count[2], 12);
    for (int64_t v = 0; v < image_voxels(&image); v++) {
        const int64_t i = v % NX, j = v / NX % NY, k = v / NX / NY;
        assert_true(image.value[v] == (k == 9 ? 1 : 256) * expected(i, j, 0));
    }
    image_free(&image);
    assert_dies(EXIT_USER, "no file has a name like", try_read, "nothing*.img");
    char *command = memory_print("cp '%s/stack.tif' layer3.img", data);
    assert_int_equal(system(command), 0);
    free(command);
    assert_dies(EXIT_USER, "layer3.img: 2 layers, and a file of a stack has one", try_read,
                "layer*.img");
}

static void names_go_with_their_values(void **state)
{
    (void)state;
    static const struct {
        const char *file, *array, *name;
        double value;
    } cases[] = {
        {"gzip.nrrd", NULL, "core", 3},
        {"gzip.nrrd", NULL, "shell", 1},
        {"square.ctf", NULL, "Iron bcc (old)", 1},
        {"square.ctf", NULL, "Iron fcc", 2},
        {"lying_head.ang", NULL, "Iron bcc (old)", 2},
        {"lying_head.ang", NULL, "Iron fcc", 1},
        {"voxels.inp", "grain", "Grain4", 4},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        char *path = at(cases[c].file);
        struct image image = image_read(path, cases[c].array, NULL);
        assert_non_null(image_name_of(&image, cases[c].value));
        assert_string_equal(image_name_of(&image, cases[c].value), cases[c].name);
        image_free(&image);
        free(path);
    }
}

/* A hexagonal map whose even rows are shorter: a box for each point, but for the last of longer
 * rows. */
static void hexagonal_rows_are_straightened(void **state)
{
    (void)state;
    char *path = at("hexagonal.ang");
    struct image image = image_read(path, NULL, NULL);
    assert_int_equal(image.count[0], NX - 1);
    assert_int_equal(image.count[1], NY);
    assert_near(image.edge[0], 0.5, 1e-9);
    assert_near(image.edge[1], 0.433, 1e-3);
    for (int64_t v = 0; v < image_voxels(&image); v++)
        assert_true(image.value[v] == expected(v % (NX - 1), v / (NX - 1), 0));
    image_free(&image);
    free(path);
}

/* Other columns than the phase, by name. */
static void any_column_of_a_map_can_be_taken(void **state)
{
    (void)state;
    static const struct {
        const char *file, *array;
        double per_row;
    } cases[] = {{"square.ctf", "BS", 10}, {"lying_head.ang", "column11", 100}};
    for (int c = 0; c < 2; c++) {
        char *path = at(cases[c].file);
        struct image image = image_read(path, cases[c].array, NULL);
        for (int64_t v = 0; v < NX * NY; v++)
            assert_true(image.value[v] == cases[c].per_row * (double)(v / NX) + (double)(v % NX));
        image_free(&image);
        free(path);
    }
}

/* --- DREAM3D, written by HDF5 itself -------------------------------------------------------------
 */

static hid_t group_in(hid_t at, const char *name)
{
    const hid_t group = H5Gcreate(at, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(group >= 0);
    return group;
}

static void put(hid_t at, const char *name, int rank, const hsize_t *shape, hid_t type,
                hid_t memory, const void *values, bool packed)
{
    const hid_t space = H5Screate_simple(rank, shape, NULL), how = H5Pcreate(H5P_DATASET_CREATE);
    if (packed) {
        assert_true(H5Pset_chunk(how, rank, shape) >= 0);
        assert_true(H5Pset_deflate(how, 6) >= 0);
    }
    const hid_t set = H5Dcreate(at, name, type, space, H5P_DEFAULT, how, H5P_DEFAULT);
    assert_true(H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Pclose(how);
    H5Sclose(space);
}

static void put_cells(hid_t cells)
{
    const hsize_t shape[4] = {NZ, NY, NX, 1}, wide[4] = {NZ, NY, NX, 3};
    int32_t ids[NX * NY * NZ];
    float angles[3 * NX * NY * NZ] = {0};
    for (int v = 0; v < NX * NY * NZ; v++)
        ids[v] = (int32_t)expected(v % NX, v / NX % NY, v / NX / NY);
    put(cells, "FeatureIds", 4, shape, H5T_STD_I32LE, H5T_NATIVE_INT32, ids, true);
    put(cells, "EulerAngles", 4, wide, H5T_IEEE_F32BE, H5T_NATIVE_FLOAT, angles, false);
}

/* Phases of features 0 (none) to 5: 10 times the feature. */
static void put_features(hid_t features)
{
    const hsize_t shape[2] = {6, 1};
    const int32_t phases[6] = {0, 10, 20, 30, 40, 50};
    put(features, "Phases", 2, shape, H5T_STD_I32BE, H5T_NATIVE_INT32, phases, false);
}

/* Names of phases 0 to 2, of one length or of their own. */
static void put_names(hid_t container, bool variable)
{
    const char *const own[3] = {"Unknown", "Primary", "Precipitate"};
    const char fixed[3][12] = {"Unknown", "Primary", "Precipitate"};
    const hid_t ensembles = group_in(container, "CellEnsembleData"), type = H5Tcopy(H5T_C_S1);
    const hsize_t shape[1] = {3};
    assert_true(H5Tset_size(type, variable ? H5T_VARIABLE : 12) >= 0);
    put(ensembles, "PhaseName", 1, shape, type, type,
        variable ? (const void *)own : (const void *)fixed, false);
    H5Tclose(type);
    H5Gclose(ensembles);
}

/* As SIMPL lays it out (FileVersion 7). */
static void write_version_7(const char *path, bool uneven, bool variable)
{
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t all = group_in(file, "DataContainers"), one = group_in(all, "SyntheticVolume");
    const hid_t cells = group_in(one, "CellData"), features = group_in(one, "CellFeatureData");
    const hid_t geometry = group_in(one, "_SIMPL_GEOMETRY");
    const hsize_t three[1] = {3}, bounds[1] = {NZ + 1};
    const float spacing[3] = {0.5F, 0.25F, 0.125F}, z[NZ + 1] = {0, 1, 4};
    put_cells(cells);
    put_features(features);
    put_names(one, variable);
    put(geometry, "SPACING", 1, three, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, spacing, false);
    if (uneven) put(geometry, "zBounds", 1, bounds, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, z, false);
    H5Gclose(geometry);
    H5Gclose(features);
    H5Gclose(cells);
    H5Gclose(one);
    H5Gclose(all);
    H5Fclose(file);
}

/* As DREAM3D-NX does (FileVersion 8): the spacing is an attribute. */
static void write_version_8(const char *path)
{
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t all = group_in(file, "DataStructure"), one = group_in(all, "Image");
    const hid_t cells = group_in(one, "CellData");
    const hsize_t three[1] = {3};
    const float spacing[3] = {0.5F, 0.25F, 0.125F};
    const hid_t space = H5Screate_simple(1, three, NULL);
    const hid_t attribute =
        H5Acreate(one, "_SPACING", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Awrite(attribute, H5T_NATIVE_FLOAT, spacing) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
    put_cells(cells);
    H5Gclose(cells);
    H5Gclose(one);
    H5Gclose(all);
    H5Fclose(file);
}

static void try_phases(const void *path)
{
    struct image image = image_read(path, "Phases", NULL);
    image_free(&image);
}

static void dream3d_is_read_in_both_layouts(void **state)
{
    (void)state;
    const char *path = "a.dream3d";
    const double edge[3] = {0.5, 0.25, 0.125};
    for (int version = 7; version <= 8; version++) {
        if (version == 7)
            write_version_7(path, false, false);
        else
            write_version_8(path);
        struct image image = image_read(path, NULL, NULL); /* the only array of one number */
        check_values(&image, &(struct flavour){.file = "a.dream3d"});
        for (int axis = 0; axis < 3; axis++) assert_true(image.edge[axis] == edge[axis]);
        image_free(&image);
    }
    assert_dies(EXIT_USER,
                "there is no array 'Phases' in it (there are: /DataStructure/Image/CellData/",
                try_phases, path);
    /* A table of features: each cell has the phase of its feature. */
    write_version_7(path, false, false);
    struct image image = image_read(path, "CellFeatureData/Phases", NULL);
    image_free(&image);
    for (int variable = 0; variable < 2; variable++) {
        write_version_7(path, false, variable);
        image = image_read(path, "Phases", NULL);
        check_values(&image, &(struct flavour){.file = "a.dream3d", .scale = 10});
        assert_string_equal(image_name_of(&image, 1), "Primary");
        assert_string_equal(image_name_of(&image, 2), "Precipitate");
        image_free(&image);
    }
    write_version_7(path, true, false);
    assert_dies(EXIT_USER, "layers of different thickness", try_read, path);
}

/* --- what is not read ----------------------------------------------------------------------------
 */

static void what_is_not_read_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *bytes, *said;
    } cases[] = {
        {"$MeshFormat\n2.2 0 8\n", "is a mesh of Gmsh"},
        {"***tess\n **format\n", "neper -T ... -format tesr"},
        {"CDF\001", "netCDF, Exodus perhaps"},
        {"\xFF\xD8\xFF\xE0 JFIF", "JPEG, whose values are smeared"},
        {"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">", "without a regular grid"},
        {"<?xml version=\"1.0\"?>\n<Xdmf>", "name that file"},
        {"BZh91AY", "compressed by bzip2"},
        {"nothing of the kind", "not an image by its first bytes"},
        {"", "not an image by its first bytes"},
        {"# vtk DataFile Version 3.0\na\nASCII\nDATASET RECTILINEAR_GRID\n",
         "STRUCTURED_POINTS is read"},
        {"# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\n"
         "POINT_DATA 2\nSCALARS a int\nLOOKUP_TABLE default\n1 2\nDIMENSIONS 3 1 1\n",
         "2 values, the dimensions say 3"},
        {"*Node\n1,0,0,0\n*Element, type=C3D4\n1,1,1,1,1\n", "'C3D4' are no voxels"},
        {"***tesr\n **format\n 2.1\n **general\n 3\n 100000 100000 100000\n 1 1 1\n **data\n "
         "ascii\n 1\n",
         "are more than 2147483647"},
        {"***tesr\n **format\n 2.1\n **general\n 3\n 100 100 100\n 1 1 1\n **data\n ascii\n 1\n",
         "cannot be in a file of"},
    };
    const char *path = "image";
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        FILE *file = fopen(path, "wb");
        fwrite(cases[c].bytes, 1, strlen(cases[c].bytes), file);
        fclose(file);
        assert_dies(EXIT_USER, cases[c].said, try_read, path);
    }
}

static void copy_with(const char *from, const char *more, const char *to)
{
    char bytes[8192], *path = at(from);
    FILE *in = fopen(path, "rb"), *out = fopen(to, "wb");
    assert_non_null(in);
    fwrite(bytes, 1, fread(bytes, 1, sizeof bytes, in), out);
    fputs(more, out);
    fclose(in);
    fclose(out);
    free(path);
}

static void what_is_unclear_is_asked(void **state)
{
    (void)state;
    static const struct {
        const char *file, *more, *said;
    } cases[] = {
        {"square.ctf", "1\t7.2\t9.0\t8\t0\t1\t1\t1\t1\t1\t1\n",
         "no regular grid; points on square and hexagonal grids are read"},
        {"appended_raw.vti", "", "say by 'array' which one is meant; there are: grey, material"},
        {"voxels.inp", "*Elset, elset=Odd\n1, 3\n", "in the sets Grain1 and Odd"},
        {"voxels.inp", "*Elset, elset=Many, generate\n2, 900000000, 2\n*Elset, elset=z\n1\n",
         "and Many"},
        {"voxels.inp", "*Elset, elset=Odd\n1e300\n", "found 1e+300, expected the number of a node"},
        {"voxels.inp", "*Include, input=more.inp\n", "another file (*INCLUDE)"},
        {"square.ctf", "1\t9.0\t0.0\t8\t0\t1\t1\t1\t1\t1\t1\n", "no regular grid"},
        {"square.ctf", "1\t7.0\t0.0\t8\t0\t1\t1\t1\t1\t1\t1\n", "13 points"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        copy_with(cases[c].file, cases[c].more, "image");
        assert_dies(EXIT_USER, cases[c].said, try_read, "image");
    }
}

/* The file of two pieces with a word in it replaced, once. */
static void pieces_fill_the_whole(void **state)
{
    (void)state;
    static const struct {
        const char *old, *new, *said;
    } cases[] = {
        {"0 1 0 3 0 2", "1 2 0 3 0 2", "piece 2 and one before it both have the voxel (1, 0, 0)"},
        {"WholeExtent=\"0", "WholeExtent=\"-1", "none of its 2 pieces has the voxel (0, 0, 0)"},
        {"0 1 0 3 0 2", "0 1 1 4 0 2", "piece 2 reaches beyond WholeExtent along y"},
        {"WholeExtent", "HoleExtent", "no WholeExtent of six numbers"},
        {"Extent=\"0 1", "Extents=\"0 1", "no Extent of six numbers"},
        {"0 1 0 3 0 2", "0 1 0 2 0 2", "more than the 4 numbers of an array"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        char *path = at("pieces_text.vti"),
             *command = memory_print("sed 's/%s/%s/' '%s' >pieces.vti; ! cmp -s '%s' pieces.vti",
                                     cases[c].old, cases[c].new, path, path);
        assert_int_equal(system(command), 0);
        assert_dies(EXIT_USER, cases[c].said, try_read, "pieces.vti");
        free(command);
        free(path);
    }
    assert_int_equal(
        system("awk '/material/ && n++ { sub(/material/, \"grey\") } 1' pieces.vti >named.vti"), 0);
    assert_dies(EXIT_USER, "piece 2 has no array 'material'", try_read, "named.vti");
}

struct wanted {
    const char *path;
    const struct flavour *flavour;
};

/* Ends with 3 where the file reads, and is something else than the structure. */
static void read_wanted(const void *argument)
{
    const struct wanted *wanted = argument;
    struct image image = image_read(wanted->path, wanted->flavour->array, NULL);
    bool same = image.count[0] == NX && image.count[1] == NY &&
                image.count[2] == (wanted->flavour->flat ? 1 : NZ);
    for (int64_t v = 0; same && v < image_voxels(&image); v++)
        same = image.value[v] == expected(v % NX, v / NX % NY, v / NX / NY);
    _exit(same ? 0 : 3);
}

/* A file that was cut off anywhere is refused as the user's error, or gives the structure all the
 * same, where what is missing says nothing of it. */
static void cut_files_are_refused(void **state)
{
    (void)state;
    enum { CUTS = 50 };
    for (int f = 0; f < N_FLAVOURS; f++) {
        const struct flavour *flavour = &flavours[f];
        if (flavour->scale != 0 || flavour->open_end) continue;
        char bytes[8192], *whole = at(flavour->file);
        FILE *file = fopen(whole, "rb");
        assert_non_null(file);
        const size_t length = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
        int refused = 0, cuts = 0;
        for (size_t cut = 0; cut < length; cut += 1 + length / CUTS, cuts++) {
            file = fopen("image", "wb");
            fwrite(bytes, 1, cut, file);
            fclose(file);
            const int code = code_of(read_wanted, &(struct wanted){"image", flavour});
            if (code != 0 && code != EXIT_USER)
                fail_msg("%s cut at %zu: %d", flavour->file, cut, code);
            refused += code == EXIT_USER;
        }
        assert_true(refused > cuts / 2);
        free(whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_flavour_holds_the_structure),
        cmocka_unit_test(files_without_a_head_are_described),
        cmocka_unit_test(stacks_are_in_the_order_of_their_numbers),
        cmocka_unit_test(names_go_with_their_values),
        cmocka_unit_test(hexagonal_rows_are_straightened),
        cmocka_unit_test(any_column_of_a_map_can_be_taken),
        cmocka_unit_test(dream3d_is_read_in_both_layouts),
        cmocka_unit_test(what_is_not_read_is_named),
        cmocka_unit_test(what_is_unclear_is_asked),
        cmocka_unit_test(pieces_fill_the_whole),
        cmocka_unit_test(cut_files_are_refused),
    };
    data = realpath("tests/data/images", NULL);
    const int failed = cmocka_run_group_tests(tests, enter_directory, leave_directory);
    free(data);
    return failed;
}
