#include "members.h"

#include "corners.h"
#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

_Noreturn static void no_such_set(const struct domain *domain, const char *name)
{
    char *known = memory_text("");
    for (int i = 0; i < domain->n_sets; i++)
        known = memory_append(known, "%s%s", i ? ", " : "", domain->sets[i].name);
    die_user("no node set '%s' in the domain (it has: %s)", name, *known ? known : "none");
}

/* Turns ascending numbers of nodes, or of particles, into lattice sites, in place. */
static void numbers_to_sites(const struct lattice *lattice, bool particles, int64_t *nodes,
                             int64_t count)
{
    int64_t node = 0, next = 0;
    for (int64_t site = 0; site < lattice->n_sites && next < count; site++) {
        if (!(particles ? lattice->phase[site] != ABSENT : lattice_has_node(lattice, site)))
            continue;
        if (node == nodes[next]) nodes[next++] = site;
        node++;
    }
}

struct members members_new(const struct body *body, const struct domain *domain, const char *name)
{
    const struct node_set *set = NULL;
    if (body->ranks.rank == 0) {
        set = domain_set(domain, name);
        if (!set) no_such_set(domain, name);
        if (set->count == 0) die_user("node set '%s' is empty", name);
    }
    int64_t count = set ? set->count : 0;
    int64_t *corners = set && body->lattice->corner && !body->lattice->hexahedron
                           ? corners_of_particles(body->lattice, set->nodes, &count)
                           : NULL;
    struct members members = members_of_nodes(body,
                                              corners ? corners
                                              : set   ? set->nodes
                                                      : NULL,
                                              count);
    free(corners);
    return members;
}

static struct members find(const struct body *body, bool particles, const int64_t *nodes,
                           int64_t count)
{
    const struct lattice *lattice = body->lattice;
    struct members members = {.n_all = count, .low = INFINITY, .high = -INFINITY};
    ranks_share(&members.n_all, sizeof members.n_all);
    int64_t *sites = memory_new((size_t)members.n_all, sizeof *sites);
    if (nodes) memcpy(sites, nodes, (size_t)count * sizeof *sites);
    ranks_share(sites, (size_t)members.n_all * sizeof *sites);
    numbers_to_sites(lattice, particles, sites, members.n_all);
    members.sites = memory_new((size_t)members.n_all, sizeof *members.sites);
    double sum = 0;
    for (int64_t i = 0; i < members.n_all; i++) {
        int at[3];
        lattice_position(lattice, sites[i], at);
        double x[3];
        (particles ? lattice_particle : lattice_coordinates)(lattice, at, x);
        const double along = x[lattice->axis];
        sum += along;
        members.low = fmin(members.low, along);
        members.high = fmax(members.high, along);
        int64_t site = grid_site(&body->grid, at);
        if (site >= 0 && (body->grid.flags[site] & SITE_OWNED))
            members.sites[members.count++] = site;
    }
    members.mean = sum / (double)members.n_all;
    free(sites);
    return members;
}

struct members members_of_nodes(const struct body *body, const int64_t *nodes, int64_t count)
{
    return find(body, false, nodes, count);
}

struct members members_of_particles(const struct body *body, const int64_t *particles,
                                    int64_t count)
{
    return find(body, true, particles, count);
}

void members_places(const struct members *members, const struct body *body, double *place[3])
{
    for (int a = 0; a < 3; a++) place[a] = memory_new((size_t)members->count, sizeof *place[a]);
    for (int64_t i = 0; i < members->count; i++) {
        double x[3];
        body_position(body, members->sites[i], x);
        for (int a = 0; a < 3; a++) place[a][i] = x[a];
    }
}

void members_free(struct members *members)
{
    free(members->sites);
    *members = (struct members){0};
}
