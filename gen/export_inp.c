/* Input of Abaqus and CalculiX: an element C3D8 a cell, numbered like the nodes of the domain from
 * 1; sets of elements for the phases, the grains (GRAIN_12) and the sets of the domain, sets of
 * nodes for the six sides of the box (X_LOW ... Z_HIGH).  Lengths are metres. */
#include "export.h"

#include "memory.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { PER_LINE = 12 };

/* A set, line by line. */
struct set {
    FILE *file;
    int on_line;
};

static struct set begin_set(FILE *file, const char *keyword, const char *prefix, const char *name)
{
    fprintf(file, "*%s, %s=%s", keyword, keyword, prefix);
    if (!*prefix && !isalpha((unsigned char)*name)) fputc('S', file);
    /* Letters, digits, '_' and '-' are safe in names of either program. */
    for (const char *c = name; *c; c++)
        fputc(isalnum((unsigned char)*c) || *c == '-' ? *c : '_', file);
    fputc('\n', file);
    return (struct set){file, 0};
}

static void add_member(struct set *set, int64_t number)
{
    fprintf(set->file, "%s%lld", set->on_line == 0 ? "" : ", ", (long long)number);
    if (++set->on_line < PER_LINE) return;
    fputc('\n', set->file);
    set->on_line = 0;
}

static void end_set(struct set *set)
{
    if (set->on_line > 0) fputc('\n', set->file);
}

/* --- nodes and elements --------------------------------------------------------------------------
 */

struct corners {
    int64_t count[3]; /* along the axes, one more than cells */
    bool *used;
};

static int64_t corner_number(const struct corners *corners, int64_t i, int64_t j, int64_t k)
{
    return i + corners->count[0] * (j + corners->count[1] * k);
}

/* In the order of Abaqus: around the lower side, then around the upper one. */
static void corners_of(const struct corners *corners, const int64_t at[3], int64_t corner[8])
{
    static const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int c = 0; c < 8; c++)
        corner[c] = corner_number(corners, at[0] + around[c % 4][0], at[1] + around[c % 4][1],
                                  at[2] + c / 4);
}

static struct corners find_corners(const struct sites *sites)
{
    struct corners corners = {
        .count = {sites->count[0] + 1, sites->count[1] + 1, sites->count[2] + 1}};
    const size_t number =
        (size_t)corners.count[0] * (size_t)corners.count[1] * (size_t)corners.count[2];
    corners.used = memory_new(number, sizeof *corners.used);
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t at[3], corner[8];
        sites_index(sites, node, at);
        corners_of(&corners, at, corner);
        for (int c = 0; c < 8; c++) corners.used[corner[c]] = true;
    }
    return corners;
}

static void write_corners(const struct sites *sites, const struct corners *corners, FILE *file)
{
    const int64_t *count = corners->count;
    int64_t at[3];
    fprintf(file, "*NODE\n");
    for (at[2] = 0; at[2] < count[2]; at[2]++)
        for (at[1] = 0; at[1] < count[1]; at[1]++)
            for (at[0] = 0; at[0] < count[0]; at[0]++) {
                const int64_t number = corner_number(corners, at[0], at[1], at[2]);
                if (!corners->used[number]) continue;
                fprintf(file, "%lld", (long long)number + 1);
                for (int axis = 0; axis < 3; axis++)
                    fprintf(file, ", %.15g",
                            0.5 * (double)(2 * at[axis] - sites->count[axis]) *
                                sites->spacing[axis]);
                fputc('\n', file);
            }
}

static void write_elements(const struct sites *sites, const struct corners *corners, FILE *file)
{
    fprintf(file, "*ELEMENT, TYPE=C3D8\n");
    for (int64_t node = 0; node < sites->n_nodes; node++) {
        int64_t at[3], corner[8];
        sites_index(sites, node, at);
        corners_of(corners, at, corner);
        fprintf(file, "%lld", (long long)node + 1);
        for (int c = 0; c < 8; c++) fprintf(file, ", %lld", (long long)corner[c] + 1);
        fputc('\n', file);
    }
}

/* --- sets ----------------------------------------------------------------------------------------
 */

static void write_phases(const struct export_source *source, FILE *file)
{
    const int64_t n_nodes = source->structure->sites->n_nodes;
    for (int phase = 0; phase < source->recipe->n_phases; phase++) {
        struct set set = begin_set(file, "ELSET", "", source->recipe->phase_names[phase]);
        for (int64_t node = 0; node < n_nodes; node++)
            if (source->structure->phase[node] == phase) add_member(&set, node + 1);
        end_set(&set);
    }
}

struct member {
    int64_t grain, element;
};

static int compare_members(const void *a, const void *b)
{
    const struct member *left = a, *right = b;
    const int order = (left->grain > right->grain) - (left->grain < right->grain);
    return order ? order : (left->element > right->element) - (left->element < right->element);
}

static void write_grains(const struct export_source *source, FILE *file)
{
    const int64_t n_nodes = source->structure->sites->n_nodes, *grain = source->structure->grain;
    struct member *members = memory_new((size_t)n_nodes, sizeof *members);
    for (int64_t node = 0; node < n_nodes; node++)
        members[node] = (struct member){grain[node], node + 1};
    qsort(members, (size_t)n_nodes, sizeof *members, compare_members);
    for (int64_t first = 0, m = 0; m < n_nodes; first = m) {
        char *name = memory_print("%lld", (long long)members[first].grain);
        struct set set = begin_set(file, "ELSET", "GRAIN_", name);
        for (; m < n_nodes && members[m].grain == members[first].grain; m++)
            add_member(&set, members[m].element);
        end_set(&set);
        free(name);
    }
    free(members);
}

static void write_sides(const struct corners *corners, FILE *file)
{
    static const char *const names[3][2] = {
        {"X_LOW", "X_HIGH"}, {"Y_LOW", "Y_HIGH"}, {"Z_LOW", "Z_HIGH"}};
    const int64_t *count = corners->count;
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2;
        struct set set = begin_set(file, "NSET", "", names[axis][side % 2]);
        int64_t low[3] = {0, 0, 0}, high[3] = {count[0] - 1, count[1] - 1, count[2] - 1}, at[3];
        low[axis] = high[axis] = side % 2 ? count[axis] - 1 : 0;
        for (at[2] = low[2]; at[2] <= high[2]; at[2]++)
            for (at[1] = low[1]; at[1] <= high[1]; at[1]++)
                for (at[0] = low[0]; at[0] <= high[0]; at[0]++) {
                    const int64_t number = corner_number(corners, at[0], at[1], at[2]);
                    if (corners->used[number]) add_member(&set, number + 1);
                }
        end_set(&set);
    }
}

static void write_domain_sets(const struct domain *domain, FILE *file)
{
    for (int s = 0; s < domain->n_sets; s++) {
        const struct node_set *from = &domain->sets[s];
        struct set set = begin_set(file, "ELSET", "", from->name);
        for (int64_t i = 0; i < from->count; i++) add_member(&set, from->nodes[i] + 1);
        end_set(&set);
    }
}

void export_inp(const struct export_source *source, FILE *file)
{
    const struct sites *sites = source->structure->sites;
    struct corners corners = find_corners(sites);
    const char *periodic = attributes_text(&source->domain->attributes, "periodic");
    fprintf(file, "*HEADING\n%s\n", attributes_text(&source->domain->attributes, "label"));
    if (periodic) fprintf(file, "** the body is periodic along %s\n", periodic);
    write_corners(sites, &corners, file);
    write_elements(sites, &corners, file);
    write_phases(source, file);
    if (source->structure->grain) write_grains(source, file);
    write_domain_sets(source->domain, file);
    write_sides(&corners, file);
    free(corners.used);
}
