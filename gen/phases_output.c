#include "phases_output.h"

#include "clusters.h"
#include "die.h"
#include "memory.h"
#include "statistics.h"

#include <math.h>
#include <stdlib.h>

static int64_t count_nodes(const struct structure *structure)
{
    int64_t nodes = 0;
    for (int64_t node = 0; node < structure->sites->n_nodes; node++)
        nodes += structure->counted[node];
    return nodes;
}

/* Unlike pairs among neighbours along an axis, across the seam where the body meets its image, and
 * elsewhere; 0 where there are no pairs. */
static void count_unlike(const struct structure *structure, int axis, double *seam, double *within)
{
    const struct sites *sites = structure->sites;
    int64_t pairs[2] = {0, 0}, unlike[2] = {0, 0};
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t at[3];
        sites_index(sites, node, at);
        const int there = at[axis]++ == sites->count[axis] - 1;
        const int64_t other = sites_at(sites, at[0], at[1], at[2]);
        if (other < 0) continue;
        pairs[there]++;
        unlike[there] += structure->phase[node] != structure->phase[other];
    }
    *seam = pairs[1] ? (double)unlike[1] / (double)pairs[1] : 0;
    *within = pairs[0] ? (double)unlike[0] / (double)pairs[0] : 0;
}

static void print_seams(const struct structure *structure)
{
    for (int axis = 0; axis < 3; axis++) {
        double seam, within;
        if (!structure->sites->periodic[axis]) continue;
        count_unlike(structure, axis, &seam, &within);
        note("seam along %c: %.3g %% of the pairs of neighbours across it are of unlike phases, "
             "%.3g "
             "%% of those elsewhere",
             "xyz"[axis], 100 * seam, 100 * within);
    }
}

void phases_print(const struct recipe *recipe, const struct structure *structure)
{
    const double all = (double)count_nodes(structure);
    const bool sheet = specimen_is_sheet(&recipe->specimen);
    for (int phase = 0; phase < recipe->n_phases; phase++) {
        const struct clusters clusters = clusters_find(structure, phase, NEIGHBOURS_6);
        if (phase == recipe->grip_phase && clusters.nodes == 0) continue; /* of the grips alone */
        const bool *through = clusters.percolates;
        note("%s: %lld nodes, fraction %.9g, in %lld clusters (faces), the largest holds %.4g %%; "
             "percolates x %s, y %s%s",
             recipe->phase_names[phase], (long long)clusters.nodes, (double)clusters.nodes / all,
             (long long)clusters.count,
             clusters.nodes ? 100 * (double)clusters.largest / (double)clusters.nodes : 0,
             through[0] ? "yes" : "no", through[1] ? "yes" : "no",
             sheet        ? ""
             : through[2] ? ", z yes"
                          : ", z no");
        if (clusters.nodes == 0)
            warn("no node outside the grips is of the phase %s", recipe->phase_names[phase]);
    }
    const struct interface interface = statistics_interface(structure, sheet);
    note("interface %.6g mm2/mm3 between unlike phases (%d directions; faces alone: %.6g)",
         1e-3 * interface.crofton, sheet ? 4 : NEIGHBOURS_26, 1e-3 * interface.faces);
    print_seams(structure);
}

static void row(FILE *file, const char *quantity, const char *name, double value, const char *unit)
{
    fprintf(file, "%s,%s,,%.9g,%s\n", quantity, name, value, unit);
}

void phases_write(const struct recipe *recipe, const struct structure *structure, FILE *file)
{
    static const char *const axes[] = {"x", "y", "z"};
    const double all = (double)count_nodes(structure);
    const bool sheet = specimen_is_sheet(&recipe->specimen);
    for (int phase = 0; phase < recipe->n_phases; phase++) {
        const char *name = recipe->phase_names[phase];
        const struct clusters clusters = clusters_find(structure, phase, NEIGHBOURS_6);
        if (phase == recipe->grip_phase && clusters.nodes == 0) continue;
        const double nodes = (double)clusters.nodes;
        row(file, "fraction", name, nodes / all, "1");
        row(file, "nodes", name, nodes, "1");
        row(file, "clusters", name, (double)clusters.count, "1");
        row(file, "largest_cluster", name, nodes > 0 ? (double)clusters.largest / nodes : 0, "1");
        for (int axis = 0; axis < (sheet ? 2 : 3); axis++) {
            char *quantity = memory_print("percolates_%s", name);
            row(file, quantity, axes[axis], clusters.percolates[axis], "1");
            free(quantity);
        }
    }
    const struct interface interface = statistics_interface(structure, sheet);
    row(file, "interface_area_per_volume", "", interface.crofton, "1/m");
    row(file, "interface_faces_per_volume", "", interface.faces, "1/m");
}
