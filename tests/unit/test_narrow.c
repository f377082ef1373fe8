/* Directions in sixteen bits: their products with vectors beside those of what they were made of,
 * whatever the order of the nodes, and at the limits of the integers. */
#include "check.h"
#include "direction.h"
#include "memory.h"
#include "narrow.h"

#include <math.h>
#include <stdlib.h>

enum { NODES = 1000, MEAN = 2, LENGTH = 3 * NODES + MEAN };

struct vectors {
    struct body body;
    struct unknowns unknowns;
    float *d;
    double *y;
};

static struct vectors vectors_new(void)
{
    struct vectors v = {.body = {.n_nodes = NODES, .ranks = {0, 1}}};
    v.unknowns = (struct unknowns){.n_nodes = NODES, .length = LENGTH, .n_mean = MEAN};
    v.d = memory_new(LENGTH, sizeof *v.d);
    v.y = memory_new(LENGTH, sizeof *v.y);
    return v;
}

/* d.y by narrow_products, beside that of the direction itself. */
static double product_of(struct vectors *v)
{
    double of_nodes, products[2];
    v->unknowns.body = &v->body;
    struct narrow narrow = narrow_new(&v->unknowns);
    const double largest = direction_largest(&v->unknowns, v->d, &of_nodes);
    narrow_take(&v->unknowns, v->d, of_nodes, &narrow);
    narrow_products(&v->unknowns, 1, (const struct narrow *[]){&narrow}, v->d, largest, v->y,
                    vector_norm(&v->unknowns, v->y), products);
    assert_true(products[1] == direction_product(&v->unknowns, v->d, v->y));
    narrow_free(&narrow);
    return products[0];
}

static double exact_product(const struct vectors *v, double *bound)
{
    double product = 0, dd = 0, yy = 0;
    for (int i = 0; i < LENGTH; i++) {
        product += (double)v->d[i] * v->y[i];
        dd += (double)v->d[i] * v->d[i];
        yy += v->y[i] * v->y[i];
    }
    *bound = sqrt(dd * yy);
    return product;
}

static void fill(struct vectors *v)
{
    for (int i = 0; i < LENGTH; i++) {
        v->d[i] = (float)(1e-7 * sin(0.7 * i) * exp(-0.01 * (i % NODES)));
        v->y[i] = 1e14 * cos(0.7 * i + 1) * (i % 17);
    }
}

/* Each number is off by half a unit, 2^-16 of the largest, at most. */
static void test_product(void **state)
{
    (void)state;
    struct vectors v = vectors_new();
    double bound;
    fill(&v);
    const double product = product_of(&v), exact = exact_product(&v, &bound);
    assert_near(product, exact, 0x1p-16 * bound);
    assert_true(fabs(exact) > 0x1p-8 * bound);
    /* Nodes the other way round: the same bits. */
    for (int a = 0; a < 3; a++)
        for (int i = 0, j = NODES - 1; i < j; i++, j--) {
            float *d = v.d + a * NODES, number = d[i];
            double *y = v.y + a * NODES, other = y[i];
            d[i] = d[j];
            d[j] = number;
            y[i] = y[j];
            y[j] = other;
        }
    assert_true(product_of(&v) == product);
    free(v.d);
    free(v.y);
}

/* All as large as they may be, or one alone: the sums of integers are then the largest. */
static void test_limits(void **state)
{
    (void)state;
    for (int first = 0; first < 4; first++) {
        struct vectors v = vectors_new();
        double bound;
        const int last = first < 3 ? first * NODES + 1 : 3 * NODES;
        for (int i = first < 3 ? first * NODES : 0; i < last; i++) {
            v.d[i] = -1;
            v.y[i] = 0x1.fffffp0;
        }
        assert_near(product_of(&v), exact_product(&v, &bound), 1e-5 * bound);
        free(v.d);
        free(v.y);
    }
}

/* Rounding of single precision, and a unit's half for each direction. */
static void test_combination(void **state)
{
    (void)state;
    static const double factors[] = {-0.5, 2};
    struct vectors v = vectors_new();
    double of_nodes;
    fill(&v);
    v.unknowns.body = &v.body;
    struct narrow x = narrow_new(&v.unknowns), y = narrow_new(&v.unknowns);
    float *d = direction_new(&v.unknowns);
    direction_largest(&v.unknowns, v.d, &of_nodes);
    narrow_take(&v.unknowns, v.d, of_nodes, &x);
    narrow_take(&v.unknowns, v.d, of_nodes, &y);
    narrow_scale(3, &y);
    const uint32_t bits =
        narrow_combine(&v.unknowns, 4, v.d, 2, factors, (const struct narrow *[]){&x, &y}, d);
    assert_int_equal(bits, direction_bits(3 * NODES, d));
    for (int i = 0; i < LENGTH; i++)
        assert_near(d[i], (4 - 0.5 + 2 * 3) * v.d[i],
                    (i < 3 * NODES ? 6.5 * 0x1p-16 * of_nodes : 0) + 1e-6 * fabsf(v.d[i]));
    narrow_free(&x);
    narrow_free(&y);
    free(d);
    free(v.d);
    free(v.y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_product),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_combination),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
