/* Sheets: one layer of nodes whose thickness has nothing to do with the spacing. */
#include "made.h"

#include "outline.h"

static const char homogeneous[] = "topology: homogeneous, phase: CG";

/* A study's domain section in one line; size is that in the deck. */
struct sheet_case {
    const char *specimen, *size, *structure;
};

static struct deck *sheet_deck(const struct sheet_case *wanted)
{
    char *keys = memory_print(
        "dimensions: 2, spacing: 10 um, size: %s, %s, grips: {length: 50 um, "
        "phase: structure}, sets: [{name: middle, box: [[-20 um, -20 um, -1 nm], [20 um, 20 um, 1 "
        "nm]]}]",
        wanted->size, wanted->structure);
    struct deck *deck = domain_deck(wanted->specimen, keys);
    free(keys);
    return deck;
}

static struct made *make(const char *specimen, const char *size, const char *structure)
{
    return made_with_domain(sheet_deck(&(struct sheet_case){specimen, size, structure}));
}

/* One layer in z = 0, volumes that sum to the body's to rounding (1e-12 of it), facts in the file.
 */
static void plates_have_their_thickness(void **state)
{
    static const double thicknesses[] = {1, 1e-5, 3.7e-6};
    (void)state;
    for (int i = 0; i < 3; i++) {
        char *size = memory_print("[0.6 mm, 0.3 mm, %.17g m]", thicknesses[i]);
        char *gauge = memory_print("%s, gauge: {length: 0.2 mm}", homogeneous);
        struct made *sheet = make("plate", size, gauge);
        const struct domain *domain = &sheet->domain;
        double sum = 0, h = thicknesses[i];
        assert_int_equal(domain->n_nodes, 60 * 30);
        for (int64_t n = 0; n < domain->n_nodes; n++) {
            sum += domain->volume[n];
            assert_true(domain->z[n] == 0);
        }
        assert_relative(sum, 0.6e-3 * 0.3e-3 * h, 1e-12);
        assert_true(attributes_number(&domain->attributes, "dimensions", 0) == 2);
        assert_true(attributes_number(&domain->attributes, "thickness_m", 0) == h);
        assert_relative(attributes_number(&domain->attributes, "section_m2", 0), 0.3e-3 * h, 1e-12);
        assert_int_equal(domain_set(domain, "grip_left")->count, 5 * 30);
        assert_int_equal(domain_set(domain, "gauge_right")->count, 30);
        assert_int_equal(domain_set(domain, "middle")->count, 16);
        made_free(sheet);
        free(gauge);
        free(size);
    }
}

/* In three dimensions the facts of a sheet are not in the file. */
static void bodies_are_no_sheets(void **state)
{
    (void)state;
    struct deck *deck = domain_deck("plate", "size: [4, 4, 1], spacing: 1, topology: "
                                             "homogeneous, phase: CG, dimensions: 3");
    struct recipe recipe = recipe_read(deck);
    assert_false(specimen_is_sheet(&recipe.specimen));
    assert_true(specimen_node_volume(&recipe.specimen) == 1);
    deck_free(deck);
}

/* The outline is that of the body: as many nodes as one of its layers has. */
static void dogbones_are_cut_alike(void **state)
{
    (void)state;
    char *structure =
        memory_print("%s, gauge: {length: 0.3 mm, width: 0.1 mm, fillet: 0.12 mm}", homogeneous);
    struct made *sheet = make("dogbone", "[0.8 mm, 0.2 mm, 1 mm]", structure);
    struct specimen body = sheet->recipe.specimen;
    body.dimensions = 3;
    body.count[2] = 4;
    body.size[2] = 40e-6;
    struct sites sites = fill_sites(&body);
    assert_int_equal(4 * sheet->sites.n_nodes, sites.n_nodes);
    /* 0.1 mm of width, 10 rows, over 1 mm; the layers of the gauge planes, which lie half a spacing
     * beyond it, are within the outline's first 0.1 um of fillet. */
    assert_relative(outline_section(&sheet->recipe.specimen, &sheet->sites), 1e-7, 1e-12);
    sites_free(&sites);
    made_free(sheet);
    free(structure);
}

/* Circles on a square lattice, d apart, of the fraction 1 - phi_U: radius R = sqrt(0.6 / pi) d,
 * interface 2 pi R / d^2.  A body of 3 x 3 whole cells outside the grips, so that no circle is cut.
 * The squares of a circle's nodes reach sqrt(1/2) h beyond it and fall short of it by as much at
 * most (Gauss), 7.1 um, which bounds the distance of the outermost node.  A pair of nodes needs
 * both, which makes n pairs n - 1 and crossings per length that much more: 1/240 along an axis,
 * twice that along a diagonal, of which there are as many: 0.6 % in all.  A circle of 70 nodes is
 * no circle: 1 % is allowed beyond that. */
static void circles_have_their_interface(void **state)
{
    (void)state;
    const char structure[] = "topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: sc, core: "
                             "sphere, core_distance: 800 um, ufg_fraction: 0.4";
    struct made *sheet = make("plate", "[2.5 mm, 2.4 mm, 1 m]", structure);
    double radius = sqrt(0.6 / M_PI) * 800e-6, exact = 2 * M_PI * radius / (800e-6 * 800e-6);
    struct interface interface = statistics_interface(&sheet->structure, true);
    assert_near(sheet->findings.reach, radius, 7.1e-6);
    assert_relative(interface.crofton, exact * (1 + 1.5 / 240), 0.01);
    assert_relative(interface.faces, 4 / M_PI * exact * (1 + 1.0 / 240), 0.01);
    assert_null(sheet->recipe.topology->fault(&sheet->recipe, &sheet->findings));
    made_free(sheet);
}

/* Cells of fcc cut through their centres are squares on the diagonals, d wide, that leave a shell
 * of d (1 - sqrt(phi_C)) = 22.5 um at d = 100 um; rank selection moves it by less than a spacing's
 * share, measured 1.3 um. */
static void cells_of_fcc_are_squares(void **state)
{
    (void)state;
    const char structure[] = "topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: fcc, "
                             "core_distance: 100 um, ufg_fraction: 0.4";
    struct made *sheet = make("plate", "[1.6 mm, 0.4 mm, 3 um]", structure);
    assert_near(sheet->findings.core_film, 100e-6 * (1 - sqrt(0.6)), 2e-6);
    assert_null(sheet->recipe.topology->fault(&sheet->recipe, &sheet->findings));
    /* The thickness says nothing about the structure. */
    struct made *thick = make("plate", "[1.6 mm, 0.4 mm, 1 m]", structure);
    assert_memory_equal(sheet->structure.phase, thick->structure.phase,
                        (size_t)sheet->sites.n_nodes);
    made_free(sheet);
    made_free(thick);
}

/* In a plane no two phases connect opposite sides both ways, so it is not asked for. */
static void random_sections_are_taken(void **state)
{
    static const char *const cores[] = {"core_distance: 60 um",
                                        "core: sphere, core_diameter: 60 um"};
    (void)state;
    for (int i = 0; i < 2; i++) {
        char *structure = memory_print("topology: random, phases: {cg: CG, ufg: UFG}, %s, "
                                       "ufg_fraction: 0.4",
                                       cores[i]);
        struct made *sheet = make("plate", "[1 mm, 0.4 mm, 1 m]", structure);
        assert_null(sheet->recipe.topology->fault(&sheet->recipe, &sheet->findings));
        /* Of 3600 counted nodes. */
        assert_near(sheet->findings.ufg_fraction, 0.4, 0.5 / 3600);
        made_free(sheet);
        free(structure);
    }
}

static void try_recipe(const void *wanted)
{
    recipe_read(sheet_deck(wanted));
}

static void what_cannot_be_is_told(void **state)
{
    (void)state;
    struct sheet_case bcc = {"plate", "[1 mm, 0.4 mm, 1 m]",
                             "topology: harmonic, phases: {cg: CG, ufg: UFG}, lattice: bcc, "
                             "core_distance: 100 um, ufg_fraction: 0.4"};
    assert_dies(EXIT_USER, "in two dimensions the cores lie on sc or fcc", try_recipe, &bcc);
    struct sheet_case thin = {"plate", "[1 mm, 0.4 mm, 0]", homogeneous};
    assert_dies(EXIT_USER, "0 m is out of range", try_recipe, &thin);
    struct sheet_case ragged = {"plate", "[1 mm, 0.405 mm, 1 m]", homogeneous};
    assert_dies(EXIT_USER, "the lattice fills the size exactly", try_recipe, &ragged);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plates_have_their_thickness),
        cmocka_unit_test(bodies_are_no_sheets),
        cmocka_unit_test(dogbones_are_cut_alike),
        cmocka_unit_test(circles_have_their_interface),
        cmocka_unit_test(cells_of_fcc_are_squares),
        cmocka_unit_test(random_sections_are_taken),
        cmocka_unit_test(what_cannot_be_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
