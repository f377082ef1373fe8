#include "die.h"
#include "memory.h"
#include "outline.h"
#include "output.h"
#include "phases_output.h"
#include "statistics.h"
#include "topology.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_LAGS = 40, MOST_SHELLS = 20000, SHELL_BINS = 24 };

static const char *const axes[] = {"x", "y", "z"};
static const char *const phases[] = {"cg", "ufg"};

static void print_clusters(const char *name, const struct clusters *clusters, bool sheet)
{
    double largest = clusters->nodes ? (double)clusters->largest / (double)clusters->nodes : 0;
    const char *along_z = sheet ? "" : clusters->percolates[2] ? ", z yes" : ", z no";
    note("%s: %lld nodes in %lld clusters (faces), the largest holds %.4g %%; percolates x %s, y "
         "%s%s",
         name, (long long)clusters->nodes, (long long)clusters->count, 100 * largest,
         clusters->percolates[0] ? "yes" : "no", clusters->percolates[1] ? "yes" : "no", along_z);
}

static void print_fraction(const struct recipe *recipe, const struct structure *structure,
                           const struct findings *findings)
{
    const struct threshold *threshold = &structure->threshold;
    const char *ufg = recipe->phase_names[PHASE_UFG];
    note("%s fraction %.9g %sby volume (asked %.9g) of %lld counted nodes", ufg,
         findings->ufg_fraction, structure->sites->volume ? "" : "by nodes and ",
         recipe->ufg_fraction, (long long)findings->counted);
    if (recipe->geometric)
        note("attainable with whole cores: %.9g and %.9g", 1 - threshold->above,
             1 - threshold->below);
    else
        note("%lld nodes of equal rank were split by the seed", (long long)threshold->split);
}

static void print_size(const struct recipe *recipe, const struct sites *sites)
{
    const struct specimen *specimen = &recipe->specimen;
    if (specimen_is_sheet(specimen)) note("a sheet %.9g mm thick", 1e3 * specimen->size[2]);
    char *cell = sites_cell(sites);
    note("%lld x %lld x %lld sites of %s um, %lld nodes, volume %.9g mm3, section %.9g mm2",
         (long long)sites->count[0], (long long)sites->count[1], (long long)sites->count[2], cell,
         (long long)sites->n_nodes, 1e9 * sites_whole_volume(sites, NULL),
         1e6 * outline_section(specimen, sites));
    free(cell);
    const struct cores_box box = recipe_box(recipe);
    char along[4];
    if (*cores_axes(&box, along)) note("periodic along %s", along);
    if (specimen_is_block(specimen)) return;
    const double length = specimen->gauge_length > 0 ? specimen->gauge_length : specimen->size[0];
    note("nominal section of the gauge %.9g mm2, volume %.9g mm3; the lattice's is what runs",
         1e6 * outline_between(specimen, length) / length,
         1e9 * outline_between(specimen, specimen->size[0]));
}

void statistics_print(const struct recipe *recipe, const struct structure *structure,
                      const struct findings *findings)
{
    char *words = recipe->topology->describe(recipe, findings);
    note("%s", words);
    free(words);
    print_size(recipe, structure->sites);
    if (recipe->voxels.phase) phases_print(recipe, structure);
    if (recipe->topology->no_cores) return;
    const bool sheet = specimen_is_sheet(&recipe->specimen);
    print_fraction(recipe, structure, findings);
    print_clusters(recipe->phase_names[PHASE_CG], &findings->cg, sheet);
    print_clusters(recipe->phase_names[PHASE_UFG], &findings->ufg, sheet);
    struct interface interface = statistics_interface(structure, sheet);
    note("interface %.6g mm2/mm3 (%d directions; cube faces alone: %.6g)", 1e-3 * interface.crofton,
         sheet ? 4 : NEIGHBOURS_26, 1e-3 * interface.faces);
    if (!recipe->topology->cores_apart) return;
    note("%s: %lld clusters by faces, edges and corners; %lld pairs of nodes of different cores "
         "touch",
         recipe->phase_names[PHASE_CG], (long long)findings->cg_26.count,
         (long long)findings->contact.touching);
    note("film between cores: %.6g um in the geometry, %.4g spacings at least on the nodes",
         1e6 * findings->core_film, findings->contact.film);
}

static void row(struct output *output, const char *quantity, const char *axis, double position,
                double value, const char *unit)
{
    if (isnan(position))
        fprintf(output->stream, "%s,%s,,%.9g,%s\n", quantity, axis, value, unit);
    else
        fprintf(output->stream, "%s,%s,%.9g,%.9g,%s\n", quantity, axis, position, value, unit);
}

static void write_clusters(struct output *output, int phase, const struct clusters *clusters,
                           int dimensions)
{
    const char *name = phases[phase];
    row(output, "nodes", name, NAN, (double)clusters->nodes, "1");
    row(output, "clusters", name, NAN, (double)clusters->count, "1");
    row(output, "largest_cluster", name, NAN,
        clusters->nodes ? (double)clusters->largest / (double)clusters->nodes : 0, "1");
    for (int axis = 0; axis < dimensions; axis++) {
        char *quantity = memory_print("percolates_%s", name);
        row(output, quantity, axes[axis], NAN, clusters->percolates[axis], "1");
        free(quantity);
    }
}

static void write_along_axes(struct output *output, const struct structure *structure,
                             int dimensions)
{
    const struct sites *sites = structure->sites;
    for (int axis = 0; axis < dimensions; axis++)
        for (int64_t lag = 0; lag < sites->count[axis] && lag <= MOST_LAGS; lag++)
            row(output, "two_point_ufg", axes[axis], (double)lag * sites->spacing[axis],
                statistics_two_point(structure, axis, lag), "1");
    for (int axis = 0; axis < dimensions; axis++)
        for (int64_t i = 0; i < sites->count[axis]; i++)
            row(output, "profile_ufg", axes[axis], sites_coordinate(sites, axis, i),
                statistics_profile(structure, axis, i), "1");
}

/* Shares of the sampled shell nodes, in bins of one spacing around 1, 2, 3 ... */
static void write_shell(struct output *output, const struct structure *structure)
{
    double *thickness = memory_new(MOST_SHELLS, sizeof *thickness);
    int64_t found = statistics_shell(structure, MOST_SHELLS, thickness);
    double share[SHELL_BINS] = {0}, mean = 0;
    for (int64_t i = 0; i < found; i++) {
        int bin = (int)lround(thickness[i]);
        share[bin < SHELL_BINS ? bin : SHELL_BINS - 1] += 1 / (double)found;
        mean += thickness[i] / (double)found;
    }
    double spacing = structure->sites->spacing[0];
    row(output, "shell_thickness_mean", "", NAN, mean * spacing, "m");
    for (int bin = 0; bin < SHELL_BINS; bin++)
        row(output, "shell_thickness_share", "", bin * spacing, share[bin], "1");
    free(thickness);
}

void statistics_write(const struct recipe *recipe, const struct structure *structure,
                      const struct findings *findings, const char *path)
{
    const struct sites *sites = structure->sites;
    const bool sheet = specimen_is_sheet(&recipe->specimen);
    const int dimensions = sheet ? 2 : 3;
    struct output output = output_open(path);
    fprintf(output.stream, "quantity,axis,position_m,value,unit\n");
    row(&output, "nodes_all", "", NAN, (double)sites->n_nodes, "1");
    row(&output, "nodes_counted", "", NAN, (double)findings->counted, "1");
    row(&output, "volume", "", NAN, sites_whole_volume(sites, NULL), "m3");
    row(&output, "volume_counted", "", NAN, sites_whole_volume(sites, structure->counted), "m3");
    row(&output, "section", "", NAN, outline_section(&recipe->specimen, sites), "m2");
    if (recipe->voxels.phase) phases_write(recipe, structure, output.stream);
    if (!recipe->topology->no_cores) {
        struct interface interface = statistics_interface(structure, sheet);
        row(&output, "ufg_fraction_asked", "", NAN, recipe->ufg_fraction, "1");
        row(&output, "ufg_fraction_nodes", "", NAN,
            1 - (double)structure->threshold.coarse / (double)findings->counted, "1");
        row(&output, "ufg_fraction_volume", "", NAN, findings->ufg_fraction, "1");
        row(&output, "nodes_split", "", NAN, (double)structure->threshold.split, "1");
        write_clusters(&output, PHASE_CG, &findings->cg, dimensions);
        write_clusters(&output, PHASE_UFG, &findings->ufg, dimensions);
        row(&output, "interface_area_per_volume", "", NAN, interface.crofton, "1/m");
        row(&output, "interface_faces_per_volume", "", NAN, interface.faces, "1/m");
        write_along_axes(&output, structure, dimensions);
    }
    if (recipe->topology->cores_apart) {
        row(&output, "clusters_26", "cg", NAN, (double)findings->cg_26.count, "1");
        row(&output, "touching_pairs", "cg", NAN, (double)findings->contact.touching, "1");
        row(&output, "core_film_geometric", "", NAN, findings->core_film, "m");
        row(&output, "core_film_nodes", "", NAN, findings->contact.film * sites->spacing[0], "m");
        write_shell(&output, structure);
    }
    output_close(&output);
}
