/* hardening.h - flow stress against equivalent plastic strain, sigma_y(p).
 *
 * sigma_y is a Kirchhoff stress (true stress up to the elastic volume change, below 0.4 % in metals),
 * p the equivalent logarithmic plastic strain.  To add a law: one more row in the table of
 * hardening.c. */
#ifndef HS_HARDENING_H
#define HS_HARDENING_H

#include "deck.h"

enum { HARDENING_PARAMETERS = 5 };

struct hardening_law;

struct hardening {
    const struct hardening_law *law;
    double parameter[HARDENING_PARAMETERS]; /* in the order of the law's keys, SI */
    int n_points;                           /* tabulated law only */
    double *strain, *stress;                /* [n_points] -, Pa */
};

/* Reads "hardening: {law: ..., ...}"; dies at what is missing, unknown, falling or out of range. */
struct hardening hardening_read(struct deck_node map);
void hardening_free(struct hardening *hardening);

/* The law without a yield point: an elastic solid. */
struct hardening hardening_none(void);

/* Flow stress [Pa] and its slope [Pa] at p >= 0; the slope of a tabulated law is that to the right. */
double hardening_stress(const struct hardening *hardening, double p);
double hardening_slope(const struct hardening *hardening, double p);
const char *hardening_name(const struct hardening *hardening);

#endif
