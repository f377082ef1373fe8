/* domain.h - particles with phases and named node sets: what hsgen makes and hssolve runs.  hsgen's
 * lie on a lattice and are numbered from 0 in lattice order (x fastest, then y, then z), absent
 * sites skipped; a file from elsewhere may hold any particles in any order. */
#ifndef HS_DOMAIN_H
#define HS_DOMAIN_H

#include <stdbool.h>
#include <stdint.h>

struct node_set {
    char *name;
    int64_t count;
    int64_t *nodes; /* [count], ascending, from 0 */
    char *alias;    /* another name, such as nodelist_10; NULL: none */
};

/* A fact that travels with a file: a number, or a text where text is not NULL. */
struct attribute {
    char *name;
    double number;
    char *text;
};

struct attributes {
    int count;
    struct attribute *items;
};

void attributes_set_number(struct attributes *attributes, const char *name, double number);
void attributes_set_text(struct attributes *attributes, const char *name, const char *text);
/* fallback where there is no number of that name */
double attributes_number(const struct attributes *attributes, const char *name, double fallback);
/* NULL where there is no text of that name */
const char *attributes_text(const struct attributes *attributes, const char *name);
void attributes_free(struct attributes *attributes);

/* Nodes of a domain that follow each other, as many as are at hand at once. */
struct domain_nodes {
    int64_t first, count;
    const double *x[3], *volume, *grain; /* [count], as in the domain */
    const uint8_t *phase;
};

/* Gives what a domain does not hold. */
struct domain_source {
    /* Some nodes from the first one on; those before have been read.  The arrays last until the
     * next call. */
    void (*read)(struct domain_source *source, struct domain_nodes *nodes);
    void (*free)(struct domain_source *source);
    bool grains; /* it gives them, too */
};

struct domain {
    int64_t n_nodes;
    double *x, *y, *z;            /* [n_nodes] m, reference positions */
    double *volume;               /* [n_nodes] m^3 */
    struct domain_source *source; /* in place of the four, which are then NULL */
    uint8_t *phase;               /* [n_nodes] index into phase_names */
    double *grain;                /* [n_nodes] ids of grains, whole numbers; NULL: none are known */
    int n_phases;                 /* at most 16 */
    char **phase_names;
    int n_sets;
    struct node_set *sets;
    struct attributes attributes; /* spacing_m, deck, deck_name, program, command, ... */
    /* Of particles that are hexahedra of a mesh: the mesh's nodes, as a domain of positions and
     * sets alone, and [8 n_nodes] which of them are a particle's corners, in the order of Exodus;
     * else NULL. */
    struct domain *corners;
    int64_t *hexahedra;
};

/* Positions, volumes and phases of n_nodes, all zero; names: [n_phases]. */
struct domain domain_new(int64_t n_nodes, int n_phases, const char *const names[]);
/* The same in a domain whose phases are named. */
void domain_make_room(struct domain *domain, int64_t n_nodes);

/* Whether ids of grains are known. */
bool domain_has_grains(const struct domain *domain);

/* The next nodes, at first from {0}; false behind the last: how to go through a domain that need
 * not be held. */
bool domain_next(const struct domain *domain, struct domain_nodes *nodes);
/* What its source gives becomes arrays of its own. */
void domain_hold(struct domain *domain);

/* NULL where there is no set of that name or alias. */
const struct node_set *domain_set(const struct domain *domain, const char *name);
void domain_add_set(struct domain *domain, const char *name, int64_t count, const int64_t *nodes);
/* Gives the set that was added last another name, that no set has. */
void domain_alias_set(struct domain *domain, const char *alias);
/* Frees what is known of each node; names, sets and attributes stay. */
void domain_forget_nodes(struct domain *domain);
/* Frees the mesh that its particles are of, where there is one. */
void domain_forget_mesh(struct domain *domain);
void domain_free(struct domain *domain);

/* Distance of the particles (m): the attribute spacing_m, of scattered ones mean_spacing_m, else
 * the cube root of their mean volume.  Of particles in one plane of z the square root of their mean
 * area: volume over the attribute thickness_m, without it the area of their box over their number.
 */
double domain_spacing(const struct domain *domain);

/* Smallest and largest of count values, for the corners of a body. */
double domain_smallest(const double *values, int64_t count);
double domain_largest(const double *values, int64_t count);

#endif
