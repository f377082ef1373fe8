#include "folding.h"

#include "memory.h"
#include "simd.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = FOLDING_WIDTH };

/* Rows and columns of a part from which on sums and differences cost less than they save. */
enum { WORTHWHILE = 12 };
/* Rows multiplied at once. */
enum { TILE = 6 };

/* Either sums and differences of pairs, in place, or the product with a block. */
enum step_kind { BEFORE, MULTIPLY, AFTER }; /* pairs of in, block, pairs of out */
struct step {
    enum step_kind kind;
    int n_from, n_to;
    int *from, *to; /* numbers of in and of out; of pairs the first and the mirrored one */
    float *matrix;  /* [tile][from][row of the tile] */
};

struct folding {
    int64_t cost;
    int count;
    struct step *steps;
};

/* Rows and columns of the whole matrix. */
struct block {
    int n_rows, n_columns;
    int *rows, *columns;
};

static struct block block_new(int n_rows, int n_columns)
{
    return (struct block){0, 0, memory_new((size_t)n_rows, sizeof(int)),
                          memory_new((size_t)n_columns, sizeof(int))};
}

static void block_free(struct block *block)
{
    free(block->rows);
    free(block->columns);
}

/* The matrix, or its transposed. */
struct view {
    const double *numbers;
    int64_t row, column;
    double slack; /* by which mirrored numbers differ */
};

static double number(const struct view *view, int row, int column)
{
    return view->numbers[row * view->row + column * view->column];
}

/* Column that mirrors this one, about the middle of those from first on. */
static int mirrored(int n, int first, int i)
{
    return i < first ? i : n - 1 - (i - first);
}

/* +1: the row is even, -1: odd, 0: neither. */
static int parity(const struct view *view, const struct block *block, int row, int first)
{
    bool even = true, odd = true;
    for (int i = 0; i < block->n_columns && (even || odd); i++) {
        const double a = number(view, row, block->columns[i]),
                     b = number(view, row, block->columns[mirrored(block->n_columns, first, i)]);
        even &= fabs(a - b) <= view->slack;
        odd &= fabs(a + b) <= view->slack;
    }
    return even ? 1 : odd ? -1 : 0;
}

/* Splits a block into that of its even rows, with the columns up to the middle, and that of its odd
 * rows, with those that mirror them; false where it has no such symmetry. */
static bool split(const struct view *view, const struct block *block, struct block halves[2],
                  int *first)
{
    const int n = block->n_columns;
    for (*first = 0; *first < 2 && n - *first >= 2; ++*first) {
        int r = 0;
        for (int half = 0; half < 2; half++) halves[half] = block_new(block->n_rows, n);
        for (int i = 0; i < n; i++) {
            struct block *half = &halves[i > mirrored(n, *first, i)];
            half->columns[half->n_columns++] = block->columns[i];
        }
        for (; r < block->n_rows; r++) {
            const int sign = parity(view, block, block->rows[r], *first);
            struct block *half = &halves[sign < 0];
            if (sign == 0) break;
            half->rows[half->n_rows++] = block->rows[r];
        }
        if (r == block->n_rows) return true;
        for (int half = 0; half < 2; half++) block_free(&halves[half]);
    }
    return false;
}

static struct step *add_step(struct folding *folding, enum step_kind kind, int n_from, int n_to)
{
    folding->steps = memory_grow(folding->steps, folding->count, sizeof *folding->steps);
    struct step *step = &folding->steps[folding->count++];
    *step = (struct step){.kind = kind,
                          .n_from = n_from,
                          .n_to = n_to,
                          .from = memory_new((size_t)n_from, sizeof(int)),
                          .to = memory_new((size_t)n_to, sizeof(int))};
    return step;
}

static void add_pairs(struct folding *folding, enum step_kind kind, int n, const int *numbers,
                      int first)
{
    const int count = (n - first) / 2;
    struct step *step = add_step(folding, kind, count, count);
    for (int i = 0; i < count; i++) {
        step->from[i] = numbers[first + i];
        step->to[i] = numbers[mirrored(n, first, first + i)];
    }
}

static void add_product(struct folding *folding, const struct view *view, const struct block *block)
{
    const int rows = block->n_rows, columns = block->n_columns;
    struct step *step = add_step(folding, MULTIPLY, columns, rows);
    memcpy(step->from, block->columns, (size_t)columns * sizeof(int));
    memcpy(step->to, block->rows, (size_t)rows * sizeof(int));
    step->matrix = memory_new((size_t)rows * (size_t)columns, sizeof(float));
    float *at = step->matrix;
    for (int tile = 0; tile < rows; tile += TILE)
        for (int j = 0; j < columns; j++)
            for (int k = tile; k < rows && k < tile + TILE; k++)
                *at++ = (float)number(view, block->rows[k], block->columns[j]);
    folding->cost += (int64_t)rows * columns;
}

static void exchange(struct block *block)
{
    const struct block before = *block;
    *block = (struct block){before.n_columns, before.n_rows, before.columns, before.rows};
}

static void fold(struct folding *folding, const struct view *view, const struct block *block,
                 int worthwhile);

/* across: columns mirror each other, else rows, which are the columns of the transposed matrix. */
static bool fold_along(struct folding *folding, const struct view *view, const struct block *block,
                       bool across)
{
    struct block halves[2], turned = *block;
    struct view seen = *view;
    int first;
    if (!across) {
        exchange(&turned);
        seen.row = view->column;
        seen.column = view->row;
    }
    if (!split(&seen, &turned, halves, &first)) return false;
    if (across) add_pairs(folding, BEFORE, turned.n_columns, turned.columns, first);
    for (int half = 0; half < 2; half++) {
        if (!across) exchange(&halves[half]);
        fold(folding, view, &halves[half], WORTHWHILE);
        block_free(&halves[half]);
    }
    if (!across) add_pairs(folding, AFTER, turned.n_columns, turned.columns, first);
    return true;
}

static void fold(struct folding *folding, const struct view *view, const struct block *block,
                 int worthwhile)
{
    if (block->n_rows >= worthwhile && block->n_columns >= worthwhile &&
        (fold_along(folding, view, block, true) || fold_along(folding, view, block, false)))
        return;
    add_product(folding, view, block);
}

struct folding *folding_new(int rows, int columns, const double *matrix)
{
    struct folding *folding = memory_new(1, sizeof *folding);
    struct view view = {matrix, columns, 1, 0};
    struct block block = {rows, columns, memory_new((size_t)rows, sizeof(int)),
                          memory_new((size_t)columns, sizeof(int))};
    for (int i = 0; i < rows; i++) block.rows[i] = i;
    for (int i = 0; i < columns; i++) block.columns[i] = i;
    for (int64_t i = 0; i < (int64_t)rows * columns; i++)
        view.slack = fmax(view.slack, 1e-9 * fabs(matrix[i]));
    fold(folding, &view, &block, 2); /* once always: what is even then has no odd part at all */
    block_free(&block);
    return folding;
}

void folding_free(struct folding *folding)
{
    if (!folding) return;
    for (int i = 0; i < folding->count; i++) {
        free(folding->steps[i].from);
        free(folding->steps[i].to);
        free(folding->steps[i].matrix);
    }
    free(folding->steps);
    free(folding);
}

int64_t folding_cost(const struct folding *folding)
{
    return folding->cost;
}

/* WIDTH numbers as compilers keep them in registers, whatever width those have. */
typedef float lanes __attribute__((vector_size(WIDTH * sizeof(float))));

/* One tile of so many rows, a constant where this is called. */
HS_INLINE void multiply_tile(const struct step *step, const float *matrix, const lanes *in,
                             lanes *out, int tile, int rows)
{
    lanes sum[TILE];
    for (int k = 0; k < rows; k++) sum[k] = (lanes){0};
    for (int j = 0; j < step->n_from; j++, matrix += rows) {
        const lanes x = in[step->from[j]];
        for (int k = 0; k < rows; k++) sum[k] += matrix[k] * x;
    }
    for (int k = 0; k < rows; k++) out[step->to[tile + k]] = sum[k];
}

HS_SIMD static void multiply(const struct step *step, const lanes *in, lanes *out)
{
    for (int tile = 0; tile < step->n_to; tile += TILE) {
        const float *matrix = step->matrix + (int64_t)tile * step->n_from;
        switch (step->n_to - tile) {
        case 1:
            multiply_tile(step, matrix, in, out, tile, 1);
            break;
        case 2:
            multiply_tile(step, matrix, in, out, tile, 2);
            break;
        case 3:
            multiply_tile(step, matrix, in, out, tile, 3);
            break;
        case 4:
            multiply_tile(step, matrix, in, out, tile, 4);
            break;
        case 5:
            multiply_tile(step, matrix, in, out, tile, 5);
            break;
        default:
            multiply_tile(step, matrix, in, out, tile, TILE);
        }
    }
}

HS_SIMD static void combine(int count, const int *sum, const int *difference, float sign,
                            lanes *values)
{
    for (int i = 0; i < count; i++) {
        const lanes a = values[sum[i]], b = values[difference[i]];
        values[sum[i]] = a + sign * b;
        values[difference[i]] = b - sign * a;
    }
}

void folding_multiply(const struct folding *folding, float (*in)[WIDTH], float (*out)[WIDTH])
{
    for (int i = 0; i < folding->count; i++) {
        const struct step *step = &folding->steps[i];
        switch (step->kind) {
        case BEFORE:
            combine(step->n_from, step->from, step->to, 1, (lanes *)in);
            break;
        case MULTIPLY:
            multiply(step, (const lanes *)in, (lanes *)out);
            break;
        case AFTER:
            combine(step->n_from, step->from, step->to, -1, (lanes *)out);
            break;
        }
    }
}
