/* flowing.c - a residual energy that flows at a share of the particle's own flow stress.
 *
 *   g_m = F^-1 h_m,  e = w_m g_m,  w_m^2 = mean over the cell of |grad s_m|^2, but      (flowing.1)
 *   e_yz = (w_xy g_xy,z + w_zx g_zx,y)/sqrt(3), e_zx and e_xy alike, for g_xy,z, g_yz,x and g_zx,y
 *   Pi = V a mu phi(|e - e'|),  d phi/dr = r up to r_c, beyond it                       (flowing.2)
 *                               r_c + H/(1 + H) (r - r_c)
 *   r_c = (f + h alpha) sigma_y(p)/(sqrt(3) mu),  H = h sigma_y(p)/(sqrt(3) mu)         (flowing.3)
 *
 * e: the deviation of the gradient over the cell, all modes and components of it one vector (12
 * numbers), seen from the material (F^-1: a superposed rotation leaves it alone).  a mu e^2/2 is
 * Silling's energy of the non-affine part of a family's motion (Comput. Methods Appl. Mech. Engrg.
 * 322 (2017) 42) for the family of eight corners, and on cubes the hourglass stiffness of Flanagan,
 * Belytschko (Int. J. Numer. Methods Engrg. 17 (1981) 679) as large as the material's own, but for
 * the motions across the plane of a mode.  Of their gradient a part is rotation, all but a shear
 * where a cell is twisted, and only shear strains count, on cubes as in 2/3 2 mu eps:eps, which for
 * bending is what the others are.  The axes are those of the lattice, of a mesh each element's own.
 *
 * An elastic energy of that size would lock what flows: so it flows like J2, with e' for the
 * plastic strain and alpha = sum |de'| for the equivalent one, the radial return in one step as it
 * hardens linearly.  It hardens by a share of the flow stress, too: a share of the shear modulus is
 * nothing in a hard phase and several times the flow stress in a soft one.  Within a step r_c and H
 * stand still, so that the force is the gradient of Pi.  The work a mu r_c d(alpha) is booked as
 * plastic.
 *
 * Beyond the caches the state sets the pace, so it is in single precision. */
#include "checkpoint.h"
#include "degradation.h"
#include "hexahedra.h"
#include "logarithmic.h"
#include "memory.h"
#include "residual.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COMPONENTS = 3 * MODES, ALPHA = COMPONENTS, STATE };
/* Across the planes of their modes: xy along z, yz along x, zx along y. */
enum { XY_Z = 2, YZ_X = 3, ZX_Y = 7 };

struct flowing {
    double modulus, limit, hardening; /* a, f, h */
    double weight[MODES];             /* w_m [1/m] */
    float *state;                     /* strip by strip: e', alpha; NULL: nothing ever flows */
    double *work;                     /* strip by strip, over V a mu */
    double *records;                  /* of degradation, strip by strip; NULL: none degrades */
    double *axes; /* of a mesh's elements, unit vectors, strip by strip; NULL: x, y, z */
};
#define AT(member) offsetof(struct flowing, member)

static const struct key keys[] = {
    {"modulus", KEY_NUMBER, AT(modulus), "1", 0.01, 10, .usual = 1,
     .help = "a: its stiffness over the shear modulus; sets bending of bodies of few particles"},
    {"limit", KEY_NUMBER, AT(limit), "1", 0, 10, .usual = 0.03,
     .help = "f: the stress at which it flows over the particle's own; between 0.02 and 0.05 the "
             "stress of a harmonic structure moves by 1.3 per cent"},
    {"hardening", KEY_NUMBER, AT(hardening), "1", 0, 10, .usual = 0.1,
     .help = "h: growth of that share by a deviation of 1 of the gradient over the cell; keeps "
             "motions of no energy away"},
};

static void start(void *self, const struct body *body, const struct materials *materials,
                  struct hexahedra *hexahedra)
{
    struct flowing *flowing = self;
    const struct strips *strips = &body->near;
    const double *dx = body->lattice->edge;
    bool flows = false;
    for (int m = 0; m < MODES; m++) {
        double square = 0;
        /* Each coordinate of a product has the mean square 1/3: that of 1/sqrt(3). */
        for (int a = 0; a < 3; a++)
            square += pow(
                residual_slope(m, a, (double[]){sqrt(1. / 3), sqrt(1. / 3), sqrt(1. / 3)}, dx), 2);
        flowing->weight[m] = hexahedra ? 1 : sqrt(square);
    }
    if (hexahedra) {
        hexahedra_normalise(hexahedra);
        flowing->axes = memory_new((size_t)strips->points * TENSOR, sizeof(double));
        hexahedra_axes(hexahedra, flowing->axes);
    }
    for (int k = 0; k < materials->n_laws; k++) flows |= materials->laws[k].law->flow_stress >= 0;
    if (flows) {
        flowing->state = memory_new((size_t)strips->points * STATE, sizeof *flowing->state);
        flowing->work = memory_new((size_t)strips->points, sizeof *flowing->work);
    }
    if (body->integrity) flowing->records = degradation_new(strips);
}

/* A checkpoint's numbers are wider: some components at a time, of which it has a copy. */
static void visit_state(struct flowing *flowing, const struct strips *strips,
                        struct checkpoint *checkpoint, int first, int count)
{
    double *wide = memory_new((size_t)(strips->points * count), sizeof *wide);
    char *name = memory_print("flowing: flow from component %d on", first);
    for (int back = 0; back < 2; back++) {
        for (int64_t s = 0; s < strips->count; s++) {
            const int64_t stride = strips->items[s].stride, store = strips->items[s].store;
            float *state = flowing->state + STATE * store + first * stride;
            double *copy = wide + count * store;
            for (int64_t k = 0; k < count * stride; k++)
                if (back)
                    state[k] = (float)copy[k];
                else
                    copy[k] = state[k];
        }
        if (!back) checkpoint_strips(checkpoint, name, strips, count, wide);
    }
    free(name);
    free(wide);
}

static void visit(void *self, const struct strips *strips, struct checkpoint *checkpoint)
{
    struct flowing *flowing = self;
    for (int k = 0; flowing->state && k < STATE; k += 3)
        visit_state(flowing, strips, checkpoint, k, k < COMPONENTS ? 3 : STATE - k);
    checkpoint_strips(checkpoint, "flowing: work", strips, 1, flowing->work);
    checkpoint_strips(checkpoint, "flowing: degradation", strips, DEGRADATION, flowing->records);
}

static void release(void *self)
{
    struct flowing *flowing = self;
    free(flowing->state);
    free(flowing->work);
    free(flowing->records);
    free(flowing->axes);
    free(flowing);
}

static double share(const void *self)
{
    (void)self;
    return 1;
}

/* What lies between e and the forces. */
struct work {
    HS_ALIGNED double G[TENSOR][LANES];     /* F^-1 */
    double g[COMPONENTS][LANES];            /* [m] */
    double d[COMPONENTS][LANES];            /* e - e' */
    double square[LANES];                   /* |e - e'|^2 */
    double scale[LANES];                    /* a mu V phi'/r, times the integrity */
    double factor[LANES], increment[LANES]; /* phi'/r, |de'| */
    double lost[LANES], waiting[LANES]; /* shares of d that go to e'; work that is not booked yet */
    double stored[LANES], dissipated[LANES], dissipating[LANES]; /* [J/m^3] */
};

HS_SIMD static void find_inverse(int count, const struct points *restrict s,
                                 struct work *restrict w)
{
    for (int i = 0; i < count; i++) {
        const struct tensor G = inverse_tensor(deformation_gradient(s, i));
        w->G[0][i] = G.xx, w->G[1][i] = G.xy, w->G[2][i] = G.xz;
        w->G[3][i] = G.yx, w->G[4][i] = G.yy, w->G[5][i] = G.yz;
        w->G[6][i] = G.zx, w->G[7][i] = G.zy, w->G[8][i] = G.zz;
    }
}

struct vector {
    double x, y, z;
};

HS_INLINE struct vector times_vector(double factor, struct vector v)
{
    return (struct vector){factor * v.x, factor * v.y, factor * v.z};
}

/* g of a mode of point i, which is kept, and w_m g. */
HS_INLINE struct vector gradient_of(int i, int mode, double weight, double (*restrict h)[3][LANES],
                                    struct work *restrict w)
{
    const double x = h[mode][0][i], y = h[mode][1][i], z = h[mode][2][i];
    const struct vector g = {dot3(w->G[0][i], x, w->G[1][i], y, w->G[2][i], z),
                             dot3(w->G[3][i], x, w->G[4][i], y, w->G[5][i], z),
                             dot3(w->G[6][i], x, w->G[7][i], y, w->G[8][i], z)};
    w->g[3 * mode][i] = g.x;
    w->g[3 * mode + 1][i] = g.y;
    w->g[3 * mode + 2][i] = g.z;
    return times_vector(weight, g);
}

/* e - e' of a mode of point i, which is kept; its square on top of those of other modes. */
HS_INLINE double deviate(int i, int mode, struct vector e, const float *restrict plastic,
                         int64_t stride, struct work *restrict w, double square)
{
    const float *from = plastic + 3 * mode * stride + i;
    const struct vector d = {e.x - from[0], e.y - from[stride], e.z - from[2 * stride]};
    w->d[3 * mode][i] = d.x;
    w->d[3 * mode + 1][i] = d.y;
    w->d[3 * mode + 2][i] = d.z;
    return square + dot3(d.x, d.x, d.y, d.y, d.z, d.z);
}

HS_SIMD static void find_deviation(int count, const double *restrict weight,
                                   double (*restrict h)[3][LANES], const float *restrict plastic,
                                   int64_t stride, struct work *restrict w)
{
    const double share = 1 / sqrt(3.);
    for (int i = 0; i < count; i++) {
        struct vector xy = gradient_of(i, 0, weight[0], h, w),
                      yz = gradient_of(i, 1, weight[1], h, w),
                      zx = gradient_of(i, 2, weight[2], h, w);
        const struct vector xyz = gradient_of(i, MODE_XYZ, weight[MODE_XYZ], h, w),
                            across = {yz.x, zx.y, xy.z};
        xy.z = share * (across.z + across.y);
        yz.x = share * (across.x + across.z);
        zx.y = share * (across.y + across.x);
        double square = deviate(i, 0, xy, plastic, stride, w, 0);
        square = deviate(i, 1, yz, plastic, stride, w, square);
        square = deviate(i, 2, zx, plastic, stride, w, square);
        w->square[i] = deviate(i, MODE_XYZ, xyz, plastic, stride, w, square);
    }
}
HS_SIMD static void find_deviation_in_plane(int count, const double *restrict weight,
                                            double (*restrict h)[3][LANES],
                                            const float *restrict plastic, int64_t stride,
                                            struct work *restrict w)
{
    for (int i = 0; i < count; i++) {
        const struct vector xy = gradient_of(i, 0, weight[0], h, w);
        w->square[i] = deviate(i, 0, xy, plastic, stride, w, 0);
    }
}

/* (x, y, z) in the axes of the elements, or back: axis a has the components 3 a + b. */
HS_SIMD static void turn(int count, bool back, const double *restrict axes, int64_t stride,
                         double *restrict x, double *restrict y, double *restrict z)
{
    const int row = back ? 1 : 3, column = back ? 3 : 1;
    for (int i = 0; i < count; i++) {
        const double *a = axes + i;
        const double u = x[i], v = y[i], w = z[i];
        x[i] = dot3(a[0], u, a[column * stride], v, a[2 * column * stride], w);
        y[i] = dot3(a[row * stride], u, a[(row + column) * stride], v,
                    a[(row + 2 * column) * stride], w);
        z[i] = dot3(a[2 * row * stride], u, a[(2 * row + column) * stride], v,
                    a[(2 * row + 2 * column) * stride], w);
    }
}

/* phi'/r, and what a commit would dissipate. */
HS_SIMD static void flow(int count, const struct flowing *restrict f, const double *restrict mu,
                         const double *restrict stress, const float *restrict alpha,
                         struct work *restrict w)
{
    const double to_shear = 1 / sqrt(3.);
    for (int i = 0; i < count; i++) {
        const double yield = to_shear * stress[i] / mu[i], slope = f->hardening * yield,
                     limit = yield * (f->limit + f->hardening * alpha[i]), r = sqrt(w->square[i]),
                     lost = r > limit ? (r - limit) / (r * (1 + slope)) : 0;
        const double increment = lost * r;
        w->factor[i] = 1 - lost;
        w->increment[i] = increment;
        w->dissipating[i] = r > limit ? increment * (limit + 0.5 * slope * increment) : 0;
    }
}

/* The state moves on: alpha and work, and e' of the modes.  Increments that its precision would
 * swallow, of short steps, wait for those to come: Pi is what it is without a commit, and their
 * share of it counts as stored. */
HS_SIMD static void move_on(int count, struct work *restrict w, float *restrict alpha,
                            double *restrict work)
{
    const double least = 4 * (double)FLT_EPSILON;
    for (int i = 0; i < count; i++) {
        const bool moves = w->increment[i] > least;
        const double booked = moves ? w->dissipating[i] : 0;
        w->lost[i] = moves ? 1 - w->factor[i] : 0;
        w->waiting[i] = w->dissipating[i] - booked;
        w->dissipating[i] = booked;
        alpha[i] = (float)(alpha[i] + (moves ? w->increment[i] : 0));
        work[i] += booked;
    }
}
HS_SIMD static void move_mode_on(int count, const double *restrict lost, const double *restrict d,
                                 float *restrict plastic)
{
    for (int i = 0; i < count; i++) plastic[i] = (float)(plastic[i] + lost[i] * d[i]);
}

/* The work that has been booked so far, and none in this step where it is not committed. */
static void read_work(int count, const double *work, bool commit, struct work *w)
{
    for (int i = 0; i < count; i++) {
        w->dissipated[i] = work[i];
        if (!commit) w->dissipating[i] = w->waiting[i] = 0;
    }
}

HS_SIMD static void find_scale(int count, double modulus, const double *restrict mu,
                               const double *restrict volume, struct work *restrict w)
{
    for (int i = 0; i < count; i++) w->scale[i] = modulus * mu[i] * volume[i] * w->factor[i];
}

/* What is conjugate to the strains of a mode of point i. */
HS_INLINE struct vector stress_of(int i, int mode, double weight, const struct work *restrict w)
{
    const double scale = weight * w->scale[i];
    return (struct vector){scale * w->d[3 * mode][i], scale * w->d[3 * mode + 1][i],
                           scale * w->d[3 * mode + 2][i]};
}

/* F^-T t of one mode of point i, t conjugate to g: taken off from A, and what it gives to the mode.
 */
HS_INLINE struct tensor force_of(int i, int mode, struct vector t, const struct work *restrict w,
                                 double (*restrict m)[3][PADDED], struct tensor A)
{
    const double gx = w->g[3 * mode][i], gy = w->g[3 * mode + 1][i], gz = w->g[3 * mode + 2][i];
    const double tx = dot3(w->G[0][i], t.x, w->G[3][i], t.y, w->G[6][i], t.z),
                 ty = dot3(w->G[1][i], t.x, w->G[4][i], t.y, w->G[7][i], t.z),
                 tz = dot3(w->G[2][i], t.x, w->G[5][i], t.y, w->G[8][i], t.z);
    m[mode][0][PAD + i] = tx;
    m[mode][1][PAD + i] = ty;
    m[mode][2][PAD + i] = tz;
    return (struct tensor){fused(-tx, gx, A.xx), fused(-tx, gy, A.xy), fused(-tx, gz, A.xz),
                           fused(-ty, gx, A.yx), fused(-ty, gy, A.yy), fused(-ty, gz, A.yz),
                           fused(-tz, gx, A.zx), fused(-tz, gy, A.zy), fused(-tz, gz, A.zz)};
}

HS_INLINE struct tensor read_tensor(double (*restrict A)[PADDED], int i)
{
    return (struct tensor){A[0][i], A[1][i], A[2][i], A[3][i], A[4][i],
                           A[5][i], A[6][i], A[7][i], A[8][i]};
}
HS_INLINE void write_tensor(double (*restrict A)[PADDED], int i, struct tensor T)
{
    A[0][i] = T.xx, A[1][i] = T.xy, A[2][i] = T.xz;
    A[3][i] = T.yx, A[4][i] = T.yy, A[5][i] = T.yz;
    A[6][i] = T.zx, A[7][i] = T.zy, A[8][i] = T.zz;
}

/* The shear strains' stresses go to what they are made of: the transpose of (flowing.1). */
HS_SIMD static void add_forces(int count, const double *restrict weight,
                               const struct work *restrict w, double (*restrict A)[PADDED],
                               double (*restrict m)[3][PADDED])
{
    const double share = 1 / sqrt(3.);
    for (int i = 0; i < count; i++) {
        struct vector xy = stress_of(i, 0, weight[0], w), yz = stress_of(i, 1, weight[1], w),
                      zx = stress_of(i, 2, weight[2], w);
        const double on_yz = w->scale[i] * w->d[XY_Z][i], on_zx = w->scale[i] * w->d[YZ_X][i],
                     on_xy = w->scale[i] * w->d[ZX_Y][i];
        xy.z = share * weight[0] * (on_yz + on_zx);
        yz.x = share * weight[1] * (on_zx + on_xy);
        zx.y = share * weight[2] * (on_xy + on_yz);
        struct tensor sum = read_tensor(A, PAD + i);
        sum = force_of(i, 0, xy, w, m, sum);
        sum = force_of(i, 1, yz, w, m, sum);
        sum = force_of(i, 2, zx, w, m, sum);
        sum = force_of(i, MODE_XYZ, stress_of(i, MODE_XYZ, weight[MODE_XYZ], w), w, m, sum);
        write_tensor(A, PAD + i, sum);
    }
}
HS_SIMD static void add_forces_in_plane(int count, const double *restrict weight,
                                        const struct work *restrict w, double (*restrict A)[PADDED],
                                        double (*restrict m)[3][PADDED])
{
    for (int i = 0; i < count; i++)
        write_tensor(A, PAD + i,
                     force_of(i, 0, stress_of(i, 0, weight[0], w), w, m, read_tensor(A, PAD + i)));
}

/* e - e' and its square */
static void deviation(const struct flowing *f, bool plane, struct cells *cells,
                      const float *plastic, int64_t stride, struct work *w)
{
    const struct strip *strip = cells->strip;
    find_inverse(strip->count, cells->points, w);
    if (f->axes)
        for (int b = 0; b < 3; b++)
            turn(strip->count, false, f->axes + TENSOR * strip->store, strip->stride, w->G[b],
                 w->G[3 + b], w->G[6 + b]);
    (plane ? find_deviation_in_plane : find_deviation)(strip->count, f->weight, cells->h, plastic,
                                                       stride, w);
}

static void push(const struct flowing *f, bool plane, struct work *w, struct cells *cells)
{
    const struct strip *strip = cells->strip;
    if (f->axes)
        for (int m = 0; m < MODES; m++)
            turn(strip->count, true, f->axes + TENSOR * strip->store, strip->stride, w->g[3 * m],
                 w->g[3 * m + 1], w->g[3 * m + 2]);
    (plane ? add_forces_in_plane : add_forces)(strip->count, f->weight, w, cells->A, cells->m);
}

HS_SIMD static void find_energies(int count, double modulus, const double *restrict mu,
                                  struct work *restrict w)
{
    for (int i = 0; i < count; i++) {
        const double density = modulus * mu[i];
        w->stored[i] = density * (0.5 * w->factor[i] * w->factor[i] * w->square[i] + w->waiting[i]);
        w->dissipated[i] *= density;
        w->dissipating[i] *= density;
    }
}

/* Of particles that lose their stress by degrees, what their energies and forces become. */
static void degrade(struct flowing *flowing, const struct cells *cells, bool commit, struct work *w)
{
    const struct strip *strip = cells->strip;
    double *record = flowing->records + DEGRADATION * strip->store;
    if (commit)
        degradation_book(strip->count, cells->integrity, w->dissipating, w->stored, record,
                         strip->stride);
    for (int i = 0; i < strip->count; i++) {
        w->scale[i] *= cells->integrity[i];
        w->stored[i] *= cells->integrity[i];
        w->dissipated[i] -= record[WITHHELD * strip->stride + i];
    }
}

static void no_flow(int count, struct work *w)
{
    for (int i = 0; i < count; i++) {
        w->factor[i] = 1;
        w->dissipated[i] = w->dissipating[i] = w->waiting[i] = 0;
    }
}

static void add(void *self, const struct body *body, struct cells *cells, const double *stress,
                struct force_mode mode, struct force_energy *energy)
{
    struct flowing *flowing = self;
    const int n = cells->strip->count;
    const bool plane = body->lattice->dimensions == 2;
    const int64_t stride = flowing->state ? cells->strip->stride : LANES;
    HS_ALIGNED float none[COMPONENTS][LANES], *state = none[0];
    double *work = NULL;
    const double *mu = cells->points->mu;
    const bool flows = flowing->state && !mode.frozen;
    struct work w;
    if (flowing->state) {
        state = flowing->state + STATE * cells->strip->store;
        work = flowing->work + cells->strip->store;
        prefetch(state + STATE * stride,
                 (size_t)(STATE * stride) * sizeof *state); /* of the next strip */
    } else
        memset(none, 0, sizeof none);
    deviation(flowing, plane, cells, state, stride, &w);
    if (flows)
        flow(n, flowing, mu, stress, state + ALPHA * stride, &w);
    else
        no_flow(n, &w);
    if (flows && mode.commit) move_on(n, &w, state + ALPHA * stride, work);
    if (flows && (mode.energy || cells->integrity)) read_work(n, work, mode.commit, &w);
    find_scale(n, flowing->modulus, mu, cells->volume, &w);
    if (mode.energy || cells->integrity) find_energies(n, flowing->modulus, mu, &w);
    if (cells->integrity) degrade(flowing, cells, mode.commit, &w);
    push(flowing, plane, &w, cells);
    for (int k = 0; k < (plane ? 3 : COMPONENTS) && flows && mode.commit; k++)
        move_mode_on(n, w.lost, w.d[k], state + k * stride);
    if (!mode.energy) return;
    cells_sum(body, cells, w.stored, 1, &energy->stabilisation);
    cells_sum(body, cells, w.dissipated, 1, &energy->plastic);
}

const struct residual residual_flowing = {
    .words = {"flowing",
              "Silling's energy of the non-affine motion, which flows at a share of the particle's "
              "flow stress; one update of the law for each particle.",
              KEYS(keys)},
    .size = sizeof(struct flowing),
    .start = start,
    .share = share,
    .add = add,
    .visit = visit,
    .free = release,
};
