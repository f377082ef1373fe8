/* A harmonic structure: coarse cores on a lattice, isolated from each other in a connected fine
 * shell.
 *
 * sphere: equal spheres about the centres; the diameter follows from the fraction.
 * cell: the Voronoi cells of the centres, all faces moved in by the same distance: a shell of
 * uniform thickness, as sintered powders have.
 *
 * A sheet shows the middle section, which passes through centres: of sc a square lattice of cores
 * along x and y, of fcc one along the diagonals, with the same core distance. */
#include "findings.h"
#include "memory.h"
#include "periodic.h"
#include "recipe.h"
#include "requirements.h"
#include "steps.h"
#include "topology.h"

#include <math.h>
#include <stdlib.h>

static const char *const lattices[] = {"sc", "bcc", "fcc", NULL};

#define MEMBER(member) .place = offsetof(struct recipe, member)

static const struct key rows[] = {
    {"lattice", KEY_CHOICE, MEMBER(lattice), .names = lattices, .otherwise = "none",
     .help = "of the centres; required without cores; in two dimensions sc or fcc"},
    {"core_distance", KEY_SPACINGS, MEMBER(distance), .low = 1, .high = LONGEST_DISTANCE,
     .usual = NAN, .help = "of the nearest centres; required without cores"},
    {"jitter", KEY_NUMBER, MEMBER(jitter), .unit = "1", .low = 0, .high = 1,
     .help = "standard deviation of each coordinate of the centres, in core distances"},
    {"offset", KEY_SPACINGS, MEMBER(offset), .low = -LONGEST_DISTANCE, .high = LONGEST_DISTANCE,
     .size = 3,
     .help =
         "from the body's centre to a core, along x, y, z; a part of a spacing leaves fewer nodes "
         "equal by symmetry, which an exact match has to split by the seed"},
    {"minimum_shell", KEY_SPACINGS, MEMBER(minimum_shell), .low = 1, .high = 10, .usual = NAN,
     .otherwise = "one layer of nodes", .help = "what the topology check demands between cores"},
};

static void check(struct deck_node domain, struct recipe *recipe)
{
    recipe->minimum_shell =
        isnan(recipe->minimum_shell) ? 0 : recipe->minimum_shell / recipe->specimen.spacing[0];
    if (recipe->cores_file) return;
    deck_get(domain, "core_distance"); /* dies where it is missing */
    struct deck_node lattice = deck_get(domain, "lattice");
    if (recipe->lattice == LATTICE_BCC && specimen_is_sheet(&recipe->specimen))
        deck_error(lattice,
                   "in two dimensions the cores lie on sc or fcc (square lattices along x or along "
                   "the diagonals); the section of bcc has no shell of even width");
    if (recipe->offset[2] != 0 && specimen_is_sheet(&recipe->specimen))
        deck_error(
            deck_get(domain, "offset"),
            "a sheet is the section through the middle of the cores: its offset along z is 0");
    recipe->distance = periodic_distance(domain, &recipe->specimen, lattices[recipe->lattice],
                                         cores_lattice_edge(recipe->lattice), recipe->distance);
}

static struct cores place(const struct recipe *recipe)
{
    const struct cores_box box = recipe_box(recipe);
    return cores_lattice(recipe->lattice, recipe->shape, recipe->distance, recipe->jitter, &box,
                         recipe->seed);
}

static int64_t score(const struct recipe *recipe, const struct cores *cores, const double point[3],
                     int32_t *core)
{
    struct core_place at = cores_place(cores, point, cores->shape == CORE_CELL);
    *core = (int32_t)at.core;
    double length = cores->shape == CORE_CELL ? -at.depth : at.distance;
    return llround(length / (SCORE_UNIT * recipe->specimen.spacing[0]));
}

static bool is_film(const struct recipe *recipe, bool touching, double film)
{
    return !touching && film >= recipe->minimum_shell - 1e-9;
}

/* The largest distance of two lattice sites, in edges along x, that is too near: nodes of cores
 * further apart than this always leave the film asked for. */
static double film_needed(const struct recipe *recipe)
{
    const double *spacing = recipe->specimen.spacing;
    const bool sheet = specimen_is_sheet(&recipe->specimen);
    const double longest = steps_longest_edge(spacing, sheet);
    double largest = 0;
    int count;
    struct step *steps = steps_ball(spacing, fmax(recipe->minimum_shell, longest) + longest, true,
                                    sheet, STEPS_BY_DISTANCE, &count);
    for (int s = 0; s < count; s++)
        if (!is_film(recipe, steps_touch(&steps[s]), steps_film(&steps[s])))
            largest = steps[s].distance;
    free(steps);
    return largest;
}

/* What spacing would do, as words; the caller frees it. */
static char *remedy(const struct recipe *recipe, const struct findings *findings)
{
    if (!(findings->core_film > 0))
        return memory_print("at this fraction the cores overlap (film %.3g um): no spacing helps; "
                            "use another lattice, core: cell, less jitter or a larger ufg_fraction",
                            1e6 * findings->core_film);
    double needed = findings->core_film / film_needed(recipe);
    double spacing = recipe->specimen.spacing[0];
    double parts = floor(spacing / needed) + 1;
    return memory_print("the film between neighbouring cores is %.4g um = %.3g spacings thick; a "
                        "spacing below %.4g um is sure to resolve it (such as %.6g um, 1/%g of "
                        "this one), or at this one a core_distance above %.4g um",
                        1e6 * findings->core_film, findings->core_film / spacing, 1e6 * needed,
                        1e6 * spacing / parts, parts, 1e6 * recipe->distance * spacing / needed);
}

static bool lacks_cg(const struct recipe *recipe, const struct findings *findings)
{
    return (recipe->require & REQUIRE_CG_CONNECTED) &&
           !clusters_percolate_everywhere(&findings->cg);
}

static char *fault(const struct recipe *recipe, const struct findings *findings)
{
    const struct clusters *ufg = &findings->ufg;
    const bool shell =
        !(recipe->require & REQUIRE_UFG_CONNECTED) || clusters_percolate_everywhere(ufg);
    const struct contact *contact = &findings->contact;
    const bool apart = !(recipe->require & REQUIRE_CORES_APART) ||
                       is_film(recipe, contact->touching > 0, contact->film);
    if (shell && apart && !lacks_cg(recipe, findings)) return NULL;
    if (shell && apart)
        return memory_print("%s does not percolate along x, y and z, as 'require: [cg_connected]' "
                            "asks for",
                            recipe->phase_names[PHASE_CG]);
    char *help = remedy(recipe, findings);
    char *text;
    if (!apart && contact->touching > 0)
        text = memory_print("not a harmonic structure: different cores touch (%lld pairs of nodes "
                            "share a face, an edge or a corner); %s",
                            (long long)contact->touching, help);
    else if (!shell)
        text = memory_print("not a harmonic structure: the shell does not percolate along %s; %s",
                            specimen_is_sheet(&recipe->specimen) ? "x and y" : "x, y and z", help);
    else
        text = memory_print("the thinnest shell on the nodes is %.3g spacings, minimum_shell asks "
                            "for %.3g; %s",
                            contact->film, recipe->minimum_shell, help);
    free(help);
    return text;
}

static char *describe(const struct recipe *recipe, const struct findings *findings)
{
    const char *where = recipe->cores_file ? "given centres" : lattices[recipe->lattice];
    if (recipe->shape == CORE_SPHERE)
        return memory_print("harmonic, spheres of %.6g um on %s", 2e6 * findings->reach, where);
    return memory_print("harmonic, cells on %s, shell %.6g um", where, 1e6 * findings->core_film);
}

const struct topology topology_harmonic = {
    .deck = {.name = "harmonic",
             .help =
                 "coarse cores on a lattice, isolated from each other in a connected fine shell",
             .keys = KEYS(rows)},
    .cores_apart = true,
    .requires = REQUIRE_UFG_CONNECTED | REQUIRE_CORES_APART,
    .check = check,
    .place = place,
    .score = score,
    .fault = fault,
    .describe = describe,
};
