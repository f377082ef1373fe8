/* page_values.h - the tables of a page: properties, phases, quality. */
#ifndef HS_PAGE_VALUES_H
#define HS_PAGE_VALUES_H

#include "study_figure.h"

#include <stdio.h>

/* The four numbers that people look at first; of one curve. */
void page_cards(FILE *page, const struct properties *list);

/* Number of titles: where curves share them, means are shown. */
int page_groups(const struct study *study);

/* Values with errors and flags, of each curve, or means over the curves of one title; and the full
 * list of each curve. */
void page_properties(FILE *page, const struct study *study);

/* Values of each body at its finest spacing and at the spacing 0, of the figure's extrapolations.
 */
void page_resolution(FILE *page, const struct study *study, const struct study_figure *figure);

/* How stress and strain are shared between the phases; nothing where no curve has two. */
void page_phases(FILE *page, const struct study *study);

/* Energies, equilibrium, noise: what is not as it should be has a flag. */
void page_quality(FILE *page, const struct study *study);

#endif
