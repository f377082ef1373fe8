/* kernels - what a force evaluation and a step of each formulation cost, in CSV on standard output:
 * model, instruction set, nodes, ns per ordered bond and per node, node-steps per second, bytes of
 * memory per node, the bound, its share, and the whole step's cost over the force's.  No test: make
 * bench.
 *
 * A body of NX x NY x NZ particles (default 200 x 40 x 8); a bond counts twice, once from either
 * end.  Of ROUNDS alternating rounds over all models the median.  Bounds, measured in the same run:
 * a square root and a division, in cache, for each pair and pass of bonds, or the bandwidth of a
 * triad beyond the caches for e^p of bonds that yield; the updates of the constitutive law, in
 * cache: four a node of correspondence with mix, one or five a particle of corner. */
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

#define CORNER(form, points, yield, state, stretch, flows)                                         \
    {                                                                                              \
        .name = "corner, " form state, .residual = "{form: " form "}", .laws = points,             \
        .materials = "{A: {model: corner, " ELASTIC ", hardening: {law: voce, yield: " yield       \
                     ", saturation: 513 MPa, rate: 5.32}}}",                                       \
        .strain = stretch, .yields = flows                                                         \
    }

#define CORRESPONDENCE(spacings, yield, state, stretch, flows)                                     \
    {                                                                                              \
        .name = "correspondence, mix, horizon " spacings state, .horizon = spacings[0] - '0',      \
        .stabilisation = small_mix, .laws = 4,                                                     \
        .materials =                                                                               \
            "{A: {model: correspondence, " ELASTIC ", hardening: {law: voce, yield: " yield        \
            ", saturation: 513 MPa, rate: 5.32}}}",                                                \
        .strain = stretch, .yields = flows                                                         \
    }

static struct kernel {
    const char *name, *materials, *stabilisation, *residual;
    int laws; /* updates a particle, where there are no passes over bonds */
    double horizon;
    int passes;
    double traffic; /* bytes of e^p an ordered bond: read twice, written once */
    double strain;  /* of the shape it is timed in */
    bool yields;
    struct small_body small;
    double bytes, bonds, calls, force[ROUNDS], step[ROUNDS];
} kernels[] = {
    {.name = "bond_based",
     .horizon = 3.015,
     .materials = "{A: {model: bond_based, density: 8900, youngs_modulus: 210 GPa}}",
     .passes = 1,
     .strain = 1e-3},
    {.name = "ordinary",
     .horizon = 3.015,
     .materials = "{A: {model: ordinary, " ELASTIC "}}",
     .passes = 2,
     .strain = 1e-3},
    {.name = "ordinary_plastic, not yielding",
     .horizon = 3.015,
     .materials = PLASTIC("10 GPa"),
     .passes = 2,
     .strain = 1e-3},
    {.name = "ordinary_plastic, yielding",
     .horizon = 3.015,
     .materials = PLASTIC("185 MPa"),
     .passes = 2,
     .traffic = 3 * sizeof(double),
     .strain = 5e-3,
     .yields = true},
    CORRESPONDENCE("1", "10 GPa", ", not yielding", 1e-3, false),
    CORRESPONDENCE("1", "185 MPa", ", yielding", 5e-3, true),
    CORRESPONDENCE("2", "185 MPa", ", yielding", 5e-3, true),
    CORRESPONDENCE("3", "185 MPa", ", yielding", 5e-3, true),
    CORNER("flowing", 1, "10 GPa", ", not yielding", 1e-3, false),
    CORNER("flowing", 1, "185 MPa", ", yielding", 5e-3, true),
    CORNER("four_points", 5, "10 GPa", ", not yielding", 1e-3, false),
    CORNER("four_points", 5, "185 MPa", ", yielding", 5e-3, true),
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

/* Of corner the nodes are the particles' corners, some more than these. */
static double particles(const struct kernel *k)
{
    return (double)k->small.lattice.n_particles;
}

static void start(struct kernel *k, const int size[3])
{
    const double before = held();
    struct small_case wanted = {.horizon = k->horizon,
                                .materials = k->materials,
                                .stabilisation = k->stabilisation,
                                .residual = k->residual};
    for (int a = 0; a < 3; a++) wanted.size[a] = size[a];
    small_body_new(&k->small, &wanted);
    deform(k, 1);
    small_body_force(&k->small, true, false);
    k->bytes = (held() - before - (double)k->small.lattice.n_sites) / particles(k);
    k->bonds = 2 * (double)bonds_total(k->small.bonds);
    k->calls = k->passes ? ceil(4e7 / k->bonds) : ceil(4e5 / particles(k));
}

static double time_force(struct kernel *k, int round)
{
    const int calls = (int)k->calls;
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
    const int calls = (int)k->calls;
    const double begin = now();
    for (int i = 0; i < calls; i++)
        verlet_step(&integration, &k->small.body, &boundary, k->small.model, i % 16 == 15, false);
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

HS_SIMD static void triad(int64_t count, const double *restrict x, const double *restrict y,
                          double *restrict z)
{
    for (int64_t i = 0; i < count; i++) z[i] = x[i] + 3 * y[i];
}

/* Seconds of a byte read or written beyond the caches. */
static double time_byte(double *const arrays[3], int64_t count)
{
    const double begin = now();
    triad(count, arrays[0], arrays[1], arrays[2]);
    return (now() - begin) / (3 * sizeof(double)) / (double)count;
}

/* Seconds of one update of the constitutive law, of points that flow or not, in cache. */
static double time_law(const struct kernel *k)
{
    enum { TIMES = 2000 };
    const struct law_in_use *use = &k->small.materials.laws[k->small.materials.law_of[0]];
    struct points strip = {.count = LANES};
    double state[SMALL_STATE * LANES];
    for (int i = 0; i < LANES; i++) {
        strip.mu[i] = k->small.materials.shear[0];
        strip.bulk[i] = k->small.materials.bulk[0];
    }
    law_start(use->law, use->pairs, &strip, state, LANES);
    const double begin = now();
    for (int t = 0; t < TIMES; t++) {
        const double e = k->strain * (1 + (k->yields ? 1e-3 * t : 0));
        for (int i = 0; i < LANES; i++) {
            strip.H[0][i] = e;
            strip.H[4][i] = strip.H[8][i] = -0.3 * e;
        }
        use->law->update(use->pairs, &strip, state, LANES, (struct step){.commit = true});
    }
    return (now() - begin) / TIMES / LANES;
}

static const char *instruction_set(void)
{
#ifndef HS_NO_AVX512
    if (__builtin_cpu_supports("avx512f")) return "avx512";
#endif
    return __builtin_cpu_supports("avx2") ? "avx2" : "sse2";
}

int main(int argc, char **argv)
{
    int size[3] = {200, 40, 8};
    for (int a = 0; a < 3 && argc > 3; a++) size[a] = atoi(argv[1 + a]);
    double root[ROUNDS], byte[ROUNDS], law[KERNELS][ROUNDS], *arrays[3];
    const int64_t beyond = INT64_C(1) << 23;
    small_ranks_start(NULL);
    for (int a = 0; a < 3; a++) arrays[a] = memory_new((size_t)beyond + 1024, sizeof(double));
    for (int k = 0; k < KERNELS; k++) start(&kernels[k], size);
    for (int round = 0; round < ROUNDS; round++) {
        root[round] = time_roots();
        /* A third of a page apart: see box_fields.h. */
        byte[round] = time_byte((double *[]){arrays[0], arrays[1] + 168, arrays[2] + 336}, beyond);
        for (int k = 0; k < KERNELS; k++) {
            kernels[k].force[round] = time_force(&kernels[k], round);
            kernels[k].step[round] = time_step(&kernels[k]);
            if (!kernels[k].passes) law[k][round] = time_law(&kernels[k]);
        }
    }
    const double per_root = median(root), per_byte = median(byte);
    for (int a = 0; a < 3; a++) free(arrays[a]);
    printf("model,isa,nodes,ns_per_bond,ns_per_node,node_steps_per_s,bytes_per_node,bound,"
           "bound_ns_per_node,share_of_bound,step_over_force\n");
    for (int k = 0; k < KERNELS; k++) {
        struct kernel *kernel = &kernels[k];
        const double force = median(kernel->force), step = median(kernel->step),
                     nodes = particles(kernel),
                     bound = kernel->passes ? fmax(0.5 * kernel->passes * per_root,
                                                   kernel->traffic * per_byte) *
                                                  kernel->bonds
                                            : kernel->laws * median(law[k]) * nodes;
        printf("\"%s\",%s,%.0f,%.3f,%.1f,%.3g,%.0f,%s,%.1f,%.2f,%.3f\n", kernel->name,
               instruction_set(), nodes, kernel->passes ? 1e9 * force / kernel->bonds : NAN,
               1e9 * force / nodes, nodes / step, kernel->bytes,
               !kernel->passes                                                ? "the law"
               : kernel->traffic * per_byte > 0.5 * kernel->passes * per_root ? "memory"
                                                                              : "root and division",
               1e9 * bound / nodes, bound / force, step / force);
        small_body_free(&kernel->small);
    }
    small_ranks_stop(NULL);
    return 0;
}
