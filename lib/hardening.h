/* hardening.h - flow stress against equivalent plastic strain, sigma_y(p): one table of laws for
 * the solver, which reads them from the deck, and for hspost, which fits them to curves.
 *
 * sigma_y is a Kirchhoff stress (true stress up to the elastic volume change, below 0.4 % in
 * metals), p the equivalent logarithmic plastic strain.  To add a law: one more row in the table of
 * hardening.c with its keys, stress and slope; the deck, hspost --law, the fits and the manual have
 * it from there. */
#ifndef HS_HARDENING_H
#define HS_HARDENING_H

#include "deck.h"
#include "keys.h"

#include <stdbool.h>
#include <stdio.h>

enum { HARDENING_PARAMETERS = 5, HARDENING_SHAPES = 2 };

struct hardening_law;

/* A law with its numbers. */
struct hardening {
    const struct hardening_law *law;
    double parameter[HARDENING_PARAMETERS]; /* in the order of law->parameters, SI */
    int n_points;                           /* tabulated law only */
    double *strain, *stress;                /* [n_points] -, Pa */
};

struct hardening_law {
    struct variant variant; /* name, formula, keys in the deck */
    /* What a fit finds: first n_linear stresses in which sigma_y is linear, then n_shapes positive
     * numbers. Parameters beyond these only the deck gives; a fit leaves them 0.  n_linear 0: the
     * law is not fitted. */
    const struct key *parameters;
    int n_linear, n_shapes;
    struct {
        double low, high; /* where the first search of a fit looks for a shape */
    } range[HARDENING_SHAPES];
    bool interchangeable; /* two equal terms, each with a shape: the first is the faster one */
    /* sigma_y [Pa] and its slope [Pa] at p >= 0 */
    double (*stress)(const struct hardening *h, double p);
    double (*slope)(const struct hardening *h, double p);
    /* From the numbers of the deck's keys to the parameters, where they are not the same; dies
     * where they do not go together.  NULL: nothing to do. */
    void (*complete)(struct hardening *h, struct deck_node map);
    /* The other way: the number of key k.  NULL: parameter k. */
    double (*express)(const struct hardening *h, int k);
};

/* Row i of the table; NULL beyond the last one. */
const struct hardening_law *hardening_law(int i);

/* The law that is fitted under this name; NULL: there is none. */
const struct hardening_law *hardening_fitted(const char *name);

/* "hardening: {law: ..., ...}" of a material. */
extern const struct section section_hardening;

/* Reads it; dies at what is missing, unknown, falling or out of range. */
struct hardening hardening_read(struct deck_node map);
void hardening_free(struct hardening *hardening);

/* The value of the law's key k in the deck [SI]; of the keys that a fit leaves 0 what the caller
 * has set. */
double hardening_key(const struct hardening *hardening, int k);

/* Whether all values are in the range that the deck takes. */
bool hardening_allowed(const struct hardening *hardening);

/* "{law: voce, yield: 182.1 MPa, ...}" as the deck takes it, six digits; lines after the first
 * begin with indent. */
void hardening_print(FILE *file, const struct hardening *hardening, const char *indent);

/* The law without a yield point: an elastic solid. */
struct hardening hardening_none(void);

/* Flow stress [Pa] and its slope [Pa] at p >= 0; the slope of a tabulated law is that to the right.
 */
double hardening_stress(const struct hardening *hardening, double p);
double hardening_slope(const struct hardening *hardening, double p);

#endif
