/* Nodes of a mesh as the corners of its particles: numbering, sets, nodes that lie on each other.
 */
#include "check.h"

#include "hexahedron.h"
#include "memory.h"
#include "mesh.h"

#include <stdlib.h>

enum { N = 3, NODES = (N + 1) * (N + 1) * (N + 1), CELLS = N * N * N, MIDDLE = CELLS / 2 };

static int64_t node_at(int x, int y, int z)
{
    return x + (N + 1) * (y + (N + 1) * (int64_t)z);
}

static void fill_cell(struct domain *domain, int64_t particle, int cell, int turned)
{
    static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const int at[3] = {cell % N, cell / N % N, cell / N / N};
    domain->volume[particle] = 1;
    for (int k = 0; k < 8; k++) {
        const int *c = corner[k / 4 * 4 + (k + turned) % 4];
        domain->hexahedra[8 * particle + k] = node_at(at[0] + c[0], at[1] + c[1], at[2] + c[2]);
    }
}

/* 3 x 3 x 3 cubes, the middle one last; one of its neighbours begins with the middle's lowest
 * corner, so that others have taken all corners of the middle when its turn comes.  A set of two
 * nodes and one that no element has. */
static struct domain block(void)
{
    struct domain domain = domain_new(CELLS, 0, NULL);
    domain.hexahedra = memory_new(8 * CELLS, sizeof(int64_t));
    domain.corners = memory_new(1, sizeof(struct domain));
    struct domain *nodes = domain.corners;
    *nodes = domain_new(NODES + 1, 0, NULL);
    for (int i = 0; i < NODES; i++) {
        nodes->x[i] = i % (N + 1);
        nodes->y[i] = i / (N + 1) % (N + 1);
        nodes->z[i] = i / ((N + 1) * (N + 1));
    }
    nodes->x[NODES] = 1; /* upon node (1, 0, 0) */
    int64_t particle = 0;
    for (int cell = 0; cell < CELLS; cell++)
        /* Cell (0, 0, 1) turned by half a turn begins at (1, 1, 1). */
        if (cell != MIDDLE) fill_cell(&domain, particle++, cell, cell == N * N ? 2 : 0);
    fill_cell(&domain, particle, MIDDLE, 0);
    domain_add_set(nodes, "some", 3, (const int64_t[]){1, NODES - 1, NODES});
    attributes_set_number(&domain.attributes, "mean_spacing_m", 1);
    return domain;
}

/* Each particle has its corners where they were, whatever their numbers, and its middle for its
 * place. */
static void test_numbers(void **state)
{
    struct domain domain = block(), corners;
    double place[CELLS][8][3];
    (void)state;
    for (int64_t p = 0; p < CELLS; p++)
        for (int k = 0; k < 8; k++) {
            const int64_t node = domain.hexahedra[8 * p + k];
            place[p][k][0] = domain.corners->x[node];
            place[p][k][1] = domain.corners->y[node];
            place[p][k][2] = domain.corners->z[node];
        }
    struct lattice lattice = mesh_lattice(&domain, &corners);
    assert_int_equal(lattice.n_nodes, NODES);
    assert_int_equal(corners.n_nodes, NODES);
    assert_null(domain.corners);
    int own = 0;
    for (int64_t p = 0; p < CELLS; p++) {
        struct hexahedron hexahedron;
        bool at_own = false;
        double middle[3] = {0};
        mesh_hexahedron(&lattice, p, &hexahedron);
        for (int k = 0; k < 8; k++)
            for (int a = 0; a < 3; a++) {
                assert_near(hexahedron.corner[k][a], place[p][k][a], 0);
                middle[a] += place[p][k][a] / 8;
                at_own |= lattice.hexahedron[8 * p + k] == p;
            }
        assert_near(domain.x[p], middle[0], 1e-15);
        assert_near(domain.y[p], middle[1], 1e-15);
        assert_near(domain.z[p], middle[2], 1e-15);
        own += at_own;
    }
    /* The middle one lies at the node of others. */
    assert_int_equal(own, CELLS - 1);
    for (int64_t i = 0; i < NODES; i++) assert_int_equal(lattice.phase[i], i < CELLS ? 0 : ABSENT);
    assert_near(lattice.finest, 1, 1e-14);
    assert_int_equal(corners.sets[0].count, 2);
    assert_near(corners.x[corners.sets[0].nodes[0]] + corners.x[corners.sets[0].nodes[1]], 1 + N,
                0);
    lattice_free(&lattice);
    domain_free(&domain);
    domain_free(&corners);
}

/* Node (1, 0, 0) has a double: of no element it is none; of one it is, and is joined in elements
 * and sets. */
static void test_coincident(void **state)
{
    struct domain domain = block();
    (void)state;
    assert_int_equal(mesh_coincident(&domain, NULL, false), 0);
    assert_int_equal(domain.hexahedra[1], 1);
    domain.hexahedra[1] = NODES;
    assert_int_equal(mesh_coincident(&domain, NULL, false), 1);
    assert_int_equal(domain.hexahedra[1], NODES);
    assert_int_equal(mesh_coincident(&domain, NULL, true), 1);
    assert_int_equal(domain.hexahedra[1], 1);
    assert_int_equal(domain.corners->sets[0].count, 2);
    assert_int_equal(domain.corners->sets[0].nodes[0], 1);
    domain_free(&domain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_coincident),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
