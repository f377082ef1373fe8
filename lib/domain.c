#include "domain.h"

#include "memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static struct attribute *find(const struct attributes *attributes, const char *name)
{
    for (int i = 0; i < attributes->count; i++)
        if (strcmp(attributes->items[i].name, name) == 0) return &attributes->items[i];
    return NULL;
}

static struct attribute *find_or_add(struct attributes *attributes, const char *name)
{
    struct attribute *item = find(attributes, name);
    if (item != NULL) return item;
    attributes->items = memory_grow(attributes->items, attributes->count, sizeof *item);
    item = &attributes->items[attributes->count++];
    *item = (struct attribute){.name = memory_text(name)};
    return item;
}

void attributes_set_number(struct attributes *attributes, const char *name, double number)
{
    struct attribute *item = find_or_add(attributes, name);
    free(item->text);
    item->text = NULL;
    item->number = number;
}

void attributes_set_text(struct attributes *attributes, const char *name, const char *text)
{
    /* Copied first: text may be the one that is replaced. */
    char *copy = memory_text(text);
    struct attribute *item = find_or_add(attributes, name);
    free(item->text);
    item->text = copy;
    item->number = 0;
}

double attributes_number(const struct attributes *attributes, const char *name, double fallback)
{
    const struct attribute *item = find(attributes, name);
    return item != NULL && item->text == NULL ? item->number : fallback;
}

const char *attributes_text(const struct attributes *attributes, const char *name)
{
    const struct attribute *item = find(attributes, name);
    return item != NULL ? item->text : NULL;
}

void attributes_free(struct attributes *attributes)
{
    for (int i = 0; i < attributes->count; i++) {
        free(attributes->items[i].name);
        free(attributes->items[i].text);
    }
    free(attributes->items);
    *attributes = (struct attributes){0};
}

void domain_make_room(struct domain *domain, int64_t n_nodes)
{
    const size_t n = (size_t)n_nodes;
    domain->n_nodes = n_nodes;
    domain->x = memory_new(n, sizeof *domain->x);
    domain->y = memory_new(n, sizeof *domain->y);
    domain->z = memory_new(n, sizeof *domain->z);
    domain->volume = memory_new(n, sizeof *domain->volume);
    domain->phase = memory_new(n, sizeof *domain->phase);
}

struct domain domain_new(int64_t n_nodes, int n_phases, const char *const names[])
{
    struct domain domain = {.n_phases = n_phases};
    domain_make_room(&domain, n_nodes);
    domain.phase_names = memory_new((size_t)n_phases, sizeof *domain.phase_names);
    for (int p = 0; p < n_phases; p++) domain.phase_names[p] = memory_text(names[p]);
    return domain;
}

const struct node_set *domain_set(const struct domain *domain, const char *name)
{
    for (int i = 0; i < domain->n_sets; i++)
        if (strcmp(domain->sets[i].name, name) == 0) return &domain->sets[i];
    for (int i = 0; i < domain->n_sets; i++)
        if (domain->sets[i].alias && strcmp(domain->sets[i].alias, name) == 0)
            return &domain->sets[i];
    return NULL;
}

void domain_add_set(struct domain *domain, const char *name, int64_t count, const int64_t *nodes)
{
    struct node_set set = {memory_text(name), count, memory_new((size_t)count, sizeof *nodes),
                           NULL};
    if (count > 0) memcpy(set.nodes, nodes, (size_t)count * sizeof *nodes);
    domain->sets = memory_grow(domain->sets, domain->n_sets, sizeof set);
    domain->sets[domain->n_sets++] = set;
}

void domain_alias_set(struct domain *domain, const char *alias)
{
    domain->sets[domain->n_sets - 1].alias = memory_text(alias);
}

bool domain_has_grains(const struct domain *domain)
{
    return domain->grain || (domain->source && domain->source->grains);
}

bool domain_next(const struct domain *domain, struct domain_nodes *nodes)
{
    enum { AT_ONCE = 1 << 16 };
    const int64_t first = nodes->first + nodes->count, left = domain->n_nodes - first;
    *nodes = (struct domain_nodes){.first = first, .count = left < AT_ONCE ? left : AT_ONCE};
    if (left <= 0) return false;
    nodes->phase = domain->phase ? domain->phase + first : NULL;
    if (domain->source) {
        domain->source->read(domain->source, nodes);
        return true;
    }
    nodes->x[0] = domain->x + first;
    nodes->x[1] = domain->y + first;
    nodes->x[2] = domain->z + first;
    nodes->volume = domain->volume ? domain->volume + first : NULL;
    nodes->grain = domain->grain ? domain->grain + first : NULL;
    return true;
}

static double *hold(double *held, const struct domain *domain, const double *some,
                    const struct domain_nodes *nodes)
{
    if (!some) return held;
    if (!held) held = memory_new((size_t)domain->n_nodes, sizeof *held);
    memcpy(held + nodes->first, some, (size_t)nodes->count * sizeof *some);
    return held;
}

void domain_hold(struct domain *domain)
{
    struct domain_nodes nodes = {0};
    if (!domain->source) return;
    while (domain_next(domain, &nodes)) {
        domain->x = hold(domain->x, domain, nodes.x[0], &nodes);
        domain->y = hold(domain->y, domain, nodes.x[1], &nodes);
        domain->z = hold(domain->z, domain, nodes.x[2], &nodes);
        domain->volume = hold(domain->volume, domain, nodes.volume, &nodes);
        domain->grain = hold(domain->grain, domain, nodes.grain, &nodes);
    }
    domain->source->free(domain->source);
    domain->source = NULL;
}

void domain_forget_nodes(struct domain *domain)
{
    if (domain->source) domain->source->free(domain->source);
    domain->source = NULL;
    free(domain->x);
    free(domain->y);
    free(domain->z);
    free(domain->volume);
    free(domain->phase);
    free(domain->grain);
    domain->x = domain->y = domain->z = domain->volume = domain->grain = NULL;
    domain->phase = NULL;
    domain_forget_mesh(domain);
}

void domain_forget_mesh(struct domain *domain)
{
    if (domain->corners) domain_free(domain->corners);
    free(domain->corners);
    free(domain->hexahedra);
    domain->corners = NULL;
    domain->hexahedra = NULL;
}

void domain_free(struct domain *domain)
{
    domain_forget_nodes(domain);
    for (int i = 0; i < domain->n_phases; i++) free(domain->phase_names[i]);
    free(domain->phase_names);
    for (int i = 0; i < domain->n_sets; i++) {
        free(domain->sets[i].name);
        free(domain->sets[i].nodes);
        free(domain->sets[i].alias);
    }
    free(domain->sets);
    attributes_free(&domain->attributes);
    *domain = (struct domain){0};
}

double domain_smallest(const double *values, int64_t count)
{
    double low = values[0];
    for (int64_t i = 1; i < count; i++) low = fmin(low, values[i]);
    return low;
}

double domain_largest(const double *values, int64_t count)
{
    double high = values[0];
    for (int64_t i = 1; i < count; i++) high = fmax(high, values[i]);
    return high;
}

double domain_spacing(const struct domain *domain)
{
    const struct attributes *facts = &domain->attributes;
    const int64_t n = domain->n_nodes;
    const double said =
        attributes_number(facts, "spacing_m", attributes_number(facts, "mean_spacing_m", 0));
    if (said > 0) return said;
    double volume = 0, thickness = attributes_number(facts, "thickness_m", 0);
    for (int64_t i = 0; i < n; i++) volume += domain->volume[i];
    const double width = domain_largest(domain->x, n) - domain_smallest(domain->x, n),
                 depth = domain_largest(domain->y, n) - domain_smallest(domain->y, n),
                 height = domain_largest(domain->z, n) - domain_smallest(domain->z, n);
    const bool plane = height <= 1e-9 * fmax(width, depth);
    if (plane && thickness > 0) return sqrt(volume / thickness / (double)n);
    if (plane && width * depth > 0) return sqrt(width * depth / (double)n);
    return cbrt(volume / (double)n);
}
