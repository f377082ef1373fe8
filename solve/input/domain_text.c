#include "domain_text.h"

#include "die.h"
#include "memory.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- reading the lines --- */

struct particle {
    double x, y, z, volume;
    int block;
};

enum { MOST_BLOCKS = 16, LONGEST_NAME = 64, LONGEST_LINE = 1024 };

struct particles {
    int64_t count;
    struct particle *items;
    char names[MOST_BLOCKS][LONGEST_NAME]; /* of the blocks, where a comment says so */
};

static void append(struct particles *all, struct particle particle)
{
    all->items = memory_grow(all->items, all->count, sizeof particle);
    all->items[all->count++] = particle;
}

static struct particle read_line(const char *line, const char *shown, long number)
{
    double values[5];
    const char *at = line;
    for (int i = 0; i < 5; i++) {
        char *end;
        values[i] = strtod(at, &end);
        if (end == at || !isfinite(values[i]))
            die_user("%s:%ld: expected 'x y z block volume', found '%s'", shown, number, line);
        at = end;
    }
    if (at[strspn(at, " \t\r")] != '\0')
        die_user("%s:%ld: more than 'x y z block volume' on the line", shown, number);
    if (values[3] != floor(values[3]) || values[3] < 1 || values[3] > 16)
        die_user("%s:%ld: block %g, expected a whole number from 1 to 16", shown, number,
                 values[3]);
    if (!(values[4] > 0)) die_user("%s:%ld: volume %g, expected > 0", shown, number, values[4]);
    return (struct particle){values[0], values[1], values[2], values[4], (int)values[3]};
}

/* "blocks: 1 CG 2 UFG" in a comment */
static void read_names(struct particles *all, const char *comment)
{
    const char *at = strstr(comment, "blocks:");
    int block, length;
    char name[LONGEST_NAME];
    if (at) at += strlen("blocks:");
    while (at && sscanf(at, "%d %63s%n", &block, name, &length) == 2) {
        if (block >= 1 && block <= MOST_BLOCKS)
            snprintf(all->names[block - 1], LONGEST_NAME, "%s", name);
        at += length;
    }
}

static struct particles read_particles(const struct spool *input, const char *shown)
{
    struct particles all = {0};
    FILE *file = fopen(input->path, "r");
    if (!file) die_user("cannot open %s: %s", shown, strerror(errno));
    char line[LONGEST_LINE];
    for (long number = 1; fgets(line, sizeof line, file); number++) {
        size_t length = strcspn(line, "#\n");
        if (line[length] == '\0' && !feof(file)) die_user("%s:%ld: line too long", shown, number);
        if (line[length] == '#') read_names(&all, line + length);
        line[length] = '\0';
        if (line[strspn(line, " \t\r")] != '\0') append(&all, read_line(line, shown, number));
    }
    if (ferror(file)) die_run("cannot read %s: %s", shown, strerror(errno));
    fclose(file);
    if (all.count == 0) die_user("%s has no particles", shown);
    return all;
}

/* --- node sets from lengths --- */

struct layer {
    const char *name;
    double from, to; /* m along x */
};

static void add_layer(struct domain *domain, struct layer layer)
{
    int64_t *nodes = memory_new((size_t)domain->n_nodes, sizeof *nodes), count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++)
        if (domain->x[i] >= layer.from && domain->x[i] <= layer.to) nodes[count++] = i;
    domain_add_set(domain, layer.name, count, nodes);
    free(nodes);
}

/* x of the layer of nodes next to a position; of two equally near the one farther from the middle, as
 * hsgen has it. */
static double nearest_layer(const struct domain *domain, double position, double middle,
                            double slack)
{
    double best = INFINITY;
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        double x = domain->x[i], gain = fabs(best - position) - fabs(x - position);
        bool outer = fabs(x - middle) > fabs(best - middle) + slack;
        if (gain > slack || (gain > -slack && outer)) best = x;
    }
    return best;
}

/* Body along x, from the faces of its outermost nodes. */
struct extent {
    double low, high, middle, spacing; /* m */
};

static struct extent extent_of(const struct domain *domain)
{
    struct extent e = {.low = domain_smallest(domain->x, domain->n_nodes),
                       .high = domain_largest(domain->x, domain->n_nodes),
                       .spacing = domain_spacing(domain)};
    e.middle = 0.5 * (e.low + e.high);
    e.low -= 0.5 * e.spacing;
    e.high += 0.5 * e.spacing;
    return e;
}

/* By x, of one x by volume, so that the order of the file does not matter. */
static int by_x(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return p[0] != q[0] ? (p[0] > q[0]) - (p[0] < q[0]) : (p[1] > q[1]) - (p[1] < q[1]);
}

/* Section of scattered particles between two places: the slope of their summed volume over x, each counted to its middle, by
 * least squares.  It does not depend on how many layers happen to lie between, as the quotient of volume and length does. */
static double slope_of_volume(const struct domain *domain, double left, double right)
{
    double(*all)[2] = memory_new((size_t)domain->n_nodes, sizeof *all), sum = 0;
    double n = 0, x = 0, v = 0, xx = 0, xv = 0;
    int64_t count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++) {
        if (domain->x[i] < left || domain->x[i] > right) continue;
        all[count][0] = domain->x[i] - left;
        all[count++][1] = domain->volume[i];
    }
    qsort(all, (size_t)count, sizeof *all, by_x);
    for (int64_t i = 0; i < count; i++) {
        const double at = all[i][0], volume = sum + 0.5 * all[i][1];
        sum += all[i][1];
        n++;
        x += at;
        v += volume;
        xx += at * at;
        xv += at * volume;
    }
    free(all);
    const double spread = n * xx - x * x;
    return spread > 0 ? (n * xv - x * v) / spread : 0;
}

/* The planes of a lattice are layers of nodes; of scattered ones a spacing's width of them. */
static void add_gauge(struct domain *domain, double gauge, bool lattice, const struct extent *e)
{
    const double slack = (lattice ? 1e-3 : 0.5) * e->spacing;
    double left = e->middle - 0.5 * gauge, right = e->middle + 0.5 * gauge, volume = 0;
    if (lattice) {
        left = nearest_layer(domain, left, e->middle, slack);
        right = nearest_layer(domain, right, e->middle, slack);
    }
    add_layer(domain, (struct layer){"gauge_left", left - slack, left + slack});
    add_layer(domain, (struct layer){"gauge_right", right - slack, right + slack});
    for (int64_t i = 0; lattice && i < domain->n_nodes; i++)
        if (domain->x[i] >= left && domain->x[i] < right - slack) volume += domain->volume[i];
    if (right > left)
        attributes_set_number(&domain->attributes, "section_m2",
                              lattice ? volume / (right - left)
                                      : slope_of_volume(domain, left, right));
}

void domain_text_sets(struct domain *domain, bool lattice, const struct deck *deck)
{
    struct deck_node section = deck_find(deck_root(deck), "domain");
    if (section.index == 0) return;
    struct deck_node grips = deck_find(section, "grips"), gauge = deck_find(section, "gauge");
    struct extent e = extent_of(domain);
    if (grips.index != 0) {
        double grip = deck_length(deck_get(grips, "length"), e.spacing, 0, 1e6);
        add_layer(domain, (struct layer){"grip_left", e.low, e.low + grip});
        add_layer(domain, (struct layer){"grip_right", e.high - grip, e.high});
    }
    if (gauge.index != 0)
        add_gauge(domain, deck_length(deck_get(gauge, "length"), e.spacing, 0, 1e6), lattice, &e);
}

/* --- the domain --- */

static void name_phases(struct domain *domain, const struct particles *all, const char *shown,
                        const struct deck *deck)
{
    struct deck_node materials = deck_get(deck_root(deck), "materials");
    domain->phase_names = memory_new((size_t)domain->n_phases, sizeof(char *));
    for (int p = 0; p < domain->n_phases; p++) {
        if (!all->names[p][0] && p >= deck_count(materials))
            deck_error(materials, "%s has %d blocks, but there are %d materials", shown,
                       domain->n_phases, deck_count(materials));
        domain->phase_names[p] =
            memory_text(all->names[p][0] ? all->names[p] : deck_key(materials, p));
    }
}

struct domain domain_text_read(const struct spool *input, const char *shown,
                               const struct deck *deck)
{
    struct particles all = read_particles(input, shown);
    const size_t n = (size_t)all.count;
    struct domain domain = {.n_nodes = all.count,
                            .x = memory_new(n, sizeof(double)),
                            .y = memory_new(n, sizeof(double)),
                            .z = memory_new(n, sizeof(double)),
                            .volume = memory_new(n, sizeof(double)),
                            .phase = memory_new(n, 1)};
    for (size_t i = 0; i < n; i++) {
        const struct particle *p = &all.items[i];
        domain.x[i] = p->x;
        domain.y[i] = p->y;
        domain.z[i] = p->z;
        domain.volume[i] = p->volume;
        domain.phase[i] = (uint8_t)(p->block - 1);
        if (p->block > domain.n_phases) domain.n_phases = p->block;
    }
    free(all.items);
    name_phases(&domain, &all, shown, deck);
    return domain;
}
