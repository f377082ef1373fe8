#include "record.h"

#include "broken.h"
#include "memory.h"

#include <string.h>

struct record record_empty(void)
{
    static const struct integration integration;
    static const struct body body;
    static const struct boundary_set set;
    return (struct record){&integration, &body, .left = &set, .right = &set};
}

/* Nodes without a deformation gradient: from the start, or since their bonds broke. */
static double unsupported(const struct body *body)
{
    return (double)body->unsupported + (body->broken ? body->broken->n_lost : 0);
}

struct list {
    unsigned has;
    int count;
    struct record_column *items;
};

/* Adds those rows that need no more than there is. */
static void add_columns(struct list *columns, int count, const struct record_column rows[])
{
    for (int i = 0; i < count; i++) {
        if (rows[i].needs & ~columns->has) continue;
        columns->items = memory_grow(columns->items, columns->count, sizeof *rows);
        columns->items[columns->count++] = rows[i];
    }
}
#define COUNT(rows) ((int)(sizeof(rows) / sizeof *(rows)))

static void add_test(struct list *columns, const struct record *record)
{
    const struct boundary_set *left = record->left, *right = record->right;
    const struct gauge_planes planes = record->planes;
    const struct energy_balance *energy = &record->integration->balance;
    const double internal = energy_internal(energy), per_internal = internal > 0 ? 1 / internal : 0;
    const struct record_column rows[] = {
        {"force_left", "N", NEEDS_GRIPS, left->total_force,
         "axial force that the left grip exerts on the specimen, along +x: below 0 in tension"},
        {"force_right", "N", NEEDS_GRIPS, right->total_force,
         "the same of the right grip: above 0 in tension"},
        {"extension", "m", NEEDS_GAUGE, planes.right - planes.left,
         "growth of the distance of the gauge planes"},
        {"grip_extension", "m", NEEDS_GRIPS, right->moved - left->moved,
         "growth of the distance of the grips"},
        {"kinetic_energy", "J", 0, energy->kinetic, "of the whole body, as the energies below"},
        {"stored_energy", "J", 0, energy->stored, "elastic energy"},
        {"plastic_energy", "J", 0, energy->plastic,
         "plastic work, with what growing ductile damage releases"},
        {"stabilisation_energy", "J", 0, energy->stabilisation, "of the stabilisation"},
        {"damping_energy", "J", 0, energy->damping, "lost to damping"},
        {"external_work", "J", 0, energy->work, "work of prescribed motions and loads"},
        {"energy_drift", "1", 0, energy_drift(energy),
         "(sum of the energies - energy at the start - external work)/largest term"},
        {"kinetic_to_internal", "1", 0, energy->kinetic * per_internal,
         "kinetic over internal energy (stored, plastic, of the stabilisation)"},
        {"minimum_section_ratio", "1", NEEDS_GAUGE, record->section.ratio,
         "smallest current section along x over the initial one, from the mean of F_yy F_zz of "
         "each layer of nodes"},
        {"minimum_section_x", "m", NEEDS_GAUGE, record->section.x, "where"},
        {"gauge_left_displacement", "m", NEEDS_GAUGE, planes.left,
         "mean displacement along x of the left gauge plane"},
        {"gauge_right_displacement", "m", NEEDS_GAUGE, planes.right, "the same of the right one"},
    };
    add_columns(columns, COUNT(rows), rows);
}

static void add_run(struct list *columns, const struct record *record)
{
    const struct integration *run = record->integration;
    const struct energy_balance *energy = &run->balance;
    const double internal = energy_internal(energy), per_internal = internal > 0 ? 1 / internal : 0;
    const struct record_column rows[] = {
        {"unsteady_to_internal", "1", 0, record->unsteady * per_internal,
         "as kinetic_to_internal, of the motion beyond the uniform stretching between the grips "
         "(waves, necks): what makes a test dynamic"},
        {"fracture_energy", "J", 0, energy->fracture,
         "what the body held less after bonds had broken"},
        {"broken_bonds", "1", 0, run->damage ? damage_broken_bonds(run->damage) : 0,
         "bonds of the whole body that have broken, without those cut by cracks"},
        {"removed_nodes", "1", 0, run->damage ? damage_removed_nodes(run->damage) : 0,
         "nodes of the whole body that laws of phases (`plastic_strain`, `ductile`) have removed"},
        {"nodes_without_gradient", "1", 0, unsupported(record->body),
         "nodes without a deformation gradient: their families do not span space, from the start "
         "or since their bonds broke"},
        {"quasi_static", "1", 0, run->moving ? 0 : 1,
         "1 where the record is of an equilibrium, 0 where of an explicit step"},
        {"residual", "1", 0, run->residual,
         "of that equilibrium: norm of the unbalanced forces over that of reactions and loads"},
        {"force_evaluations", "1", 0, (double)run->evaluations, "so far"},
    };
    add_columns(columns, COUNT(rows), rows);
}

struct record_column *record_columns(const struct record *record, unsigned has, int *count)
{
    struct list columns = {.has = has};
    add_test(&columns, record);
    add_run(&columns, record);
    *count = columns.count;
    return columns.items;
}

char *column_title(const char *name, const char *unit)
{
    const bool pure = strcmp(unit, "1") == 0;
    return memory_print("%s%s%s", name, pure ? "" : "_", pure ? "" : unit);
}
