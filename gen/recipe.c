#include "recipe.h"

#include "die.h"
#include "exodus.h"
#include "fill.h"
#include "periodic.h"
#include "requirements.h"
#include "sections.h"
#include "symmetry.h"
#include "topology.h"

#include <math.h>
#include <string.h>

static const char *const shapes[] = {"cell", "sphere", NULL};
static const char *const matches[] = {"exact", "geometric", NULL};

#define MEMBER(member) .place = offsetof(struct recipe, member)
#define TWO_PHASES     ~3u /* all topologies but the first two */
#define ALL_BUT_IMAGE  ~2u

static const struct key phase_rows[] = {
    {"cg", KEY_TEXT, MEMBER(phase_names[PHASE_CG]), .form = "name of a material", .required = true,
     .help = "the coarse one"},
    {"ufg", KEY_TEXT, MEMBER(phase_names[PHASE_UFG]), .form = "name of a material",
     .required = true, .help = "the fine one"},
};
static const struct section phases_section = {
    .path = "domain.phases", .help = "The two materials.", .keys = KEYS(phase_rows)};

static const struct key rows[] = {
    {"specimen", KEY_CHOICE, MEMBER(specimen.shape), .names = specimen_shapes, .required = true,
     .help = "shape of the body, centred at the origin; x is the loading direction"},
    {"dimensions", KEY_INTEGER, MEMBER(specimen.dimensions), .low = 2, .high = 3, .usual = 3,
     .help = "2: a sheet, one layer of nodes in the plane z = 0"},
    {"spacing", KEY_SPACING, MEMBER(specimen.spacing), .low = 1e-12, .high = 1e3, .size = 3,
     .usual = NAN, .otherwise = "of an image that of its voxels",
     .help =
         "edges of the lattice's cells, along x, y, z, or of its cubes; the third of a sheet is "
         "its "
         "thickness.  Lengths in spacings are in the edge along x, but the components of size and "
         "of the boxes of sets in that axis' own"},
    {"size", KEY_NODE, MEMBER(size), .form = "[x, y, z], m or spacings", .required = true,
     .users = ALL_BUT_IMAGE,
     .help = "of the whole, heads included, of a round one its length alone: whole numbers of that "
             "axis' "
             "spacings, 1 to 1e6 each, but of a turned one any along x and y; the third of a sheet "
             "is its "
             "thickness, 1e-12 to 1e3 m"},
    {"diameter", KEY_SPACINGS, MEMBER(specimen.diameter), .low = 1, .high = 1e6, .usual = NAN,
     .help = "of a rod or of the heads of a round dog-bone; required of these"},
    {"angle", KEY_NUMBER, MEMBER(specimen.angle), .unit = "rad", .low = -1.5707963267948966,
     .high = 1.5707963267948966,
     .help = "by which the body, with its structure, grips and gauge, is turned about z against "
             "the lattice"},
    {"volumes", KEY_CHOICE, MEMBER(specimen.volumes), .names = specimen_volumes,
     .help = "whole: nodes whose centres are inside own their cells; cut: each owns the part of "
             "its cell that is "
             "inside, parts below 5 per cent given to a neighbour"},
    {"periodic", KEY_NODE, MEMBER(periodic), .form = "list of x, y, z", .otherwise = "none",
     .help = "axes along which the body goes on with its own image, as a representative cell does: "
             "of a plate, of flat ones else z alone, of sheets x and y; along x without grips and "
             "gauge.  Along these axes the size is a whole number of the cubic cells of the "
             "lattice of cores"},
    {"symmetry", KEY_NODE, MEMBER(symmetry), .form = "list of x, y, z", .otherwise = "none",
     .help = "axes across which the middle of the specimen is a plane of symmetry: the part above "
             "it is made, an eighth of a body with all three; across x without grip_left and "
             "gauge_left.  Sizes and grips are those of the whole body, for which the part stands "
             "with its images"},
    {"phases", KEY_SECTION, .section = &phases_section, .required = true, .users = TWO_PHASES,
     .help = "names of the two materials"},
    {"ufg_fraction", KEY_NUMBER, MEMBER(ufg_fraction), .unit = "1", .low = 1e-6, .high = 1 - 1e-6,
     .required = true, .users = TWO_PHASES, .help = "of the nodes outside the grips"},
    {"core", KEY_CHOICE, MEMBER(shape), .names = shapes, .users = TWO_PHASES,
     .help = "Voronoi cells or spheres about the centres"},
    {"match", KEY_CHOICE, MEMBER(geometric), .names = matches, .users = TWO_PHASES,
     .help = "exact: half a node off the fraction at most; geometric: nodes equal by symmetry stay "
             "together, and the fraction is the nearest that this allows"},
    {"cores", KEY_TEXT, MEMBER(cores_file), .form = "file", .users = TWO_PHASES,
     .help = "centres written by hsgen --cores, in place of lattice, core, core_distance, "
             "core_diameter, jitter and offset"},
    {"require", KEY_NODE, MEMBER(require_list), .users = TWO_PHASES,
     .form = "list of ufg_connected, cg_connected, cores_apart",
     .otherwise = "[ufg_connected, cores_apart] of harmonic, [] of random",
     .help =
         "what the topology check asks for: that a phase percolates along all axes, that different "
         "cores do not touch; the rest is found and said.  [] asks for nothing"},
    {"override", KEY_FLAG, MEMBER(override), .users = TWO_PHASES,
     .help = "write the domain though its topology check failed"},
    {"seed", KEY_INTEGER, MEMBER(seed), .low = 0, .high = INT32_MAX, .usual = 1,
     .help = "of all that is random"},
    {"grips", KEY_NODE, MEMBER(grips), .section = &specimen_grips,
     .help = "the ends, none without the key"},
    {"gauge", KEY_NODE, MEMBER(gauge), .section = &specimen_gauge,
     .help = "planes between which strain is measured; required of dog-bones"},
    {"notch", KEY_NODE, MEMBER(notch), .section = &specimen_notch, .otherwise = "none",
     .help = "in the middle"},
    {"hole", KEY_NODE, MEMBER(hole), .section = &specimen_hole, .otherwise = "none",
     .help = "through a flat body"},
    {"sets", KEY_NODE, MEMBER(sets), .form = "list of mappings", .section = &specimen_set,
     .help = "further node sets"},
};

#define ADDRESS(name) &topology_##name
static const struct topology *const topologies[] = {TOPOLOGIES(ADDRESS), NULL};

static const struct variant *topology_variant(int i)
{
    return topologies[i] ? &topologies[i]->deck : NULL;
}

const struct section domain_section = {
    .path = "domain",
    .help = "The body that hsgen makes: a lattice of particles, each of a phase.",
    .keys = KEYS(rows),
    .chooser = "topology",
    .variant = topology_variant,
    .usual = -1,
};

static void check_name(struct deck_node where, const char *phase)
{
    const char *fault = exodus_phase_fault(phase);
    if (fault) deck_error(where, "the phase's name '%s' %s", phase, fault);
}

static void check_names(struct deck_node domain, const struct recipe *recipe)
{
    const struct deck_node one = deck_find(domain, "phase");
    const struct deck_node labels = deck_find(domain, "labels");
    struct deck_node where = one.index      ? one
                             : labels.index ? labels
                                            : deck_find(domain, "threshold");
    if (!where.index) where = deck_get(domain, "phases");
    for (int p = 0; p < recipe->n_phases; p++) check_name(where, recipe->phase_names[p]);
}

/* What the rows cannot say of two phases. */
static void check_two_phases(struct deck_node domain, const struct recipe *recipe)
{
    static const char *const said[] = {"lattice",       "core",   "core_distance",
                                       "core_diameter", "jitter", "offset"};
    if (strcmp(recipe->phase_names[PHASE_CG], recipe->phase_names[PHASE_UFG]) == 0)
        deck_error(deck_get(domain, "phases"), "the two phases need two names");
    for (size_t i = 0; recipe->cores_file && i < sizeof said / sizeof *said; i++)
        if (deck_has(domain, said[i]))
            deck_error(deck_get(domain, said[i]), "%s says this already: leave out '%s' or 'cores'",
                       recipe->cores_file, said[i]);
}

/* The grips' phase is one of the structure's, or a further material of the deck. */
static void read_grip_phase(struct deck_node root, struct recipe *recipe)
{
    const char *name = recipe->specimen.grip_phase;
    recipe->grip_phase = -1;
    if (!name) return;
    for (int phase = 0; phase < recipe->n_phases; phase++)
        if (strcmp(recipe->phase_names[phase], name) == 0) recipe->grip_phase = phase;
    if (recipe->grip_phase >= 0) return;
    struct deck_node where = deck_get(recipe->grips, "phase");
    struct deck_node materials = deck_find(root, "materials");
    if (materials.index == 0 || !deck_has(materials, name))
        deck_error(where,
                   "'%s' is neither 'structure' nor one of this domain's phases nor a material of "
                   "this deck",
                   name);
    check_name(where, name);
    recipe->phase_names[recipe->n_phases] = name;
    recipe->grip_phase = recipe->n_phases++;
}

/* A deck of many decks is none of a body. */
static void refuse_study(struct sections sections)
{
    const struct deck_node study = sections.vary.index     ? sections.vary
                                   : sections.refine.index ? sections.refine
                                                           : sections.sensitivity;
    if (study.index)
        deck_error(study,
                   "this deck is a study of several: 'hsgen --study %s -o FOLDER' writes them, "
                   "'make -j2 -C FOLDER' runs them",
                   deck_name(study.deck));
}

struct recipe recipe_read(const struct deck *deck)
{
    refuse_study(sections_read(deck));
    struct recipe recipe = {0};
    struct deck_node root = deck_root(deck), domain = deck_get(root, "domain");
    const int choice = keys_variant(domain, &domain_section);
    recipe.topology = topologies[choice];
    recipe.n_phases = recipe.topology->no_cores ? 1 : 2;
    keys_check(domain, &domain_section, choice);
    if (!recipe.topology->measure) (void)deck_get(domain, "spacing"); /* dies where it is missing */
    keys_read(domain, &domain_section, choice, 0, &recipe, &recipe);
    periodic_read(domain, &recipe.specimen);
    if (recipe.topology->measure) recipe.topology->measure(domain, &recipe);
    specimen_read(&recipe.specimen, domain);
    symmetry_read(domain, &recipe.specimen);
    check_names(domain, &recipe);
    if (!recipe.topology->no_cores) check_two_phases(domain, &recipe);
    recipe.require = requirements_read(recipe.require_list, recipe.topology->requires);
    if (recipe.topology->check) recipe.topology->check(domain, &recipe);
    read_grip_phase(root, &recipe);
    return recipe;
}

void recipe_free(struct recipe *recipe)
{
    voxels_free(&recipe->voxels);
}

struct voxel recipe_voxel(const struct recipe *recipe, const double position[3])
{
    if (!recipe->voxels.phase) return (struct voxel){VOXEL_OUTSIDE, 0};
    return voxels_at(&recipe->voxels, position, recipe->specimen.spacing, recipe->measured.rule);
}

static bool has_material(const void *all, int64_t site, const double point[3])
{
    const struct recipe *recipe = all;
    (void)site;
    return recipe_voxel(recipe, point).phase != VOXEL_EMPTY &&
           symmetry_keeps(&recipe->specimen, point);
}

struct sites recipe_sites(const struct recipe *recipe)
{
    const struct specimen *specimen = &recipe->specimen;
    if (!recipe->voxels.phase) return fill_sites(specimen);
    struct sites sites = sites_new(specimen->count, specimen->spacing, has_material, recipe);
    specimen_repeats(specimen, &sites);
    return sites;
}

struct cores_box recipe_box(const struct recipe *recipe)
{
    struct cores_box box;
    specimen_extent(&recipe->specimen, box.size);
    for (int axis = 0; axis < 3; axis++) {
        box.periodic[axis] = recipe->specimen.periodic[axis];
        box.offset[axis] = recipe->offset[axis];
    }
    return box;
}

/* Whether a file's cores are for this body. */
static void check_box(const struct recipe *recipe, const struct cores_box *file)
{
    const struct cores_box box = recipe_box(recipe);
    const double *size = file->size, rounding = 1e-9;
    char axes[2][4];
    if (strcmp(cores_axes(file, axes[0]), cores_axes(&box, axes[1])) != 0)
        die_user(
            "%s: the cores are for a body that is periodic along '%s', the deck's is along '%s'",
            recipe->cores_file, axes[0], axes[1]);
    for (int axis = 0; axis < 3; axis++) {
        const double larger = box.size[axis] - size[axis];
        if (larger > rounding * size[axis])
            die_user("%s: the cores are for a body of %g x %g x %g m, the deck's is larger",
                     recipe->cores_file, size[0], size[1], size[2]);
        if (box.periodic[axis] && larger < -rounding * size[axis])
            die_user("%s: the cores are for a body that repeats after %g m along %c, the deck's "
                     "does after %g m",
                     recipe->cores_file, size[axis], "xyz"[axis], box.size[axis]);
    }
}

struct cores recipe_cores(struct recipe *recipe)
{
    if (recipe->topology->no_cores) return (struct cores){0};
    if (!recipe->cores_file) return recipe->topology->place(recipe);
    struct cores cores = cores_read(recipe->cores_file, recipe->topology->deck.name);
    check_box(recipe, &cores.box);
    if (cores.distance < recipe->specimen.spacing[0] ||
        cores.distance > LONGEST_DISTANCE * recipe->specimen.spacing[0])
        die_user("%s: distance_m %g is not between 1 and %g spacings", recipe->cores_file,
                 cores.distance, LONGEST_DISTANCE);
    recipe->shape = cores.shape;
    recipe->distance = cores.distance;
    return cores;
}
