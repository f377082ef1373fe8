/* solver_sections.h - the sections of the deck that hssolve reads, for its --keys. */
#ifndef HS_SOLVER_SECTIONS_H
#define HS_SOLVER_SECTIONS_H

struct section;

/* In the deck's order, ended by NULL. */
extern const struct section *const solver_sections[];

#endif
