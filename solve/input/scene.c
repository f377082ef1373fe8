#include "scene.h"

#include "family.h"
#include "interface.h"
#include "residual.h"
#include "sections.h"
#include "stabilisation.h"
#include "surface_correction.h"
#include "units.h"

#include <math.h>

/* --- the section solver ----------------------------------------------------------------------- */

enum {
    EXPLICIT = 1 << SOLVER_explicit,
    HYBRID = 1 << SOLVER_hybrid,
    OPEN = 1 << SOLVER_auto,
    MOVING = EXPLICIT | HYBRID | OPEN,
    RESTING = 1 << SOLVER_quasi_static | HYBRID | OPEN
};

#define TYPE(name, words)                                                                          \
    {                                                                                              \
#name, words,                                                                              \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
static const struct variant types[SOLVER_TYPES] = {COURSES(TYPE)};

static const struct variant *type_variant(int i)
{
    return i < SOLVER_TYPES ? &types[i] : NULL;
}

#define IN_DECK(name) #name
const char *const equilibrium_methods[] = {EQUILIBRIUM_METHODS(IN_DECK), NULL};

static const char *const volumes[] = {"whole", "partial", NULL};
static const char *const planes[] = {"stress", "strain", NULL};
static const char *const coincidents[] = {"join", "part", NULL};
static const char *const starts[] = {"affine", "ramp", NULL};
static const char *const events[] = {"damage", "maximum_load", NULL};

#define AT(member) offsetof(struct scene, member)

static const struct key back_keys[] = {
    {"kinetic_to_internal", KEY_NUMBER, AT(hybrid.kinetic_share), "1", 1e-12, 1, .required = true,
     .help = "kinetic over internal energy, below which the body counts as quiet"},
    {"quiet", KEY_NUMBER, AT(hybrid.quiet), "s", 0, 1e6, .required = true,
     .help = "how long it has to stay so, without a broken bond"},
};
static const struct section back = {
    .path = "solver.static_when",
    .help = "When a hybrid run goes back to load steps; what is left of its motion is damped.",
    .keys = KEYS(back_keys)};

static const double along_x[] = {1, 0, 0};

static const struct key solver_keys[] = {
    {"horizon", KEY_NODE, AT(given_horizon), .form = "NUMBER or LENGTH",
     .otherwise = "of correspondence 1, among scattered particles 1.8; else required",
     .help = "in spacings, 1 to 8 of them, or a length; not for corner"},
    {"influence", KEY_CHOICE, AT(influence), .usual = -1, .names = family_influences,
     .otherwise = "constant; of ordinary ones linear, of madenci_oterkus inverse and no other",
     .help = "of a bond of the length r, the horizon being d: constant; steep (dx/r)^8, not for "
             "bond_based; inverse dx/r; linear 1 - r/d; gaussian exp(-4 r^2/d^2); spline, cubic"},
    {"volumes", KEY_CHOICE, AT(partial_volumes), .names = volumes,
     .help = "partial: members near the horizon count by the part of their cell within it"},
    {"plane", KEY_CHOICE, AT(plane), .usual = -1, .names = planes,
     .otherwise = "required of a domain of two dimensions",
     .help = "of such a domain alone; correspondence has strain alone"},
    {"surface_correction", KEY_NODE, AT(elsewhere), .form = "one", .names = surface_corrections,
     .otherwise = "none",
     .help = "factors on the bonds of nodes near a surface; not for correspondence"},
    {"interfaces", KEY_NODE, AT(elsewhere), .form = "one", .names = interface_laws,
     .otherwise = "series",
     .help = "bonds through two phases: series, as stiff as the parts of their line one behind the "
             "other; mean of the moduli; not for correspondence"},
    {"stabilisation", KEY_NODE, AT(elsewhere), .section = &section_stabilisation,
     .otherwise = "mix with its defaults, among scattered particles capped",
     .help = "of correspondence"},
    {"residual", KEY_NODE, AT(elsewhere), .section = &section_residual,
     .otherwise = "flowing with its defaults", .help = "of corner"},
    {"coincident_nodes", KEY_CHOICE, AT(coincident), .usual = -1, .names = coincidents,
     .otherwise = "required where nodes of a mesh lie on each other",
     .help =
         "of corner in meshes: join makes one of nodes at one place, as between blocks that were "
         "meshed apart; part leaves them apart, as along a crack"},
    {"accept", KEY_FLAG, AT(accept),
     .help = "true: also moduli, densities, yield and hardening that no metal has, as a forgotten "
             "GPa makes of it, tests that are over in one step, grips thinner than the horizon "
             "needs, and forces and extension along x of a turned body"},
    {"direction", KEY_NUMBER, AT(direction), "1", -1e6, 1e6, .size = 3, .usuals = along_x,
     .help = "of a periodic body of corner, such as [1, 1, 0]: where x of macroscopic points among "
             "the lattice's axes; z stays as close to the lattice's as may be"},
    {"end_strain", KEY_NUMBER, AT(end_strain), "1", 1e-9, 10, .otherwise = "none",
     .help = "of the gauge, at which the run ends; needs grips with velocities that are numbers"},
    {"end_time", KEY_NUMBER, AT(end_time), "s", 1e-15, 1e12, .otherwise = "none",
     .help = "in place of end_strain"},
    {"end_steps", KEY_INTEGER, AT(end_steps), NULL, 1, 1e12, .otherwise = "none",
     .help = "in place of end_strain"},
    {"programme", KEY_NODE, AT(legs), .form = "list", .section = &section_programme,
     .users = 1 << SOLVER_quasi_static,
     .help = "in place of end_strain: unloading, reloading and cycles, one after the other"},
    {"end_load", KEY_NUMBER, AT(end_load), "1", 0, 1,
     .help = "a broken body that carries less than this share of its largest load ends the run"},
    {"safety", KEY_NUMBER, AT(safety), "1", 1e-3, 10, .usual = 0.8, .users = MOVING,
     .help = "time step over the critical one; above 1 the run explodes and is stopped"},
    {"damping", KEY_NUMBER, AT(damping), "1/s", 0, 1e15, .users = MOVING,
     .help = "of velocities relative to the uniform motion between the grips, if there are any"},
    {"local_damping", KEY_NUMBER, AT(local_damping), "1", 0, 0.95, .users = MOVING,
     .help = "share of the force on each node that acts against its motion, relative as above"},
    {"mass_scaling", KEY_NUMBER, AT(mass_scaling), "1", 1e-6, 1e12, .usual = 1, .users = MOVING,
     .help = "factor on the inertia, not on the stiffness; the step grows by its root"},
    {"energy_tolerance", KEY_NUMBER, AT(energy_tolerance), "1", 1e-12, 1e6, .usual = NAN,
     .users = MOVING, .otherwise = "1e-4; 0.01 where something flows or breaks",
     .help = "relative drift of the energy balance that stops the run"},
    {"strain_step", KEY_NUMBER, AT(strain_step), "1", 1e-12, 1, .usual = 1e-3, .users = MOVING,
     .help = "largest strain between the grips in one explicit step"},
    {"least_steps", KEY_INTEGER, AT(least_steps), NULL, 1, 1e12, .usual = 100, .users = MOVING,
     .help = "of a test by explicit steps, but for one with end_steps"},
    {"start", KEY_CHOICE, AT(start), .names = starts, .users = EXPLICIT,
     .help = "affine: the body moves with its grips from the first step; ramp: from rest"},
    {"ramp", KEY_NUMBER, AT(ramp), "s", 1e-15, 1e6, .users = EXPLICIT,
     .otherwise = "required with 'start: ramp', an error without",
     .help = "time in which velocities that are numbers are reached"},
    {"method", KEY_CHOICE, AT(statics.method), .names = equilibrium_methods, .users = RESTING,
     .help = "of finding equilibria: lbfgs, which leaves to newton what it does not find; newton; "
             "adaptive dynamic relaxation, which takes ten times as many evaluations"},
    {"step", KEY_NODE, AT(statics.given.largest), .form = "NUMBER", .users = RESTING,
     .otherwise = "0.005 of strain, also of end_steps where grips have velocities (a periodic body "
                  "rates) and no step is given; or a hundredth of end_time, or 1 s",
     .help =
         "largest load step: strain between the grips where the run ends at a strain, 1e-12 to "
         "10, else s, 1e-15 to 1e12; steps grow where easy, and are halved where none is found"},
    {"first_step", KEY_NODE, AT(statics.given.first), .form = "NUMBER", .users = RESTING,
     .otherwise = "1/80 of the strain at which the first phase yields, so that the elastic slope "
                  "has its records, at most 1/100 of end_strain; of end_time, and of end_steps "
                  "whose step is in s, the "
                  "largest",
     .help = "first load step, in the same unit"},
    {"smallest_step", KEY_NODE, AT(statics.given.smallest), .form = "NUMBER", .users = RESTING,
     .otherwise = "1e-4 of the largest", .help = "in the same unit; below it the run stops"},
    {"accuracy", KEY_NUMBER, AT(statics.accuracy), "1", 1e-6, 1, .usual = 1e-3, .users = RESTING,
     .help =
         "of the forces on what is moved, relative to the largest so far: steps are as short "
         "as that takes, of those at whose end bonds break five times as long, and residuals as "
         "small; of steps that are counted residuals alone"},
    {"tolerance", KEY_NUMBER, AT(statics.tolerance), "1", 1e-10, 1e-2, .usual = NAN,
     .users = RESTING, .otherwise = "1000 times the square of the accuracy, from 1e-8 to 1e-3",
     .help = "of the residual: norm of the unbalanced forces over that of reactions and loads"},
    {"most_evaluations", KEY_INTEGER, AT(statics.most_evaluations), NULL, 10, 1e9, .users = RESTING,
     .otherwise = "2000, of relaxation 20000",
     .help = "of the force, for one equilibrium; steps grow where it takes up to a quarter of it"},
    {"break_at_once", KEY_INTEGER, AT(statics.break_at_once), NULL, 1, 1e9, .usual = 10,
     .users = RESTING, .help = "bonds and nodes that break in one round at rest, the worst ones"},
    {"explicit_when", KEY_NODE, AT(hybrid.events), .form = "list", .names = events, .users = HYBRID,
     .help =
         "beside where no equilibrium is found: something has to break; the grips' force falls"},
    {"explicit_strain", KEY_NUMBER, AT(hybrid.strain), "1", 0, 10, .usual = INFINITY,
     .users = HYBRID, .otherwise = "none",
     .help = "of the gauge, from which on steps are explicit"},
    {"static_when", KEY_SECTION, .users = HYBRID, .section = &back, .otherwise = "never",
     .help = "when it goes back to load steps"},
};

const struct section section_solver = {
    .path = "solver",
    .help = "How the body is made and how the run advances.  Exactly one of end_strain, end_time, "
            "end_steps and programme says where it ends.",
    .keys = KEYS(solver_keys),
    .chooser = "type",
    .variant = type_variant,
    .usual = SOLVER_quasi_static};

/* --- what depends on other keys --------------------------------------------------------------- */

/* A load step in the unit of the run's end; deck_number wants a literal. */
static double step_or(const struct scene *scene, struct deck_node given, double usual)
{
    if (given.index == 0) return usual;
    return scene->end_strain > 0 ? deck_number(given, "1", 1e-12, 10)
                                 : deck_number(given, "s", 1e-15, 1e12);
}

static void refuse_over(double step, struct deck_node given, const char *other, double most)
{
    if (step > most) deck_error(given, "%g is over the %s step, %g", step, other, most);
}

static void read_steps(struct scene *scene)
{
    struct scene_static *s = &scene->statics;
    const bool strain = scene->end_strain > 0;
    const double usual = strain                ? scene_strain_step
                         : scene->end_time > 0 ? scene->end_time / 100
                                               : 1;
    const bool open =
        strain || (scene->end_steps > 0 && !s->given.largest.index && !s->given.smallest.index);
    s->largest_step = step_or(scene, s->given.largest, usual);
    /* Steps of loads are all alike; that of a strain follows from the materials. */
    s->first_step = step_or(scene, s->given.first, open ? INFINITY : s->largest_step);
    s->smallest_step =
        step_or(scene, s->given.smallest, fmin(1e-4 * s->largest_step, s->first_step));
    if (s->given.first.index)
        refuse_over(s->first_step, s->given.first, "largest", s->largest_step);
    refuse_over(s->smallest_step, s->given.smallest, s->given.first.index ? "first" : "largest",
                fmin(s->first_step, s->largest_step));
    if (isnan(s->tolerance)) s->tolerance = fmax(1e-8, fmin(1e-3, 1e3 * s->accuracy * s->accuracy));
}

static void read_events(struct scene_hybrid *hybrid)
{
    const struct deck_node list = hybrid->events;
    for (int i = 0; list.index && i < deck_count(list); i++)
        *(keys_choice(deck_item(list, i), events) == 0 ? &hybrid->at_damage : &hybrid->at_maximum) =
            true;
}

/* A length waits for the body, whose spacing it is measured in. */
static void read_horizon(struct scene *scene)
{
    double number;
    const struct deck_node given = scene->given_horizon;
    if (given.index && !units_read(deck_string(given), "1", &number))
        scene->horizon = deck_number(given, "1", 1, 8);
}

void scene_measure_horizon(struct scene *scene, double spacing)
{
    if (scene->given_horizon.index && scene->horizon == 0)
        scene->horizon = deck_length(scene->given_horizon, spacing, spacing, 8 * spacing) / spacing;
}

static void read_solver(struct scene *scene)
{
    const struct deck_node solver = scene->solver;
    scene->type = (enum scene_type)keys_variant(solver, &section_solver);
    keys_read(solver, &section_solver, (int)scene->type, 0, scene, NULL);
    read_horizon(scene);
    scene->plane++; /* SPACE stands before the two names */
    scene->programme = programme_read(scene->legs);
    if ((scene->end_strain > 0) + (scene->end_time > 0) + (scene->end_steps > 0) +
            (scene->programme.count > 0) !=
        1)
        deck_error(solver, "give one of end_strain, end_time, end_steps and programme");
    if (scene->type == SOLVER_auto && scene->end_steps > 0)
        deck_error(deck_get(solver, "end_steps"),
                   "steps of either kind are of another length: 'type: auto' ends at an end_strain "
                   "or end_time");
    if (scene->programme.count > 0) scene->end_strain = programme_farthest(&scene->programme);
    if (scene->start == START_RAMP)
        deck_get(solver, "ramp"); /* dies */
    else if (scene->ramp > 0)
        deck_error(deck_get(solver, "ramp"), "a ramp goes with 'start: ramp'");
    if (scene->type != SOLVER_explicit) read_steps(scene);
    read_events(&scene->hybrid);
}

struct scene scene_read(struct deck *deck)
{
    const struct deck_node root = deck_root(deck);
    sections_read(deck);
    struct scene scene = {.solver = deck_get(root, "solver")};
    read_solver(&scene);
    scene_read_entries(&scene, root);
    scene_read_output(&scene, deck_find(root, "output"));
    return scene;
}
