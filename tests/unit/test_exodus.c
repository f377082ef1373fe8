#include "check.h"

#include "exodus.h"
#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct domain small_domain(void)
{
    enum { NODES = 24 };
    static const int64_t left[] = {0, 4, 8, 12, 16, 20}, right[] = {3, 7, 11, 15, 19, 23};
    struct domain domain = {.n_nodes = NODES, .n_phases = 2};
    domain.x = memory_new(NODES, sizeof(double));
    domain.y = memory_new(NODES, sizeof(double));
    domain.z = memory_new(NODES, sizeof(double));
    domain.volume = memory_new(NODES, sizeof(double));
    domain.phase = memory_new(NODES, 1);
    for (int i = 0; i < NODES; i++) {
        domain.x[i] = 25e-6 * (i % 4);
        domain.y[i] = 25e-6 * (i / 4 % 3);
        domain.z[i] = 25e-6 * (i / 12);
        domain.volume[i] = (1 + i) * 1e-15;
        domain.phase[i] = i % 3 == 0;
    }
    domain.phase_names = memory_new(2, sizeof(char *));
    domain.phase_names[0] = memory_text("CG");
    domain.phase_names[1] = memory_text("a_phase_with_a_rather_long_name_of_more_than_32_characters");
    domain_add_set(&domain, "grip_left", 6, left);
    domain_add_set(&domain, "nobody", 0, NULL);
    domain_add_set(&domain, "grip_right", 6, right);
    attributes_set_number(&domain.attributes, "spacing_m", 25e-6);
    attributes_set_text(&domain.attributes, "deck", "title: é\n# \"quoted\"\n");
    attributes_set_text(&domain.attributes, "empty", "");
    return domain;
}

static void test_domain_comes_back(void **state)
{
    (void)state;
    struct domain written = small_domain();
    struct spool output = spool_output("/tmp/t.g");
    exodus_write_domain(&output, &written);
    spool_finish(&output);
    struct spool input = spool_input("/tmp/t.g");
    struct domain read = exodus_read_domain(&input);
    spool_close(&input);
    assert_int_equal(read.n_nodes, written.n_nodes);
    assert_memory_equal(read.x, written.x, 24 * sizeof(double));
    assert_memory_equal(read.volume, written.volume, 24 * sizeof(double));
    assert_memory_equal(read.phase, written.phase, 24);
    assert_string_equal(attributes_text(&read.attributes, "deck"), attributes_text(&written.attributes, "deck"));
    assert_int_equal(read.n_sets, 3);
    assert_memory_equal(domain_set(&read, "grip_right")->nodes, written.sets[2].nodes, 48);
    domain_free(&written);
    domain_free(&read);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_domain_comes_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
