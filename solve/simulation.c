#include "simulation.h"

#include "bond_search.h"
#include "corners.h"
#include "cracks.h"
#include "die.h"
#include "domain_input.h"
#include "exodus.h"
#include "initial.h"
#include "law.h"
#include "material_plausible.h"
#include "material_read.h"
#include "memory.h"
#include "mesh.h"
#include "options.h"
#include "pieces.h"
#include "simulation_parts.h"
#include "stable_step.h"
#include "yield.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct domain *own_domain(struct simulation *s)
{
    return s->ranks.rank == 0 ? &s->domain : NULL;
}

static void read_particles(struct simulation *s)
{
    domain_input_read(s->arguments, &s->domain, &s->deck, &s->lattice);
    if (s->lattice.n_sites > 0) return;
    double thickness = attributes_number(&s->domain.attributes, "thickness_m", 0);
    s->lattice = lattice_scattered(&s->domain, thickness);
}

static bool is_repeated(const struct lattice *lattice)
{
    bool repeated = false;
    for (int a = 0; a < 3; a++) repeated = repeated || lattice->periodic[a] || lattice->mirror[a];
    return repeated;
}

static void check_plane(const struct simulation *s)
{
    const bool flat = s->lattice.dimensions == 2;
    if (flat && s->scene.plane == SPACE)
        deck_error(s->scene.solver, "a body of one layer needs 'plane: stress' or 'plane: strain'");
    if (!flat && s->scene.plane != SPACE)
        deck_error(deck_get(s->scene.solver, "plane"),
                   "the body has three dimensions (domain.dimensions: 2 makes one layer)");
}

/* They become parts of names in the outputs. */
static void check_phases(const struct simulation *s, struct deck_node materials)
{
    for (int p = 0; p < s->domain.n_phases; p++) {
        const char *name = s->domain.phase_names[p], *fault = exodus_phase_fault(name);
        const struct deck_node map = deck_find(materials, name);
        if (fault) deck_error(map.index ? map : materials, "the phase's name '%s' %s", name, fault);
    }
}

static void read_model(struct simulation *s)
{
    const struct scene *scene = &s->scene;
    const struct deck_node section = deck_get(deck_root(s->deck), "materials");
    check_phases(s, section);
    s->materials = materials_read(section, s->domain.n_phases, s->domain.phase_names, scene->plane);
    if (!scene->accept) material_check_plausible(&s->materials, section);
    for (int p = 0; p < s->materials.count; p++)
        s->materials.items[p].density *= scene->mass_scaling;
    const struct formulation *formulation = s->materials.formulation;
    const bool scattered = lattice_is_scattered(&s->lattice) && !formulation->corners;
    scene_measure_horizon(&s->scene, s->lattice.spacing);
    if (scene->horizon == 0)
        s->scene.horizon = scattered ? formulation->scattered : formulation->horizon;
    if (scene->horizon == 0) deck_get(scene->solver, "horizon"); /* dies */
    int influence =
        scene->influence >= 0 ? scene->influence : family_influence(formulation->influence);
    s->family = family_new(scene->horizon, influence, scene->partial_volumes);
    s->family.scattered = scattered;
    s->model = model_new(scene->solver, &s->family, &s->materials);
}

/* Graded meshes have gaps where their elements are longer than a horizon of mean spacings. */
static void warn_of_pieces(const struct simulation *s)
{
    const double reach = s->scene.horizon * s->lattice.spacing;
    const int64_t pieces =
        pieces_count(s->lattice.point, s->lattice.period, s->lattice.n_sites, reach);
    if (pieces > 1)
        warn("the particles are %lld bodies: no bond joins these within a horizon of %g spacings, "
             "%.4g m; where they should be one, take a longer horizon",
             (long long)pieces, s->scene.horizon, reach);
}

/* Bonds have one length along all axes, and nodes one volume, but for scattered ones. */
static void refuse_cells(const struct simulation *s)
{
    const char *name = s->materials.formulation->name;
    if (lattice_is_scattered(&s->lattice)) {
        note("the particles lie on no lattice: a list of neighbours serves them");
        return;
    }
    if (lattice_is_oblong(&s->lattice))
        die_user("the lattice is spaced %g, %g, %g m along x, y, z: %s materials need cubes; take "
                 "corner, or one spacing",
                 s->lattice.edge[0], s->lattice.edge[1], s->lattice.edge[2], name);
    if (s->lattice.volume)
        die_user("the particles' volumes are cut at the surface, which %s materials do not take: "
                 "use corner, or leave out domain.volumes",
                 name);
}

static void take_mesh(struct simulation *s)
{
    const int64_t coincident = mesh_coincident(&s->domain, NULL, s->scene.coincident == MESH_JOIN);
    if (coincident > 0 && s->scene.coincident < 0)
        deck_error(s->scene.solver,
                   "%lld nodes of the mesh lie on others: 'coincident_nodes: join' makes one of "
                   "those at one place, 'coincident_nodes: part' leaves the elements apart there",
                   (long long)coincident);
    if (lattice_is_periodic(&s->lattice)) {
        if (coincident > 0 && s->scene.coincident == MESH_PART)
            deck_error(deck_get(s->scene.solver, "coincident_nodes"),
                       "a periodic mesh has none of its nodes apart: take join");
        mesh_fold(&s->domain);
    }
    lattice_free(&s->lattice);
    s->lattice = mesh_lattice(&s->domain, &s->corners);
}

/* Where the formulation has corners of particles for its nodes. */
static void take_corners(struct simulation *s)
{
    if (!s->materials.formulation->corners) {
        refuse_cells(s);
        return;
    }
    if (s->domain.corners) {
        take_mesh(s);
        return;
    }
    if (lattice_is_scattered(&s->lattice))
        die_user("the particles lie on no lattice and are no hexahedra of a mesh, so that they "
                 "have no cells with corners: take correspondence or another formulation than "
                 "corner");
    struct lattice particles = s->lattice;
    s->lattice = corners_lattice(&particles);
    s->corners = corners_domain(&s->lattice);
    lattice_free(&particles);
}

/* The nodes as rank 0 has read or made them. */
static const struct domain *nodes_of(const struct simulation *s)
{
    return s->lattice.corner ? &s->corners : &s->domain;
}

/* The domain whose sets members are of (members.h); NULL on other ranks than 0. */
static const struct domain *sets_of(const struct simulation *s)
{
    if (s->ranks.rank != 0) return NULL;
    return s->lattice.hexahedron ? &s->corners : &s->domain;
}

/* Rank 0 reads and checks everything a user can get wrong; the others follow what is known to be
 * good, so that each error is told once. */
static void read_inputs(struct simulation *s)
{
    int n_phases = 0;
    long length = 0;
    char *text = NULL;
    if (s->ranks.rank == 0) {
        read_particles(s);
        if (s->arguments->input) s->input = open(s->arguments->input, O_RDONLY | O_CLOEXEC);
        s->scene = scene_read(s->deck);
        n_phases = s->domain.n_phases;
        read_model(s);
        take_corners(s);
        check_plane(s);
        s->lattice.axis = (int)attributes_number(&s->domain.attributes, "axis", 0);
        if (s->lattice.axis > 0 && is_repeated(&s->lattice))
            die_user(
                "domain.axis: a body that is periodic or has planes of symmetry is tested along x");
        if (s->lattice.dimensions == 2 && s->lattice.axis == 2)
            die_user("domain.axis: z is no axis of a test of a sheet in x and y");
        scene_resolve(&s->scene, &s->domain, nodes_of(s), &s->lattice);
        scene_check_images(&s->scene, &s->domain, nodes_of(s), &s->lattice);
        text = memory_text(deck_text(s->deck));
        length = (long)strlen(text);
    }
    lattice_share(&s->lattice, s->ranks.rank);
    ranks_share(&length, sizeof length);
    ranks_share(&n_phases, sizeof n_phases);
    if (s->ranks.rank != 0) {
        text = memory_new((size_t)length + 1, 1);
        s->domain.phase_names = memory_new((size_t)n_phases, sizeof(char *));
        s->domain.n_phases = n_phases;
    }
    ranks_share(text, (size_t)length);
    for (int p = 0; p < n_phases; p++) {
        char phase[256] = {0};
        if (s->ranks.rank == 0) snprintf(phase, sizeof phase, "%s", s->domain.phase_names[p]);
        ranks_share(phase, sizeof phase);
        if (s->ranks.rank != 0) s->domain.phase_names[p] = memory_text(phase);
    }
    if (s->ranks.rank != 0) {
        note_set_quiet(1);
        s->deck = deck_parse(text, (size_t)length, "deck");
        s->scene = scene_read(s->deck);
        read_model(s);
    }
    free(text);
}

static void open_outputs(struct simulation *s)
{
    const struct arguments *a = s->arguments;
    if (s->ranks.rank != 0) return;
    if (a->ranks > 1 && a->ranks != s->ranks.size)
        die_user("-j %d within a launcher that started %d: leave one of them out", a->ranks,
                 s->ranks.size);
    if (a->check && !a->history)
        s->history_output = (struct spool){.descriptor = -1};
    else if (a->spooled)
        s->history_output = (struct spool){.descriptor = -1, .path = memory_text(a->spooled)};
    else if (!a->history && s->ranks.size > 1)
        die_user("under mpirun or srun the history needs a name: --history FILE "
                 "(mpirun hides a full disk and a closed pipe)");
    else
        s->history_output = spool_output(a->history);
    s->history_output.shown = a->history;
    s->history_output.precious = "hssolve-history.failed";
    if (a->fields && s->scene.fields.n_variables == 0)
        die_user("-o %s: the deck's output section asks for no fields", a->fields);
    if (!a->fields && s->scene.fields.n_variables > 0)
        note("no -o FILE: the fields are not written");
    if (a->fields) s->fields_output = spool_output(a->fields);
}

/* Before the model starts, which must see the body with its cracks. */
static void start_damage(struct simulation *s)
{
    struct deck_node root = deck_root(s->deck), section = deck_find(root, "cracks");
    s->damage = damage_new(root, s->model, &s->materials, &s->body, s->bonds);
    if (section.index && s->materials.formulation->corners)
        deck_error(section, "corner has no bonds that a crack could cut: take another formulation");
    struct cracks cracks = cracks_read(section, s->lattice.spacing, s->lattice.dimensions);
    const int64_t cut = cracks_cut(&cracks, &s->body, s->bonds);
    if (cracks.count > 0 && cut == 0 && s->ranks.rank == 0) warn("the cracks cut no bond");
    if (cut > 0) note("cracks cut %lld bonds", (long long)cut);
    cracks_free(&cracks);
}

/* Steps keep the energy of an elastic body; each node that begins to flow, and each bond that
 * breaks, is a kink which a step meets in its midst. */
static double usual_tolerance(const struct simulation *s)
{
    bool elastic = !deck_find(deck_root(s->deck), "damage").index;
    for (int k = 0; k < s->materials.n_laws; k++)
        elastic = elastic && s->materials.laws[k].law->n_states == 0;
    return elastic ? 1e-4 : 0.01;
}

static void fill_corners(struct simulation *s)
{
    double *density = memory_new((size_t)s->materials.count, sizeof *density);
    for (int p = 0; p < s->materials.count; p++) density[p] = s->materials.items[p].density;
    corners_fill(&s->body, density);
    free(density);
}

/* Layers of nodes that a grip has to have, so that no free node misses a part of its family in it;
 * where the stress is that of nodes two at least: the layer which the free ones see needs a
 * gradient. */
static int layers_of_grip(const struct simulation *s)
{
    const struct formulation *formulation = s->materials.formulation;
    if (formulation->corners) return 1;
    return s->family.reach < 2 && formulation->stress_of == STRESS_OF_NODES ? 2 : s->family.reach;
}

static void check_grips(const struct simulation *s)
{
    const struct boundary *boundary = &s->boundary;
    const int needed = layers_of_grip(s);
    if (!boundary_has_grips(boundary)) return;
    for (int k = 0; k < 2; k++) {
        const struct boundary_set *set = &boundary->sets[k ? boundary->right : boundary->left];
        const double layers = 1 + (set->members.high - set->members.low) / s->lattice.spacing;
        static const char thin[] =
            "this grip is %.3g layers of particles thick, and a horizon of %g spacings needs %d: "
            "the free particles beside it%s miss a part of their families%s";
        if (layers >= needed - 0.5) continue;
        if (!s->scene.accept)
            deck_error(set->where, thin, layers, s->scene.horizon, needed, " would",
                       "; hold more of the body, or shorten the horizon; 'accept: true' takes it");
        if (s->ranks.rank == 0) warn(thin, layers, s->scene.horizon, needed, "", "");
    }
}

/* Forces of grips and displacements of gauge planes are along the axis of the test. */
static void check_turned(const struct simulation *s)
{
    const struct deck_node domain = deck_find(deck_root(s->deck), "domain"),
                           said = domain.index ? deck_find(domain, "angle") : domain;
    double angle = attributes_number(&s->domain.attributes, "angle_rad", 0);
    static const char turned[] = "the body is turned by %.4g degree, and the history has forces "
                                 "and extension along %c, not along the body%s";
    ranks_share(&angle, sizeof angle);
    if (angle == 0 || !(s->gauge || boundary_has_grips(&s->boundary))) return;
    const double degrees = angle * 180 / acos(-1);
    const int axis = 'x' + s->lattice.axis;
    if (!s->scene.accept)
        deck_error(
            said.index ? said : s->scene.solver, turned, degrees, axis,
            ": test one that is not turned; 'accept: true' in solver takes these components");
    if (s->ranks.rank == 0) warn(turned, degrees, axis, "");
}

/* Share of the nodes that may have too few neighbours for a gradient, and carry nothing. */
static const double MOST_LOST = 0.05;

static void refuse_lost(const struct simulation *s)
{
    const double lost = (double)s->body.unsupported / (double)s->lattice.n_nodes;
    const struct deck_node horizon = deck_find(s->scene.solver, "horizon");
    if (s->materials.formulation->stress_of != STRESS_OF_NODES || lost <= MOST_LOST) return;
    deck_error(horizon.index ? horizon : s->scene.solver,
               "%.3g %% of the nodes (%lld of %lld) have too few neighbours within a horizon of "
               "%g spacings for a deformation gradient, and would carry no stress; %g %% may: take "
               "a longer horizon, or particles that stand closer",
               100 * lost, (long long)s->body.unsupported, (long long)s->lattice.n_nodes,
               s->scene.horizon, 100 * MOST_LOST);
}

/* Where a node's family, and that of its neighbours, reaches, nothing is more than a period away.
 */
static void check_thickness(const struct simulation *s)
{
    const struct lattice *lattice = &s->lattice;
    const bool corners = s->materials.formulation->corners, row = lattice_is_row(lattice);
    const int least = corners ? 1 : 2 * s->family.reach;
    const double reach = s->family.horizon * lattice->spacing;
    for (int a = 0; a < 3; a++) {
        if (row && !corners && lattice->periodic[a] && !(lattice->period[a] > 2.001 * reach))
            die_user("the body is periodic along %c after %g m, no more than twice the horizon of "
                     "%g m: take more of the body or a shorter horizon",
                     'x' + a, lattice->period[a], reach);
        if (!row && lattice->periodic[a] && lattice->size[a] < least)
            die_user("the body is periodic along %c after %d layers, thinner than twice the "
                     "horizon: it needs %d; take more cells, a finer spacing or a shorter horizon",
                     'x' + a, lattice->size[a], least);
    }
}

/* What is measured of nodes is that along the axis of the test, of corner alone any one. */
static void check_direction(const struct simulation *s)
{
    const bool *periodic = s->lattice.periodic;
    const double *d = s->scene.direction;
    const struct deck_node where = deck_find(s->scene.solver, "direction");
    if (!where.index) return;
    if (!(fabs(d[0]) + fabs(d[1]) + fabs(d[2]) > 0))
        deck_error(where, "the direction [0, 0, 0] points nowhere");
    if (!periodic[0] || !periodic[1] || !periodic[2])
        deck_error(where, "only bodies that are periodic along x, y and z are tested along "
                          "another direction");
    if (!s->materials.formulation->corners)
        deck_error(where, "%s materials are tested along x: take corner, or turn the structure",
                   s->materials.formulation->name);
}

static void check_periods(struct simulation *s)
{
    const struct lattice *lattice = &s->lattice;
    const struct deck_node section = s->scene.periodic_load;
    const bool mirror = lattice->mirror[0] || lattice->mirror[1] || lattice->mirror[2];
    if (mirror && !s->materials.formulation->corners)
        deck_error(deck_get(deck_root(s->deck), "materials"),
                   "%s materials have no planes of symmetry: take corner",
                   s->materials.formulation->name);
    check_direction(s);
    if (!lattice_is_periodic(lattice)) {
        if (section.index && deck_count(section) > 0)
            deck_error(section, "the body is not periodic: domain.periodic says along which axes a "
                                "body is");
        return;
    }
    check_thickness(s);
    if (lattice->periodic[0] && s->ranks.rank == 0)
        attributes_set_number(&s->domain.attributes, "section_m2",
                              lattice_whole_volume(lattice) / lattice_period(lattice, 0));
}

static void build(struct simulation *s)
{
    const struct offset *near;
    int n_near = model_near(s->model, &s->family, &near);
    check_periods(s);
    profile_enter(s->profile, PART_PARTITION);
    s->body = body_new(&s->lattice, &s->family, near, n_near, s->ranks);
    body_profile(&s->body, s->profile);
    body_turn(&s->body, s->scene.direction);
    profile_enter(s->profile, PART_BONDS);
    if (s->lattice.corner) fill_corners(s);
    yield_start(&s->body, &s->materials);
    s->bonds = bonds_new(&s->body);
    s->n_bonds = (double)bonds_total(s->bonds);
    start_damage(s);
    if (isnan(s->scene.energy_tolerance)) s->scene.energy_tolerance = usual_tolerance(s);
    model_start(s->model, &s->body, s->bonds);
    s->boundary = boundary_new(&s->scene, &s->body, 10 * materials_stiffest(&s->materials));
    check_grips(s);
    s->gauge = gauge_new(&s->body, sets_of(s), s->domain.n_phases);
    check_turned(s);
    s->quantities = quantities_new(&s->scene, &s->body, s->damage);
    refuse_lost(s);
    if (s->family.scattered && s->ranks.rank == 0) warn_of_pieces(s);
}

double simulation_fraction(const struct simulation *s, int phase)
{
    int64_t nodes = 0;
    if (s->gauge) return gauge_fraction(s->gauge, phase);
    for (int64_t site = 0; site < s->lattice.n_sites; site++)
        nodes += s->lattice.phase[site] == phase;
    return (double)nodes / (double)s->lattice.n_particles;
}

/* Mean Poisson's ratio, for the start velocity. */
static double mean_poissons_ratio(const struct simulation *s)
{
    double sum = 0;
    for (int p = 0; p < s->materials.count; p++)
        sum += simulation_fraction(s, p) * s->materials.items[p].poissons_ratio;
    return sum;
}

/* Time in which the grips stretch the gauge to its end. */
static double time_to_strain(const struct simulation *s)
{
    const char *key = legs_are(s) ? "programme" : "end_strain";
    const struct deck_node where = deck_get(s->scene.solver, key);
    const double rate = boundary_full_strain_rate(&s->boundary);
    if (!s->gauge)
        deck_error(where,
                   "%s needs a gauge: node sets gauge_left and gauge_right, or a body that "
                   "is periodic along x",
                   key);
    if (!(rate > 0))
        deck_error(where,
                   "%s needs grips that move apart: two sets, one right of the other, with "
                   "velocities along %c that are numbers, or of a periodic body a rate of xx in "
                   "macroscopic (strain rate %g 1/s)",
                   key, "xyz"[s->lattice.axis], rate);
    if (legs_are(s)) return programme_way(&s->scene.programme) / rate;
    /* By the ramp's end the grips have gone half of what they would at full speed. */
    return s->scene.end_strain / rate + 0.5 * boundary_ramp(&s->boundary);
}

static double explicit_step(struct simulation *s)
{
    s->explicit_steps.critical = stable_step(s->model, &s->body, &s->materials);
    if (!isfinite(s->explicit_steps.critical))
        die_user(
            "no node acts on another: no bond within the horizon of %g spacings has a weight, or "
            "cracks cut all",
            s->scene.horizon);
    return s->scene.safety * s->explicit_steps.critical;
}

/* A step that is stable has to show something of the test. */
static double resolve_test(const struct simulation *s, double stable)
{
    if (s->course->moving && s->scene.end_steps == 0 && !(s->end_time > stable) && !s->scene.accept)
        deck_error(
            s->scene.solver,
            "the test is over in %.3g s, within one stable step of %.3g s: no wave has "
            "crossed a particle by then. Are the grips' velocities, the moduli (did you "
            "mean GPa?), density and mass_scaling what they should be? 'accept: true' takes them",
            s->end_time, stable);
    return s->course->moving ? explicit_length(s) : stable;
}

static double end_of_time(const struct simulation *s, double dt)
{
    if (s->scene.end_strain > 0) return time_to_strain(s);
    return s->scene.end_steps > 0 ? (double)s->scene.end_steps * dt : s->scene.end_time;
}

/* A body that goes from equilibrium to equilibrium has lost it before the first. */
static void refuse_velocities(const struct simulation *s)
{
    for (int i = 0; i < s->scene.n_initial; i++)
        if (s->scene.initial[i].kind == SCENE_VELOCITY)
            deck_error(s->scene.initial[i].where,
                       "load steps have no inertia, and a velocity at the start changes nothing "
                       "in them: take 'type: explicit', or leave it out");
}

#define COURSE_ADDRESS(name, words) &course_##name

static void plan_time(struct simulation *s)
{
    static const struct course *const courses[] = {COURSES(COURSE_ADDRESS)};
    s->course = courses[s->scene.type];
    initial_set(&s->scene, &s->body, SCENE_DISPLACEMENT);
    boundary_set_displacements(&s->boundary, &s->body);
    static_first_step(s);
    if (s->course->choose) {
        s->end_time = end_of_time(s, NAN);
        s->course = s->course->choose(s);
    }
    const bool moving = s->course->moving;
    if (!moving) refuse_velocities(s);
    const double first = moving ? explicit_step(s) : static_step(s, s->scene.statics.first_step);
    s->end_time = end_of_time(s, first);
    const double dt = resolve_test(s, first);
    if (!(s->end_time / dt < 1.001e12))
        deck_error(s->scene.solver, "%.3g s in steps of %.3g s are over 1e12 steps", s->end_time,
                   dt);
    s->n_steps = s->scene.end_steps > 0 ? s->scene.end_steps : (int64_t)ceil(s->end_time / dt);
    /* A prescribed displacement is asked for half a step beyond the end. */
    if (s->ranks.rank == 0) {
        scene_try(&s->scene, nodes_of(s), s->end_time + dt);
        scene_check_planes(&s->scene, nodes_of(s), &s->lattice, s->end_time);
    }
    if (s->scene.start == START_AFFINE)
        boundary_affine_start(&s->boundary, &s->body, mean_poissons_ratio(s), dt);
    initial_set(&s->scene, &s->body, SCENE_VELOCITY);
    if (!moving) static_start(s);
    s->integration = integration_new(moving, dt, s->scene.damping, &s->materials, &s->body,
                                     &s->boundary, s->model);
    s->integration.damage = s->damage;
    if (legs_are(s)) legs_begin(s);
    s->integration.local_damping = s->scene.local_damping;
}

static unsigned what_there_is(const struct simulation *s)
{
    const bool grips = boundary_has_grips(&s->boundary);
    return (grips ? NEEDS_GRIPS : 0) | (grips || s->lattice.periodic[0] ? NEEDS_LOAD : 0) |
           (s->gauge ? NEEDS_GAUGE : 0) | (s->boundary.macroscopic ? NEEDS_PERIODS : 0);
}

struct simulation *simulation_new(const struct arguments *arguments, struct ranks ranks)
{
    struct simulation *s = memory_new(1, sizeof *s);
    s->arguments = arguments;
    s->ranks = ranks;
    s->input = -1;
    s->profile = arguments->profile ? profile_new() : NULL;
    profile_enter(s->profile, PART_READ);
    read_inputs(s);
    open_outputs(s);
    build(s);
    profile_enter(s->profile, PART_PLAN);
    const bool frames = arguments->fields && !arguments->check;
    /* The stable step takes room; the particles' places have no reader any more. */
    if (s->lattice.corner && !frames) domain_forget_nodes(&s->domain);
    plan_time(s);
    s->recorder = recorder_new(own_domain(s), s->domain.n_phases, s->domain.phase_names, &s->scene,
                               what_there_is(s));
    if (frames) {
        if (ranks.rank == 0) {
            attributes_set_text(&s->domain.attributes, "solver_program", options_version());
            attributes_set_text(&s->domain.attributes, "deck", deck_text(s->deck));
        }
        s->fields =
            fields_open(&s->fields_output, own_domain(s), &s->scene.fields, &s->body, s->damage);
    }
    domain_forget_nodes(&s->domain);
    domain_forget_nodes(&s->corners);
    profile_enter(s->profile, PART_REST);
    return s;
}

void simulation_free(struct simulation *s)
{
    recorder_free(&s->recorder);
    free(s->own);
    static_free(&s->load_steps);
    integration_free(&s->integration);
    gauge_free(s->gauge);
    quantities_free(s->quantities);
    boundary_free(&s->boundary);
    model_free(s->model);
    damage_free(s->damage);
    bonds_free(s->bonds);
    body_free(&s->body);
    materials_free(&s->materials);
    family_free(&s->family);
    lattice_free(&s->lattice);
    scene_free(&s->scene);
    deck_free(s->deck);
    domain_free(&s->domain);
    domain_free(&s->corners);
    if (s->history_output.path) spool_close(&s->history_output);
    if (s->fields_output.path) spool_close(&s->fields_output);
    free(s->failure);
    free(s->fields_name);
    if (s->input >= 0) close(s->input);
    profile_free(s->profile);
    free(s);
}
