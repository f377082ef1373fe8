#include "domain_input.h"

#include "die.h"
#include "domain_facts.h"
#include "domain_order.h"
#include "domain_text.h"
#include "exodus.h"
#include "foreign.h"
#include "keys.h"
#include "memory.h"
#include "spool.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_DECK = 1 << 20 };
enum file_kind { FILE_NETCDF, FILE_TEXT, FILE_OTHER };

/* Text has no bytes below space but tab and line ends. */
static enum file_kind kind_of(const char *path, const char *shown)
{
    unsigned char bytes[512] = {0};
    FILE *file = fopen(path, "rb");
    if (!file) die_user("cannot open the domain");
    const size_t got = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    if (memcmp(bytes, "CDF", 3) == 0 || memcmp(bytes, "\211HDF", 4) == 0) return FILE_NETCDF;
    const char *foreign = foreign_format(bytes, got);
    if (foreign)
        die_user("%s is %s, expected Genesis (Exodus), or text with 'x y z block volume' a line: "
                 "programs such as meshio turn meshes into Exodus; hsgen reads images of voxels",
                 shown, foreign);
    for (size_t i = 0; i < got; i++)
        if (bytes[i] < ' ' && !memchr("\n\r\t", bytes[i], 3)) return FILE_OTHER;
    return got > 0 ? FILE_TEXT : FILE_OTHER;
}

/* domain.spacing, a number or a list of three. */
static void edges(struct deck_node spacing, double edge[3])
{
    static const struct key row = {"spacing", KEY_LENGTH, .low = 1e-12, .high = 1e3, .size = 3};
    if (deck_is_list(spacing))
        keys_list(&row, spacing, 0, edge);
    else
        edge[0] = edge[1] = edge[2] = deck_number(spacing, "m", row.low, row.high);
}

/* What a file from elsewhere does not say and the deck's domain section does: that the particles
 * are a sheet, and its thickness. */
static void take_dimensions(struct domain *domain, const struct domain_facts *said)
{
    struct attributes *facts = &domain->attributes;
    const struct deck_node dimensions = said->dimensions;
    if (attributes_number(facts, "spacing_m", 0) > 0 || dimensions.index == 0) return;
    const long number = deck_integer(dimensions, 2, 3);
    attributes_set_number(facts, "dimensions", (double)number);
    if (number == 3) return;
    static const struct key row = {"size", KEY_LENGTH, .low = 1e-12, .high = 1e3, .size = 3};
    const struct deck_node spacing = said->spacing, given = said->size;
    double size[3], edge[3] = {0};
    if (given.index == 0)
        deck_error(dimensions, "a sheet needs its size here, whose third length is the thickness");
    if (spacing.index) edges(spacing, edge);
    keys_list(&row, given, edge[0], size);
    attributes_set_number(facts, "thickness_m", size[2]);
}

/* Cells that are no cubes, or cut, cannot be seen in the particles of a text: the deck says so. */
static bool take_cells(struct domain *domain, const struct domain_facts *said)
{
    struct attributes *facts = &domain->attributes;
    const struct deck_node spacing = said->spacing, volumes = said->volumes;
    const bool cut = volumes.index != 0 && strcmp(deck_string(volumes), "cut") == 0;
    if (spacing.index == 0 || !(cut || deck_is_list(spacing))) return false;
    double edge[3];
    edges(spacing, edge);
    attributes_set_number(facts, "spacing_m", edge[0]);
    attributes_set_number(facts, "spacing_y_m", edge[1]);
    if (attributes_number(facts, "dimensions", 3) == 3)
        attributes_set_number(facts, "spacing_z_m", edge[2]);
    if (cut) attributes_set_text(facts, "volumes", "cut");
    return true;
}

/* That a body from elsewhere repeats itself after its particles, or is the half of one, along the
 * axes that the deck names. */
static void take_axes(struct domain *domain, struct deck_node said, const char *key)
{
    bool axes[3] = {false};
    char letters[4], *end = letters;
    if (said.index == 0 || attributes_text(&domain->attributes, key)) return;
    keys_axes(said, key, axes);
    for (int a = 0; a < 3; a++)
        if (axes[a]) *end++ = (char)('x' + a);
    *end = '\0';
    attributes_set_text(&domain->attributes, key, letters);
}

/* After what length it does, which a lattice shows by itself and a mesh by its nodes. */
static void take_periods(struct domain *domain, const struct domain_facts *said)
{
    static const struct key row = {"period", KEY_LENGTH, .low = 1e-12, .high = 1e3, .size = 3};
    const struct domain *corners = domain->corners;
    double period[3];
    if (!attributes_text(&domain->attributes, "periodic")) {
        if (said->period.index)
            deck_error(said->period, "the body is not periodic: along which axes it is says "
                                     "domain.periodic");
        return;
    }
    if (said->period.index)
        keys_list(&row, said->period, 0, period);
    else if (!corners)
        return;
    for (int a = 0; a < 3; a++) {
        char name[] = "period_x_m";
        name[strlen("period_")] = (char)('x' + a);
        if (corners && !said->period.index) {
            const double *const x[3] = {corners->x, corners->y, corners->z};
            period[a] =
                domain_largest(x[a], corners->n_nodes) - domain_smallest(x[a], corners->n_nodes);
        }
        attributes_set_number(&domain->attributes, name, period[a]);
    }
}

/* Of scattered particles the deck may say what a spacing is to mean. */
static void take_spacing(struct domain *domain, const struct domain_facts *said)
{
    if (said->spacing.index != 0)
        attributes_set_number(&domain->attributes, "mean_spacing_m",
                              deck_number(said->spacing, "m", 1e-12, 1e3));
    else if (attributes_number(&domain->attributes, "dimensions", 3) == 2 &&
             !(attributes_number(&domain->attributes, "thickness_m", 0) > 0))
        die_user("the particles are a sheet and lie on no lattice: how thick it is says the third "
                 "of domain.size, beside domain.dimensions: 2");
}

static struct deck *deck_inside(const struct domain *domain, const char *shown)
{
    const char *text = attributes_text(&domain->attributes, "deck");
    const char *name = attributes_text(&domain->attributes, "deck_name");
    if (!text) die_user("%s has no deck inside: give it with --deck", shown);
    return deck_parse(text, strlen(text), name ? name : "deck");
}

/* After a restart it has the name under which it was given at first. */
static struct deck *deck_beside(const char *path)
{
    const char *name = getenv("HSSOLVE_DECK_NAME");
    long length;
    if (!name) return deck_read(path);
    char *text = spool_text(path, LONGEST_DECK, &length);
    struct deck *deck = deck_parse(text, (size_t)length, name);
    free(text);
    return deck;
}

/* Of a file such as hsgen's, in order: then its nodes stay there. */
static bool stream(const struct spool *input, struct domain *domain, struct lattice *lattice)
{
    if (!exodus_stream_domain(input, domain)) return false;
    const bool good = lattice_recognise(domain, lattice);
    if (good && lattice->sorted) return true;
    if (good) lattice_free(lattice);
    domain_free(domain);
    return false;
}

void domain_input_read(const struct arguments *a, struct domain *domain, struct deck **deck,
                       struct lattice *lattice)
{
    struct spool input = spool_input(a->input);
    bool piped = !a->input || strncmp(a->input, "/proc/", strlen("/proc/")) == 0;
    const char *shown = piped ? "standard input" : a->input;
    const bool text = kind_of(input.path, shown) == FILE_TEXT;
    *deck = a->deck ? deck_beside(a->deck) : NULL;
    if (text && !*deck)
        die_user("%s is text: a deck goes through hsgen first; particles in Peridigm's text format "
                 "need the deck beside them (--deck)",
                 shown);
    const bool streamed = !text && stream(&input, domain, lattice);
    if (!streamed)
        *domain = text ? domain_text_read(&input, shown, *deck) : exodus_read_domain(&input);
    spool_close(&input);
    if (!*deck) *deck = deck_inside(domain, shown);
    const struct domain_facts facts = domain_facts_read(*deck);
    domain_facts_scale(&facts, domain);
    domain_facts_node_sets(&facts, domain);
    take_dimensions(domain, &facts);
    if (!(attributes_number(&domain->attributes, "spacing_m", 0) > 0)) {
        take_axes(domain, facts.periodic, "periodic");
        take_axes(domain, facts.symmetry, "symmetry");
        take_periods(domain, &facts);
    }
    const bool cells = text && take_cells(domain, &facts),
               sites = streamed || domain_sort(domain, lattice);
    if (cells && !sites)
        deck_error(facts.spacing,
                   "the particles of %s lie on no lattice of such cells, each in one of its own: "
                   "say which "
                   "spacing they have, or leave 'volumes: cut' and the list of edges out",
                   shown);
    if (!sites) take_spacing(domain, &facts);
    domain_facts_planes(&facts, sites, domain);
    if (facts.axis > 0) attributes_set_number(&domain->attributes, "axis", facts.axis);
}
