#include "symbol.h"

#include "bond_search.h"
#include "corners.h"
#include "material.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A block whose middle node and all that answer to it have whole families. */
static struct lattice block_new(const struct lattice *like, int reach, int phase)
{
    struct lattice block = *like;
    block.volume = block.grain = NULL;
    block.corner = NULL;
    block.hexahedron = NULL;
    memset(block.periodic, 0, sizeof block.periodic);
    memset(block.mirror, 0, sizeof block.mirror);
    for (int a = 0; a < 3; a++) block.point[a] = NULL;
    block.n_sites = 1;
    for (int a = 0; a < 3; a++) {
        block.size[a] = a == 2 && like->dimensions == 2 ? 1 : 2 * (4 * reach + 2) + 1;
        block.n_sites *= block.size[a];
    }
    block.n_nodes = block.n_particles = block.n_sites;
    block.phase = memory_new((size_t)block.n_sites, 1);
    for (int64_t i = 0; i < block.n_sites; i++) block.phase[i] = (uint8_t)phase;
    if (!like->corner) return block;
    const struct lattice corners = corners_lattice(&block);
    lattice_free(&block);
    return corners;
}

static int64_t corner(const struct symbol *symbol, int x, int y, int z)
{
    return ((int64_t)z * (symbol->reach[1] + 1) + y) * (symbol->reach[0] + 1) + x;
}

/* The entry of the components a and b. */
static int entry_of(int a, int b)
{
    return a == b ? a : 6 - a - b;
}

/* What moving a node along a has for its answer along b. */
static void push(const struct symbol *symbol, struct model *model, struct body *body, int a,
                 double *const answer[3])
{
    int middle[3];
    for (int b = 0; b < 3; b++) middle[b] = body->lattice->size[b] / 2;
    const int64_t site = grid_site(&body->grid, middle);
    const double way = 1e-7 * body->lattice->spacing;
    for (int sign = 1; sign >= -1; sign -= 2) {
        body->u[a][site] = sign * way;
        model_force(model, body, (struct force_mode){.frozen = true}, NULL);
        for (int z = 0; z <= symbol->reach[2]; z++)
            for (int y = 0; y <= symbol->reach[1]; y++)
                for (int x = 0; x <= symbol->reach[0]; x++) {
                    const int step[3] = {x, y, z};
                    for (int b = a; b < 3; b++)
                        answer[b][corner(symbol, x, y, z)] -=
                            0.5 * sign * body->f[b][site + grid_shift(&body->grid, step)] / way;
                }
    }
    body->u[a][site] = 0;
}

struct symbol symbol_new(struct deck_node solver, const struct family *family,
                         const struct materials *materials, const struct lattice *lattice,
                         int phase)
{
    struct symbol symbol = {{0}, {0}};
    const int reach = lattice->corner ? 1 : 3 * family->reach;
    struct lattice block = block_new(lattice, lattice->corner ? 1 : family->reach, phase);
    size_t size = 1;
    for (int a = 0; a < 3; a++) {
        /* Force to stress, along a bond of the stabilisation, and to strain. */
        symbol.reach[a] = block.size[a] > 1 ? reach : 0;
        size *= (size_t)symbol.reach[a] + 1;
    }
    const struct offset *near;
    struct model *model = model_new(solver, family, materials);
    const int n_near = model_near(model, family, &near);
    /* Each rank has a block of its own. */
    struct body body = body_new(&block, family, near, n_near, (struct ranks){0, 1});
    if (lattice->corner) {
        const double density[ABSENT] = {0};
        corners_fill(&body, density);
    }
    struct bonds *bonds = bonds_new(&body);
    model_start(model, &body, bonds);
    for (int e = 0; e < SYMBOL_ENTRIES; e++) symbol.answer[e] = memory_new(size, sizeof(double));
    for (int a = 0; a < 3; a++) {
        double *answers[3];
        for (int b = 0; b < 3; b++) answers[b] = symbol.answer[entry_of(a, b)];
        push(&symbol, model, &body, a, answers);
    }
    model_free(model);
    bonds_free(bonds);
    body_free(&body);
    lattice_free(&block);
    return symbol;
}

void symbol_free(struct symbol *symbol)
{
    for (int e = 0; e < SYMBOL_ENTRIES; e++) free(symbol->answer[e]);
    *symbol = (struct symbol){{0}, {0}};
}

/* waves[n (reach + 1)]: cos(k r) or sin(k r), twice where r stands for -r, too. */
static double *waves_of(int n, const double *k, int reach, bool sine)
{
    double *waves = memory_new((size_t)n * ((size_t)reach + 1), sizeof *waves);
    for (int i = 0; i < n; i++)
        for (int r = 0; r <= reach; r++)
            waves[i * (reach + 1) + r] = (r > 0 ? 2 : 1) * (sine ? sin(k[i] * r) : cos(k[i] * r));
    return waves;
}

/* out[(o n + i) inner + j] = sum over r of waves[i][r] in[(o (reach + 1) + r) inner + j] */
static void contract(int64_t outer, int n, int reach, int64_t inner, const double *waves,
                     const double *in, double *out)
{
    for (int64_t o = 0; o < outer; o++)
        for (int i = 0; i < n; i++) {
            double *row = out + (o * n + i) * inner;
            for (int64_t j = 0; j < inner; j++) row[j] = 0;
            for (int r = 0; r <= reach; r++) {
                const double c = waves[i * (reach + 1) + r],
                             *from = in + (o * (reach + 1) + r) * inner;
                for (int64_t j = 0; j < inner; j++) row[j] += c * from[j];
            }
        }
}

void symbol_evaluate(const struct symbol *symbol, int entry, const int n[3], double *const k[3],
                     double *values)
{
    const int *reach = symbol->reach;
    const int64_t plane = (int64_t)n[0] * n[1];
    double *waves[3],
        *lines =
            memory_new((size_t)n[0] * (size_t)((reach[1] + 1) * (reach[2] + 1)), sizeof *lines),
        *planes = memory_new((size_t)plane * (size_t)(reach[2] + 1), sizeof *planes);
    for (int b = 0; b < 3; b++)
        waves[b] = waves_of(n[b], k[b], reach[b], entry >= 3 && b != entry - 3);
    contract((int64_t)(reach[1] + 1) * (reach[2] + 1), n[0], reach[0], 1, waves[0],
             symbol->answer[entry], lines);
    contract(reach[2] + 1, n[1], reach[1], n[0], waves[1], lines, planes);
    contract(1, n[2], reach[2], plane, waves[2], planes, values);
    for (int b = 0; b < 3; b++) free(waves[b]);
    free(lines);
    free(planes);
}
