#include "small_static.h"

#include "check.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

struct small_static small_static_new(struct small_body *small)
{
    struct small_static problem = {.small = small};
    for (int a = 0; a < 3; a++) {
        const size_t n = (size_t)small->body.grid.n_sites;
        problem.held[a] = memory_new(n, sizeof(double));
        problem.load[a] = memory_new(n, sizeof(double));
        problem.u[a] = memory_new(n, sizeof(double));
    }
    return problem;
}

void small_static_free(struct small_static *problem)
{
    for (int a = 0; a < 3; a++) {
        free(problem->held[a]);
        free(problem->load[a]);
        free(problem->u[a]);
    }
}

/* Stiffness times a field, over the density of volume: minus the force at a ten millionth of a
 * spacing. */
static void multiply(struct small_static *problem, double *const field[3], double *product[3])
{
    struct small_body *small = problem->small;
    const int64_t n = small->body.grid.n_sites;
    const double most = small_body_largest(small, field),
                 scale = most > 0 ? 1e-7 * SMALL_SPACING / most : 0;
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < n; i++)
            small->body.u[a][i] = small_body_has(small, i) ? scale * field[a][i] : 0;
    small_body_force(small, false, true);
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < n; i++)
            product[a][i] = small_body_has(small, i) && scale > 0 && problem->held[a][i] == 0
                                ? -small->body.f[a][i] / scale
                                : 0;
}

void small_static_solve(struct small_static *problem, double tolerance, int most_steps)
{
    struct small_body *small = problem->small;
    const int64_t n = small->body.grid.n_sites;
    double *rest[3], *way[3], *product[3];
    for (int a = 0; a < 3; a++) {
        rest[a] = memory_new((size_t)n, sizeof(double));
        way[a] = memory_new((size_t)n, sizeof(double));
        product[a] = memory_new((size_t)n, sizeof(double));
    }
    multiply(problem, problem->u, product);
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < n; i++)
            way[a][i] = rest[a][i] =
                problem->held[a][i] == 0 ? problem->load[a][i] - product[a][i] : 0;
    double square = small_body_product(small, rest, rest);
    const double goal = tolerance * tolerance * square;
    int step = 0;
    for (; square > goal && step < most_steps; step++) {
        multiply(problem, way, product);
        const double along = square / small_body_product(small, way, product), before = square;
        for (int a = 0; a < 3; a++)
            for (int64_t i = 0; i < n; i++) {
                problem->u[a][i] += along * way[a][i];
                rest[a][i] -= along * product[a][i];
            }
        square = small_body_product(small, rest, rest);
        for (int a = 0; a < 3; a++)
            for (int64_t i = 0; i < n; i++) way[a][i] = rest[a][i] + square / before * way[a][i];
    }
    assert_true(step < most_steps);
    for (int a = 0; a < 3; a++) {
        free(rest[a]);
        free(way[a]);
        free(product[a]);
    }
}
