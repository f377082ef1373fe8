/* What a layer of particles is drawn as: cells that deform with the body, without slits. */
#include "check.h"

#include "cells.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 5, ROWS = 5, NODES = COLUMNS * ROWS };
static const int axes[2] = {0, 1};

/* Oblong sites of 2 by 1 m; displacement: of a node, by its position. */
static struct snapshot body(void (*displacement)(double x, double y, double u[2]))
{
    struct snapshot snapshot = {.edge = {2, 1, 1}};
    struct domain *domain = &snapshot.domain;
    double **const places[] = {&domain->x,
                               &domain->y,
                               &domain->z,
                               &snapshot.side,
                               &snapshot.displacement[0],
                               &snapshot.displacement[1]};
    domain->n_nodes = NODES;
    for (int k = 0; k < 6; k++) *places[k] = memory_new(NODES, sizeof(double));
    for (int i = 0; i < NODES; i++) {
        double u[2];
        domain->x[i] = 2 * (i % COLUMNS);
        domain->y[i] = i / COLUMNS;
        snapshot.side[i] = 2;
        displacement(domain->x[i], domain->y[i], u);
        for (int a = 0; a < 2; a++) snapshot.displacement[a][i] = u[a];
    }
    return snapshot;
}

static void release(struct snapshot *snapshot)
{
    free(snapshot->domain.x);
    free(snapshot->domain.y);
    free(snapshot->domain.z);
    free(snapshot->side);
    free(snapshot->displacement[0]);
    free(snapshot->displacement[1]);
}

/* All particles but one, which is a hole. */
static struct cell *cells_of(const struct snapshot *snapshot, int hole, double factor,
                             int64_t nodes[NODES], int64_t *count)
{
    *count = 0;
    for (int i = 0; i < NODES; i++)
        if (i != hole) nodes[(*count)++] = i;
    return cells_make(snapshot, axes, nodes, *count, factor);
}

/* Corners of a cell at rest, from the lower left one on. */
static double at_rest(const struct snapshot *snapshot, int64_t node, int corner, int axis)
{
    const bool high = axis == 0 ? corner == 1 || corner == 2 : corner >= 2;
    const double x = axis == 0 ? snapshot->domain.x[node] : snapshot->domain.y[node];
    return x + (high ? 0.5 : -0.5) * snapshot->edge[axis];
}

static void affine(double x, double y, double u[2])
{
    u[0] = 0.3 * x - 0.2 * y + 1;
    u[1] = 0.1 * x - 0.25 * y;
}

/* Exactly, but for rounding, at faces and beside a hole, too. */
static void test_an_affine_deformation_is_that_of_the_corners(void **state)
{
    static const double factor = 1.5;
    struct snapshot snapshot = body(affine);
    int64_t nodes[NODES], count;
    (void)state;
    struct cell *cells = cells_of(&snapshot, 12, factor, nodes, &count);
    for (int64_t k = 0; k < count; k++)
        for (int c = 0; c < 4; c++) {
            const double x[2] = {at_rest(&snapshot, nodes[k], c, 0),
                                 at_rest(&snapshot, nodes[k], c, 1)};
            double u[2];
            affine(x[0], x[1], u);
            for (int a = 0; a < 2; a++)
                assert_near(cells[k].corner[c][a], x[a] + factor * u[a], 1e-13);
        }
    free(cells);
    release(&snapshot);
}

static void wavy(double x, double y, double u[2])
{
    u[0] = 0.4 * sin(x + 0.3 * y);
    u[1] = 0.3 * cos(1.7 * y) * x / 8;
}

/* The same bits: what is drawn next to each other leaves no slit. */
static void test_neighbours_share_corners(void **state)
{
    struct snapshot snapshot = body(wavy);
    int64_t nodes[NODES], count;
    (void)state;
    struct cell *cells = cells_of(&snapshot, -1, 1, nodes, &count);
    for (int i = 0; i < NODES; i++) {
        const size_t bytes = sizeof cells[i].corner[0];
        if (i % COLUMNS < COLUMNS - 1) {
            assert_memory_equal(cells[i].corner[1], cells[i + 1].corner[0], bytes);
            assert_memory_equal(cells[i].corner[2], cells[i + 1].corner[3], bytes);
        }
        if (i / COLUMNS < ROWS - 1) {
            assert_memory_equal(cells[i].corner[3], cells[i + COLUMNS].corner[0], bytes);
            assert_memory_equal(cells[i].corner[2], cells[i + COLUMNS].corner[1], bytes);
        }
    }
    free(cells);
    release(&snapshot);
}

/* Stretched by 10 %, and the right part, from x = 5 m on, 4 m further away. */
static void broken(double x, double y, double u[2])
{
    (void)y;
    u[0] = 0.1 * x + (x > 5 ? 4 : 0);
    u[1] = 0;
}

static void test_parts_of_a_broken_body_stay_apart(void **state)
{
    struct snapshot snapshot = body(broken);
    int64_t nodes[NODES], count;
    (void)state;
    struct cell *cells = cells_of(&snapshot, -1, 1, nodes, &count);
    for (int i = 0; i < NODES; i++)
        for (int c = 0; c < 4; c++) {
            const double x = at_rest(&snapshot, i, c, 0);
            const double shift = snapshot.domain.x[i] > 5 ? 4 : 0;
            assert_near(cells[i].corner[c][0], 1.1 * x + shift, 1e-13);
        }
    free(cells);
    release(&snapshot);
}

static void test_scattered_particles_are_squares(void **state)
{
    struct snapshot snapshot = body(affine);
    int64_t nodes[NODES], count;
    (void)state;
    memset(snapshot.edge, 0, sizeof snapshot.edge);
    struct cell *cells = cells_of(&snapshot, -1, 1, nodes, &count);
    for (int i = 0; i < NODES; i++) {
        const double x = snapshot.domain.x[i] + snapshot.displacement[0][i];
        assert_near(cells[i].corner[0][0], x - 1, 1e-13);
        assert_near(cells[i].corner[2][0], x + 1, 1e-13);
    }
    free(cells);
    release(&snapshot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_affine_deformation_is_that_of_the_corners),
        cmocka_unit_test(test_neighbours_share_corners),
        cmocka_unit_test(test_parts_of_a_broken_body_stay_apart),
        cmocka_unit_test(test_scattered_particles_are_squares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
