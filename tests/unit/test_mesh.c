/* Genesis with hexahedra from elsewhere: written as text by the test, made binary by ncgen. */
#include "directory.h"
#include "files.h"

enum { NX = 3, NY = 2, NZ = 1, NODES = (NX + 1) * (NY + 1) * (NZ + 1), HEXES = NX * NY * NZ };

/* A bar of 3 x 2 x 1 hexahedra between x = 0 and 3, sheared along y and bent within.  The last
 * block holds one SPHERE on the node at the origin. */
struct mesh_case {
    const char *type;  /* of the first block's elements */
    bool mirrored;     /* the first element has its corners in the wrong order */
    bool unknown_node; /* an element has a node that is not there */
};

static int64_t node_at(int i, int j, int k)
{
    return i + (NX + 1) * (j + (NY + 1) * k) + 1;
}

static void print_positions(FILE *out, int axis)
{
    fprintf(out, " coord%c = ", "xyz"[axis]);
    for (int n = 0; n < NODES; n++) {
        int i = n % (NX + 1), j = n / (NX + 1) % (NY + 1), k = n / (NX + 1) / (NY + 1);
        bool inner = i > 0 && i < NX && j > 0 && j < NY;
        double x[3] = {i + (inner ? 0.1 - 0.2 * k : 0), j + 0.25 * i, k};
        fprintf(out, "%s%.17g", n ? ", " : "", x[axis]);
    }
    fprintf(out, " ;\n");
}

static void print_element(FILE *out, int number, const struct mesh_case *wanted)
{
    static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    int i = number % NX, j = number / NX % NY, k = number / NX / NY;
    for (int c = 0; c < 8; c++) {
        const int *at = corner[wanted->mirrored && number == 0 ? (c + 4) % 8 : c];
        int64_t node = node_at(i + at[0], j + at[1], k + at[2]);
        if (wanted->unknown_node && number == 1 && c == 0) node = NODES + 1;
        fprintf(out, "%s%lld", c ? ", " : "", (long long)node);
    }
}

static void print_elements(FILE *out, int block, int first, int last,
                           const struct mesh_case *wanted)
{
    fprintf(out, " connect%d = ", block);
    for (int e = first; e < last; e++) {
        if (e > first) fprintf(out, ", ");
        print_element(out, e, wanted);
    }
    fprintf(out, " ;\n");
}

static const char dimensions[] =
    "netcdf mesh {\ndimensions:\n len_name = 33 ; time_step = UNLIMITED ; num_dim = 3 ; num_nodes "
    "= 24 ; "
    "num_elem = 7 ; num_el_blk = 3 ; num_el_in_blk1 = 4 ; num_nod_per_el1 = 8 ; num_el_in_blk2 = 2 "
    "; "
    "num_nod_per_el2 = 8 ; num_el_in_blk3 = 1 ; num_nod_per_el3 = 1 ; num_att_in_blk3 = 1 ; "
    "num_node_sets = 3 ; num_nod_ns1 = 6 ; num_nod_ns2 = 2 ; num_nod_ns3 = 5 ;\n";

static const char variables[] =
    "variables:\n double time_whole(time_step) ; int eb_status(num_el_blk) ; int "
    "eb_prop1(num_el_blk) ; "
    "eb_prop1:name = \"ID\" ; int ns_status(num_node_sets) ; int ns_prop1(num_node_sets) ; "
    "ns_prop1:name = "
    "\"ID\" ; double coordx(num_nodes) ; double coordy(num_nodes) ; double coordz(num_nodes) ; "
    "char "
    "eb_names(num_el_blk, len_name) ; char ns_names(num_node_sets, len_name) ; double "
    "attrib3(num_el_in_blk3, num_att_in_blk3) ; char attrib_name3(num_att_in_blk3, len_name) ; int "
    "connect1(num_el_in_blk1, num_nod_per_el1) ; connect1:elem_type = \"%s\" ; int "
    "connect2(num_el_in_blk2, num_nod_per_el2) ; connect2:elem_type = \"HEX\" ; int "
    "connect3(num_el_in_blk3, num_nod_per_el3) ; connect3:elem_type = \"SPHERE\" ; int "
    "node_ns1(num_nod_ns1) ; int node_ns2(num_nod_ns2) ; int node_ns3(num_nod_ns3) ;\n"
    ":api_version = 6.02f ; :version = 6.02f ; :floating_point_word_size = 8 ; :file_size = 1 ; "
    ":title = \"\" ;\n";

/* Sets: the face x = 0; an edge of it; the face x = 3 but for one corner. */
static const char sets[] = " node_ns1 = 1, 5, 9, 13, 17, 21 ;\n node_ns2 = 1, 13 ;\n"
                           " node_ns3 = 4, 8, 16, 20, 24 ;\n";

static void write_mesh(const char *name, const struct mesh_case *wanted)
{
    FILE *out = fopen("mesh.cdl", "w");
    fputs(dimensions, out);
    fprintf(out, variables, wanted->type);
    fputs("data:\n eb_status = 1, 1, 1 ;\n eb_prop1 = 10, 20, 30 ;\n ns_status = 1, 1, 1 ;\n "
          "ns_prop1 = 1, "
          "2, 3 ;\n eb_names = \"CG\", \"\", \"pin\" ;\n ns_names = \"left\", \"edge\", \"right\" "
          ";\n "
          "attrib_name3 = \"VOLUME\" ;\n attrib3 = 0.125 ;\n connect3 = 1 ;\n",
          out);
    for (int axis = 0; axis < 3; axis++) print_positions(out, axis);
    print_elements(out, 1, 0, 4, wanted);
    print_elements(out, 2, 4, HEXES, wanted);
    fputs(sets, out);
    fputs("}\n", out);
    assert_int_equal(fclose(out), 0);
    char *command = memory_print("ncgen -6 -o %s mesh.cdl", name);
    assert_int_equal(system(command), 0);
    free(command);
}

static void need_ncgen(void)
{
    if (system("command -v ncgen >/dev/null") != 0) skip();
}

static void expect_set(const struct domain *domain, const char *name, int count,
                       const int64_t *nodes)
{
    const struct node_set *set = domain_set(domain, name);
    assert_non_null(set);
    assert_int_equal(set->count, count);
    for (int i = 0; i < count; i++) assert_int_equal(set->nodes[i], nodes[i]);
}

/* The hexahedra fill the bar, whose volume the shear does not change: 6, to rounding. */
static void hexahedra_become_particles(void **state)
{
    static const int64_t left[] = {0, 3, 6}, right[] = {2, 5}, edge[] = {0, 6};
    (void)state;
    need_ncgen();
    write_mesh("mesh.g", &(struct mesh_case){.type = "HEX8"});
    struct domain domain = read_domain("mesh.g");
    assert_int_equal(domain.n_nodes, HEXES + 1);
    assert_int_equal(domain.n_phases, 3);
    assert_string_equal(domain.phase_names[0], "CG");
    assert_string_equal(domain.phase_names[1], "block_20");
    double sum = 0, moment = 0;
    for (int e = 0; e < HEXES; e++) {
        assert_int_equal(domain.phase[e], e < 4 ? 0 : 1);
        sum += domain.volume[e];
        moment += domain.volume[e] * domain.x[e];
    }
    assert_relative(sum, 6, 1e-14);
    /* Centroids of parts make that of the whole. */
    assert_relative(moment / sum, 1.5, 1e-14);
    assert_int_equal(domain.phase[HEXES], 2);
    assert_true(domain.volume[HEXES] == 0.125 && domain.x[HEXES] == 0 && domain.y[HEXES] == 0);
    /* A node of the set makes an element a member, and the sphere on it. */
    expect_set(&domain, "left", 3, left);
    expect_set(&domain, "edge", 2, edge);
    expect_set(&domain, "right", 2, right);
    expect_set(&domain, "nodelist_3", 2, right);
    domain_free(&domain);
}

static void wrong_meshes_are_refused(void **state)
{
    (void)state;
    need_ncgen();
    write_mesh("bad.g", &(struct mesh_case){.type = "HEX8", .mirrored = true});
    assert_dies(EXIT_USER, "bad.g: element 1 (from node 13 on) has the volume -", try_domain,
                "bad.g");
    write_mesh("bad.g", &(struct mesh_case){.type = "WEDGE"});
    assert_dies(EXIT_USER, "bad.g: block 'CG' holds 'WEDGE' elements of 8 nodes, expected SPHERE",
                try_domain, "bad.g");
    write_mesh("bad.g", &(struct mesh_case){.type = "HEX8", .unknown_node = true});
    assert_dies(EXIT_USER, "bad.g: damaged: element with node 25, which is unknown", try_domain,
                "bad.g");
}

static void damaged_meshes_do_no_harm(void **state)
{
    (void)state;
    need_ncgen();
    write_mesh("mesh.g", &(struct mesh_case){.type = "HEX8"});
    expect_no_harm("mesh.g", 23, try_domain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hexahedra_become_particles),
        cmocka_unit_test(wrong_meshes_are_refused),
        cmocka_unit_test(damaged_meshes_do_no_harm),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
