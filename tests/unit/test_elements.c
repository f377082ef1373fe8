/* Tetrahedra, wedges and pyramids from elsewhere: volume and centroid, sets, what is left out. */
#include "directory.h"
#include "files.h"

/* Four elements with warped faces and no node in common, and a triangle. */
static const double place[][3] = {
    {0, 0, 0},    {1, 0, 0},    {0, 2, 0},      {0, 0, 3},                       /* TETRA */
    {10, 0, 0},   {12, 0.1, 0}, {10.2, 1, 0},                                    /* WEDGE */
    {10, 0, 2.5}, {11.7, 0, 2}, {10.3, 1.2, 3},                                  /* above */
    {20, 0, 0},   {22, 0, 0.3}, {22, 2, 0},     {20, 2.1, -0.2}, {21.5, 0.5, 3}, /* PYRAMID */
    {30, 0, 0},   {31, 0, 0.2}, {31.2, 1.1, 0}, {30, 1, -0.1},                   /* HEX */
    {30, 0.1, 1}, {31, 0, 1.3}, {31, 1, 0.9},   {30.2, 1, 1.1},                  /* above */
};
enum { NODES = sizeof place / sizeof *place, SOLIDS = 4, MOST_FACES = 6 };

/* Outward faces from the element's first node; the fourth corner of a triangle is -1. */
struct solid {
    int first, n_faces, faces[MOST_FACES][4];
};
static const struct solid solids[SOLIDS] = {
    {0, 4, {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}},
    {4, 5, {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}}},
    {10, 5, {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}},
    {15, 6, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
};

static void write_elements(const char *name)
{
    FILE *out = fopen("mesh.cdl", "w");
    fprintf(
        out,
        "netcdf mesh {\ndimensions: len_name = 33 ; time_step = UNLIMITED ; num_dim = 3 ; "
        "num_nodes = %d ; num_elem = 5 ; num_el_blk = 5 ; num_el_in_blk1 = 1 ; num_nod_per_el1 "
        "= 3 ; num_el_in_blk2 = 1 ; num_nod_per_el2 = 4 ; num_el_in_blk3 = 1 ; num_nod_per_el3 "
        "= 6 ; num_el_in_blk4 = 1 ; num_nod_per_el4 = 5 ; num_el_in_blk5 = 1 ; num_nod_per_el5 "
        "= 8 ; num_node_sets = 1 ; num_nod_ns1 = 2 ; num_side_sets = 2 ; num_side_ss1 = 1 ; "
        "num_side_ss2 = 2 ;\nvariables:\n double time_whole(time_step) ; int "
        "eb_status(num_el_blk) ; int eb_prop1(num_el_blk) ; eb_prop1:name = \"ID\" ; int "
        "ns_status(num_node_sets) ; int ns_prop1(num_node_sets) ; ns_prop1:name = \"ID\" ; int "
        "ss_status(num_side_sets) ; int ss_prop1(num_side_sets) ; ss_prop1:name = \"ID\" ; char "
        "ss_names(num_side_sets, len_name) ; "
        "double coordx(num_nodes) ; double coordy(num_nodes) ; double coordz(num_nodes) ; int "
        "node_ns1(num_nod_ns1) ; int elem_ss1(num_side_ss1) ; int side_ss1(num_side_ss1) ; int "
        "elem_ss2(num_side_ss2) ; int side_ss2(num_side_ss2) ;\n",
        NODES);
    static const char *const types[] = {"TRI3", "TETRA", "WEDGE", "PYRAMID", "HEX8"};
    for (int b = 0; b < 5; b++)
        fprintf(
            out,
            " int connect%d(num_el_in_blk%d, num_nod_per_el%d) ; connect%d:elem_type = \"%s\" ;\n",
            b + 1, b + 1, b + 1, b + 1, types[b]);
    fputs(
        ":api_version = 6.02f ; :version = 6.02f ; :floating_point_word_size = 8 ; :file_size = 1 "
        "; :title = \"\" ;\ndata:\n eb_status = 1, 1, 1, 1, 1 ; eb_prop1 = 7, 1, 2, 3, 4 ; "
        "ns_status = 1 "
        "; ns_prop1 = 10 ; ss_status = 1, 1 ; ss_prop1 = 5, 6 ; ss_names = \"top\", \"\" ; "
        "node_ns1 = "
        "11, 4 ; elem_ss1 = 5 ; side_ss1 = 6 ; elem_ss2 = 1, 3 ; side_ss2 = 1, 2 ;\n connect1 = 1, "
        "2, 3 "
        ";\n",
        out);
    for (int a = 0; a < 3; a++) {
        fprintf(out, " coord%c = ", "xyz"[a]);
        for (int n = 0; n < NODES; n++) fprintf(out, "%s%.17g", n ? ", " : "", place[n][a]);
        fputs(" ;\n", out);
    }
    for (int s = 0; s < SOLIDS; s++) {
        const int end = s + 1 < SOLIDS ? solids[s + 1].first : NODES;
        fprintf(out, " connect%d = ", s + 2);
        for (int n = solids[s].first; n < end; n++)
            fprintf(out, "%s%d", n > solids[s].first ? ", " : "", n + 1);
        fputs(" ;\n", out);
    }
    fputs("}\n", out);
    assert_int_equal(fclose(out), 0);
    char *command = memory_print("ncgen -k nc4 -o %s mesh.cdl", name);
    if (system("command -v ncgen >/dev/null") != 0) skip();
    assert_int_equal(system(command), 0);
    free(command);
}

/* Adds the tetrahedron between the origin and an outward triangle: volume, and its moments. */
static void add_triangle(const double *a, const double *b, const double *c, double weight,
                         double sums[4])
{
    const double volume = weight / 6 *
                          (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0]));
    sums[0] += volume;
    for (int d = 0; d < 3; d++) sums[1 + d] += volume * (a[d] + b[d] + c[d]) / 4;
}

/* The corners of a face; one of three is added, and true. */
static bool add_flat(const struct solid *solid, int f, const double *p[4], double sums[4])
{
    const int *face = solid->faces[f];
    for (int k = 0; k < 4; k++) p[k] = place[solid->first + (face[k] < 0 ? 0 : face[k])];
    if (face[3] < 0) add_triangle(p[0], p[1], p[2], 1, sums);
    return face[3] < 0;
}

/* A bilinear face bounds the mean of the two volumes that its diagonals' pairs of triangles bound:
 * along a line across it the two tetrahedra between the pairs lie on either side of it, as large as
 * each other. */
static double volume_of(const struct solid *solid)
{
    double sums[4] = {0};
    for (int f = 0; f < solid->n_faces; f++) {
        const double *p[4];
        if (add_flat(solid, f, p, sums)) continue;
        add_triangle(p[0], p[1], p[2], 0.5, sums);
        add_triangle(p[0], p[2], p[3], 0.5, sums);
        add_triangle(p[0], p[1], p[3], 0.5, sums);
        add_triangle(p[1], p[2], p[3], 0.5, sums);
    }
    return sums[0];
}

/* The moment of a bilinear face by midpoints of n x n parts, each of which is nearly plane: error
 * 1/n^2. */
static void moments_of(const struct solid *solid, int n, double sums[4])
{
    for (int f = 0; f < solid->n_faces; f++) {
        const double *p[4];
        if (add_flat(solid, f, p, sums)) continue;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                double q[4][3];
                for (int k = 0; k < 4; k++) {
                    const double r = (double)(i + (k == 1 || k == 2)) / n,
                                 s = (double)(j + (k > 1)) / n;
                    for (int d = 0; d < 3; d++)
                        q[k][d] = (1 - r) * (1 - s) * p[0][d] + r * (1 - s) * p[1][d] +
                                  r * s * p[2][d] + (1 - r) * s * p[3][d];
                }
                add_triangle(q[0], q[1], q[2], 1, sums);
                add_triangle(q[0], q[2], q[3], 1, sums);
            }
    }
}

/* Closed form of the tetrahedron; by the theorem of Gauss of all, where cancellation of terms some
 * 30 times as large costs digits. */
static void volumes_and_centroids_are_exact(void **state)
{
    enum { PARTS = 200 };
    (void)state;
    write_elements("mesh.g");
    struct domain domain = read_domain("mesh.g");
    assert_int_equal(domain.n_nodes, SOLIDS);
    assert_null(domain.hexahedra);
    assert_near(domain.volume[0], 1, 1e-15);
    assert_near(domain.x[0], 0.25, 1e-15);
    assert_near(domain.y[0], 0.5, 1e-15);
    assert_near(domain.z[0], 0.75, 1e-15);
    for (int s = 0; s < SOLIDS; s++) {
        double sums[4] = {0};
        assert_relative(domain.volume[s], volume_of(&solids[s]), 1e-12);
        moments_of(&solids[s], PARTS, sums);
        /* Parts of 1/200 leave a millionth. */
        assert_near(domain.x[s], sums[1] / sums[0], 3e-5);
        assert_near(domain.y[s], sums[2] / sums[0], 3e-5);
        assert_near(domain.z[s], sums[3] / sums[0], 3e-5);
    }
    domain_free(&domain);
}

static void expect_set(const struct domain *domain, const char *name, int count, int64_t node)
{
    const struct node_set *set = domain_set(domain, name);
    assert_non_null(set);
    assert_int_equal(set->count, count);
    assert_int_equal(set->nodes[0], node);
}

/* The triangle is no particle; its block no phase; numbers of elements count it. */
static void sets_of_nodes_and_sides(void **state)
{
    (void)state;
    write_elements("mesh.g");
    struct domain domain = read_domain("mesh.g");
    assert_int_equal(domain.n_phases, SOLIDS);
    assert_string_equal(domain.phase_names[0], "block_1");
    assert_string_equal(domain.phase_names[3], "block_4");
    for (int s = 0; s < SOLIDS; s++) assert_int_equal(domain.phase[s], s);
    expect_set(&domain, "set_10", 2, 0); /* nodes of the tetrahedron and of the pyramid */
    expect_set(&domain, "nodelist_10", 2, 0);
    expect_set(&domain, "top", 1, 3);
    expect_set(&domain, "surface_5", 1, 3);
    expect_set(&domain, "surface_6", 1, 1); /* the triangle's is none */
    domain_free(&domain);
}

static void damaged_files_do_no_harm(void **state)
{
    (void)state;
    write_elements("mesh.g");
    expect_no_harm("mesh.g", 331, try_domain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_and_centroids_are_exact),
        cmocka_unit_test(sets_of_nodes_and_sides),
        cmocka_unit_test(damaged_files_do_no_harm),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
