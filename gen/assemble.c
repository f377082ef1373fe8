#include "assemble.h"

#include "memory.h"
#include "outline.h"
#include "topology.h"

#include <math.h>
#include <stdlib.h>

static double mean_along(const struct specimen *specimen, const struct domain *domain,
                         const char *name)
{
    const struct node_set *set = domain_set(domain, name);
    const double c = cos(specimen->angle), s = sin(specimen->angle);
    double sum = 0;
    for (int64_t i = 0; i < set->count; i++)
        sum += c * domain->x[set->nodes[i]] + s * domain->y[set->nodes[i]];
    return sum / (double)set->count;
}

/* Distance of the nodes of the gauge planes along the body. */
static double gauge_length(const struct specimen *specimen, const struct domain *domain)
{
    int64_t layer[2];
    specimen_gauge_layers(specimen, layer);
    /* From a plane of symmetry on it is the half. */
    if (specimen->angle == 0)
        return (double)(layer[1] - layer[0]) * specimen->spacing[0] *
               (specimen->symmetry[0] ? 0.5 : 1);
    return mean_along(specimen, domain, "gauge_right") - mean_along(specimen, domain, "gauge_left");
}

/* The axes as letters, and after what length (m) the body repeats along each. */
static void set_periods(const struct recipe *recipe, struct attributes *attributes)
{
    static const char *const names[] = {"period_x_m", "period_y_m", "period_z_m"};
    const struct cores_box box = recipe_box(recipe);
    char axes[4];
    if (*cores_axes(&box, axes) == '\0') return;
    attributes_set_text(attributes, "periodic", axes);
    for (int axis = 0; axis < 3; axis++)
        if (box.periodic[axis]) attributes_set_number(attributes, names[axis], box.size[axis]);
}

static void set_symmetry(const struct specimen *specimen, struct attributes *attributes)
{
    char letters[4] = "";
    int count = 0;
    for (int axis = 0; axis < 3; axis++)
        if (specimen->symmetry[axis]) letters[count++] = "xyz"[axis];
    if (count > 0) attributes_set_text(attributes, "symmetry", letters);
}

static void set_attributes(const struct recipe *recipe, const struct structure *structure,
                           const struct findings *findings, const char *fault,
                           struct domain *domain)
{
    const struct specimen *specimen = &recipe->specimen;
    struct attributes *attributes = &domain->attributes;
    const double *edge = specimen->spacing;
    attributes_set_number(attributes, "spacing_m", edge[0]);
    if (edge[1] != edge[0]) attributes_set_number(attributes, "spacing_y_m", edge[1]);
    if (edge[2] != edge[0] && !specimen_is_sheet(specimen))
        attributes_set_number(attributes, "spacing_z_m", edge[2]);
    if (specimen_is_sheet(specimen)) {
        attributes_set_number(attributes, "dimensions", (double)specimen->dimensions);
        attributes_set_number(attributes, "thickness_m", specimen->size[2]);
    }
    attributes_set_number(attributes, "section_m2", outline_section(specimen, structure->sites));
    if (specimen->gauge_length > 0)
        attributes_set_number(attributes, "gauge_length_m", gauge_length(specimen, domain));
    set_periods(recipe, attributes);
    set_symmetry(specimen, attributes);
    if (structure->sites->volume) attributes_set_text(attributes, "volumes", "cut");
    if (specimen->angle != 0) attributes_set_number(attributes, "angle_rad", specimen->angle);
    if (!recipe->topology->no_cores)
        attributes_set_number(attributes, "ufg_fraction", findings->ufg_fraction);
    char *words = recipe->topology->describe(recipe, findings);
    char *label = fault ? memory_print("%s; overridden: %s", words, fault) : memory_text(words);
    attributes_set_text(attributes, "label", label);
    free(words);
    free(label);
}

struct domain assemble_domain(const struct recipe *recipe, const struct structure *structure,
                              const struct findings *findings, const char *fault)
{
    const struct sites *sites = structure->sites;
    size_t n_nodes = (size_t)sites->n_nodes;
    struct domain domain = domain_new(sites->n_nodes, recipe->n_phases, recipe->phase_names);
    for (size_t node = 0; node < n_nodes; node++) {
        double position[3];
        sites_position(sites, (int64_t)node, position);
        domain.x[node] = position[0];
        domain.y[node] = position[1];
        domain.z[node] = position[2];
        domain.volume[node] = sites_volume(sites, (int64_t)node);
        domain.phase[node] = structure->phase[node];
    }
    if (structure->grain) {
        domain.grain = memory_new(n_nodes, sizeof *domain.grain);
        for (size_t node = 0; node < n_nodes; node++)
            domain.grain[node] = (double)structure->grain[node];
    }
    specimen_add_sets(&recipe->specimen, sites, recipe->sets, &domain);
    set_attributes(recipe, structure, findings, fault, &domain);
    return domain;
}
