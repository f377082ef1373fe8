#include "cracks.h"

#include "broken.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct entry {
    struct deck_node rectangle;
    struct crack crack;
};
#define AT(member)    offsetof(struct entry, member)
#define LENGTHS(name) name, KEY_LENGTH, .low = -1e3, .high = 1e3, .size = 3

static const struct key disc_keys[] = {
    {LENGTHS("centre"), .place = AT(crack.corner), .required = true, .help = "[x, y, z]"},
    {"normal", KEY_NUMBER, AT(crack.normal), "1", -1e6, 1e6, 3, .required = true,
     .help = "of any length; nodes on the plane belong to the side it points to"},
    {"radius", KEY_LENGTH, AT(crack.radius), NULL, 0, 1e3, .required = true, .help = "of its rim"},
};
static const struct section disc = {.path = "cracks.disc",
                                    .help = "In a body of one layer a line of twice the radius.",
                                    .keys = KEYS(disc_keys)};
static const struct key keys[] = {
    {"rectangle", KEY_NODE, AT(rectangle), .form = "[corner, edge, edge]",
     .help = "three lengths each, in m or spacings, the edges at right angles; in a body of one "
             "layer one edge lies along z and has no end"},
    {"disc", KEY_SECTION, .section = &disc, .help = "a round one"},
};
const struct section section_cracks = {
    .path = "cracks",
    .help =
        "A list of cracks that are there from the start; bonds that cross one are cut.  The body "
        "is centred at the origin.",
    .keys = KEYS(keys)};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void make_unit(double vector[3], struct deck_node where)
{
    const double length = sqrt(dot(vector, vector));
    if (!(length > 0)) deck_error(where, "this crack has no direction: an edge or normal is zero");
    for (int a = 0; a < 3; a++) vector[a] /= length;
}

/* In a plane the second edge is the way through the layer, the first the line that is seen. */
static void stand_up(struct crack *crack, struct deck_node where)
{
    const double *const *edges = (const double *const[]){crack->edge[0], crack->edge[1]};
    const bool flat[2] = {hypot(edges[0][0], edges[0][1]) <= crack->slack,
                          hypot(edges[1][0], edges[1][1]) <= crack->slack};
    if (flat[0] == flat[1])
        deck_error(where, "in a body of one layer one edge of a crack lies in the plane, the other "
                          "along z");
    if (flat[0]) memcpy(crack->edge[0], crack->edge[1], sizeof crack->edge[0]);
    crack->edge[0][2] = crack->corner[2] = 0;
    memcpy(crack->edge[1], (double[3]){0, 0, 1}, sizeof crack->edge[1]);
}

static void read_rectangle(struct crack *crack, struct deck_node list, double spacing,
                           int dimensions)
{
    static const struct key parts[] = {{LENGTHS("corner")}, {LENGTHS("edge")}, {LENGTHS("edge")}};
    double *const part[] = {crack->corner, crack->edge[0], crack->edge[1]};
    if (!deck_is_list(list) || deck_count(list) != 3)
        deck_error(list, "a rectangle is a list of a corner and two edges");
    for (int k = 0; k < 3; k++) keys_list(&parts[k], deck_item(list, k), spacing, part[k]);
    if (dimensions == 2) stand_up(crack, list);
    cross(crack->edge[0], crack->edge[1], crack->normal);
    make_unit(crack->normal, list);
    const double *a = crack->edge[0], *b = crack->edge[1];
    if (fabs(dot(a, b)) > 1e-6 * sqrt(dot(a, a) * dot(b, b)))
        deck_error(list, "the edges of a rectangle stand at right angles");
    if (dimensions == 2) memset(crack->edge[1], 0, sizeof crack->edge[1]); /* no end along z */
}

static void check_disc(struct crack *crack, struct deck_node map, int dimensions)
{
    struct deck_node normal = deck_get(map, "normal");
    crack->disc = true;
    make_unit(crack->normal, normal);
    if (dimensions == 2 && fabs(crack->normal[2]) > 1e-9)
        deck_error(normal, "in a body of one layer the normal of a crack lies in the plane");
    if (dimensions == 2) crack->corner[2] = 0;
}

static struct crack read_crack(struct deck_node map, double spacing, int dimensions)
{
    struct entry entry = {0};
    keys_read(map, &section_cracks, 0, spacing, &entry, NULL);
    const struct deck_node round = deck_find(map, "disc");
    struct crack *crack = &entry.crack;
    crack->slack = 1e-9 * spacing;
    if ((round.index != 0) == (entry.rectangle.index != 0))
        deck_error(map, "give one of rectangle and disc");
    if (round.index)
        check_disc(crack, round, dimensions);
    else
        read_rectangle(crack, entry.rectangle, spacing, dimensions);
    return *crack;
}

struct cracks cracks_read(struct deck_node section, double spacing, int dimensions)
{
    struct cracks cracks = {0};
    if (section.index == 0) return cracks;
    if (!deck_is_list(section)) deck_error(section, "cracks is a list of rectangles and discs");
    cracks.count = deck_count(section);
    cracks.items = memory_new((size_t)cracks.count, sizeof *cracks.items);
    for (int i = 0; i < cracks.count; i++)
        cracks.items[i] = read_crack(deck_item(section, i), spacing, dimensions);
    return cracks;
}

void cracks_free(struct cracks *cracks)
{
    free(cracks->items);
    *cracks = (struct cracks){0};
}

/* Whether a point of the crack's plane, counted from its corner or centre, belongs to it. */
static bool covers(const struct crack *crack, const double at[3])
{
    if (crack->disc) return sqrt(dot(at, at)) <= crack->radius + crack->slack;
    for (int e = 0; e < 2; e++) {
        const double length = sqrt(dot(crack->edge[e], crack->edge[e]));
        if (!(length > 0)) continue; /* through the layer */
        const double along = dot(at, crack->edge[e]) / length;
        if (along < -crack->slack || along > length + crack->slack) return false;
    }
    return true;
}

bool crack_cuts(const struct crack *crack, const double from[3], const double to[3])
{
    double a[3], b[3], at[3];
    for (int k = 0; k < 3; k++) {
        a[k] = from[k] - crack->corner[k];
        b[k] = to[k] - crack->corner[k];
    }
    double before = dot(a, crack->normal), behind = dot(b, crack->normal);
    if (fabs(before) <= crack->slack) before = 0;
    if (fabs(behind) <= crack->slack) behind = 0;
    if ((before < 0) == (behind < 0)) return false;
    for (int k = 0; k < 3; k++) at[k] = (before * b[k] - behind * a[k]) / (before - behind);
    return covers(crack, at);
}

static bool cuts_any(const struct cracks *cracks, const double from[3], const double to[3])
{
    for (int c = 0; c < cracks->count; c++)
        if (crack_cuts(&cracks->items[c], from, to)) return true;
    return false;
}

/* Of a periodic body an image of a bond, too. */
static bool is_cut(const struct cracks *cracks, const struct body *body,
                   const struct bond_view *view, int k)
{
    static const int shifts[] = {0, -1, 1};
    const struct lattice *lattice = body->lattice;
    double at[3];
    bool cut = false;
    body_position(body, bond_lower(view, k), at);
    for (int image = 0; image < 27 && !cut; image++) {
        const int shift[3] = {shifts[image % 3], shifts[image / 3 % 3], shifts[image / 9]};
        double from[3], to[3];
        bool there = true;
        for (int a = 0; a < 3; a++) {
            there = there && (shift[a] == 0 || lattice->periodic[a]);
            from[a] = at[a] + (shift[a] ? shift[a] * lattice_period(lattice, a) : 0);
            to[a] = from[a] + view->xi[a][k * view->geometry_step];
        }
        if (lattice->dimensions == 2) from[2] = to[2] = 0;
        cut = there && cuts_any(cracks, from, to);
    }
    return cut;
}

int64_t cracks_cut(const struct cracks *cracks, struct body *body, struct bonds *bonds)
{
    double cut = 0;
    if (cracks->count == 0) return 0;
    body_need_gradient(body); /* here, as only some ranks may have bonds to cut */
    for (int64_t s = 0; s < bonds->count; s++)
        for (int k = 0; k < bonds->strips[s].count; k++) {
            const struct bond_view view = bonds_view(bonds, &bonds->strips[s]);
            if (!(view.weight[k * view.weight_step] > 0) || !is_cut(cracks, body, &view, k))
                continue;
            cut += body->grid.flags[bond_lower(&view, k)] & SITE_OWNED ? 1 : 0;
            broken_add(body, bonds, &bonds->strips[s], k);
        }
    ranks_sum(&cut, 1);
    if (cut > 0) broken_shapes(body, false);
    return (int64_t)cut;
}
