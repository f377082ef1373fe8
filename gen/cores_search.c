#include "cores.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static void box_of(const struct cores *cores, const double point[3], int64_t box[3])
{
    for (int axis = 0; axis < 3; axis++)
        box[axis] = (int64_t)floor((point[axis] - cores->low[axis]) / cores->distance);
}

static int64_t box_number(const struct cores *cores, const int64_t box[3])
{
    return box[0] + cores->boxes[0] * (box[1] + cores->boxes[1] * box[2]);
}

void cores_index(struct cores *cores)
{
    double n_wanted = 1;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (int64_t c = 0; c < cores->count; c++) {
            low = fmin(low, cores->centre[c][axis]);
            high = fmax(high, cores->centre[c][axis]);
        }
        n_wanted *= (high - low) / cores->distance + 1;
        if (n_wanted > 1e6 + 1e3 * (double)cores->count)
            die_user("%lld cores are far too few for their distance of %g m",
                     (long long)cores->count, cores->distance);
        cores->low[axis] = low;
        cores->boxes[axis] = (int64_t)floor((high - low) / cores->distance) + 1;
    }
    int64_t n_boxes = cores->boxes[0] * cores->boxes[1] * cores->boxes[2];
    cores->first = memory_new((size_t)n_boxes + 2, sizeof *cores->first);
    cores->member = memory_new((size_t)cores->count, sizeof *cores->member);
    /* Counting sort: first[b + 2] counts, then first[b + 1] runs on as the place to fill. */
    int64_t box[3];
    for (int64_t c = 0; c < cores->count; c++) {
        box_of(cores, cores->centre[c], box);
        cores->first[box_number(cores, box) + 2]++;
    }
    for (int64_t b = 0; b < n_boxes; b++) cores->first[b + 2] += cores->first[b + 1];
    for (int64_t c = 0; c < cores->count; c++) {
        box_of(cores, cores->centre[c], box);
        cores->member[cores->first[box_number(cores, box) + 1]++] = c;
    }
}

/* One ring of boxes at the Chebyshev distance `ring` around a box, visited member by member. */
typedef void core_visit(const struct cores *cores, const double point[3], int64_t core,
                        struct core_place *place);

static void visit_ring(const struct cores *cores, const double point[3], const int64_t middle[3],
                       int64_t ring, core_visit *visit, struct core_place *place)
{
    int64_t low[3], high[3];
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = middle[axis] - ring < 0 ? 0 : middle[axis] - ring;
        high[axis] = middle[axis] + ring;
        if (high[axis] > cores->boxes[axis] - 1) high[axis] = cores->boxes[axis] - 1;
    }
    int64_t box[3];
    for (box[2] = low[2]; box[2] <= high[2]; box[2]++)
        for (box[1] = low[1]; box[1] <= high[1]; box[1]++) {
            bool edge = llabs(box[1] - middle[1]) == ring || llabs(box[2] - middle[2]) == ring;
            for (box[0] = low[0]; box[0] <= high[0]; box[0]++) {
                if (!edge && llabs(box[0] - middle[0]) != ring) continue;
                int64_t b = box_number(cores, box);
                for (int64_t m = cores->first[b]; m < cores->first[b + 1]; m++)
                    visit(cores, point, cores->member[m], place);
            }
        }
}

static double distance_to(const struct cores *cores, const double point[3], int64_t core)
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        double difference = cores->centre[core][axis] - point[axis];
        square += difference * difference;
    }
    return sqrt(square);
}

static void visit_nearest(const struct cores *cores, const double point[3], int64_t core,
                          struct core_place *place)
{
    double distance = distance_to(cores, point, core);
    if (distance < place->distance || (distance == place->distance && core < place->core)) {
        place->distance = distance;
        place->core = core;
    }
}

/* Distance from the point to the plane halfway between its own centre and another. */
static void visit_face(const struct cores *cores, const double point[3], int64_t core,
                       struct core_place *place)
{
    if (core == place->core) return;
    double between = distance_to(cores, cores->centre[place->core], core);
    double other = distance_to(cores, point, core);
    double depth =
        between > 0 ? (other - place->distance) * (other + place->distance) / (2 * between) : 0;
    place->depth = fmin(place->depth, depth);
}

/* What lies further than this from the point may be missing. */
static void check_gap(const struct cores *cores, double radius)
{
    if (cores->original && radius > cores->reach)
        die_user(
            "the cores of the periodic body leave a gap of %g core distances: take a wider body, "
            "more cores or another seed",
            radius / cores->distance);
}

struct core_place cores_place(const struct cores *cores, const double point[3], int with_depth)
{
    struct core_place place = {.core = 0, .distance = INFINITY, .depth = INFINITY};
    int64_t middle[3], last = 0;
    box_of(cores, point, middle);
    for (int axis = 0; axis < 3; axis++) {
        int64_t far = llabs(middle[axis]) + cores->boxes[axis];
        last = far > last ? far : last;
    }
    /* After ring r everything nearer than r box widths has been seen. */
    for (int64_t ring = 0; ring <= last; ring++) {
        visit_ring(cores, point, middle, ring, visit_nearest, &place);
        if (place.distance <= (double)ring * cores->distance) break;
    }
    if (!with_depth) check_gap(cores, place.distance);
    if (!with_depth) return place;
    /* A centre at the distance r has its face at least (r - r0) / 2 away (triangle inequality). */
    for (int64_t ring = 0; ring <= last; ring++) {
        visit_ring(cores, point, middle, ring, visit_face, &place);
        if (place.distance + 2 * place.depth <= (double)ring * cores->distance) break;
    }
    check_gap(cores, place.distance + 2 * place.depth);
    /* A single core fills all space. */
    place.depth = fmin(place.depth, 1e3 * cores->distance);
    return place;
}

static bool touches_body(const struct cores *cores, int64_t core, double radius)
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        double out = fmax(0, fabs(cores->centre[core][axis]) - 0.5 * cores->box.size[axis]);
        square +=
            cores->box.periodic[axis] ? 0 : out * out; /* there it touches an image of the body */
    }
    return square < radius * radius;
}

double cores_nearest_pair(const struct cores *cores, double diameter)
{
    double nearest = INFINITY;
    for (int64_t c = 0; c < cores->count; c++) {
        if (!touches_body(cores, c, 0.5 * diameter)) continue;
        int64_t box[3], other[3];
        box_of(cores, cores->centre[c], box);
        for (int n = 0; n < 27; n++) {
            int shift[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
            bool exists = true;
            for (int axis = 0; axis < 3; axis++) {
                other[axis] = box[axis] + shift[axis];
                exists = exists && other[axis] >= 0 && other[axis] < cores->boxes[axis];
            }
            if (!exists) continue;
            int64_t b = box_number(cores, other);
            for (int64_t m = cores->first[b]; m < cores->first[b + 1]; m++) {
                int64_t d = cores->member[m];
                if (d != c && touches_body(cores, d, 0.5 * diameter))
                    nearest = fmin(nearest, distance_to(cores, cores->centre[c], d));
            }
        }
    }
    return nearest;
}
