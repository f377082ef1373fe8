/* kernels - what a force evaluation and a step of each formulation cost, in CSV on standard output: model, nodes, ns per
 * ordered bond, bytes of memory per node, share of the bounds measured in the same run, steps' cost beside the force.
 * No test: make bench.
 *
 * A body of NX x NY x NZ particles (default 200 x 40 x 8) with horizon 3.015; a bond counts twice, once from either
 * end.  Of ROUNDS alternating rounds over all models the median.  Bounds: a square root and a division per
 * pair and pass; what a step reads and writes of the nodes' fields, at the rate of a triad. */
#include "check.h"

#include "balance.h"
#include "integration.h"
#include "memory.h"
#include "small_body.h"
#include "verlet.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ROUNDS = 7 };

#define ELASTIC "density: 8900, youngs_modulus: 210 GPa, poissons_ratio: 0.31"
#define PLASTIC(yield)                                                                             \
    "{A: {model: ordinary_plastic, " ELASTIC ", hardening: {law: linear, yield: " yield            \
    ", modulus: 898 MPa}}}"

static struct kernel {
    const char *name, *materials;
    int influence, passes;
    double strain; /* of the shape it is timed in */
    bool yields;
    struct small_body small;
    double bytes, bonds, force[ROUNDS], step[ROUNDS];
} kernels[] = {
    {.name = "bond_based",
     .materials = "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}}",
     .passes = 1,
     .strain = 1e-3},
    {.name = "ordinary",
     .materials = "{A: {model: ordinary, " ELASTIC "}}",
     .passes = 2,
     .strain = 1e-3},
    {.name = "ordinary_plastic, not yielding",
     .materials = PLASTIC("10 GPa"),
     .passes = 2,
     .strain = 1e-3},
    {.name = "ordinary_plastic, yielding",
     .materials = PLASTIC("185 MPa"),
     .passes = 2,
     .strain = 5e-3,
     .yields = true},
};
enum { KERNELS = sizeof kernels / sizeof *kernels };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double values[ROUNDS])
{
    qsort(values, ROUNDS, sizeof *values, compare);
    return values[ROUNDS / 2];
}

static double held(void)
{
    const struct mallinfo2 info = mallinfo2();
    return (double)info.uordblks + (double)info.hblkhd;
}

/* Stretched a little more at each call, so that what yields goes on yielding. */
static void deform(struct kernel *k, double factor)
{
    const double e = k->strain * factor;
    small_body_deform(&k->small, (const double[]){e, 0, 0, 0, -0.3 * e, 0, 0, 0, -0.3 * e});
}

static void start(struct kernel *k, const int size[3])
{
    const double before = held();
    struct small_case wanted = {.horizon = 3.015, .materials = k->materials};
    for (int a = 0; a < 3; a++) wanted.size[a] = size[a];
    small_body_new(&k->small, &wanted);
    deform(k, 1);
    small_body_force(&k->small, true, false);
    k->bytes = (held() - before - (double)k->small.lattice.n_sites) / (double)k->small.body.n_nodes;
    k->bonds = 2 * (double)bonds_total(k->small.bonds);
}

static double time_force(struct kernel *k, int round)
{
    const int calls = (int)ceil(4e7 / k->bonds);
    double sum = 0;
    for (int i = 0; i < calls; i++) {
        if (k->yields) deform(k, 1 + 1e-3 * (calls * (round + 1) + i));
        const double begin = now();
        small_body_force(&k->small, true, false);
        sum += now() - begin;
    }
    return sum / calls;
}

static double time_step(struct kernel *k)
{
    struct boundary boundary = small_free_boundary();
    struct integration integration = integration_new(true, 1e-10, 0, &k->small.materials,
                                                     &k->small.body, &boundary, k->small.model);
    const int calls = (int)ceil(4e7 / k->bonds);
    const double begin = now();
    for (int i = 0; i < calls; i++)
        verlet_step(&integration, &k->small.body, &boundary, k->small.model, i % 16 == 15, NULL);
    const double spent = now() - begin;
    integration_free(&integration);
    boundary_free(&boundary);
    return spent / calls;
}

HS_SIMD static void roots(int count, const double *restrict x, double *restrict y)
{
    for (int i = 0; i < count; i++) y[i] = x[i] / (1 + sqrt(x[i]));
}

/* Seconds of a square root and a division, in cache. */
static double time_roots(void)
{
    enum { COUNT = 1024, TIMES = 4000 };
    static double x[COUNT], y[COUNT];
    for (int i = 0; i < COUNT; i++) x[i] = 1 + i;
    const double begin = now();
    for (int t = 0; t < TIMES; t++) {
        roots(COUNT, x, y);
        x[t % COUNT] += y[t % COUNT];
    }
    return (now() - begin) / COUNT / TIMES;
}

HS_SIMD static void triad(int64_t count, const double *restrict b, const double *restrict c,
                          double *restrict a)
{
    for (int64_t i = 0; i < count; i++) a[i] = b[i] + 3 * c[i];
}

/* Bytes per second of a triad beyond the caches. */
static double time_triad(double *const field[3], int64_t count)
{
    const double begin = now();
    triad(count, field[0], field[1], field[2]);
    return 24 * (double)count / (now() - begin);
}

int main(int argc, char **argv)
{
    int size[3] = {200, 40, 8};
    for (int a = 0; a < 3 && argc > 3; a++) size[a] = atoi(argv[1 + a]);
    enum { COUNT = 8000000 };
    double *field[3], root[ROUNDS], rate[ROUNDS];
    small_ranks_start(NULL);
    for (int k = 0; k < KERNELS; k++) start(&kernels[k], size);
    for (int a = 0; a < 3; a++) {
        field[a] = memory_new(COUNT, sizeof(double));
        for (int64_t i = 0; i < COUNT; i++) field[a][i] = 1;
    }
    for (int round = 0; round < ROUNDS; round++) {
        root[round] = time_roots();
        rate[round] = time_triad(field, COUNT);
        for (int k = 0; k < KERNELS; k++) kernels[k].force[round] = time_force(&kernels[k], round);
        for (int k = 0; k < KERNELS; k++) kernels[k].step[round] = time_step(&kernels[k]);
    }
    const double per_root = median(root), per_second = median(rate);
    printf("model,nodes,ns_per_bond,bytes_per_node,roots_ns_per_bond,share_of_roots,"
           "triad_gb_per_s,step_over_force\n");
    for (int k = 0; k < KERNELS; k++) {
        struct kernel *kernel = &kernels[k];
        const double force = median(kernel->force),
                     roots_only = 0.5 * kernel->passes * per_root * kernel->bonds;
        printf("\"%s\",%lld,%.3f,%.0f,%.3f,%.2f,%.1f,%.3f\n", kernel->name,
               (long long)kernel->small.body.n_nodes, 1e9 * force / kernel->bonds, kernel->bytes,
               1e9 * roots_only / kernel->bonds, roots_only / force, 1e-9 * per_second,
               median(kernel->step) / force);
        small_body_free(&kernel->small);
    }
    for (int a = 0; a < 3; a++) free(field[a]);
    small_ranks_stop(NULL);
    return 0;
}
