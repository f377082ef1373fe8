/* page_origin.h - where the numbers of a page come from: programs, commands, decks. */
#ifndef HS_PAGE_ORIGIN_H
#define HS_PAGE_ORIGIN_H

#include "study.h"

#include <stdio.h>

/* What varied, with its values; nothing where nothing did. */
void page_varied(FILE *page, const struct study *study);

/* Versions, commands and facts of each curve. */
void page_provenance(FILE *page, const struct study *study);

/* The decks, each once. */
void page_decks(FILE *page, const struct study *study);

/* What to cite. */
void page_citation(FILE *page, const struct study *study);

#endif
