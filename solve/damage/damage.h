/* damage.h - when bonds break, and what has broken.
 *
 * A broken bond has weight 0, so that every material obeys it, and never heals.  Bonds are tested at the
 * configuration that a step has led to: what the body holds less after they have broken is the energy of
 * fracture.  Of nodes, also what their stress loses before that.  To add a law: one file after the pattern of
 * critical_stretch.c (bonds) or ductile.c (nodes), its name in one of the lists below. */
#ifndef HS_DAMAGE_H
#define HS_DAMAGE_H

#include "bonds.h"
#include "deck.h"
#include "integrity.h"
#include "keys.h"
#include "model.h"

#include <stdbool.h>

/* What laws may look at. */
struct damage_view {
    const struct model *model;
    const struct materials *materials;
    const struct body *body;
    const struct bonds *bonds;
};

enum { DAMAGE_STATES = 4 }; /* at most */

struct damage_law {
    struct variant words; /* name, help and keys of its own, which fill size bytes: */
    size_t size;          /* of a law of bonds one double, its value, 0 where its entry has none */
    /* Of bonds: how far [m] the ends of each bond of a strip may still move apart before it breaks, below 0
     * where it has to break now, 0 where only a test can tell. */
    void (*room)(const struct damage_view *see, const struct bond_strip *strip, const double *value,
                 double *room);
    /* The value that a fracture energy [J/m^2] stands for, at bonds between two phases; dies where the
     * material has none. */
    double (*from_fracture_energy)(const struct damage_view *see, int a, int b, double energy,
                                   struct deck_node where);
    /* Dies where the material lacks what the law needs; may be NULL. */
    void (*check)(const struct damage_view *see, struct deck_node where);
    /* Of nodes: the states of their material that it reads, by name (model.h); none: a law of bonds.  Each of the
     * functions gets one number of each, the last two only beyond least. */
    const char *states[DAMAGE_STATES + 1];
    /* Of its keys, what depends on more than one of them; may be NULL. */
    void (*read)(void *own, struct deck_node entry, double spacing);
    /* The first state up to which a node is sound. */
    double (*least)(const void *own);
    /* D, by which the stress of the node is degraded, 1 and more: all of it.  NULL: nothing before it is gone. */
    double (*degradation)(const void *own, const double state[]);
    /* The first state beyond which all bonds of the node break. */
    double (*limit)(const void *own, const double state[]);
};

/* All laws, in the order of the manual: damage_NAME, each in a file of its own. */
#define DAMAGE_BOND_LAWS(DO) DO(critical_stretch), DO(bond_energy)
#define DAMAGE_NODE_LAWS(DO) DO(plastic_strain), DO(ductile)
#define DAMAGE_LAW(name)     damage_##name
extern const struct damage_law DAMAGE_BOND_LAWS(DAMAGE_LAW), DAMAGE_NODE_LAWS(DAMAGE_LAW);

/* What the nodes of a phase obey. */
struct node_rule {
    const struct damage_law *law; /* NULL: they stay as they are */
    void *own;
    double least; /* INFINITY without a law */
};

/* A law of nodes that some phase has. */
struct node_law {
    const struct damage_law *law;
    int count, state[DAMAGE_STATES]; /* numbers of its states */
    double least;                    /* of all its phases */
};

/* The deck's section, read for the phases of the domain. */
struct damage_rules {
    int n_phases;
    const struct damage_law *
        *law;               /* [n_phases^2] of the bonds of each pair, NULL: they never break */
    double *value;          /* [n_phases^2] */
    struct node_rule *node; /* [n_phases] */
    int n_node_laws;        /* up to n_phases */
    struct node_law *node_laws;
    enum combination *integrity; /* [n_phases^2] of the bonds between two phases */
    bool bonds;                  /* whether any of them may break */
    bool degrading;              /* whether some nodes do so by degrees */
};

extern const struct section section_damage, section_damage_rule;

/* section.index may be 0: nothing breaks. */
struct damage_rules damage_rules_read(struct deck_node section, const struct damage_view *see);
void damage_rules_free(struct damage_rules *rules);

struct checkpoint;
struct damage;

/* root: of the deck, whose section "damage" is read; it may be missing.  To be made of the whole body, before
 * cracks are cut.  Collective. */
struct damage *damage_new(struct deck_node root, const struct model *model,
                          const struct materials *materials, struct body *body,
                          struct bonds *bonds);
void damage_free(struct damage *damage);

/* Finds what has to break at the body's u and plastic strain: whether there is anything anywhere.  It does so when
 * it is broken; then the force is to be found again.  Collective, both. */
bool damage_find(struct damage *damage);
void damage_break(struct damage *damage);

/* No owned node has moved by more than that [m] since the last call of damage_find, and since the last of this one; then
 * bonds far from breaking are not looked at.  Who has not said so has them looked at. */
void damage_moved(struct damage *damage, double most);

/* Between the two: of what has been found only the worst are left, that many, with all that are as bad as the last
 * one (symmetric bodies stay so).  Collective. */
void damage_choose(struct damage *damage, double most);

/* Moves the integrity of the nodes (integrity.h) on to what their committed plastic strain makes of it: the
 * largest change anywhere.  To be called once a state has been accepted, and nowhere else: forces in between
 * are those of damage that stands still.  Collective. */
double damage_grow(struct damage *damage);

/* Bonds of the whole body broken so far, without those that cracks cut. */
double damage_broken_bonds(const struct damage *damage);

/* Nodes of the whole body that laws of nodes have removed. */
double damage_removed_nodes(const struct damage *damage);

/* index[site] = 1 - (volume of the family still bonded)/(volume of the family) at owned nodes, cuts by cracks
 * included, or 1 - integrity where that is more. */
void damage_index(const struct damage *damage, double *index);

/* All that has been damaged.  Collective. */
void damage_visit(struct damage *damage, struct checkpoint *checkpoint);

/* For tests: no strip of bonds is passed over. */
void damage_test_all(struct damage *damage);

#endif
