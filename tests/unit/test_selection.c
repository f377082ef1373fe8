/* Selections: sets, blocks, boxes and expressions of a small domain counted by hand. */
#include "dies.h"

#include "memory.h"
#include "selection.h"

#include <stdlib.h>

enum { SIZE = 4, NODES = SIZE * SIZE * SIZE };
static const double spacing =
    0.1; /* not a binary fraction: corners meet nodes only within rounding */

/* 4 x 4 x 4 nodes at -0.15 ... 0.15 m; z < 0 is phase A, the others B; C has none. */
static struct domain cube(void)
{
    static const char *const names[] = {"A", "B", "C"};
    static const int64_t corners[] = {0, NODES - 1};
    struct domain domain = domain_new(NODES, 3, names);
    for (int i = 0; i < NODES; i++) {
        domain.x[i] = (i % SIZE - 1.5) * spacing;
        domain.y[i] = (i / SIZE % SIZE - 1.5) * spacing;
        domain.z[i] = (i / (SIZE * SIZE) - 1.5) * spacing;
        domain.phase[i] = domain.z[i] > 0;
    }
    domain_add_set(&domain, "corners", 2, corners);
    domain_add_set(&domain, "nothing", 0, NULL);
    return domain;
}

static struct deck *deck_of(const char *text)
{
    char *line = memory_print("{%s}", text);
    struct deck *deck = deck_parse(line, strlen(line), "study.yaml");
    free(line);
    return deck;
}

static struct selection read_selection(struct deck_node map)
{
    static const struct key keys[] = {SELECTION_KEYS(0)};
    struct deck_node selector[SELECTORS];
    for (int k = 0; k < SELECTORS; k++) selector[k] = deck_find(map, keys[k].name);
    return selection_read(map, selector);
}

/* The caller frees the result. */
static int64_t *select_nodes(const char *text, int64_t *count)
{
    struct domain domain = cube();
    struct deck *deck = deck_of(text);
    struct selection selection = read_selection(deck_root(deck));
    int64_t *nodes = selection_nodes(&selection, &domain, spacing, count);
    for (int64_t i = 1; i < *count; i++) assert_true(nodes[i] > nodes[i - 1]);
    selection_free(&selection);
    deck_free(deck);
    domain_free(&domain);
    return nodes;
}

static void test_counts(void **state)
{
    static const struct {
        const char *text;
        int64_t count, first, last;
    } cases[] = {
        {"set: corners", 2, 0, 63},
        {"block: A", 32, 0, 31},
        {"block: B, velocity: 1", 32, 32, 63},
        {"box: [[-1, -1, -1], [1, 1, 1]]", 64, 0, 63},
        {"box: [[-15 cm, -15 cm, -15 cm], [-15 cm, 15 cm, 15 cm]]", 16, 0, 60},
        {"box: [[-0.15, -0.15, -0.15], [-0.05, -0.05, -0.05]]", 8, 0, 21},
        {"box: [[-1.5 spacings, 0, 0], [-0.5 spacings, 1 spacings, 1]]", 4, 40, 57},
        {"box: [[0, 0], [1, 1]]", 16, 10, 63},
        {"box: [[0.05, 0.05, 0.05], [0.05, 0.05, 0.05]]", 1, 42, 42},
        {"where: x < 0", 32, 0, 61},
        {"where: \"x > 0.1 && y < -0.1 || z > 1\"", 4, 3, 51},
        {"where: x*y*z", 64, 0, 63},
        {"where: \"hypot(x, y) < 0.1\"", 16, 5, 58},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int64_t count, *nodes = select_nodes(cases[i].text, &count);
        if (count != cases[i].count || nodes[0] != cases[i].first ||
            nodes[count - 1] != cases[i].last)
            fail_msg("%s: %lld nodes, %lld ... %lld", cases[i].text, (long long)count,
                     (long long)nodes[0], (long long)nodes[count - 1]);
        free(nodes);
    }
}

static void test_names(void **state)
{
    static const char *const texts[] = {"set: corners", "block: A", "where: x < 0",
                                        "box: [[0, 0], [1, 1]]"};
    static const char *const names[] = {"set corners", "block A", "where x < 0", "box"};
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct deck *deck = deck_of(texts[i]);
        struct selection selection = read_selection(deck_root(deck));
        char *name = selection_name(&selection);
        assert_string_equal(name, names[i]);
        free(name);
        selection_free(&selection);
        deck_free(deck);
    }
}

static void select_only(const void *text)
{
    int64_t count;
    free(select_nodes(text, &count));
}

static void test_mistakes(void **state)
{
    static const char *const extent =
        "the nodes are at x = -0.15 to 0.15 m, y = -0.15 to 0.15 m, z = -0.15 to 0.15 m";
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"velocity: 1",
         "study.yaml:1:1: which nodes? Expected exactly one of: set, block, box, where"},
        {"set: corners, where: x", "study.yaml:1:23: 'where' beside 'set', expected exactly one"},
        {"set: corner",
         "study.yaml:1:7: no node set 'corner' in the domain, which has: corners, nothing"},
        {"set: nothing", "node set 'nothing' is empty"},
        {"set: [corners]", "expected a single value"},
        {"block: D", "no block 'D' in the domain, which has: A, B, C"},
        {"block: C", "no node is in block 'C'"},
        {"box: 1", "a box is two corners"},
        {"box: [[0, 0, 0]]", "a box is two corners"},
        {"box: [[0, 0, 0], [1, 1]]", "a box is two corners"},
        {"box: [[0, 0, 0, 0], [1, 1, 1, 1]]", "a box is two corners"},
        {"box: [[0, 0, 0 s], [1, 1, 1]]", "study.yaml:1:15: 's' is a time, expected a length in m"},
        {"box: [[0, 1, 0], [1, 0, 1]]",
         "study.yaml:1:23: the second corner's y, 0 m, is below the"},
        {"box: [[1, 1, 1], [2, 2, 2]]", extent},
        {"box: [[0.01, 0.01, 0.01], [0.02, 0.02, 0.02]]",
         "study.yaml:1:7: no node lies in this box"},
        {"where: x > 1", "study.yaml:1:9: expression 'x > 1' holds at no node"},
        {"where: x > 1", extent},
        {"where: x < t", "unknown name 't' (known: x, y, z, pi"},
        {"where: sqrt(x)", "is not a number at x = -0.15, expected"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_dies(EXIT_USER, cases[i].message, select_only, cases[i].text);
}

static int64_t nearest(const char *place)
{
    struct domain domain = cube();
    char *text = memory_print("nearest: %s", place);
    struct deck *deck = deck_of(text);
    int64_t node = selection_nearest(deck_get(deck_root(deck), "nearest"), &domain, spacing);
    free(text);
    deck_free(deck);
    domain_free(&domain);
    return node;
}

static void nearest_only(const void *place)
{
    nearest(place);
}

static void test_nearest(void **state)
{
    (void)state;
    assert_int_equal(nearest("[-0.15, -0.15, -0.15]"), 0);
    assert_int_equal(nearest("[16 cm, 2 spacings, 0.2]"), 63);
    assert_int_equal(nearest("[0.04, -0.06, 0.07]"), 38);
    assert_int_equal(nearest("[0, 0, 0]"), 21); /* of eight the first */
    assert_dies(EXIT_USER, "study.yaml:1:11: the nearest node is 0.25 m away", nearest_only,
                "[0.4, 0.15, 0.15]");
    assert_dies(EXIT_USER, "'nearest' is a list of 3 lengths", nearest_only, "[0, 0]");
    assert_dies(EXIT_USER, "'nearest' is a list of 3 lengths", nearest_only, "here");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_mistakes),
        cmocka_unit_test(test_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
