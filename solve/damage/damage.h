/* damage.h - when bonds break, and what has broken.
 *
 * A broken bond has weight 0, so that every material obeys it, and never heals.  Bonds are tested
 * at the configuration that a step has led to: what the body holds less after they have broken is
 * the energy of fracture.  Laws of nodes also degrade the stress of a node before all of its bonds
 * break.  To add a law: one file after the pattern of critical_stretch.c (bonds) or ductile.c
 * (nodes), its name in one of the lists below. */
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
    bool series; /* bonds through two phases are as stiff as these in series, not as their mean */
};

enum { DAMAGE_STATES = 4 }; /* at most */

struct damage_law {
    struct variant words; /* name, help and keys of its own, which fill size bytes: */
    size_t size;          /* of a law of bonds one double, its value, 0 where its entry has none */
    /* Of bonds: the margin [m]: how far the ends of each bond of a strip may still move apart
     * before it breaks, below 0 where it has to break now, 0 where only a test can tell. */
    void (*margin)(const struct damage_view *see, const struct bond_strip *strip,
                   const double *value, double *margin);
    /* The value that a fracture energy [J/m^2] stands for, at bonds between two phases; dies where
     * the material has none. */
    double (*from_fracture_energy)(const struct damage_view *see, int a, int b, double energy,
                                   struct deck_node where);
    /* Dies where the material lacks what the law needs; may be NULL. */
    void (*check)(const struct damage_view *see, struct deck_node where);
    /* Of nodes: the states of their material that it reads, by name (model.h); none: a law of
     * bonds.  Each of the functions gets one number of each, the last two only beyond least. */
    const char *states[DAMAGE_STATES + 1];
    /* Of its keys, what depends on more than one of them; may be NULL. */
    void (*read)(void *own, struct deck_node entry, double spacing);
    /* The first state up to which a node is sound. */
    double (*least)(const void *own);
    /* D, by which the stress of the node is degraded, 1 and more: all of it.  NULL: nothing before
     * it is gone. */
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
    /* [n_phases^2] of the bonds of each pair, NULL: they never break; and the value of the law. */
    const struct damage_law **law;
    double *value;
    struct node_rule *node; /* [n_phases] */
    int n_node_laws;        /* up to n_phases */
    struct node_law *node_laws;
    enum combination *integrity; /* [n_phases^2] of the bonds between two phases */
    bool bonds;                  /* whether some law may break bonds by stretch or energy */
    bool degrading; /* whether the stress of some nodes degrades before their bonds break */
};

extern const struct section section_damage, section_damage_rule;

/* section.index may be 0: nothing breaks. */
struct damage_rules damage_rules_read(struct deck_node section, const struct damage_view *see);
void damage_rules_free(struct damage_rules *rules);

struct checkpoint;
struct damage;

/* root: of the deck, whose section "damage" is read; it may be missing.  To be made of the whole
 * body, before cracks are cut.  Collective. */
struct damage *damage_new(struct deck_node root, const struct model *model,
                          const struct materials *materials, struct body *body,
                          struct bonds *bonds);
void damage_free(struct damage *damage);

/* damage_find lists the bonds and nodes that have to break at the body's u and states, and says
 * whether any rank has some.  damage_break breaks what is listed; then the force is to be found
 * again.  Both collective. */
bool damage_find(struct damage *damage);
void damage_break(struct damage *damage);

/* most [m] bounds how far any owned node has moved since the last call of damage_moved or
 * damage_find: bonds with a margin beyond that are passed over.  Before a damage_find without such
 * a call all bonds are tested. */
void damage_moved(struct damage *damage, double most);

/* Between damage_find and damage_break: keeps of the list the worst, most in number, with all that
 * have as much excess as the last of them (symmetric bodies stay so).  Collective. */
void damage_choose(struct damage *damage, double most);

/* The integrity of the nodes (integrity.h) becomes 1 - D of their committed states; returns the
 * largest change of any node.  To be called once a state has been accepted, and nowhere else:
 * forces in between are those of damage that stands still.  Collective. */
double damage_grow(struct damage *damage);

/* Bonds of the whole body broken so far, without those that cracks cut. */
double damage_broken_bonds(const struct damage *damage);

/* Nodes of the whole body that laws of nodes have removed. */
double damage_removed_nodes(const struct damage *damage);

/* index[site] = 1 - (volume of the family still bonded)/(volume of the family) at owned nodes, cuts
 * by cracks included, or 1 - integrity where that is more. */
void damage_index(const struct damage *damage, double *index);

/* All that has been damaged.  Collective. */
void damage_visit(struct damage *damage, struct checkpoint *checkpoint);

/* For tests: no strip of bonds is passed over. */
void damage_test_all(struct damage *damage);

#endif
