/* critical_extension.c - a bond breaks where its ends have moved apart by a length. */
#include "bond_loop.h"
#include "damage.h"

/* value - (|y| - |xi|) */
HS_INLINE void find_margin(const struct bond_pass *p, int k, struct bond b)
{
    p->each[0][k] = p->given[0][k] - bond_extension(b);
}
BOND_KERNELS(find_margins, find_margin(p, k, b))

static void margin(const struct damage_view *see, const struct bond_strip *strip,
                   const double *value, double *margin)
{
    struct bond_pass pass = {.given = {value}, .each = {margin}};
    bond_run(find_margins, see->bonds, strip, (struct bond_fields){0}, &pass);
}

static const struct key keys[] = {
    {"value", KEY_NUMBER, 0, "m", 1e-12, 1, .required = true, .help = "length - length at rest"}};

const struct damage_law damage_critical_extension = {
    .words = {"critical_extension", "A bond breaks beyond an extension.", KEYS(keys)},
    .size = sizeof(double),
    .margin = margin,
};
