/* spectral - a yardstick for load steps of periodic cells: what who homogenises voxels would take.
 * No test: make bench.
 *
 *   spectral DOMAIN.g END STEP TOLERANCE
 *     strain, stress [MPa] and evaluations of each step, then what it cost
 *
 * J2 with Voce's law in small strain on the voxels of a periodic domain of two phases (the laws of
 * pipelines/study), in uniaxial tension along x by the mean stress.  Along axes that are not
 * periodic a layer of gas without stiffness makes its surfaces free.  Compatible strains by the
 * rotated scheme (Willot, C. R. Mecanique 343 (2015) 232), steps of Barzilai and Borwein
 * (Schneider, Int. J. Numer. Methods Engrg. 118 (2019) 482), double precision, FFTW. */
#include "domain.h"
#include "exodus.h"
#include "memory.h"
#include "spool.h"

#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { TENSOR = 6, GAS = 2 }; /* xx yy zz xy yz zx; the phase of voxels without stiffness */

static const double mu = 210e3 / 2 / 1.31, bulk = 210e3 / 3 / (1 - 2 * 0.31); /* MPa */
static const double yield[2] = {182.1, 1259.8}, saturation[2] = {513.0, 564.5},
                    rate[2] = {5.320, 238.5};

struct cell {
    int n[3];
    int64_t voxels, solid, waves; /* solid: voxels without those of gas */
    uint8_t *phase;
    double *strain[TENSOR], *plastic[TENSOR], *stress[TENSOR],
        *p; /* p: equivalent plastic strain */
    double *off[TENSOR], *off_before[TENSOR], *before[TENSOR];
    fftw_complex *wave[TENSOR];
    fftw_plan forth, back;
    int64_t evaluations;
};

static double weight(int k)
{
    return k < 3 ? 1 : 2;
}

/* The next number that has no prime factors but 2, 3 and 5. */
static int smooth(int n)
{
    for (;; n++) {
        int left = n;
        for (int factor = 2; factor <= 5; factor++)
            while (left % factor == 0) left /= factor;
        if (left == 1) return n;
    }
}

/* The domain's sites in their order, x fastest. */
static void read_cell(struct cell *cell, const char *name)
{
    struct spool input = spool_input(name);
    struct domain domain = exodus_read_domain(&input);
    const double edge = attributes_number(&domain.attributes, "spacing_m", NAN), *const x[3] = {
                                                                                     domain.x,
                                                                                     domain.y,
                                                                                     domain.z};
    const char *const periods[] = {"period_x_m", "period_y_m", "period_z_m"};
    int64_t sites = 1;
    int size[3];
    cell->voxels = 1;
    for (int a = 0; a < 3; a++) {
        const double extent =
            domain_largest(x[a], domain.n_nodes) - domain_smallest(x[a], domain.n_nodes);
        const double period = attributes_number(&domain.attributes, periods[a], NAN);
        size[a] = (int)lround(extent / edge) + 1;
        cell->n[a] = isnan(period) ? smooth(size[a] + 1) : size[a];
        cell->voxels *= cell->n[a];
        sites *= size[a];
    }
    cell->solid = domain.n_nodes;
    if (cell->solid != sites) {
        fprintf(stderr, "spectral: %s is no box of cubes\n", name);
        exit(2);
    }
    cell->phase = memory_new((size_t)cell->voxels, 1);
    memset(cell->phase, GAS, (size_t)cell->voxels);
    for (int64_t line = 0; line < sites / size[0]; line++)
        memcpy(cell->phase + (line / size[1] * cell->n[1] + line % size[1]) * cell->n[0],
               domain.phase + line * size[0], (size_t)size[0]);
    domain_free(&domain);
    spool_close(&input);
}

static void make_room(struct cell *cell)
{
    const size_t n = (size_t)cell->voxels;
    const int *size = cell->n;
    cell->waves = (int64_t)size[2] * size[1] * (size[0] / 2 + 1);
    for (int k = 0; k < TENSOR; k++) {
        double **const fields[] = {&cell->strain[k], &cell->plastic[k],    &cell->stress[k],
                                   &cell->off[k],    &cell->off_before[k], &cell->before[k]};
        for (size_t f = 0; f < sizeof fields / sizeof *fields; f++) {
            *fields[f] = fftw_alloc_real(n);
            memset(*fields[f], 0, n * sizeof(double));
        }
        cell->wave[k] = fftw_alloc_complex((size_t)cell->waves);
    }
    cell->p = memory_new(n, sizeof *cell->p);
    cell->forth = fftw_plan_dft_r2c_3d(size[2], size[1], size[0], cell->stress[0], cell->wave[0],
                                       FFTW_MEASURE);
    cell->back =
        fftw_plan_dft_c2r_3d(size[2], size[1], size[0], cell->wave[0], cell->off[0], FFTW_MEASURE);
    memset(cell->stress[0], 0, n * sizeof(double));
}

/* Plastic multiplier of Voce's law at the trial stress q. */
static double multiplier(int phase, double p, double q)
{
    double g = 0;
    if (q <= yield[phase] + saturation[phase] * (1 - exp(-rate[phase] * p))) return 0;
    for (int step = 0; step < 20; step++) {
        const double x = exp(-rate[phase] * (p + g)),
                     residual = q - 3 * mu * g - yield[phase] - saturation[phase] * (1 - x);
        g += residual / (3 * mu + saturation[phase] * rate[phase] * x);
        if (fabs(residual) < 1e-9 * q) break;
    }
    return g;
}

static void find_stress(struct cell *cell, bool commit)
{
    cell->evaluations++;
    for (int64_t i = 0; i < cell->voxels; i++) {
        double e[TENSOR], square = 0;
        if (cell->phase[i] == GAS) continue; /* whose stress stays 0 */
        for (int k = 0; k < TENSOR; k++) e[k] = cell->strain[k][i] - cell->plastic[k][i];
        const double trace = e[0] + e[1] + e[2];
        for (int k = 0; k < 3; k++) e[k] -= trace / 3;
        for (int k = 0; k < TENSOR; k++) square += weight(k) * e[k] * e[k];
        const double q = 2 * mu * sqrt(1.5 * square), g = multiplier(cell->phase[i], cell->p[i], q),
                     left = q > 0 ? 1 - 3 * mu * g / q : 1;
        for (int k = 0; k < TENSOR; k++) {
            cell->stress[k][i] = 2 * mu * left * e[k] + (k < 3 ? bulk * trace : 0);
            if (commit) cell->plastic[k][i] += (1 - left) * e[k];
        }
        if (commit) cell->p[i] += g;
    }
}

/* The compatible part of one wave of the stress, s: the strain of the displacement that is nearest
 * to it. */
static void project_wave(const double complex q[3], double complex s[TENSOR])
{
    const double square = creal(q[0] * conj(q[0]) + q[1] * conj(q[1]) + q[2] * conj(q[2]));
    const double complex T[3] = {s[0] * conj(q[0]) + s[3] * conj(q[1]) + s[5] * conj(q[2]),
                                 s[3] * conj(q[0]) + s[1] * conj(q[1]) + s[4] * conj(q[2]),
                                 s[5] * conj(q[0]) + s[4] * conj(q[1]) + s[2] * conj(q[2])};
    double complex u[3], along = 0;
    if (square < 1e-24) {
        memset(s, 0, TENSOR * sizeof *s);
        return;
    }
    for (int a = 0; a < 3; a++) along += q[a] * T[a] / square;
    for (int a = 0; a < 3; a++) u[a] = (2 * T[a] - conj(q[a]) * along) / square;
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3;
        s[a] = q[a] * u[a];
        s[3 + a] = (q[a] * u[b] + q[b] * u[a]) / 2;
    }
}

/* off: the part of the stress that the strain can follow, with the mean stress but its xx. */
static void project(struct cell *cell)
{
    const int *n = cell->n;
    int64_t at = 0;
    for (int k = 0; k < TENSOR; k++)
        fftw_execute_dft_r2c(cell->forth, cell->stress[k], cell->wave[k]);
    for (int z = 0; z < n[2]; z++)
        for (int y = 0; y < n[1]; y++)
            for (int x = 0; x < n[0] / 2 + 1; x++, at++) {
                const double complex e[3] = {cexp(2 * M_PI * I * x / n[0]),
                                             cexp(2 * M_PI * I * y / n[1]),
                                             cexp(2 * M_PI * I * z / n[2])};
                const double complex q[3] = {(e[0] - 1) * (e[1] + 1) * (e[2] + 1) / 4,
                                             (e[0] + 1) * (e[1] - 1) * (e[2] + 1) / 4,
                                             (e[0] + 1) * (e[1] + 1) * (e[2] - 1) / 4};
                double complex s[TENSOR];
                for (int k = 0; k < TENSOR; k++) s[k] = cell->wave[k][at] / (double)cell->voxels;
                if (at > 0)
                    project_wave(q, s);
                else
                    s[0] = 0;
                for (int k = 0; k < TENSOR; k++) cell->wave[k][at] = s[k];
            }
    for (int k = 0; k < TENSOR; k++) fftw_execute_dft_c2r(cell->back, cell->wave[k], cell->off[k]);
}

static double product(const struct cell *cell, double *const a[TENSOR], double *const b[TENSOR])
{
    double sum = 0;
    for (int k = 0; k < TENSOR; k++)
        for (int64_t i = 0; i < cell->voxels; i++) sum += weight(k) * a[k][i] * b[k][i];
    return sum;
}

static double mean_stress(const struct cell *cell)
{
    double sum = 0;
    for (int64_t i = 0; i < cell->voxels; i++) sum += cell->stress[0][i];
    return sum / (double)cell->solid;
}

/* Strains move on as in the last step, of the length last (0: elastically). */
static void guess(struct cell *cell, double step, double last)
{
    for (int k = 0; k < TENSOR; k++)
        for (int64_t i = 0; i < cell->voxels; i++) {
            const double now = cell->strain[k][i],
                         change = last > 0 ? (now - cell->before[k][i]) * step / last
                                           : step * (k == 0  ? 1
                                                     : k < 3 ? -0.31
                                                             : 0);
            cell->before[k][i] = now;
            cell->strain[k][i] += change;
        }
}

/* strain -= off/stiffness; stiffness: of Barzilai and Borwein from the second time on. */
static void descend(struct cell *cell, bool first, double *stiffness)
{
    if (!first) {
        const double square = product(cell, cell->off_before, cell->off_before),
                     mixed = product(cell, cell->off_before, cell->off);
        if (square > mixed) *stiffness *= (square - mixed) / square;
    }
    for (int k = 0; k < TENSOR; k++)
        for (int64_t i = 0; i < cell->voxels; i++) {
            cell->strain[k][i] -= cell->off[k][i] / *stiffness;
            cell->off_before[k][i] = cell->off[k][i];
        }
}

int main(int argc, char **argv)
{
    struct cell cell = {.evaluations = 0};
    if (argc != 5) {
        fprintf(stderr, "usage: spectral DOMAIN.g END STEP TOLERANCE\n");
        return 2;
    }
    const double end = strtod(argv[2], NULL), largest = strtod(argv[3], NULL),
                 tolerance = strtod(argv[4], NULL);
    read_cell(&cell, argv[1]);
    make_room(&cell);
    const clock_t begun = clock();
    puts("strain,stress_MPa,evaluations");
    double step = 2e-4, last = 0;
    for (double strain = 0; strain < end - 1e-9;) {
        double stiffness = 1.2 * (bulk + 4 * mu / 3);
        const double length = fmin(step, end - strain);
        guess(&cell, length, last);
        for (int trial = 0; trial < 3000; trial++) {
            find_stress(&cell, false);
            project(&cell);
            if (sqrt(product(&cell, cell.off, cell.off) / (double)cell.solid) <
                tolerance * fabs(mean_stress(&cell)))
                break;
            descend(&cell, trial == 0, &stiffness);
        }
        find_stress(&cell, true);
        strain += length;
        last = length;
        step = fmin(1.5 * step, largest);
        printf("%.6g,%.6g,%lld\n", strain, mean_stress(&cell), (long long)cell.evaluations);
    }
    const double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
    fprintf(stderr,
            "spectral: %lld evaluations, %.2f s of the processor, %.0f ns a voxel and evaluation\n",
            (long long)cell.evaluations, seconds,
            1e9 * seconds / (double)cell.evaluations / (double)cell.voxels);
    return 0;
}
