#include "hardening.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One law: its keys in the deck with unit and range, and sigma_y(p), d sigma_y/dp. */
struct hardening_key {
    const char *name, *unit;
    double low, high;
};
struct hardening_law {
    const char *name;
    struct hardening_key keys[HARDENING_PARAMETERS + 1];
    double (*stress)(const struct hardening *h, double p);
    double (*slope)(const struct hardening *h, double p);
};

static const double huge_stress = 1e15; /* Pa; a strength no metal has */

/* sigma_y = Y + H p */
static double linear_stress(const struct hardening *h, double p)
{
    return h->parameter[0] + h->parameter[1] * p;
}
static double linear_slope(const struct hardening *h, double p)
{
    (void)p;
    return h->parameter[1];
}

/* Swift (1952): sigma_y = K (p0 + p)^n with K p0^n = Y, so that Y is the stress at first yield. */
static double swift_offset(const struct hardening *h)
{
    return pow(h->parameter[0] / h->parameter[1], 1 / h->parameter[2]);
}
static double swift_stress(const struct hardening *h, double p)
{
    return h->parameter[1] * pow(swift_offset(h) + p, h->parameter[2]);
}
static double swift_slope(const struct hardening *h, double p)
{
    double n = h->parameter[2];
    return h->parameter[1] * n * pow(swift_offset(h) + p, n - 1);
}

/* Ludwik (1909): sigma_y = Y + K p^n.  Its slope is infinite at p = 0 for n < 1; the first 1e-9 of
 * plastic strain takes the chord. */
static const double first_strain = 1e-9;
static double ludwik_stress(const struct hardening *h, double p)
{
    double k = h->parameter[1], n = h->parameter[2];
    if (p < first_strain) return h->parameter[0] + k * pow(first_strain, n) * p / first_strain;
    return h->parameter[0] + k * pow(p, n);
}
static double ludwik_slope(const struct hardening *h, double p)
{
    double k = h->parameter[1], n = h->parameter[2];
    if (p < first_strain) return k * pow(first_strain, n - 1);
    return k * n * pow(p, n - 1);
}

/* Hollomon (1945) with a yield stress: sigma_y = max(Y, K p^n). */
static double hollomon_stress(const struct hardening *h, double p)
{
    return fmax(h->parameter[0], h->parameter[1] * pow(p, h->parameter[2]));
}
static double hollomon_slope(const struct hardening *h, double p)
{
    double k = h->parameter[1], n = h->parameter[2];
    return k * pow(p, n) < h->parameter[0] ? 0 : k * n * pow(p, n - 1);
}

/* Voce (1948): sigma_y = Y + Q (1 - exp(-b p)). */
static double voce_stress(const struct hardening *h, double p)
{
    return h->parameter[0] - h->parameter[1] * expm1(-h->parameter[2] * p);
}
static double voce_slope(const struct hardening *h, double p)
{
    return h->parameter[1] * h->parameter[2] * exp(-h->parameter[2] * p);
}

/* Two Voce terms: sigma_y = Y + Q1 (1 - exp(-b1 p)) + Q2 (1 - exp(-b2 p)). */
static double two_voce_stress(const struct hardening *h, double p)
{
    return voce_stress(h, p) - h->parameter[3] * expm1(-h->parameter[4] * p);
}
static double two_voce_slope(const struct hardening *h, double p)
{
    return voce_slope(h, p) + h->parameter[3] * h->parameter[4] * exp(-h->parameter[4] * p);
}

/* Straight lines between the points; past the last one the stress stays (perfect plasticity). */
static int table_interval(const struct hardening *h, double p)
{
    int i = 0;
    while (i + 1 < h->n_points && p >= h->strain[i + 1]) i++;
    return i;
}
static double table_slope(const struct hardening *h, double p)
{
    int i = table_interval(h, p);
    if (i + 1 >= h->n_points) return 0;
    return (h->stress[i + 1] - h->stress[i]) / (h->strain[i + 1] - h->strain[i]);
}
static double table_stress(const struct hardening *h, double p)
{
    int i = table_interval(h, p);
    return h->stress[i] + table_slope(h, p) * (p - h->strain[i]);
}

static double no_yield_stress(const struct hardening *h, double p)
{
    (void)h, (void)p;
    return huge_stress;
}
static double no_yield_slope(const struct hardening *h, double p)
{
    (void)h, (void)p;
    return 0;
}

#define YIELD                                                                                      \
    {                                                                                              \
        "yield", "Pa", 1, 1e13                                                                     \
    }
#define EXPONENT                                                                                   \
    {                                                                                              \
        "exponent", "1", 1e-3, 1                                                                   \
    }
#define STRENGTH                                                                                   \
    {                                                                                              \
        "strength", "Pa", 1, 1e13                                                                  \
    }

static const struct hardening_law laws[] = {
    {"linear", {YIELD, {"modulus", "Pa", 0, 1e13}}, linear_stress, linear_slope},
    {"swift", {YIELD, STRENGTH, EXPONENT}, swift_stress, swift_slope},
    {"ludwik", {YIELD, STRENGTH, EXPONENT}, ludwik_stress, ludwik_slope},
    {"hollomon", {YIELD, STRENGTH, EXPONENT}, hollomon_stress, hollomon_slope},
    {"voce",
     {YIELD, {"saturation", "Pa", 0, 1e13}, {"rate", "1", 0, 1e6}},
     voce_stress,
     voce_slope},
    {"two_voce",
     {YIELD,
      {"saturation", "Pa", 0, 1e13},
      {"rate", "1", 0, 1e6},
      {"saturation_2", "Pa", 0, 1e13},
      {"rate_2", "1", 0, 1e6}},
     two_voce_stress,
     two_voce_slope},
    {"tabulated", {{0}}, table_stress, table_slope},
};
enum { LAW_COUNT = sizeof laws / sizeof *laws };

static const struct hardening_law no_yield = {"none", {{0}}, no_yield_stress, no_yield_slope};

static void read_points(struct hardening *h, struct deck_node list)
{
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

struct hardening hardening_read(struct deck_node map)
{
    const char *names[LAW_COUNT];
    for (int i = 0; i < LAW_COUNT; i++) names[i] = laws[i].name;
    struct hardening h = {.law = &laws[deck_choice(deck_get(map, "law"), names, LAW_COUNT)]};

    const char *known[HARDENING_PARAMETERS + 3] = {"law"};
    int n = 0;
    for (; h.law->keys[n].name; n++) known[n + 1] = h.law->keys[n].name;
    if (n == 0) known[1] = "points";
    deck_keys(map, known);

    if (n == 0) read_points(&h, deck_get(map, "points"));
    for (int i = 0; i < n; i++) {
        const struct hardening_key *key = &h.law->keys[i];
        h.parameter[i] = deck_number(deck_get(map, key->name), key->unit, key->low, key->high);
    }
    if (h.law->stress == swift_stress && h.parameter[0] > h.parameter[1])
        deck_error(map, "swift: the yield stress lies above the strength K");
    return h;
}

struct hardening hardening_none(void)
{
    return (struct hardening){.law = &no_yield};
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

const char *hardening_name(const struct hardening *h)
{
    return h->law->name;
}
