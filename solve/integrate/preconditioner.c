#include "preconditioner.h"

#include "direction.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of more held components so many, evenly chosen: they hold the body as a whole, and S costs as
 * many solutions. */
enum { MOST_PINS = 256 };

struct preconditioner {
    const struct unknowns *unknowns;
    struct transform *transform;
    int count;      /* pins of all ranks, by their sites and components */
    int64_t *at;    /* [count] place in the vector, -1 of those of other ranks */
    double *factor; /* [count count] lower triangle L of S = L L^T, row by row */
    double *force;  /* [count] lambda */
    double *held;   /* [length] r with the forces on pins; NULL: there are none */
};

/* A held component within the box: its place in the vector, and what tells it from all others on
 * any rank. */
struct pin {
    int64_t key, at;
};

struct list {
    int64_t count;
    struct pin *pins;
};

static int by_key(const void *a, const void *b)
{
    const struct pin *p = a, *q = b;
    return (p->key > q->key) - (p->key < q->key);
}

/* Within: with all of its shares. */
static bool lies_within(const struct box *box, const struct body *body, int64_t site)
{
    static const float all = 0.999999f;
    int places[BOX_PLACES][3];
    float shares[BOX_PLACES], sum = 0;
    if (box->count == 0) return false;
    const int count = box_places(box, body, site, places, shares);
    for (int k = 0; k < count; k++) sum += shares[k];
    return sum > all;
}

static struct list find_candidates(const struct unknowns *unknowns, const struct box box[3])
{
    const struct body *body = unknowns->body;
    struct list list = {0};
    int64_t node = 0;
    for (int64_t s = 0; s < body->owned.count; s++)
        for (int i = 0; i < body->owned.items[s].count; i++, node++)
            for (int a = 0; a < 3; a++) {
                const int64_t at = a * unknowns->n_nodes + node,
                              site = body->owned.items[s].site + i;
                if (unknowns->free[at] > 0 || !lies_within(&box[a], body, site)) continue;
                list.pins = memory_grow(list.pins, list.count, sizeof *list.pins);
                list.pins[list.count++] = (struct pin){3 * body_number(body, site) + a, at};
            }
    if (list.count > 0) qsort(list.pins, (size_t)list.count, sizeof *list.pins, by_key);
    return list;
}

/* How many pins of all ranks have a key below this one. */
static double count_below(const struct list *list, double key)
{
    int64_t low = 0, high = list->count;
    while (low < high) {
        const int64_t middle = low + (high - low) / 2;
        if ((double)list->pins[middle].key < key)
            low = middle + 1;
        else
            high = middle;
    }
    return (double)low;
}

/* The key of the pin of this number, by halving: the same on any number of ranks. */
static double find_key(const struct list *list, double number, double last)
{
    double low = 0, high = last;
    while (low < high) {
        const double middle = floor(0.5 * (low + high));
        double below = count_below(list, middle + 1);
        ranks_sum(&below, 1);
        if (below > number)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static void choose_pins(struct preconditioner *p, const struct box box[3])
{
    struct list list = find_candidates(p->unknowns, box);
    double all = (double)list.count, last = list.count ? -(double)list.pins[list.count - 1].key : 0;
    ranks_sum(&all, 1);
    ranks_minimum(&last, 1);
    p->count = all < MOST_PINS ? (int)all : MOST_PINS;
    p->at = memory_new((size_t)p->count, sizeof *p->at);
    for (int k = 0; k < p->count; k++) {
        const double key = find_key(&list, floor(k * all / p->count), -last);
        const struct pin wanted = {(int64_t)key, 0}, *own = NULL;
        if (list.count > 0)
            own = bsearch(&wanted, list.pins, (size_t)list.count, sizeof wanted, by_key);
        p->at[k] = own ? own->at : -1;
    }
    free(list.pins);
}

/* values[count] of all ranks' pins in a direction.  Collective. */
static void take_pins(const struct preconditioner *p, const float *direction, double *values)
{
    for (int k = 0; k < p->count; k++)
        values[k] = p->at[k] >= 0 ? (double)direction[p->at[k]] : INFINITY;
    ranks_minimum(values, p->count);
}

static void factorise(struct preconditioner *p)
{
    /* M^-1 is known in single precision, and nodes of scattered bodies may share a place. */
    static const double slack = 1e-5;
    const int n = p->count;
    double *L = p->factor, largest = 0;
    for (int i = 0; i < n; i++) largest = fmax(largest, L[i * n + i]);
    for (int i = 0; i < n; i++) {
        L[i * n + i] += slack * largest;
        for (int j = 0; j <= i; j++) {
            double sum = L[i * n + j];
            for (int k = 0; k < j; k++) sum -= L[i * n + k] * L[j * n + k];
            L[i * n + j] = i == j ? sqrt(fmax(sum, slack * largest)) : sum / L[j * n + j];
        }
    }
}

static void solve(const struct preconditioner *p, double *x)
{
    const int n = p->count;
    const double *L = p->factor;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) x[i] -= L[i * n + k] * x[k];
        x[i] /= L[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) x[i] -= L[k * n + i] * x[k];
        x[i] /= L[i * n + i];
    }
}

static void fill_pins(struct preconditioner *p)
{
    const int n = p->count;
    float *answer = direction_new(p->unknowns);
    p->factor = memory_new((size_t)n * (size_t)n, sizeof *p->factor);
    p->force = memory_new((size_t)n, sizeof *p->force);
    p->held = vector_new(p->unknowns);
    for (int j = 0; j < n; j++) {
        if (p->at[j] >= 0) p->held[p->at[j]] = 1;
        transform_apply(p->transform, p->held, answer);
        if (p->at[j] >= 0) p->held[p->at[j]] = 0;
        take_pins(p, answer, p->force);
        for (int i = j; i < n; i++) p->factor[i * n + j] = p->force[i];
    }
    factorise(p);
    free(answer);
}

struct preconditioner *preconditioner_new(const struct unknowns *unknowns,
                                          const struct symbol *symbol)
{
    struct preconditioner *p = memory_new(1, sizeof *p);
    struct box box[3];
    p->unknowns = unknowns;
    for (int a = 0; a < 3; a++) box[a] = box_new(unknowns, a);
    choose_pins(p, box);
    const bool any = p->count > 0;
    p->transform = transform_new(unknowns, box, symbol, any);
    if (any) fill_pins(p);
    return p;
}

void preconditioner_free(struct preconditioner *p)
{
    transform_free(p->transform);
    free(p->at);
    free(p->factor);
    free(p->force);
    free(p->held);
    free(p);
}

bool preconditioner_is_crowded(const struct preconditioner *p)
{
    return transform_is_crowded(p->transform);
}

double preconditioner_filled(const struct preconditioner *p)
{
    return transform_filled(p->transform);
}

void preconditioner_apply(struct preconditioner *p, const double *r, float *z)
{
    const struct unknowns *unknowns = p->unknowns;
    transform_apply(p->transform, r, z);
    if (p->count == 0) return;
    take_pins(p, z, p->force);
    solve(p, p->force);
    memcpy(p->held, r, (size_t)unknowns->length * sizeof *p->held);
    for (int k = 0; k < p->count; k++)
        if (p->at[k] >= 0) p->held[p->at[k]] = -p->force[k];
    transform_apply(p->transform, p->held, z);
    for (int64_t i = 0; i < 3 * unknowns->n_nodes; i++)
        if (!(unknowns->free[i] > 0)) z[i] = 0;
}
