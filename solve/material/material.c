#include "material.h"

#include "law.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>

void materials_free(struct materials *all)
{
    for (int i = 0; i < all->count; i++) {
        if (all->items[i].law->release) all->items[i].law->release(all->items[i].parameters);
        free(all->items[i].parameters);
    }
    for (int k = 0; k < all->n_laws; k++) {
        free(all->laws[k].pairs);
        free(all->laws[k].component);
    }
    free(all->items);
    free(all->shear);
    free(all->bulk);
    free(all->laws);
    free(all->law_of);
    *all = (struct materials){0};
}

const void *materials_pairs(const struct materials *all, const struct law *law)
{
    for (int k = 0; k < all->n_laws; k++)
        if (all->laws[k].law == law) return all->laws[k].pairs;
    return NULL;
}

double material_bulk_modulus(const struct material *m, enum plane plane)
{
    const double nu = m->poissons_ratio;
    if (plane == PLANE_STRESS) return m->youngs_modulus / (2 * (1 - nu));
    if (plane == PLANE_STRAIN) return m->youngs_modulus / (2 * (1 + nu) * (1 - 2 * nu));
    return m->bulk_modulus;
}

double materials_wave_speed(const struct materials *all)
{
    double fastest = 0;
    for (int i = 0; i < all->count; i++) {
        const struct material *m = &all->items[i];
        double speed = sqrt((m->bulk_modulus + 4 * m->shear_modulus / 3) / m->density);
        fastest = fmax(fastest, speed);
    }
    return fastest;
}

double materials_stiffest(const struct materials *all)
{
    double most = 0;
    for (int i = 0; i < all->count; i++) most = fmax(most, all->items[i].youngs_modulus);
    return most;
}
