#include "equilibrium.h"

#include "checkpoint.h"
#include "die.h"
#include "direction.h"
#include "memory.h"
#include "mesh.h"
#include "profile.h"
#include "stable_step.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ADDRESS(name) &equilibrium_##name
static const struct equilibrium_method *const table[] = {EQUILIBRIUM_METHODS(ADDRESS)};

static int most_common_phase(const struct lattice *lattice)
{
    int64_t counts[ABSENT + 1] = {0};
    for (int64_t i = 0; i < lattice->n_sites; i++) counts[lattice->phase[i]]++;
    int most = 0;
    for (int p = 1; p < ABSENT; p++) most = counts[p] > counts[most] ? p : most;
    return most;
}

/* Nodes of which some component is held. */
static struct members held_nodes(const struct body *body, const struct boundary *boundary)
{
    struct members held = {.sites = memory_new((size_t)body->grid.n_owned, sizeof *held.sites)};
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++)
            if (boundary->held[body->owned.items[s].site + i])
                held.sites[held.count++] = body->owned.items[s].site + i;
    return held;
}

/* (equilibrium.3): 4/dt^2 is the largest eigenvalue of the stiffness over rho, which flow only
 * softens; in a mesh that of its stiffest element, others have it in the ratio of the squares of
 * their edges. */
static double *bound_new(const struct equilibrium *e, const struct materials *materials)
{
    const struct unknowns *unknowns = &e->unknowns;
    const struct body *body = e->body;
    const double dt = stable_step(e->model, e->body, materials), scale = 1.2 / (dt * dt);
    double *bound = vector_new(unknowns);
    double *edge = body->lattice->hexahedron ? mesh_edges(body->lattice) : NULL;
    int64_t node = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++, node++) {
            const int64_t site = body->owned.items[s].site + i;
            const double density = materials_density(materials, body, site),
                         stiff = edge ? body->lattice->finest / edge[site] : 1;
            for (int a = 0; a < 3; a++)
                bound[a * unknowns->n_nodes + node] =
                    scale * density * (body_volume(body, site) / body->volume) * stiff * stiff;
        }
    free(edge);
    for (int64_t i = 0; i < unknowns->length - 3 * unknowns->n_nodes; i++)
        bound[3 * unknowns->n_nodes + i] = 1 / e->mean_inverse[i][i];
    return bound;
}

/* Against X_k of (macroscopic.3), of the elastic body of one material [N/m^4]: lambda d_ab d_cd +
 * mu d_ac d_bd, of F as of a strain, for what turns the body is no unknown. */
static double mean_stiffness(const struct equilibrium *e, const struct material *material, int k,
                             int l)
{
    const struct macroscopic *m = e->unknowns.macroscopic;
    const double mu = material->shear_modulus, lambda = material->bulk_modulus - 2 * mu / 3;
    const bool diagonal = k / 3 == k % 3 && l / 3 == l % 3;
    return (lambda * diagonal + mu * ((k == l) + (k == l && diagonal))) * m->volume /
           (e->body->volume * m->period[k % 3] * m->period[l % 3]);
}

/* By Cholesky's factors. */
static void find_mean_inverse(struct equilibrium *e, const struct material *material)
{
    const int n = e->unknowns.n_mean;
    if (n == 0) return;
    gsl_matrix *stiffness = gsl_matrix_alloc((size_t)n, (size_t)n);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            gsl_matrix_set(stiffness, (size_t)i, (size_t)k,
                           mean_stiffness(e, material, e->unknowns.mean[i], e->unknowns.mean[k]));
    gsl_linalg_cholesky_decomp1(stiffness);
    gsl_linalg_cholesky_invert(stiffness);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            e->mean_inverse[i][k] = gsl_matrix_get(stiffness, (size_t)i, (size_t)k);
    gsl_matrix_free(stiffness);
}

/* Waves of a box that the body hardly fills are not those of the body. */
static void say_fit(const struct equilibrium *e)
{
    static const double enough = 0.3;
    const double filled = preconditioner_filled(e->preconditioner);
    if (filled < enough && e->body->ranks.rank == 0)
        note("the body fills %.0f %% of its box, which the preconditioner of load steps is made "
             "for: "
             "they may take many more evaluations than the plan says",
             100 * filled);
}

static double *weights_new(const struct body *body)
{
    double *weights = memory_new((size_t)body->grid.n_owned, sizeof *weights);
    int64_t node = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++)
            weights[node++] = body->volumes[body->owned.items[s].site + i] / body->volume;
    return weights;
}

struct equilibrium *equilibrium_new(int method, struct integration *integration, struct body *body,
                                    struct boundary *boundary, struct model *model,
                                    struct deck_node solver, const struct materials *materials)
{
    struct equilibrium *e = memory_new(1, sizeof *e);
    e->integration = integration;
    e->body = body;
    e->boundary = boundary;
    e->model = model;
    e->method = table[method];
    e->tolerance = 1e-6;
    e->most_evaluations = e->method->usual_evaluations;
    /* What pulls at nothing has no reactions; a strain of 1e-7 everywhere is as good as none. */
    e->largest = 1e-5 * materials_stiffest(materials) / body->lattice->spacing *
                 sqrt(3 * (double)body->n_nodes);
    e->unknowns = unknowns_new(body, boundary);
    e->held = held_nodes(body, boundary);
    if (body->volumes) e->weights = weights_new(body);
    e->x = vector_new(&e->unknowns);
    e->g = vector_new(&e->unknowns);
    if (e->method->preconditions) {
        e->symbol = symbol_new(solver, body->family, materials, body->lattice,
                               most_common_phase(body->lattice));
        e->preconditioner = preconditioner_new(&e->unknowns, &e->symbol);
        say_fit(e);
    }
    find_mean_inverse(e, &materials->items[most_common_phase(body->lattice)]);
    if (!e->preconditioner || preconditioner_is_crowded(e->preconditioner))
        e->bound = bound_new(e, materials);
    return e;
}

void equilibrium_free(struct equilibrium *e)
{
    if (!e) return;
    if (e->self) e->method->free(e->self);
    if (e->next) e->method->next->free(e->next);
    if (e->preconditioner) preconditioner_free(e->preconditioner);
    symbol_free(&e->symbol);
    unknowns_free(&e->unknowns);
    members_free(&e->held);
    free(e->weights);
    free(e->bound);
    free(e->x);
    free(e->g);
    free(e);
}

/* Density of force at a node, outer and inner, as it counts in g. */
static double unbalanced(const struct body *body, int a, int64_t site)
{
    const double density = body->f[a][site] + (body->b[a] ? body->b[a][site] : 0);
    return density * (body_volume(body, site) / body->volume);
}

/* Largest of the reactions on this rank. */
static double largest_reaction(const struct equilibrium *e)
{
    double largest = 0;
    for (int64_t i = 0; i < e->held.count; i++)
        for (int a = 0; a < 3; a++)
            if (e->boundary->held[e->held.sites[i]] >> a & 1)
                largest = fmax(largest, fabs(unbalanced(e->body, a, e->held.sites[i])));
    return largest;
}

/* The sum of their squares. */
static struct exact_sum square_reactions(const struct equilibrium *e, double bound)
{
    struct exact_sum sum = exact_sum_new(bound);
    for (int64_t i = 0; i < e->held.count; i++)
        for (int a = 0; a < 3; a++) {
            if (!(e->boundary->held[e->held.sites[i]] >> a & 1)) continue;
            const double value = unbalanced(e->body, a, e->held.sites[i]);
            exact_sum_add(&sum, value * value);
        }
    return sum;
}

/* Norm of the loads on free components, found with g as scratch. */
static double norm_of_loads(struct equilibrium *e)
{
    double square = 0;
    for (int a = 0; a < 3; a++) {
        if (!e->body->b[a]) continue;
        double *fields[3] = {e->body->b[a], e->body->b[a], e->body->b[a]};
        vector_take(&e->unknowns, fields, 1, e->g);
        for (int64_t i = 0; i < e->unknowns.length; i++)
            if (i / e->unknowns.n_nodes != a) e->g[i] = 0;
        const double norm = vector_norm(&e->unknowns, e->g);
        square += norm * norm;
    }
    return sqrt(square);
}

/* g = - unbalanced() of the free components of a strip along one axis. */
HS_SIMD static void take_strip(int count, const double *restrict f, const double *restrict b,
                               const double *restrict weight, const uint8_t *restrict mask,
                               double *restrict g)
{
    for (int i = 0; i < count; i++) g[i] = mask[i] > 0 ? (f[i] + b[i]) * -weight[i] : 0;
}

/* Adds squares to a sum, a node's three as one term. */
HS_SIMD static void add_squares(int count, int64_t stride, const double *restrict g,
                                struct exact_sum *square)
{
    const double *restrict g_y = g + stride, *restrict g_z = g_y + stride;
    const double high = square->high, low = square->low;
    double top = 0, bottom = 0;
#pragma omp simd reduction(+ : top, bottom)
    for (int i = 0; i < count; i++) {
        const double term = g[i] * g[i] + g_y[i] * g_y[i] + g_z[i] * g_z[i],
                     part = (term + high) - high;
        top += part;
        bottom += ((term - part) + low) - low;
    }
    square->top += top;
    square->bottom += bottom;
}

/* (macroscopic.3) */
static void take_mean_unbalanced(const struct equilibrium *e, double *g)
{
    const struct unknowns *unknowns = &e->unknowns;
    const struct macroscopic *m = unknowns->macroscopic;
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++) {
        const int k = unknowns->mean[i - 3 * unknowns->n_nodes];
        g[i] = (e->body->mean_stress[k] - m->target[k]) * m->volume / m->period[k % 3] /
               e->body->volume;
    }
}

/* g, and what the sums of its squares and of its products with d get from this rank; d: NULL where
 * there are none. */
static void take_unbalanced(const struct equilibrium *e, double *g, struct exact_sum *square,
                            const float *d, struct exact_sum *along)
{
    const struct body *body = e->body;
    const int64_t n = e->unknowns.n_nodes;
    double none[LANES] = {0}, whole[LANES];
    int64_t at = 0;
    for (int i = 0; i < LANES; i++) whole[i] = 1;
    for (int64_t s = 0; s < body->owned.count; at += body->owned.items[s++].count) {
        const int64_t site = body->owned.items[s].site;
        const int count = body->owned.items[s].count;
        for (int a = 0; a < 3; a++)
            take_strip(count, body->f[a] + site, body->b[a] ? body->b[a] + site : none,
                       e->weights ? e->weights + at : whole, e->unknowns.free + a * n + at,
                       g + a * n + at);
        add_squares(count, n, g + at, square);
        if (d) direction_add_nodes(&e->unknowns, count, d + at, g + at, along);
    }
    take_mean_unbalanced(e, g);
    for (int64_t i = 3 * n; i < e->unknowns.length; i++) exact_sum_add(square, g[i] * g[i]);
    if (d) direction_add_mean(&e->unknowns, d, g, along);
}

/* g, its norm and that of the reactions, and its product with a direction d, of which no number is
 * beyond far; d: NULL where it is not asked for.  The sum of squares is bounded by a guess from the
 * last norm, which saves passes and messages, and found in two passes where that was too small, or
 * leaves less than 40 bits: up to twice the guess it is exact, so that all ranks see the same. */
static double measure(struct equilibrium *e, double *g, const float *d, double far)
{
    const double guess = 0x1p20 * e->norm * e->norm;
    double largest = -largest_reaction(e), values[3] = {0};
    ranks_minimum(&largest, 1);
    struct exact_sum sums[3] = {
        exact_sum_new(guess),
        square_reactions(e, 3.000001 * (double)e->body->n_nodes * largest * largest)};
    if (d) sums[2] = direction_sum_new(&e->unknowns, far, sqrt(guess));
    take_unbalanced(e, g, &sums[0], d, &sums[2]);
    exact_sum_finish(sums, d ? 3 : 2, values);
    const bool good = values[0] <= guess && values[0] >= 0x1p-34 * guess;
    e->norm = good ? sqrt(values[0]) : vector_norm(&e->unknowns, g);
    e->reference = hypot(largest < 0 ? sqrt(values[1]) : 0, e->loads);
    if (e->boundary->macroscopic)
        e->reference =
            hypot(e->reference, macroscopic_reactions(e->boundary->macroscopic, e->body));
    return good || !d || !isfinite(e->norm) ? values[2] : direction_product(&e->unknowns, d, g);
}

/* Whether any rank is asked to stop: from then on no method goes on. */
static void look_for_stop(struct equilibrium *e)
{
    if (!e->stop) return;
    double asked = stop_asked(e->stop, 0) ? -1 : 0;
    ranks_minimum(&asked, 1);
    e->cut |= asked < 0;
    if (e->cut) e->last = 0;
}

/* g where the body is, and its product with d. */
static double evaluate(struct equilibrium *e, double *g, const float *d, double far)
{
    look_for_stop(e);
    integration_force(e->integration, e->model, e->body, (struct force_mode){0}, NULL);
    e->evaluations++;
    const double slope = measure(e, g, d, far);
    if (e->watch) e->watch(e->watcher, e);
    return slope;
}

double equilibrium_evaluate(struct equilibrium *e, const double *x, double *g)
{
    vector_put(&e->unknowns, x, e->body->u);
    vector_put_mean(&e->unknowns, x, e->body->mean_gradient);
    evaluate(e, g, NULL, 0);
    return e->norm;
}

double equilibrium_go(struct equilibrium *e, double a, const float *d, double far)
{
    const struct unknowns *unknowns = &e->unknowns;
    direction_add_to_fields(unknowns, a, d, e->body->u);
    for (int64_t i = 3 * unknowns->n_nodes; i < unknowns->length; i++) e->x[i] += a * (double)d[i];
    vector_put_mean(unknowns, e->x, e->body->mean_gradient);
    return evaluate(e, e->g, d, far);
}

void equilibrium_find_x(struct equilibrium *e)
{
    vector_take(&e->unknowns, e->body->u, 1, e->x);
    vector_take_mean(&e->unknowns, e->body->mean_gradient, e->x);
}

double equilibrium_residual(const struct equilibrium *e)
{
    const double reference = fmax(e->reference, 0.01 * e->largest);
    return e->norm > 0 ? e->norm / reference : e->norm;
}

bool equilibrium_reached(const struct equilibrium *e)
{
    return equilibrium_residual(e) <= e->tolerance;
}

void equilibrium_precondition(struct equilibrium *e, const double *g, float *z)
{
    const enum profile_part before = profile_enter(e->body->profile, PART_PRECONDITION);
    const int64_t n = e->unknowns.n_nodes;
    preconditioner_apply(e->preconditioner, g, z);
    for (int64_t i = 3 * n; i < e->unknowns.length; i++) {
        double answer = 0;
        for (int64_t k = 3 * n; k < e->unknowns.length; k++)
            answer += e->mean_inverse[i - 3 * n][k - 3 * n] * g[k];
        z[i] = (float)answer;
    }
    for (int64_t i = 0; e->bound && i < e->unknowns.length; i++)
        z[i] += (float)(g[i] / e->bound[i]);
    profile_enter(e->body->profile, before);
}

static bool solve_by(struct equilibrium *e, const struct equilibrium_method *method, void **self)
{
    if (!method || e->cut) return false;
    if (!*self) *self = method->start(e);
    e->last = e->evaluations + e->most_evaluations;
    return method->solve(*self, e);
}

bool equilibrium_solve(struct equilibrium *e)
{
    e->evaluations = 0;
    e->norm = 0;
    e->loads = norm_of_loads(e);
    equilibrium_evaluate(e, e->x, e->g);
    if (!equilibrium_reached(e) && !solve_by(e, e->method, &e->self) &&
        !solve_by(e, e->method->next, &e->next))
        return false;
    e->largest = fmax(e->largest, e->reference);
    return true;
}

static void visit_method(struct equilibrium *e, const struct equilibrium_method *method,
                         void **self, struct checkpoint *checkpoint)
{
    bool started = *self != NULL;
    if (!method || !method->visit) return;
    checkpoint_flag(checkpoint, "the method has begun", &started);
    if (!started) return;
    if (!*self) *self = method->start(e);
    method->visit(*self, checkpoint);
}

void equilibrium_visit(struct equilibrium *e, struct checkpoint *checkpoint)
{
    checkpoint_numbers(checkpoint, "largest reference", &e->largest, 1);
    visit_method(e, e->method, &e->self, checkpoint);
    visit_method(e, e->method->next, &e->next, checkpoint);
}
