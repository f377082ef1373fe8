/* selection.h - the nodes that an entry of the deck is about.
 *
 * Exactly one of:
 *   set: grip_left               a node set of the domain
 *   block: UFG                   a phase
 *   box: [[0, -1 mm, -1 mm], [1 mm, 1 mm, 1 mm]]
 *                                corners, faces included (within 1e-6 spacings); of two numbers
 *                                each: any z
 *   where: "x > 0.01 && y < 0"   an expression in the reference position [m], true where it is not
 *                                0; compared to the last bit, so put limits between nodes */
#ifndef HS_SELECTION_H
#define HS_SELECTION_H

#include "deck.h"
#include "domain.h"
#include "expression.h"
#include "keys.h"

#include <stdbool.h>

enum selection_kind { SELECT_SET, SELECT_BLOCK, SELECT_BOX, SELECT_WHERE };
enum { SELECTORS = SELECT_WHERE + 1 };

/* First rows of a section whose mappings hold a selection; at: where in its struct selection_read
 * may find struct deck_node selector[SELECTORS]. */
#define SELECTOR(at, kind, name, form_of_it, words)                                                \
    {                                                                                              \
        name, KEY_NODE, (at) + kind * sizeof(struct deck_node), .form = form_of_it, .help = words  \
    }
#define SELECTION_KEYS(at)                                                                         \
    SELECTOR(at, SELECT_SET, "set", "NAME", "node set of the domain"),                             \
        SELECTOR(at, SELECT_BLOCK, "block", "NAME", "phase"),                                      \
        SELECTOR(at, SELECT_BOX, "box", "[[x, y, z], [x, y, z]]",                                  \
                 "two corners, in m or spacings, or of [x, y] for any z; faces (within 1e-6 "      \
                 "spacings) belong to it"),                                                        \
        SELECTOR(at, SELECT_WHERE, "where", "EXPRESSION",                                          \
                 "in x, y, z [m, of the unloaded body], true where it is not 0; it compares to "   \
                 "the last bit, so put limits between nodes")

struct selection {
    enum selection_kind kind;
    struct deck_node where;        /* the value of its key */
    struct expression *expression; /* else NULL */
};

/* Of the four selectors of a mapping, as its rows have found them.  Dies where there is none or
 * more than one, and where an expression or a box is malformed. */
struct selection selection_read(struct deck_node map, const struct deck_node selector[SELECTORS]);
void selection_free(struct selection *selection);

/* "set grip_left", "block UFG", "box", "where x > 0"; the caller frees it. */
char *selection_name(const struct selection *selection);

/* Numbers (from 0, ascending) of the domain's nodes in the selection; the caller frees them.
 * spacing [m]: of the lattice, or the mean one, for lengths given in it and for the faces of a box.
 * Dies where there are none, naming what there is. */
int64_t *selection_nodes(const struct selection *selection, const struct domain *domain,
                         double spacing, int64_t *count);

/* Whether a box or an expression holds at the image, across a plane at this place [m] of an axis,
 * of a node at which it does not hold itself. */
bool selection_is_beyond(const struct selection *selection, const struct domain *domain,
                         double spacing, int axis, double plane);

/* Whether a box or an expression holds at a place [m]; a set or a block at none that is no node. */
bool selection_holds(const struct selection *selection, double spacing, const double x[3]);

/* The node nearest to a place [x, y, z] of the deck (lengths as in a box), of several equally near
 * within 1e-6 spacings the first.  Dies where it is farther than 2 spacings: such a place is a
 * mistake. */
int64_t selection_nearest(struct deck_node place, const struct domain *domain, double spacing);

#endif
