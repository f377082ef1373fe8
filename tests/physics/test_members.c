/* Members: node numbers become sites of the body, holes counted out. */
#include "check.h"

#include "members.h"
#include "small_body.h"

/* A box without every fifth site. */
static uint8_t with_holes(const int size[3], const int at[3])
{
    return ((at[2] * size[1] + at[1]) * size[0] + at[0]) % 5 == 3 ? ABSENT : 0;
}

static void test_nodes_become_sites(void **state)
{
    (void)state;
    struct small_body small;
    enum { NODES = 4 };
    /* Sites 3, 8, 13, ... are missing: node 4 a + b is site 5 a + b, or 5 a + 4 for b = 3. */
    const int64_t nodes[NODES] = {0, 3, 10, 33};
    const int at[NODES][3] = {{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {6, 2, 1}};
    small_body_new(&small, &(struct small_case){.size = {7, 3, 2},
                                                .horizon = 1,
                                                .stabilisation = small_mix,
                                                .materials = small_elastic,
                                                .phase = with_holes});
    struct members members = members_of_nodes(&small.body, nodes, NODES);
    assert_int_equal(members.n_all, NODES);
    assert_int_equal(members.count, NODES);
    double sum = 0;
    for (int i = 0; i < NODES; i++) {
        int found[3];
        small_body_position(&small, members.sites[i], found);
        assert_memory_equal(found, at[i], sizeof found);
        sum += at[i][0] * SMALL_SPACING;
    }
    assert_true(members.low == 0 && members.high == 6 * SMALL_SPACING);
    assert_relative(members.mean, sum / NODES, 1e-15); /* a few roundings */
    members_free(&members);
    small_body_free(&small);
}

/* A set of the domain gives the same as its nodes. */
static void test_sets_are_nodes(void **state)
{
    (void)state;
    struct small_body small;
    struct domain domain = {0};
    const int64_t nodes[] = {1, 2, 30};
    domain_add_set(&domain, "some", 3, nodes);
    small_body_new(&small, &(struct small_case){.size = {7, 3, 2},
                                                .horizon = 1,
                                                .stabilisation = small_mix,
                                                .materials = small_elastic,
                                                .phase = with_holes});
    struct members a = members_of_nodes(&small.body, nodes, 3),
                   b = members_new(&small.body, &domain, "some");
    assert_int_equal(a.count, b.count);
    assert_memory_equal(a.sites, b.sites, 3 * sizeof *a.sites);
    members_free(&a);
    members_free(&b);
    small_body_free(&small);
    domain_free(&domain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nodes_become_sites),
        cmocka_unit_test(test_sets_are_nodes),
    };
    return cmocka_run_group_tests(tests, small_ranks_start, small_ranks_stop);
}
