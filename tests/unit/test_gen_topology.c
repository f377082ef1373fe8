/* The topology check: clusters, contact of cores, films, and what it advises. */
#include "check.h"

#include "fill.h"
#include "findings.h"
#include "memory.h"
#include "requirements.h"
#include "topology.h"

#include <stdlib.h>
#include <string.h>

/* A structure drawn by hand: '#' coarse, '.' fine, layer after layer; a core for each letter. */
struct drawing {
    struct sites sites;
    struct structure structure;
};

static bool anywhere(const void *specimen, int64_t site, const double point[3])
{
    (void)specimen, (void)site, (void)point;
    return true;
}

static const double cube[3] = {1, 1, 1};

static struct drawing draw(const int64_t count[3], const char *text)
{
    struct drawing drawing = {.sites = sites_new(count, cube, anywhere, NULL)};
    size_t n = (size_t)drawing.sites.n_nodes;
    assert_int_equal(strlen(text), n);
    struct structure *structure = &drawing.structure;
    structure->counted = memory_new(n, 1);
    structure->phase = memory_new(n, 1);
    structure->core = memory_new(n, sizeof *structure->core);
    for (size_t node = 0; node < n; node++) {
        structure->counted[node] = 1;
        structure->phase[node] = text[node] == '.' ? PHASE_UFG : PHASE_CG;
        structure->core[node] = text[node];
    }
    return drawing;
}

static void erase(struct drawing *drawing)
{
    structure_free(&drawing->structure);
    sites_free(&drawing->sites);
}

static void corners_join_26_neighbours_only(void **state)
{
    (void)state;
    const int64_t count[3] = {3, 3, 3};
    struct drawing drawing = draw(count, "a........"
                                         "....a...."
                                         "........a");
    drawing.structure.sites = &drawing.sites;
    struct clusters faces = clusters_find(&drawing.structure, PHASE_CG, NEIGHBOURS_6);
    struct clusters corners = clusters_find(&drawing.structure, PHASE_CG, NEIGHBOURS_26);
    assert_int_equal(faces.nodes, 3);
    assert_int_equal(faces.count, 3);
    assert_false(faces.percolates[0]);
    assert_int_equal(corners.count, 1);
    assert_int_equal(corners.largest, 3);
    assert_true(corners.percolates[0] && corners.percolates[1] && corners.percolates[2]);
    erase(&drawing);
}

static void percolation_is_found_along_each_axis(void **state)
{
    (void)state;
    const int64_t count[3] = {3, 3, 2};
    struct drawing drawing = draw(count, "..."
                                         "aaa"
                                         "..."
                                         "..."
                                         "a.."
                                         "...");
    drawing.structure.sites = &drawing.sites;
    struct clusters coarse = clusters_find(&drawing.structure, PHASE_CG, NEIGHBOURS_6);
    assert_true(coarse.percolates[0]);
    assert_false(coarse.percolates[1]);
    assert_true(coarse.percolates[2]);
    struct clusters fine = clusters_find(&drawing.structure, PHASE_UFG, NEIGHBOURS_6);
    assert_true(fine.percolates[1]);
    /* Outside the counted region nothing conducts. */
    for (int node = 0; node < 18; node++) drawing.structure.counted[node] = node % 3 > 0;
    coarse = clusters_find(&drawing.structure, PHASE_CG, NEIGHBOURS_6);
    assert_int_equal(coarse.nodes, 2);
    assert_true(coarse.percolates[0]);
    assert_false(coarse.percolates[2]);
    erase(&drawing);
}

static void films_are_measured_between_different_cores(void **state)
{
    (void)state;
    const int64_t count[3] = {4, 3, 1};
    const struct {
        const char *text;
        int64_t touching;
        double film;
    } cases[] = {
        {"ab..........", 1, 0},           /* a face */
        {"a....b......", 1, sqrt(2) - 1}, /* an edge */
        {"aa..........", 0, INFINITY},    /* one core */
        {"a.b.........", 0, 1},           /* one node between */
        {"a.....b.....", 0, sqrt(5) - 1}, /* a knight's move */
        {"a..b........", 0, 2},           /* two nodes between */
        {"a.........bb", 0, sqrt(8) - 1}, /* the nearest pair counts */
        {"a...bb......", 2, 0},           /* a face and an edge */
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct drawing drawing = draw(count, cases[c].text);
        drawing.structure.sites = &drawing.sites;
        struct contact contact = clusters_contact(&drawing.structure, 5);
        assert_int_equal(contact.touching, cases[c].touching);
        if (isinf(cases[c].film))
            assert_true(isinf(contact.film));
        else
            assert_near(contact.film, cases[c].film, 1e-12);
        erase(&drawing);
    }
}

/* A plate of 1 x 0.5 x 0.25 mm; cores as asked for. */
static char *fault_of(enum core_lattice lattice, enum core_shape shape, double distance,
                      double fraction, double spacing, struct findings *findings)
{
    struct recipe recipe = {
        .specimen = {.size = {1e-3, 5e-4, 2.5e-4}, .spacing = {spacing, spacing, spacing}},
        .topology = &topology_harmonic,
        .require = REQUIRE_UFG_CONNECTED | REQUIRE_CORES_APART,
        .grip_phase = -1,
        .n_phases = 2,
        .lattice = lattice,
        .shape = shape,
        .distance = distance,
        .ufg_fraction = fraction,
        .minimum_shell = 1,
        .seed = 1,
    };
    for (int axis = 0; axis < 3; axis++)
        recipe.specimen.count[axis] = (int64_t)llround(recipe.specimen.size[axis] / spacing);
    struct sites sites = fill_sites(&recipe.specimen);
    struct cores cores = recipe.topology->place(&recipe);
    struct structure structure = structure_new(&recipe, &sites, &cores);
    *findings = findings_of(&recipe, &structure, &cores);
    char *fault = recipe.topology->fault(&recipe, findings);
    structure_free(&structure);
    cores_free(&cores);
    sites_free(&sites);
    return fault;
}

static void resolved_cells_pass(void **state)
{
    (void)state;
    struct findings findings;
    assert_null(fault_of(LATTICE_FCC, CORE_CELL, 2.5e-4, 0.4, 1.25e-5, &findings));
    assert_int_equal(findings.contact.touching, 0);
    assert_true(findings.contact.film >= 1);
    assert_int_equal(findings.ufg.count, 1);
    /* (1 - cbrt(0.6)) of the distance for the infinite lattice; the plate cuts cells, which moves
     * the share of shell in it: 10 %. */
    assert_relative(findings.core_film, (1 - cbrt(0.6)) * 2.5e-4, 0.1);
}

/* The advice is kept: at the spacing that is said to do, it does. */
static void unresolved_cells_are_told_the_spacing(void **state)
{
    (void)state;
    struct findings findings;
    char *fault = fault_of(LATTICE_FCC, CORE_CELL, 1.25e-4, 0.4, 2.5e-5, &findings);
    assert_non_null(fault);
    const char *number = strstr(fault, "below ");
    assert_non_null(number);
    double needed = 1e-6 * strtod(number + strlen("below "), NULL);
    assert_near(needed, findings.core_film / sqrt(3), 1e-8);
    double spacing = 2.5e-5 / ceil(2.5e-5 / needed);
    free(fault);
    assert_null(fault_of(LATTICE_FCC, CORE_CELL, 1.25e-4, 0.4, spacing, &findings));
}

/* Body-centred spheres at 40 % fine: the film is 0.0427 diameters in the infinite lattice, of which
 * the plate holds 4 x 2 x 1 cells of 10 spacings; far below a spacing.  On a lattice this coarse
 * the diameter is known to half a spacing. */
static void spheres_of_a_coarse_lattice_fail(void **state)
{
    (void)state;
    struct findings findings;
    char *fault = fault_of(LATTICE_BCC, CORE_SPHERE, sqrt(3) * 1.25e-4, 0.4, 2.5e-5, &findings);
    assert_non_null(fault);
    assert_non_null(strstr(fault, "different cores touch"));
    assert_true(findings.contact.touching > 0);
    assert_near(findings.core_film, 0.0427 / 1.0427 * sqrt(3) * 1.25e-4, 1.25e-5);
    free(fault);
}

/* At 20 % the spheres themselves overlap: no spacing helps, and the message says so. */
static void overlapping_spheres_have_no_remedy(void **state)
{
    (void)state;
    struct findings findings;
    char *fault = fault_of(LATTICE_BCC, CORE_SPHERE, sqrt(3) * 1e-4, 0.2, 1e-5, &findings);
    assert_non_null(fault);
    assert_true(findings.core_film < 0);
    assert_non_null(strstr(fault, "no spacing helps"));
    free(fault);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_join_26_neighbours_only),
        cmocka_unit_test(percolation_is_found_along_each_axis),
        cmocka_unit_test(films_are_measured_between_different_cores),
        cmocka_unit_test(resolved_cells_pass),
        cmocka_unit_test(unresolved_cells_are_told_the_spacing),
        cmocka_unit_test(spheres_of_a_coarse_lattice_fail),
        cmocka_unit_test(overlapping_spheres_have_no_remedy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
