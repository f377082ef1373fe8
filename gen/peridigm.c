#include "peridigm.h"

#include "memory.h"
#include "output.h"

#include <stdlib.h>

static void write_nodes(const struct domain *domain, const char *path)
{
    struct output output = output_open(path);
    fprintf(output.stream, "# x(m) y(m) z(m) block volume(m3); blocks:");
    for (int phase = 0; phase < domain->n_phases; phase++)
        fprintf(output.stream, " %d %s", phase + 1, domain->phase_names[phase]);
    fprintf(output.stream, "\n");
    for (int64_t node = 0; node < domain->n_nodes; node++)
        fprintf(output.stream, "%.17g %.17g %.17g %d %.17g\n", domain->x[node], domain->y[node],
                domain->z[node], domain->phase[node] + 1, domain->volume[node]);
    output_close(&output);
}

static void write_set(const struct node_set *set, const char *path)
{
    struct output output = output_open(path);
    for (int64_t i = 0; i < set->count; i++)
        fprintf(output.stream, "%lld\n", (long long)set->nodes[i] + 1);
    output_close(&output);
}

void peridigm_write(const struct domain *domain, const char *basename)
{
    char *path = memory_print("%s.txt", basename);
    write_nodes(domain, path);
    free(path);
    for (int s = 0; s < domain->n_sets; s++) {
        path = memory_print("%s_%s.txt", basename, domain->sets[s].name);
        write_set(&domain->sets[s], path);
        free(path);
    }
}
