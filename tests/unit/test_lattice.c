/* Lattices recognised in particles of any order, and the order of those that are none. */
#include "dies.h"

#include "domain_order.h"
#include "lattice.h"
#include "memory.h"
#include "random.h"

#include <stdlib.h>

static const double spacing = 25e-6;

static const char *const names[] = {"CG", "UFG"};

/* Puts it in order; whether it is a lattice. */
static bool sorted(struct domain *domain)
{
    struct lattice lattice = {0};
    const bool found = domain_sort(domain, &lattice);
    lattice_free(&lattice);
    return found;
}

/* Node i goes where the node order[i] was. */
static void shuffle(struct domain *domain, long seed)
{
    struct random_stream *stream = random_new(seed, "test");
    double *const values[] = {domain->x, domain->y, domain->z, domain->volume};
    for (int64_t i = domain->n_nodes - 1; i > 0; i--) {
        int64_t j = (int64_t)random_integer(stream, (uint64_t)i + 1);
        for (int v = 0; v < 4; v++) {
            double kept = values[v][i];
            values[v][i] = values[v][j];
            values[v][j] = kept;
        }
        uint8_t phase = domain->phase[i];
        domain->phase[i] = domain->phase[j];
        domain->phase[j] = phase;
    }
    random_free(stream);
}

/* x fastest; the upper half along x is of phase 1. */
static struct domain block(int nx, int ny, int nz, double volume)
{
    struct domain domain = domain_new((int64_t)nx * ny * nz, 2, names);
    for (int64_t i = 0; i < domain.n_nodes; i++) {
        domain.x[i] = ((double)(i % nx) - 0.5 * (nx - 1)) * spacing;
        domain.y[i] = ((double)(i / nx % ny) - 0.5 * (ny - 1)) * spacing;
        domain.z[i] = ((double)(i / nx / ny) - 0.5 * (nz - 1)) * spacing;
        domain.volume[i] = volume;
        domain.phase[i] = i % nx >= nx / 2;
    }
    return domain;
}

/* Independent uniform points with unequal volumes. */
static struct domain cloud(int64_t count, long seed)
{
    struct domain domain = domain_new(count, 2, names);
    struct random_stream *stream = random_new(seed, "cloud");
    for (int64_t i = 0; i < count; i++) {
        domain.x[i] = 1e-3 * random_uniform(stream);
        domain.y[i] = 0.5e-3 * random_uniform(stream);
        domain.z[i] = 0.2e-3 * random_uniform(stream);
        domain.volume[i] = 1e-10 / (double)count * (0.5 + random_uniform(stream));
        domain.phase[i] = domain.x[i] > 0.5e-3;
    }
    random_free(stream);
    return domain;
}

/* The nodes of phase 1 as a set. */
static void add_set(struct domain *domain)
{
    int64_t *nodes = memory_new((size_t)domain->n_nodes, sizeof *nodes), count = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++)
        if (domain->phase[i] == 1) nodes[count++] = i;
    domain_add_set(domain, "upper", count, nodes);
    free(nodes);
}

static void expect_set_followed(const struct domain *domain)
{
    const struct node_set *set = domain_set(domain, "upper");
    int64_t members = 0;
    for (int64_t i = 0; i < domain->n_nodes; i++) members += domain->phase[i];
    assert_int_equal(set->count, members);
    for (int64_t i = 0; i < set->count; i++) {
        assert_int_equal(domain->phase[set->nodes[i]], 1);
        if (i > 0) assert_true(set->nodes[i] > set->nodes[i - 1]);
    }
}

/* The spacing comes from the volume within rounding (a cube root, 1e-15), exactly from the
 * attribute. */
static void shuffled_lattices_are_found(void **state)
{
    (void)state;
    for (int given = 0; given < 2; given++) {
        struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
        if (given) attributes_set_number(&domain.attributes, "spacing_m", spacing);
        shuffle(&domain, 3);
        struct lattice lattice;
        assert_true(lattice_recognise(&domain, &lattice));
        assert_int_equal(lattice.dimensions, 3);
        assert_int_equal(lattice.n_sites, 7 * 5 * 3);
        assert_int_equal(lattice.n_nodes, 7 * 5 * 3);
        assert_relative(lattice.spacing, spacing, given ? 0 : 1e-15);
        assert_relative(lattice.node_volume, spacing * spacing * spacing, 1e-14);
        for (int64_t s = 0; s < lattice.n_sites; s++)
            assert_int_equal(lattice.phase[s], s % 7 >= 3);
        lattice_free(&lattice);
        domain_free(&domain);
    }
}

static void sorting_makes_lattice_order(void **state)
{
    (void)state;
    struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
    struct domain wanted = block(7, 5, 3, spacing * spacing * spacing);
    shuffle(&domain, 3);
    add_set(&domain);
    assert_true(sorted(&domain));
    const size_t bytes = (size_t)domain.n_nodes * sizeof(double);
    assert_memory_equal(domain.x, wanted.x, bytes);
    assert_memory_equal(domain.y, wanted.y, bytes);
    assert_memory_equal(domain.z, wanted.z, bytes);
    expect_set_followed(&domain);
    struct lattice lattice;
    assert_true(lattice_recognise(&domain, &lattice));
    assert_relative(attributes_number(&domain.attributes, "spacing_m", 0), spacing, 1e-15);
    lattice_free(&lattice);
    domain_free(&domain);
    domain_free(&wanted);
}

/* A layer: thickness said, or from the volume; a third of these volumes is (spacing / 2)^3, which
 * as a lattice of three dimensions would have seven sites of eight empty.  Rounding of the spacing
 * and thickness 1e-14. */
static void sheets_are_found(void **state)
{
    static const double thicknesses[] = {1, 2e-6, 25e-6 / 8};
    (void)state;
    for (int said = 0; said < 2; said++)
        for (int i = 0; i < 3; i++) {
            const double h = thicknesses[i];
            struct domain domain = block(9, 4, 1, spacing * spacing * h);
            if (said) {
                attributes_set_number(&domain.attributes, "spacing_m", spacing);
                attributes_set_number(&domain.attributes, "dimensions", 2);
                attributes_set_number(&domain.attributes, "thickness_m", h);
            }
            shuffle(&domain, 5);
            struct lattice lattice;
            assert_true(lattice_recognise(&domain, &lattice));
            assert_int_equal(lattice.dimensions, 2);
            assert_int_equal(lattice.n_sites, 36);
            assert_relative(lattice.spacing, spacing, 1e-14);
            assert_relative(lattice.thickness, h, 1e-14);
            assert_relative(lattice.node_volume, spacing * spacing * h, 1e-14);
            lattice_free(&lattice);
            assert_true(sorted(&domain));
            assert_true(attributes_number(&domain.attributes, "dimensions", 0) == 2);
            assert_relative(attributes_number(&domain.attributes, "thickness_m", 0), h, 1e-14);
            domain_free(&domain);
        }
}

/* One layer of cubes is a body of three dimensions unless it says otherwise; so is a row or a
 * single node. */
static void layers_of_cubes_are_bodies(void **state)
{
    static const int sizes[][2] = {{9, 4}, {9, 1}, {1, 4}, {1, 1}};
    (void)state;
    for (int i = 0; i < 4; i++)
        for (int said = 0; said < 2; said++) {
            struct domain domain = block(sizes[i][0], sizes[i][1], 1, spacing * spacing * spacing);
            if (said) attributes_set_number(&domain.attributes, "dimensions", 2);
            struct lattice lattice;
            assert_true(lattice_recognise(&domain, &lattice));
            assert_int_equal(lattice.dimensions, said ? 2 : 3);
            assert_relative(lattice.spacing, spacing, 1e-14);
            assert_true(said || lattice.thickness == 0);
            lattice_free(&lattice);
            domain_free(&domain);
        }
}

static void others_are_no_lattices(void **state)
{
    (void)state;
    struct lattice lattice;
    struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
    domain.x[40] += 1e-4 * spacing;
    assert_false(lattice_recognise(&domain, &lattice));
    assert_null(lattice.phase);
    domain.x[40] -= 1e-4 * spacing;
    domain.volume[40] *= 1 + 1e-5;
    assert_false(lattice_recognise(&domain, &lattice));
    domain_free(&domain);
    domain = cloud(500, 1);
    assert_false(lattice_recognise(&domain, &lattice));
    for (int64_t i = 0; i < domain.n_nodes; i++) domain.z[i] = 0.1;
    assert_false(lattice_recognise(&domain, &lattice));
    domain_free(&domain);
    /* Most of the box empty. */
    domain = block(2, 1, 1, spacing * spacing * spacing);
    domain.x[1] = domain.y[1] = domain.z[1] = 1000 * spacing;
    assert_false(lattice_recognise(&domain, &lattice));
    domain_free(&domain);
}

/* Whatever the order in the file, the same order comes out, and neighbours in it are near in space:
 * the mean step is a few of the mean distances (1.4 measured; at random it were 15). */
static void scattered_nodes_have_one_order(void **state)
{
    (void)state;
    struct domain first = cloud(5000, 2), second = cloud(5000, 2);
    shuffle(&second, 7);
    add_set(&first);
    add_set(&second);
    assert_false(sorted(&first));
    assert_false(sorted(&second));
    const size_t bytes = (size_t)first.n_nodes * sizeof(double);
    assert_memory_equal(first.x, second.x, bytes);
    assert_memory_equal(first.y, second.y, bytes);
    assert_memory_equal(first.z, second.z, bytes);
    assert_memory_equal(first.volume, second.volume, bytes);
    expect_set_followed(&first);
    expect_set_followed(&second);
    double mean = 0, volume = 0;
    for (int64_t i = 0; i < first.n_nodes; i++) volume += first.volume[i];
    for (int64_t i = 1; i < first.n_nodes; i++)
        mean += sqrt(pow(first.x[i] - first.x[i - 1], 2) + pow(first.y[i] - first.y[i - 1], 2) +
                     pow(first.z[i] - first.z[i - 1], 2)) /
                (double)(first.n_nodes - 1);
    double distance = attributes_number(&first.attributes, "mean_spacing_m", 0);
    assert_relative(distance, cbrt(volume / 5000), 1e-12);
    assert_true(mean < 3 * distance);
    domain_free(&first);
    domain_free(&second);
}

static void try_sort(const void *domain)
{
    struct domain copy = *(const struct domain *)domain;
    sorted(&copy);
}

static void coincident_nodes_are_refused(void **state)
{
    (void)state;
    struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
    domain.x[60] = domain.x[20];
    domain.y[60] = domain.y[20];
    domain.z[60] = domain.z[20] + 1e-9 * spacing;
    assert_dies(EXIT_USER, "node 61 at (", try_sort, &domain);
    assert_dies(EXIT_USER, "m lies on another node, 21", try_sort, &domain);
    domain_free(&domain);
    domain = cloud(5000, 3);
    domain.x[4000] = domain.x[17];
    domain.y[4000] = domain.y[17];
    domain.z[4000] = domain.z[17];
    assert_dies(EXIT_USER, "node 4001 at (", try_sort, &domain);
    assert_dies(EXIT_USER, "m lies on another node, 18", try_sort, &domain);
    domain_free(&domain);
    /* A grid of unequal volumes shares its coordinates, but no two nodes. */
    domain = block(30, 30, 30, spacing * spacing * spacing);
    domain.volume[5] *= 2;
    assert_false(sorted(&domain));
    domain_free(&domain);
}

static void sheets_lie_in_one_plane(void **state)
{
    (void)state;
    struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
    attributes_set_number(&domain.attributes, "dimensions", 2);
    assert_dies(EXIT_USER, "the domain has two dimensions", try_sort, &domain);
    domain_free(&domain);
}

static void what_does_not_fit_is_no_lattice(void **state)
{
    (void)state;
    struct domain domain = block(7, 5, 3, spacing * spacing * spacing);
    struct lattice lattice;
    domain.volume[8] *= 2;
    assert_false(lattice_recognise(&domain, &lattice));
    domain.volume[8] /= 2;
    domain.y[9] += 0.1 * spacing;
    assert_false(lattice_recognise(&domain, &lattice));
    domain.y[9] -= 0.1 * spacing;
    assert_true(lattice_recognise(&domain, &lattice));
    lattice_free(&lattice);
    domain_free(&domain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shuffled_lattices_are_found),
        cmocka_unit_test(sorting_makes_lattice_order),
        cmocka_unit_test(sheets_are_found),
        cmocka_unit_test(layers_of_cubes_are_bodies),
        cmocka_unit_test(others_are_no_lattices),
        cmocka_unit_test(scattered_nodes_have_one_order),
        cmocka_unit_test(coincident_nodes_are_refused),
        cmocka_unit_test(sheets_lie_in_one_plane),
        cmocka_unit_test(what_does_not_fit_is_no_lattice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
