#include "material_block.h"

#include "die.h"
#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double first_strain = 1e-4;
static const double misfit_share = 0.005; /* of Rm, root mean square up to which a law is a law */
static const double transient_share =
    0.02; /* of ReL, above which the fall from the upper yield point goes on */
static const double thinning_share = 0.001;
enum { FEWEST_POINTS = 2 };

/* Plastic strains that rise, and stresses, of the uniform part. */
struct points {
    long n;
    double *strain, *stress;
};

long material_first_row(const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    const struct yield_point *yield = &analysis->measures.yield;
    long first = 0;
    for (long i = 0; i <= analysis->measures.uniform; i++)
        if (curve->plastic_strain[i] < first_strain) first = i;
    for (long i = yield->row; i >= 0 && i < yield->end; i++)
        if (curve->stress[i] <= (1 + transient_share) * yield->lower) return i > first ? i : first;
    return first;
}

static struct points points_of(const struct analysis *analysis)
{
    const struct curve *curve = &analysis->envelope;
    const double *p = curve->plastic_strain, *stress = curve->true_stress;
    const long last = analysis->measures.uniform;
    struct points points = {0};
    points.strain = memory_new((size_t)last + 1, sizeof(double));
    points.stress = memory_new((size_t)last + 1, sizeof(double));
    const long first = material_first_row(analysis);
    for (long i = first; i <= last; i++) {
        const double strain = i == first ? 0 : p[i];
        if (i > first && !(strain > points.strain[points.n - 1] && stress[i] > 0)) continue;
        points.strain[points.n] = strain;
        points.stress[points.n++] = stress[i];
    }
    return points;
}

/* Least squares under the condition that they do not fall: neighbours that do are put together
 * (pool adjacent violators). */
static void make_rising(struct points *points)
{
    double *sum = memory_new((size_t)points->n, sizeof *sum);
    long *weight = memory_new((size_t)points->n, sizeof *weight), blocks = 0;
    for (long i = 0; i < points->n; i++) {
        sum[blocks] = points->stress[i];
        weight[blocks++] = 1;
        while (blocks > 1 && sum[blocks - 2] / (double)weight[blocks - 2] >
                                 sum[blocks - 1] / (double)weight[blocks - 1]) {
            sum[blocks - 2] += sum[blocks - 1];
            weight[blocks - 2] += weight[blocks - 1];
            blocks--;
        }
    }
    for (long b = 0, i = 0; b < blocks; b++)
        for (long k = 0; k < weight[b]; k++) points->stress[i++] = sum[b] / (double)weight[b];
    free(sum);
    free(weight);
}

/* Keeps, between two kept points, the one farthest from their line if that is more than
 * tolerance, and goes on on both sides (Ramer 1972, Douglas and Peucker 1973). */
static void keep_farthest(const struct points *points, long from, long to, double tolerance,
                          bool keep[])
{
    long farthest = -1;
    double most = tolerance;
    for (long i = from + 1; i < to; i++) {
        const double share = (points->strain[i] - points->strain[from]) /
                             (points->strain[to] - points->strain[from]);
        const double off = fabs(points->stress[i] - points->stress[from] -
                                share * (points->stress[to] - points->stress[from]));
        if (off <= most) continue;
        most = off;
        farthest = i;
    }
    if (farthest < 0) return;
    keep[farthest] = true;
    keep_farthest(points, from, farthest, tolerance, keep);
    keep_farthest(points, farthest, to, tolerance, keep);
}

static const struct hardening_law *tabulated_law(void)
{
    const struct hardening_law *law;
    for (int i = 0; (law = hardening_law(i)); i++)
        if (strcmp(law->variant.name, "tabulated") == 0) return law;
    die_run("no tabulated law");
}

/* Without most of the noise of the curve, which tolerance covers. */
static struct hardening tabulate(struct points *points, struct noise noise, double strength)
{
    const double tolerance = fmax(thinning_share * strength, noise.deviation);
    struct hardening table = {.law = tabulated_law()};
    bool *keep = memory_new((size_t)points->n, sizeof *keep);
    if (noise.deviation > 0) noise_trend(points->strain, points->stress, points->n, noise);
    make_rising(points);
    keep[0] = keep[points->n - 1] = true;
    keep_farthest(points, 0, points->n - 1, tolerance, keep);
    table.strain = memory_new((size_t)points->n, sizeof(double));
    table.stress = memory_new((size_t)points->n, sizeof(double));
    for (long i = 0; i < points->n; i++) {
        if (!keep[i]) continue;
        table.strain[table.n_points] = points->strain[i];
        table.stress[table.n_points++] = points->stress[i];
    }
    free(keep);
    return table;
}

/* Of all rows, not only those that have become points. */
static double misfit(const struct hardening *law, const struct points *points)
{
    double squares = 0;
    for (long i = 1; i < points->n; i++) {
        const double off = hardening_stress(law, points->strain[i]) - points->stress[i];
        squares += off * off;
    }
    return sqrt(squares / (double)(points->n - 1));
}

/* The least AIC among the laws that will do; law NULL: none will. */
static struct law_fit best_law(const struct points *points, const char *name)
{
    struct law_fit best = {0};
    const struct hardening_law *law;
    for (int i = 0; (law = hardening_law(i)); i++) {
        if (law->n_linear == 0 || (name && strcmp(name, law->variant.name) != 0)) continue;
        struct law_fit fit = law_fit(law, points->strain + 1, points->stress + 1, points->n - 1);
        /* What only the deck has, the yield stress of Hollomon's law, is that of the first
         * point. */
        for (int k = law->n_linear + law->n_shapes; k < law->variant.keys.count; k++)
            fit.hardening.parameter[k] = points->stress[0];
        if (!fit.done || (law_fit_flag(&fit) && !name) || !hardening_allowed(&fit.hardening))
            continue;
        if (!best.hardening.law || fit.akaike < best.akaike) best = fit;
    }
    return best;
}

/* Whether the modulus is that of the measured rows, as they are. */
static bool is_slope(const struct analysis *analysis)
{
    const struct elastic_line *line = &analysis->measures.line;
    const bool corrected = line->flag && strcmp(line->flag, "machine_compliance_removed") == 0;
    return line->count > 0 && !corrected && analysis->measures.modulus == line->slope;
}

struct material material_make(const char *name, const struct curve *curve,
                              const struct analysis *analysis, const char *law)
{
    const double strength = analysis->measures.maximum.stress;
    const bool plateau = analysis->measures.yield.row >= 0,
               table = law && strcmp(law, "tabulated") == 0;
    struct points points = points_of(analysis);
    if (!(analysis->measures.modulus > 0))
        die_user("%s: no Young's modulus, as the curve has no elastic part; give --modulus",
                 curve->title);
    if (points.n <= FEWEST_POINTS)
        die_user(
            "%s: %ld rows of plastic strain up to maximum force are too few for a hardening law",
            curve->title, points.n - 1);
    struct material m = {.name = name,
                         .youngs_modulus = analysis->measures.modulus,
                         .is_slope = is_slope(analysis),
                         .count = points.n - 1,
                         .first = points.strain[1],
                         .last = points.strain[points.n - 1]};
    struct law_fit fit = table ? (struct law_fit){0} : best_law(&points, law);
    if (law && !table && !fit.hardening.law)
        die_user("%s: the law %s does not fit within the range of the deck", curve->title, law);
    m.root_mean_square = fit.hardening.law ? misfit(&fit.hardening, &points) : INFINITY;
    const bool poor = m.root_mean_square > misfit_share * strength;
    if (fit.hardening.law && (law || (!plateau && !poor))) {
        m.hardening = fit.hardening;
        m.reason = memory_text(law ? "as asked for" : "least AIC of the laws that the deck knows");
    } else {
        struct points rising = {points.n, points.strain,
                                memory_new((size_t)points.n, sizeof(double))};
        memcpy(rising.stress, points.stress, (size_t)points.n * sizeof(double));
        m.hardening = tabulate(&rising, analysis->noise, strength);
        free(rising.stress);
        m.root_mean_square = misfit(&m.hardening, &points);
        m.reason = memory_print("%s; not falling, thinned to %d points within %.3g %% of Rm",
                                table     ? "as asked for"
                                : plateau ? "no law has a yield plateau"
                                          : "no law is within 0.5 % of Rm",
                                m.hardening.n_points,
                                100 * fmax(thinning_share, analysis->noise.deviation / strength));
    }
    free(points.strain);
    free(points.stress);
    return m;
}

void material_free(struct material *material)
{
    hardening_free(&material->hardening);
    free(material->reason);
}

void material_print(FILE *file, const struct material *m, const struct curve *curve,
                    const char *model)
{
    const char *input = attributes_text(&curve->provenance, "input");
    const char *checksum = attributes_text(&curve->provenance, "input_cksum");
    fprintf(file, "# From %s (cksum %s).\n", input, checksum);
    fprintf(file, "# Law: %s.\n", m->reason);
    fprintf(file,
            "# Root mean square %.3g MPa over %ld rows, plastic strain %.3g to %.3g (maximum "
            "force); beyond it the law is an\n"
            "# extrapolation.\n",
            m->root_mean_square / 1e6, m->count, m->first, m->last);
    if (m->is_slope)
        fputs("# Young's modulus: the slope of the curve, which is the machine's, too, where no "
              "extensometer measured the strain:\n# --true-modulus takes that out.\n",
              file);
    fprintf(file,
            "materials:\n  %s:\n    model: %s\n    density: %.6g kg/m3\n    "
            "youngs_modulus: %.6g GPa\n"
            "    poissons_ratio: %.6g\n    hardening: ",
            m->name, model, m->density, m->youngs_modulus / 1e9, m->poissons_ratio);
    hardening_print(file, &m->hardening, "      ");
}
