/* refinement.h - the same body at other spacings: lengths in spacings, and cores. */
#ifndef HS_REFINEMENT_H
#define HS_REFINEMENT_H

#include "deck_path.h"
#include "text_edits.h"

/* How many spacings 'refine: 2' or [2, 4] adds; where number i stands, for messages; and
 * domain.spacing divided by number i, as YAML writes it, which the caller frees. */
int refinement_count(struct deck_node refine);
struct deck_node refinement_where(struct deck_node refine, int i);
char *refinement_text(struct deck_node refine, int i, struct deck_node spacing);

/* The spacing along x [m] that a text of domain.spacing means; dies at where. */
double refinement_spacing(const char *text, struct deck_node where);

/* A text with each length in spacings times factor; the caller frees it. */
char *refinement_scale(const char *text, double factor);

/* Edits that make the spacing finer by factor and leave the body as it is: all lengths in spacings,
 * but of what lies in except[count]; and, where the file of cores is given, that in place of what
 * would place them anew. */
void refinement_edit(const struct deck *deck, const struct deck_paths *paths,
                     const struct deck_node except[], int count, double factor, const char *cores,
                     struct text_edits *edits);

/* Whether the deck has cores that each spacing would place anew. */
bool refinement_has_cores(const struct deck *deck);

#endif
