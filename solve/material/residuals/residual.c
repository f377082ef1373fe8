#include "residual.h"

#include "memory.h"

#define ADDRESS(name) &residual_##name
static const struct residual *const table[] = {RESIDUALS(ADDRESS)};
enum { COUNT = sizeof table / sizeof *table };

static const struct variant *variant(int i)
{
    return i < COUNT ? &table[i]->words : NULL;
}

const struct section section_residual = {
    .path = "solver.residual",
    .help =
        "What resists motions of a particle's corners that its gradient does not see; of corner.",
    .chooser = "form",
    .variant = variant,
};

const struct residual *residual_read(struct deck_node map, void **self)
{
    const int i = map.index ? keys_variant(map, &section_residual) : 0;
    *self = memory_new(1, table[i]->size);
    keys_read(map, &section_residual, i, 0, NULL, *self);
    return table[i];
}

double residual_slope(int mode, int a, const double r[3], const double dx[3])
{
    static const int has[MODES][3] = {{1, 1, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
    double slope = has[mode][a] ? 2 / dx[a] : 0;
    for (int b = 0; b < 3; b++)
        if (b != a && has[mode][b]) slope *= r[b];
    return slope;
}
