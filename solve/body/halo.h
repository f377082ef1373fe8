/* halo.h - values of sites that other ranks own, and of images of sites in a periodic body. */
#ifndef HS_HALO_H
#define HS_HALO_H

#include "grid.h"

struct halo;
struct profile;

/* Plans the exchange for the sites that carry the flag (SITE_MOVES, SITE_STRESSED).  Collective. */
struct halo *halo_new(const struct grid *grid, const struct lattice *lattice,
                      const struct partition *partition, int flag, int size);
void halo_free(struct halo *halo);
void halo_profile(struct halo *halo, struct profile *profile); /* where its time is booked */

/* Brings fields[k][site], k < count (at most 9), of those sites up to date.  Collective. */
void halo_exchange(struct halo *halo, double *const fields[], int count);

#endif
