/* domain_text.h - particles in the text formats of Peridigm and PeriLab. */
#ifndef HS_DOMAIN_TEXT_H
#define HS_DOMAIN_TEXT_H

#include "deck.h"
#include "domain.h"
#include "spool.h"

/* "x y z block volume" a line, blanks or commas between, '#' starts a comment.  A first line of
 * words, with or without "header:" before it, names the columns x y z block_id volume, in any
 * order; without z the body is a sheet, further ones are passed over.  Blocks have any numbers.  A
 * comment "blocks: 1 NAME 2 NAME ..." as hsgen writes it names the phases; without it block N is
 * the deck's material block_N, else the N-th.  Nodes are in the order of the lines, without sets.
 * shown: name in messages. */
struct domain domain_text_read(const struct spool *input, const char *shown,
                               const struct deck *deck);

#endif
