/* stable_step.c - the critical time step by Lanczos' method (stable_step.h).
 *
 * A formula of wave speed and spacing knows nothing of formulation, influence, stabilisation,
 * surface and damage, each of which moves the limit.  Lanczos needs no matrix, only forces of small
 * displacements, so whatever the force is made of is seen. The force is that of frozen states:
 * plastic flow and slip only soften.  No reorthogonalisation: what it loses are copies of values
 * found already, and the largest is found first. */
#include "stable_step.h"

#include "material.h"
#include "memory.h"
#include "profile.h"
#include "random.h"

#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST = 16, MOST = 30 }; /* the fewest see a stiff spot among 1e7 nodes */

/* Three components over the grid's box. */
struct vector {
    double *component[3];
};

struct lanczos {
    struct model *model;
    struct body *body;
    const struct materials *materials;
    struct vector rest, force; /* displacement of the body as it is, and the force at it; NULL where
                                  they are zero */
    struct vector current, before;
};

/* The image of the current vector takes the place of the body's force. */
static struct vector image_of(const struct lanczos *l)
{
    return (struct vector){{l->body->f[0], l->body->f[1], l->body->f[2]}};
}

static struct vector vector_new(const struct body *body)
{
    struct vector vector;
    for (int a = 0; a < 3; a++)
        vector.component[a] = memory_new((size_t)body->grid.n_sites, sizeof(double));
    return vector;
}

/* A copy of box fields, none of fields that are zero: a body is set up at rest, and has to have
 * room for this beside all else. */
static struct vector copy_new(const struct body *body, double *const fields[3])
{
    const int64_t n = body->grid.n_sites;
    bool zero = true;
    for (int a = 0; a < 3; a++)
        for (int64_t i = 0; i < n && zero; i++) zero = fields[a][i] == 0;
    if (zero) return (struct vector){{NULL}};
    const struct vector vector = vector_new(body);
    for (int a = 0; a < 3; a++) memcpy(vector.component[a], fields[a], (size_t)n * sizeof(double));
    return vector;
}

static void put_back(const struct body *body, const struct vector *copy, double *const fields[3])
{
    const size_t bytes = (size_t)body->grid.n_sites * sizeof(double);
    for (int a = 0; a < 3; a++)
        if (copy->component[a])
            memcpy(fields[a], copy->component[a], bytes);
        else
            memset(fields[a], 0, bytes);
}

static void vector_free(struct vector *vector)
{
    for (int a = 0; a < 3; a++) free(vector->component[a]);
}

/* The mass-weighted product sum m a . b, in which M^-1 K is symmetric, in mean volumes. */
static double product(const struct lanczos *l, const struct vector *x, const struct vector *y,
                      double bound)
{
    struct exact_sum sum = exact_sum_new(bound);
    const struct body *body = l->body;
    for (int64_t s = 0; s < body->owned.count; s++) {
        const struct strip *strip = &body->owned.items[s];
        double terms[LANES];
        for (int i = 0; i < strip->count; i++) {
            int64_t site = strip->site + i;
            terms[i] = 0;
            for (int a = 0; a < 3; a++) terms[i] += x->component[a][site] * y->component[a][site];
            terms[i] *= materials_density(l->materials, body, site);
            if (body->volumes) terms[i] *= body->volumes[site] / body->volume;
        }
        exact_sum_add_strip(&sum, strip->count, terms, 1);
    }
    double value;
    exact_sum_finish(&sum, 1, &value);
    return value;
}

HS_SIMD static void add_scaled(int count, double a, const double *restrict x, double b,
                               double *restrict y)
{
    for (int i = 0; i < count; i++) y[i] = a * x[i] + b * y[i];
}
/* y = a x + b y at owned sites */
static void combine(const struct body *body, double a, const struct vector *x, double b,
                    struct vector *y)
{
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int c = 0; c < 3; c++)
            add_scaled(body->owned.items[s].count, a, x->component[c] + body->owned.items[s].site,
                       b, y->component[c] + body->owned.items[s].site);
}

static void start_vector(const struct lanczos *l)
{
    const struct body *body = l->body;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++) {
            int64_t site = body->owned.items[s].site + i;
            uint64_t number = (uint64_t)body_number(body, site);
            for (unsigned a = 0; a < 3; a++)
                l->current.component[a][site] =
                    (double)(random_hash(1, "stable step", 3 * number + a) >> 11) * 0x1p-53 - 0.5;
        }
}

/* image_of(l) = -M^-1 df/du current, by differences from rest.  Their error is of the order of the
 * displacement over the spacing, 1e-7. */
static void apply(const struct lanczos *l, double amplitude)
{
    struct body *body = l->body;
    struct vector u = {{body->u[0], body->u[1], body->u[2]}};
    put_back(body, &l->rest, body->u);
    combine(body, amplitude, &l->current, 1, &u);
    model_force(l->model, body, (struct force_mode){.frozen = true}, NULL);
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int64_t i = body->owned.items[s].site, end = i + body->owned.items[s].count; i < end;
             i++)
            for (int a = 0; a < 3; a++) {
                const double rest = l->force.component[a] ? l->force.component[a][i] : 0;
                body->f[a][i] =
                    (rest - body->f[a][i]) / amplitude / materials_density(l->materials, body, i);
            }
}

/* Largest Ritz value of the tridiagonal matrix, and the norm of its residual. */
static double largest_value(const double *diagonal, const double *off, int n, double *residual)
{
    gsl_matrix *T = gsl_matrix_calloc((size_t)n, (size_t)n),
               *vectors = gsl_matrix_alloc((size_t)n, (size_t)n);
    gsl_vector *values = gsl_vector_alloc((size_t)n);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc((size_t)n);
    for (size_t i = 0; i < (size_t)n; i++) {
        gsl_matrix_set(T, i, i, diagonal[i]);
        if (i + 1 < (size_t)n) {
            gsl_matrix_set(T, i, i + 1, off[i]);
            gsl_matrix_set(T, i + 1, i, off[i]);
        }
    }
    gsl_eigen_symmv(T, values, vectors, work);
    size_t largest = gsl_vector_max_index(values);
    const double value = gsl_vector_get(values, largest);
    *residual = off[n - 1] * fabs(gsl_matrix_get(vectors, (size_t)n - 1, largest));
    gsl_eigen_symmv_free(work);
    gsl_vector_free(values);
    gsl_matrix_free(vectors);
    gsl_matrix_free(T);
    return value;
}

static double largest_eigenvalue(struct lanczos *l)
{
    const double nodes = (double)l->body->n_nodes;
    double heaviest = 0, diagonal[MOST], off[MOST];
    for (int i = 0; i < l->materials->count; i++)
        heaviest = fmax(heaviest, l->materials->items[i].density);
    start_vector(l);
    double norm = sqrt(product(l, &l->current, &l->current, 3 * nodes * heaviest));
    combine(l->body, 0, &l->current, 1 / norm, &l->current);
    /* Unit vectors have a root mean square of about 1/sqrt(3 nodes density). */
    const double amplitude = 1e-7 * l->body->lattice->spacing * sqrt(3 * nodes * heaviest);
    const struct lattice *lattice = l->body->lattice;
    const double speed = materials_wave_speed(l->materials),
                 spacing = lattice->finest > 0 ? lattice->finest : lattice->spacing;
    const double scale = 1e4 * speed * speed / (spacing * spacing); /* far above any eigenvalue */
    struct vector image = image_of(l);
    double value = 0, residual = 0;
    for (int n = 1; n <= MOST; n++) {
        apply(l, amplitude);
        diagonal[n - 1] = product(l, &l->current, &image, scale);
        combine(l->body, -diagonal[n - 1], &l->current, 1, &image);
        if (n > 1) combine(l->body, -off[n - 2], &l->before, 1, &image);
        off[n - 1] = sqrt(product(l, &image, &image, scale * scale));
        value = largest_value(diagonal, off, n, &residual);
        if (n >= FEWEST && residual < 1e-2 * value) break;
        if (off[n - 1] <= 1e-6 * fabs(diagonal[n - 1]))
            break; /* an invariant space: small bodies */
        const struct vector spare = l->before;
        l->before = l->current;
        l->current = spare;
        put_back(l->body, &image, l->current.component);
        combine(l->body, 0, &l->before, 1 / off[n - 1], &l->current);
    }
    return value + residual;
}

double stable_step(struct model *model, struct body *body, const struct materials *materials)
{
    const enum profile_part before = profile_enter(body->profile, PART_STABLE_STEP);
    struct lanczos l = {
        .model = model, .body = body, .materials = materials, .rest = copy_new(body, body->u)};
    struct vector force = copy_new(body, body->f);
    const struct force_mode frozen = {.frozen = true};
    model_force(model, body, frozen, NULL);
    l.force = copy_new(body, body->f);
    l.current = vector_new(body);
    l.before = vector_new(body);
    double eigenvalue = largest_eigenvalue(&l);
    put_back(body, &l.rest, body->u);
    /* The gradients go back with the displacement, the force to its own bits. */
    model_force(model, body, frozen, NULL);
    put_back(body, &force, body->f);
    vector_free(&force);
    vector_free(&l.rest);
    vector_free(&l.force);
    vector_free(&l.current);
    vector_free(&l.before);
    profile_enter(body->profile, before);
    return 2 / sqrt(eigenvalue);
}
