#include "record.h"

#include "broken.h"
#include "memory.h"

#include <stdlib.h>
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
        {"force_left", "N", NEEDS_LOAD, record->force_left,
         "axial force that the left grip exerts on the specimen, along the axis of the test: below "
         "0 in tension; of a body periodic along x minus the next"},
        {"force_right", "N", NEEDS_LOAD, record->force_right,
         "axial force that the right grip exerts on the specimen: above 0 in tension; of a body "
         "periodic along x the mean stress xx times its section, volume over period"},
        {"extension", "m", NEEDS_GAUGE, planes.right - planes.left,
         "growth of the distance of the gauge planes"},
        {"grip_extension", "m", NEEDS_GRIPS, right->moved - left->moved,
         "growth of the distance of the grips"},
        {"kinetic_energy", "J", 0, energy->kinetic, "kinetic energy of the whole body"},
        {"stored_energy", "J", 0, energy->stored, "elastic energy of the whole body"},
        {"plastic_energy", "J", 0, energy->plastic,
         "plastic work, with what growing ductile damage releases"},
        {"stabilisation_energy", "J", 0, energy->stabilisation, "energy of the stabilisation"},
        {"damping_energy", "J", 0, energy->damping, "energy lost to damping"},
        {"external_work", "J", 0, energy->work, "work of prescribed motions and loads"},
        {"energy_drift", "1", 0, energy_drift(energy),
         "(sum of the energies - energy at the start - external work)/largest term"},
        {"kinetic_to_internal", "1", 0, energy->kinetic * per_internal,
         "kinetic over internal energy (stored, plastic, of the stabilisation)"},
        {"minimum_section_ratio", "1", NEEDS_GAUGE, record->section.ratio,
         "smallest current section across the axis over the initial one, from the mean of F_yy "
         "F_zz (of the axis x) of each layer of nodes"},
        {"minimum_section_x", "m", NEEDS_GAUGE, record->section.x,
         "reference place of that section along the axis of the test"},
        {"gauge_left_displacement", "m", NEEDS_GAUGE, planes.left,
         "mean axial displacement of the left gauge plane"},
        {"gauge_right_displacement", "m", NEEDS_GAUGE, planes.right,
         "mean axial displacement of the right gauge plane"},
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
        {"staggered_energy", "J", 0, energy->staggered,
         "1/2 m (v(n-1/2).v(n+1/2) - v(n)^2), which with kinetic_energy is what explicit steps "
         "keep"},
        {"fracture_energy", "J", 0, energy->fracture,
         "what the body held less after bonds had broken"},
        {"broken_bonds", "1", 0, run->damage ? damage_broken_bonds(run->damage) : 0,
         "bonds of the whole body that have broken, without those cut by cracks"},
        {"removed_nodes", "1", 0, run->damage ? damage_removed_nodes(run->damage) : 0,
         "nodes of the whole body that laws of phases (plastic_strain, ductile) have removed"},
        {"nodes_without_gradient", "1", 0, unsupported(record->body),
         "nodes without a deformation gradient: their families do not span space, from the start "
         "or since their bonds broke"},
        {"quasi_static", "1", 0, run->moving ? 0 : 1,
         "1 where the record is of an equilibrium, 0 where of an explicit step"},
        {"residual", "1", 0, run->residual,
         "of the equilibrium of a record: norm of the unbalanced forces over that of reactions and "
         "loads"},
        {"force_evaluations", "1", 0, (double)run->evaluations,
         "evaluations of the force since the start"},
    };
    add_columns(columns, COUNT(rows), rows);
}

/* Of a periodic body. */
static void add_macroscopic(struct list *columns, const struct record *record)
{
    static const char *const gradients[] = {"mean_gradient_xx", "mean_gradient_xy",
                                            "mean_gradient_xz", "mean_gradient_yx",
                                            "mean_gradient_yy", "mean_gradient_yz",
                                            "mean_gradient_zx", "mean_gradient_zy",
                                            "mean_gradient_zz"},
                             *const stresses[] = {
                                 "mean_stress_xx", "mean_stress_xy", "mean_stress_xz",
                                 "mean_stress_yx", "mean_stress_yy", "mean_stress_yz",
                                 "mean_stress_zx", "mean_stress_zy", "mean_stress_zz"};
    struct record_column rows[2 * COMPONENTS];
    for (int k = 0; k < COMPONENTS; k++) {
        rows[k] =
            (struct record_column){gradients[k], "1", NEEDS_PERIODS, record->body->mean_gradient[k],
                                   "of a periodic body: this component of the mean F - 1"};
        rows[COMPONENTS + k] = (struct record_column){
            stresses[k], "Pa", NEEDS_PERIODS, record->body->mean_stress[k],
            "of a periodic body: mean nominal (first Piola-Kirchhoff) stress over its volume"};
    }
    add_columns(columns, COUNT(rows), rows);
}

struct record_column *record_columns(const struct record *record, unsigned has, int *count)
{
    struct list columns = {.has = has};
    add_test(&columns, record);
    add_run(&columns, record);
    add_macroscopic(&columns, record);
    *count = columns.count;
    return columns.items;
}

static struct key manual_row(char *title, const char *unit, const char *help)
{
    return (struct key){title, KEY_NODE, .form = strcmp(unit, "1") == 0 ? "number" : unit,
                        .otherwise = "", .help = help};
}

const struct section *record_section(void)
{
    static struct section section = {
        .path = "output.history",
        .help = "The columns of a history, which are no keys. Those of forces and grip_extension "
                "need two grips or a body periodic along x, those of the mean stress and gradient "
                "a periodic body, those of the gauge, its phases and sections the node sets "
                "gauge_left and gauge_right; without them they are absent. Behind them stand "
                "output.quantities."};
    const struct record empty = record_empty();
    int count;
    struct record_column *columns = record_columns(&empty, ~0u, &count);
    struct key *rows = memory_new((size_t)(count + gauge_mean_count), sizeof *rows);
    for (int i = 0; i < count; i++)
        rows[i] = manual_row(column_title(columns[i].name, columns[i].unit), columns[i].unit,
                             columns[i].help);
    free(columns);
    for (int k = 0; k < gauge_mean_count; k++) {
        const struct gauge_mean *mean = &gauge_means[k];
        char *title = column_title(mean->name, mean->unit);
        rows[count + k] =
            manual_row(memory_print("PHASE_%s", title), mean->unit,
                       memory_print("mean over the nodes of the phase between the gauge planes: %s",
                                    mean->help));
        free(title);
    }
    section.keys = (struct keys){count + gauge_mean_count, rows};
    return &section;
}

char *column_title(const char *name, const char *unit)
{
    const bool pure = strcmp(unit, "1") == 0;
    return memory_print("%s%s%s", name, pure ? "" : "_", pure ? "" : unit);
}
