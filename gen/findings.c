#include "findings.h"

#include "topology.h"

#include <math.h>

enum { FURTHEST_FILM = 12 }; /* spacings; thicker films are not searched on the nodes */

struct findings findings_of(const struct recipe *recipe, const struct structure *structure,
                            const struct cores *cores)
{
    struct findings findings = {.core_film = INFINITY, .contact.film = INFINITY};
    if (recipe->topology->no_cores) {
        for (int64_t node = 0; node < structure->sites->n_nodes; node++)
            findings.counted += structure->counted[node];
        findings.ufg_fraction = NAN;
        return findings;
    }
    findings.counted = structure->threshold.counted;
    findings.ufg_fraction = 1 - structure->threshold.share;
    findings.cg = clusters_find(structure, PHASE_CG, NEIGHBOURS_6);
    findings.ufg = clusters_find(structure, PHASE_UFG, NEIGHBOURS_6);
    findings.cg_26 = clusters_find(structure, PHASE_CG, NEIGHBOURS_26);
    findings.reach = structure_reach(structure);
    if (!recipe->topology->cores_apart) return findings;
    findings.contact = clusters_contact(structure, FURTHEST_FILM);
    if (cores->shape == CORE_CELL)
        findings.core_film = -2 * findings.reach;
    else
        findings.core_film = cores_nearest_pair(cores, 2 * findings.reach) - 2 * findings.reach;
    return findings;
}
