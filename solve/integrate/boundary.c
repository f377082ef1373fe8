#include "boundary.h"

#include "checkpoint.h"
#include "memory.h"
#include "mirror.h"

#include <math.h>
#include <stdlib.h>

static void find_grips(struct boundary *boundary, int axis)
{
    const struct boundary_set *sets = boundary->sets;
    int left = -1, right = -1;
    for (int i = 0; i < boundary->count; i++) {
        if (sets[i].direction != axis || sets[i].place[0]) continue;
        if (left < 0 || sets[i].members.mean < sets[left].members.mean) left = i;
        if (right < 0 || sets[i].members.mean > sets[right].members.mean) right = i;
    }
    const bool two = left >= 0 && sets[left].members.high < sets[right].members.low;
    boundary->left = two ? left : -1;
    boundary->right = two ? right : -1;
}

static struct boundary_set set_new(const struct scene_entry *entry, const struct body *body,
                                   double largest_stress)
{
    const struct lattice *lattice = body->lattice;
    const double middle = lattice_middle(lattice, lattice->axis);
    const double area = lattice_largest_face(lattice);
    struct members members = members_of_nodes(body, entry->nodes.numbers, entry->nodes.count);
    struct boundary_set set = {.where = entry->where,
                               .direction = entry->direction,
                               .kind = entry->kind,
                               .value = entry->value,
                               .sense = 1,
                               .members = members,
                               .inner = members.mean < middle ? members.high : members.low,
                               .zero =
                                   exact_sum_new((double)members.n_all * largest_stress * area)};
    if (value_depends_on_place(&entry->value)) members_places(&set.members, body, set.place);
    return set;
}

/* Holds the nodes of each plane of symmetry. */
static void add_mirrors(struct boundary *boundary, const struct scene *scene,
                        const struct body *body, double largest_stress)
{
    const struct lattice *lattice = body->lattice;
    for (int a = 0; a < 3; a++) {
        int64_t count, any;
        if (!lattice->mirror[a]) continue;
        int64_t *nodes = mirror_nodes(scene, body, a, &count);
        any = count;
        ranks_share(&any, sizeof any);
        if (any > 0) {
            struct boundary_set *set = &boundary->sets[boundary->count++];
            *set = (struct boundary_set){.where = scene->solver,
                                         .direction = a,
                                         .kind = SCENE_DISPLACEMENT,
                                         .members = members_of_nodes(body, nodes, count)};
            set->inner = set->members.high;
            set->zero = exact_sum_new((double)set->members.n_all * largest_stress *
                                      lattice_largest_face(lattice));
        }
        free(nodes);
    }
}

/* Whether the body has no ends along x. */
static bool is_stretched(const struct boundary *boundary)
{
    return boundary->macroscopic && boundary->macroscopic->axis[0];
}

struct boundary boundary_new(const struct scene *scene, struct body *body, double largest_stress)
{
    struct boundary boundary = {
        .sets = memory_new((size_t)scene->n_boundary + 3, sizeof(struct boundary_set))};
    for (int i = 0; i < scene->n_boundary; i++)
        if (scene_holds(scene->boundary[i].kind))
            boundary.sets[boundary.count++] = set_new(&scene->boundary[i], body, largest_stress);
    add_mirrors(&boundary, scene, body, largest_stress);
    boundary_mark(&boundary, body);
    find_grips(&boundary, body->lattice->axis);
    boundary.loads = loads_new(scene, body);
    boundary.macroscopic = macroscopic_new(scene, body);
    return boundary;
}

void boundary_free(struct boundary *boundary)
{
    for (int b = 0; b < boundary->count; b++) {
        members_free(&boundary->sets[b].members);
        for (int a = 0; a < 3; a++) free(boundary->sets[b].place[a]);
    }
    free(boundary->sets);
    free(boundary->held);
    loads_free(&boundary->loads);
    free(boundary->macroscopic);
    *boundary = (struct boundary){0};
}

void boundary_mark(struct boundary *boundary, const struct body *body)
{
    boundary->held = memory_new((size_t)body->grid.n_sites, 1);
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        for (int64_t i = 0; i < set->members.count; i++)
            boundary->held[set->members.sites[i]] |= (uint8_t)(1 << set->direction);
    }
}

/* What a set prescribes at one of its nodes; at any, where place is NULL. */
static double given(const struct boundary_set *set, int64_t i, double time)
{
    double x[3] = {0, 0, 0};
    for (int a = 0; a < 3 && set->place[a]; a++) x[a] = set->place[a][i];
    return set->sense * value_at(&set->value, x, time);
}

void boundary_turn(struct boundary *boundary, double sense)
{
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *set = &boundary->sets[b];
        if (set->kind == SCENE_VELOCITY && set->value.kind == VALUE_CONSTANT) set->sense = sense;
    }
    if (boundary->macroscopic) macroscopic_turn(boundary->macroscopic, sense);
}

/* At a full step a prescribed displacement has its mean velocity over the half steps beside it,
 * which does not ask for times before the start. */
static double velocity(const struct boundary_set *set, int64_t i, double time, double dt)
{
    if (set->kind == SCENE_VELOCITY) return given(set, i, time);
    const double start = fmax(time - 0.5 * dt, 0), end = time + 0.5 * dt;
    return (given(set, i, end) - given(set, i, start)) / (end - start);
}

double boundary_speed(const struct boundary_set *set, double time, double dt)
{
    return velocity(set, 0, time, dt);
}

void boundary_set_displacements(const struct boundary *boundary, struct body *body)
{
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        for (int64_t i = 0; set->kind == SCENE_DISPLACEMENT && i < set->members.count; i++)
            body->u[set->direction][set->members.sites[i]] = given(set, i, 0);
    }
}

void boundary_set_velocities(struct boundary *boundary, struct body *body, double time, double dt)
{
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *set = &boundary->sets[b];
        double *v = body->v[set->direction];
        set->speed_before = set->speed;
        if (!set->place[0]) set->speed = velocity(set, 0, time, dt);
        for (int64_t i = 0; i < set->members.count; i++)
            v[set->members.sites[i]] = set->place[0] ? velocity(set, i, time, dt) : set->speed;
    }
}

void boundary_stop(struct boundary *boundary)
{
    for (int b = 0; b < boundary->count; b++)
        boundary->sets[b].speed = boundary->sets[b].speed_before = 0;
}

void boundary_set_ways(struct boundary *boundary, struct body *body, double time, double dt)
{
    if (boundary->macroscopic) macroscopic_set_ways(boundary->macroscopic, body, time, dt);
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *set = &boundary->sets[b];
        const bool moved = set->kind == SCENE_DISPLACEMENT;
        const double at = moved ? time + dt : time + 0.5 * dt;
        const double one = set->place[0] ? 0 : given(set, 0, at);
        double *v = body->v[set->direction], *u = body->u[set->direction];
        set->way = set->place[0] ? 0 : moved ? one - given(set, 0, time) : one * dt;
        for (int64_t i = 0; i < set->members.count; i++) {
            const int64_t site = set->members.sites[i];
            const double value = set->place[0] ? given(set, i, at) : one;
            v[site] = moved ? (value - u[site]) / dt : value;
        }
    }
}

/* Reaction of a held component: minus the sum of inner force and load [N]. */
static double reaction(const struct body *body, int direction, int64_t site)
{
    double density = body->f[direction][site];
    if (body->b[direction]) density += body->b[direction][site];
    return -density * body_volume(body, site);
}

void boundary_reactions(const struct boundary *boundary, const struct body *body,
                        struct exact_sum *sums)
{
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        sums[b] = set->zero;
        for (int64_t i = 0; i < set->members.count; i++)
            exact_sum_add(&sums[b], reaction(body, set->direction, set->members.sites[i]));
    }
}

int boundary_holds(const struct boundary *boundary)
{
    const struct macroscopic *m = boundary->macroscopic;
    int count = boundary->count;
    for (int k = 0; m && k < COMPONENTS; k++) count += m->component[k].given;
    return count;
}

void boundary_forces(const struct boundary *boundary, const struct body *body, double *forces)
{
    const struct macroscopic *m = boundary->macroscopic;
    if (boundary->count > 0) {
        struct exact_sum *sums = memory_new((size_t)boundary->count, sizeof *sums);
        boundary_reactions(boundary, body, sums);
        exact_sum_finish(sums, boundary->count, forces);
        free(sums);
    }
    forces += boundary->count;
    for (int k = 0; m && k < COMPONENTS; k++)
        if (m->component[k].given) *forces++ = macroscopic_force(m, body, k);
}

void boundary_ways(const struct boundary *boundary, double *ways)
{
    const struct macroscopic *m = boundary->macroscopic;
    for (int b = 0; b < boundary->count; b++) *ways++ = boundary->sets[b].way;
    for (int k = 0; m && k < COMPONENTS; k++)
        if (m->component[k].given) *ways++ = macroscopic_way(m, k);
}

double boundary_load(const struct boundary *boundary, const struct body *body)
{
    if (is_stretched(boundary)) return macroscopic_force(boundary->macroscopic, body, 0);
    if (!boundary_has_grips(boundary)) return 0;
    const struct boundary_set *sets = boundary->sets;
    return 0.5 * (sets[boundary->right].reaction - sets[boundary->left].reaction);
}

void boundary_add_set_work(const struct boundary *boundary, const struct body *body,
                           double duration, struct exact_sum *work)
{
    for (int b = 0; b < boundary->count; b++) {
        const struct boundary_set *set = &boundary->sets[b];
        const double *v = body->v[set->direction];
        for (int64_t i = 0; set->place[0] && i < set->members.count; i++) {
            const int64_t site = set->members.sites[i];
            exact_sum_add(work, reaction(body, set->direction, site) * v[site] * duration);
        }
    }
}

void boundary_add_work(const struct boundary *boundary, const struct body *body, double duration,
                       struct exact_sum *work)
{
    boundary_add_set_work(boundary, body, duration, work);
    loads_add_work(&boundary->loads, body, duration, work);
}

/* Velocity at full speed; not finite where it is no number. */
static double full_speed(const struct boundary_set *set)
{
    if (set->kind == SCENE_DISPLACEMENT) return set->value.kind == VALUE_CONSTANT ? 0 : NAN;
    return set->value.kind == VALUE_CONSTANT || set->value.kind == VALUE_RAMP ? set->value.number
                                                                              : NAN;
}

static double full_rate(const struct boundary *boundary)
{
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const struct boundary_set *right = &boundary->sets[boundary->right];
    return (full_speed(right) - full_speed(left)) / (right->inner - left->inner);
}

double boundary_full_strain_rate(const struct boundary *boundary)
{
    if (is_stretched(boundary)) return macroscopic_full_rate(boundary->macroscopic);
    if (!boundary_has_grips(boundary)) return 0;
    const double rate = full_rate(boundary);
    return isfinite(rate) ? rate : 0;
}

/* Of grips whose velocity is given. */
static double stretch_rate(const struct boundary *boundary, double time)
{
    const struct boundary_set *left = &boundary->sets[boundary->left],
                              *right = &boundary->sets[boundary->right];
    const double speed = (right->kind == SCENE_VELOCITY ? given(right, 0, time) : 0) -
                         (left->kind == SCENE_VELOCITY ? given(left, 0, time) : 0);
    return fabs(speed) / (right->inner - left->inner);
}

double boundary_stretch(const struct boundary *boundary, double time, double dt)
{
    double most = 0;
    for (int k = 0; k < 3; k++) {
        const double at = time + 0.5 * k * dt;
        if (boundary->macroscopic)
            most = fmax(most, macroscopic_largest_rate(boundary->macroscopic, at));
        if (boundary_has_grips(boundary)) most = fmax(most, stretch_rate(boundary, at));
    }
    return most * dt;
}

double boundary_ramp(const struct boundary *boundary)
{
    if (is_stretched(boundary)) return macroscopic_ramp(boundary->macroscopic);
    return boundary_has_grips(boundary) ? boundary->sets[boundary->right].value.ramp : 0;
}

/* Whether the grips gain speeds that are numbers in the same way. */
static bool alike(const struct boundary_set *left, const struct boundary_set *right)
{
    return left->kind == SCENE_VELOCITY && right->kind == SCENE_VELOCITY &&
           left->value.kind == right->value.kind && isfinite(full_speed(left)) &&
           left->value.ramp == right->value.ramp;
}

double boundary_strain_rate(const struct boundary *boundary, double time, double dt)
{
    if (!boundary_has_grips(boundary)) return 0;
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const struct boundary_set *right = &boundary->sets[boundary->right];
    if (alike(left, right)) {
        const double ramp = left->value.ramp;
        return (ramp > 0 ? value_rise(time / ramp) : 1) * full_rate(boundary);
    }
    return (boundary_speed(right, time, dt) - boundary_speed(left, time, dt)) /
           (right->inner - left->inner);
}

void boundary_affine_start(const struct boundary *boundary, struct body *body,
                           double poissons_ratio, double dt)
{
    if (boundary->macroscopic) macroscopic_start(boundary->macroscopic, body, poissons_ratio, dt);
    if (!boundary_has_grips(boundary)) return;
    const struct boundary_set *left = &boundary->sets[boundary->left];
    const struct boundary_set *right = &boundary->sets[boundary->right];
    const double rate = boundary_strain_rate(boundary, 0, dt),
                 left_speed = boundary_speed(left, 0, dt);
    double centre[3];
    for (int a = 0; a < 3; a++) centre[a] = lattice_middle(body->lattice, a);
    const int axis = body->lattice->axis, across[2] = {(axis + 1) % 3, (axis + 2) % 3};
    const double width = 0.5 * fmax(lattice_extent(body->lattice, across[0]),
                                    lattice_extent(body->lattice, across[1]));
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            int64_t site = body->owned.items[s].site + i;
            double x[3];
            body_position(body, site, x);
            double along = fmin(fmax(x[axis], left->inner), right->inner);
            body->v[axis][site] = left_speed + rate * (along - left->inner);
            const double inside = fmin(along - left->inner, right->inner - along);
            for (int k = 0; k < 2; k++) {
                const int a = across[k];
                body->v[a][site] = -poissons_ratio * rate * (x[a] - centre[a]) *
                                   (inside < width ? inside / width : 1);
            }
        }
}

void boundary_visit(struct boundary *boundary, struct body *body, double time,
                    struct checkpoint *checkpoint)
{
    for (int b = 0; b < boundary->count; b++) {
        struct boundary_set *s = &boundary->sets[b];
        double values[] = {s->moved,        s->way,      s->speed,
                           s->speed_before, s->reaction, s->reaction_before};
        checkpoint_numbers(checkpoint, "motion and reaction of a set", values,
                           sizeof values / sizeof *values);
        s->moved = values[0];
        s->way = values[1];
        s->speed = values[2];
        s->speed_before = values[3];
        s->reaction = values[4];
        s->reaction_before = values[5];
    }
    loads_visit(&boundary->loads, body, time, checkpoint);
    if (boundary->macroscopic) macroscopic_visit(boundary->macroscopic, body, checkpoint);
}
