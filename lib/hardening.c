#include "hardening.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NUMBER(i, key, sign, dimension, least, most, words)                                        \
    {                                                                                              \
        .name = key, .kind = KEY_NUMBER, .place = offsetof(struct hardening, parameter[i]),        \
        .unit = dimension, .low = least, .high = most, .required = true, .help = words,            \
        .symbol = sign                                                                             \
    }
#define YIELD(i)    NUMBER(i, "yield", "Y", "Pa", 1, 1e13, "stress at first yield")
#define STRENGTH(i) NUMBER(i, "strength", "K", "Pa", 1, 1e13, "strength coefficient")
#define EXPONENT(i) NUMBER(i, "exponent", "n", "1", 1e-3, 1, "hardening exponent")
#define SATURATION(i, key, sign)                                                                   \
    NUMBER(i, key, sign, "Pa", 0, 1e13, "what hardening adds in the end")
#define RATE(i, key, sign) NUMBER(i, key, sign, "1", 0, 1e6, "how fast it comes")

/* Hollomon (1945), with a yield stress in the deck: sigma_y = max(Y, K p^n). */
static const struct key hollomon_keys[] = {
    STRENGTH(0), EXPONENT(1),
    NUMBER(2, "yield", "Y", "Pa", 1, 1e13, "stress at first yield, where K p^n is below it")};
static double hollomon_stress(const struct hardening *h, double p)
{
    return fmax(h->parameter[2], h->parameter[0] * pow(p, h->parameter[1]));
}
static double hollomon_slope(const struct hardening *h, double p)
{
    double k = h->parameter[0], n = h->parameter[1];
    return k * pow(p, n) < h->parameter[2] ? 0 : k * n * pow(p, n - 1);
}

/* Ludwik (1909): sigma_y = Y + K p^n.  Its slope is infinite at p = 0 for n < 1; the first 1e-9 of
 * plastic strain takes the chord. */
static const struct key ludwik_keys[] = {YIELD(0), STRENGTH(1), EXPONENT(2)};
static const double first_strain = 1e-9;
static double ludwik_stress(const struct hardening *h, double p)
{
    double k = h->parameter[1], n = h->parameter[2];
    if (n < 1 && p < first_strain)
        return h->parameter[0] + k * pow(first_strain, n) * p / first_strain;
    return h->parameter[0] + k * pow(p, n);
}
static double ludwik_slope(const struct hardening *h, double p)
{
    double k = h->parameter[1], n = h->parameter[2];
    if (n < 1 && p < first_strain) return k * pow(first_strain, n - 1);
    return k * n * pow(p, n - 1);
}

/* Swift (1952): sigma_y = K (e0 + p)^n.  The deck has the stress at first yield, Y = K e0^n, in the
 * place of the offset e0 that a fit finds. */
static const struct key swift_keys[] = {
    STRENGTH(0), NUMBER(1, "yield", "Y", "Pa", 1, 1e13, "stress at first yield, K e0^n"),
    EXPONENT(2)};
static const struct key swift_parameters[] = {
    STRENGTH(0), NUMBER(1, "offset", "e0", "1", 0, 1, "plastic strain before the test"),
    EXPONENT(2)};
static void swift_complete(struct hardening *h, struct deck_node map)
{
    if (h->parameter[1] > h->parameter[0])
        deck_error(map, "swift: the yield stress lies above the strength K");
    h->parameter[1] = pow(h->parameter[1] / h->parameter[0], 1 / h->parameter[2]);
}
static double swift_express(const struct hardening *h, int k)
{
    const double *a = h->parameter;
    return k == 1 ? a[0] * pow(a[1], a[2]) : a[k];
}
static double swift_stress(const struct hardening *h, double p)
{
    return h->parameter[0] * pow(h->parameter[1] + p, h->parameter[2]);
}
static double swift_slope(const struct hardening *h, double p)
{
    double n = h->parameter[2];
    return h->parameter[0] * n * pow(h->parameter[1] + p, n - 1);
}

/* Voce (1948): sigma_y = Y + Q (1 - exp(-b p)). */
static const struct key voce_keys[] = {YIELD(0), SATURATION(1, "saturation", "Q"),
                                       RATE(2, "rate", "b")};
static double voce_stress(const struct hardening *h, double p)
{
    return h->parameter[0] - h->parameter[1] * expm1(-h->parameter[2] * p);
}
static double voce_slope(const struct hardening *h, double p)
{
    return h->parameter[1] * h->parameter[2] * exp(-h->parameter[2] * p);
}

/* Two Voce terms: sigma_y = Y + Q1 (1 - exp(-b1 p)) + Q2 (1 - exp(-b2 p)). */
static const struct key two_voce_keys[] = {YIELD(0), SATURATION(1, "saturation", "Q1"),
                                           SATURATION(2, "saturation_2", "Q2"),
                                           RATE(3, "rate", "b1"), RATE(4, "rate_2", "b2")};
static double two_voce_stress(const struct hardening *h, double p)
{
    const double *a = h->parameter;
    return a[0] - a[1] * expm1(-a[3] * p) - a[2] * expm1(-a[4] * p);
}
static double two_voce_slope(const struct hardening *h, double p)
{
    const double *a = h->parameter;
    return a[1] * a[3] * exp(-a[3] * p) + a[2] * a[4] * exp(-a[4] * p);
}

/* sigma_y = Y + H p */
static const struct key linear_keys[] = {
    YIELD(0), NUMBER(1, "modulus", "H", "Pa", 0, 1e13, "hardening modulus")};
static double linear_stress(const struct hardening *h, double p)
{
    return h->parameter[0] + h->parameter[1] * p;
}
static double linear_slope(const struct hardening *h, double p)
{
    (void)p;
    return h->parameter[1];
}

/* Straight lines between the points; past the last one the stress stays (perfect plasticity). */
struct tabulated {
    struct hardening hardening;
    struct deck_node points; /* read by tabulated_complete */
};
static const struct key tabulated_keys[] = {{.name = "points",
                                             .kind = KEY_NODE,
                                             .place = offsetof(struct tabulated, points),
                                             .required = true,
                                             .form = "[[plastic strain, true stress], ...]",
                                             .help = "two or more, the first at plastic strain 0"}};
static void tabulated_complete(struct hardening *h, struct deck_node map)
{
    struct deck_node list = deck_get(map, "points");
    h->n_points = deck_count(list);
    if (h->n_points < 2) deck_error(list, "a tabulated law needs two points or more");
    h->strain = memory_new((size_t)h->n_points, sizeof(double));
    h->stress = memory_new((size_t)h->n_points, sizeof(double));
    for (int i = 0; i < h->n_points; i++) {
        struct deck_node pair = deck_item(list, i);
        if (deck_count(pair) != 2) deck_error(pair, "expected [plastic strain, true stress]");
        h->strain[i] = deck_number(deck_item(pair, 0), "1", 0, 100);
        h->stress[i] = deck_number(deck_item(pair, 1), "Pa", 1, 1e13);
        if (i == 0 && h->strain[0] != 0)
            deck_error(pair, "the first point is the yield stress, at plastic strain 0");
        if (i > 0 && h->strain[i] <= h->strain[i - 1])
            deck_error(pair, "plastic strain must rise from point to point");
        if (i > 0 && h->stress[i] < h->stress[i - 1])
            deck_error(pair, "true stress must not fall (softening is damage, not hardening)");
    }
}
static int tabulated_interval(const struct hardening *h, double p)
{
    int i = 0;
    while (i + 1 < h->n_points && p >= h->strain[i + 1]) i++;
    return i;
}
static double tabulated_slope(const struct hardening *h, double p)
{
    int i = tabulated_interval(h, p);
    if (i + 1 >= h->n_points) return 0;
    return (h->stress[i + 1] - h->stress[i]) / (h->strain[i + 1] - h->strain[i]);
}
static double tabulated_stress(const struct hardening *h, double p)
{
    int i = tabulated_interval(h, p);
    return h->stress[i] + tabulated_slope(h, p) * (p - h->strain[i]);
}

#define LAW(name, formula, fitted, ...)                                                            \
    {                                                                                              \
        .variant = {#name, formula, KEYS(name##_keys)}, .parameters = fitted,                      \
        .stress = name##_stress, .slope = name##_slope, __VA_ARGS__                                \
    }

/* In the order in which hspost lists its fits. */
static const struct hardening_law laws[] = {
    LAW(hollomon, "K p^n", hollomon_keys, .n_linear = 1, .n_shapes = 1, .range = {{0.01, 2}}),
    LAW(ludwik, "Y + K p^n", ludwik_keys, .n_linear = 2, .n_shapes = 1, .range = {{0.01, 2}}),
    LAW(swift, "K (e0 + p)^n", swift_parameters, .n_linear = 1, .n_shapes = 2,
        .range = {{1e-6, 1}, {0.01, 2}}, .complete = swift_complete, .express = swift_express),
    LAW(voce, "Y + Q (1 - exp(-b p))", voce_keys, .n_linear = 2, .n_shapes = 1,
        .range = {{0.1, 1e4}}),
    LAW(two_voce, "Y + Q1 (1 - exp(-b1 p)) + Q2 (1 - exp(-b2 p))", two_voce_keys, .n_linear = 3,
        .n_shapes = 2, .range = {{0.1, 1e4}, {0.1, 1e4}}, .interchangeable = true),
    LAW(linear, "Y + H p", linear_keys, .n_linear = 2),
    LAW(tabulated, "straight lines between points, the last stress beyond them", NULL,
        .complete = tabulated_complete),
};
enum { LAW_COUNT = sizeof laws / sizeof *laws };

const struct hardening_law *hardening_law(int i)
{
    return i < LAW_COUNT ? &laws[i] : NULL;
}

const struct hardening_law *hardening_fitted(const char *name)
{
    for (int i = 0; i < LAW_COUNT; i++)
        if (laws[i].n_linear > 0 && strcmp(laws[i].variant.name, name) == 0) return &laws[i];
    return NULL;
}

static const struct variant *variant(int i)
{
    return i < LAW_COUNT ? &laws[i].variant : NULL;
}

const struct section section_hardening = {.path = "materials.NAME.hardening",
                                          .help = "The flow stress sigma of true stress against p, "
                                                  "the equivalent logarithmic plastic strain.",
                                          .chooser = "law",
                                          .variant = variant,
                                          .usual = -1};

struct hardening hardening_read(struct deck_node map)
{
    const int i = keys_variant(map, &section_hardening);
    struct tabulated read = {.hardening.law = &laws[i]};
    keys_read(map, &section_hardening, i, 0, NULL, &read);
    if (laws[i].complete) laws[i].complete(&read.hardening, map);
    return read.hardening;
}

double hardening_key(const struct hardening *h, int k)
{
    return h->law->express ? h->law->express(h, k) : h->parameter[k];
}

bool hardening_allowed(const struct hardening *h)
{
    const struct keys *keys = &h->law->variant.keys;
    for (int k = 0; k < keys->count; k++) {
        const double value = hardening_key(h, k);
        if (keys->rows[k].kind == KEY_NUMBER &&
            !(value >= keys->rows[k].low && value <= keys->rows[k].high))
            return false;
    }
    return true;
}

static void print_points(FILE *file, const struct hardening *h, const char *indent)
{
    fputs(", points: [", file);
    for (int i = 0; i < h->n_points; i++)
        fprintf(file, "%s\n%s  [%.6g, %.6g MPa]", i ? "," : "", indent, h->strain[i],
                h->stress[i] / 1e6);
    fputs("]", file);
}

void hardening_print(FILE *file, const struct hardening *h, const char *indent)
{
    const struct keys *keys = &h->law->variant.keys;
    fprintf(file, "{law: %s", h->law->variant.name);
    for (int k = 0; h->n_points == 0 && k < keys->count; k++) {
        const bool stress = strcmp(keys->rows[k].unit, "Pa") == 0;
        fprintf(file, ", %s: %.6g%s", keys->rows[k].name, hardening_key(h, k) / (stress ? 1e6 : 1),
                stress ? " MPa" : "");
    }
    if (h->n_points > 0) print_points(file, h, indent);
    fputs("}\n", file);
}

static double no_yield_stress(const struct hardening *h, double p)
{
    (void)h, (void)p;
    return 1e15; /* Pa; a strength no metal has */
}
static double no_yield_slope(const struct hardening *h, double p)
{
    (void)h, (void)p;
    return 0;
}

struct hardening hardening_none(void)
{
    static const struct hardening_law none = {
        .variant.name = "none", .stress = no_yield_stress, .slope = no_yield_slope};
    return (struct hardening){.law = &none};
}

void hardening_free(struct hardening *h)
{
    free(h->strain);
    free(h->stress);
    *h = (struct hardening){0};
}

double hardening_stress(const struct hardening *h, double p)
{
    return h->law->stress(h, p);
}

double hardening_slope(const struct hardening *h, double p)
{
    return h->law->slope(h, p);
}
