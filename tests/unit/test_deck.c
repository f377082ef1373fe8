#include "dies.h"

#include "deck.h"
#include "nearest.h"
#include "sections.h"

#include <math.h>
#include <stdlib.h>

static struct deck *parse(const char *text)
{
    return deck_parse(text, strlen(text), "study.yaml");
}

static const char study[] = "title: Nickel\n"
                            "domain:\n"
                            "  size: [5 mm, 1 mm, 0.2 mm]\n"
                            "  spacing: \"25 um\"\n"
                            "  grips: &grips {length: 3 spacings}\n"
                            "  again: *grips\n"
                            "  seed: 7\n"
                            "  override: true\n"
                            "  lattice: bcc\n"
                            "  fraction: 0.4\n";

static void test_values(void **state)
{
    static const char *const lattices[] = {"sc", "bcc", "fcc"};
    (void)state;
    struct deck *deck = parse(study);
    struct deck_node domain = deck_get(deck_root(deck), "domain");
    sections_read(deck);
    assert_string_equal(deck_string(deck_get(deck_root(deck), "title")), "Nickel");
    assert_string_equal(deck_text(deck), study);
    assert_int_equal(deck_count(deck_get(domain, "size")), 3);
    assert_true(deck_number(deck_item(deck_get(domain, "size"), 2), "m", 0, 1) == 0.2e-3);
    assert_true(deck_number(deck_get(domain, "spacing"), "m", 0, 1) == 25e-6);
    struct deck_node length = deck_get(deck_get(domain, "again"), "length");
    assert_true(deck_length(length, 25e-6, 0, 1) == 3 * 25e-6);
    assert_int_equal(deck_integer(deck_get(domain, "seed"), 0, 10), 7);
    assert_true(deck_bool(deck_get(domain, "override")));
    assert_int_equal(deck_choice(deck_get(domain, "lattice"), lattices, 3), 1);
    assert_true(deck_has(domain, "seed") && !deck_has(domain, "seeds"));
    assert_int_equal(deck_find(domain, "seeds").index, 0);
    assert_string_equal(deck_key(domain, 1), "spacing");
    assert_true(deck_is_map(deck_value(domain, 2)) && deck_is_list(deck_value(domain, 0)));
    deck_free(deck);
}

struct fault {
    const char *text, *message;
};

static void parse_fault(const void *argument)
{
    deck_free(parse(((const struct fault *)argument)->text));
}

static void test_decks_that_are_refused(void **state)
{
    static const struct fault faults[] = {
        {"", "study.yaml: empty"},
        {"# only a comment\n", "study.yaml: empty"},
        {"just a text", "study.yaml:1:1: expected a mapping"},
        {"- a\n- b\n", "study.yaml:1:1: expected a mapping"},
        {"a: 1\nb: 2\na: 3\n", "study.yaml:3:1: key 'a' stands here for the second time"},
        {"a: {b: 1, b: 2}\n", "study.yaml:1:11: key 'b'"},
        {"a: 1\n---\nb: 2\n", "study.yaml:2:1: a second document"},
        {"a: &x [1, *x]\n", "study.yaml:1:4: contains itself"},
        {"a: *x\n", "study.yaml:1:4: "},
        {"a: [1, 2\n", "study.yaml:2:1: "},
        {"a:\n\t- 1\n", "study.yaml:2:1: "},
        {"? [a, b]\n: 1\n", "study.yaml:1:3: a key that is a list"},
        {"a: \"x\\0y\"\n", "study.yaml:1:4: a text with a NUL"},
        {"a: \x01\n", "study.yaml: byte 4: control characters"},
        {"a: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]", "nested too deep"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        assert_dies(EXIT_USER, faults[i].message, parse_fault, &faults[i]);
}

static void parse_large(const void *unused)
{
    (void)unused;
    size_t length = 1000001;
    char *text = malloc(length);
    memset(text, '#', length);
    deck_parse(text, length, "study.yaml");
}

static void test_bombs(void **state)
{
    (void)state;
    assert_dies(EXIT_USER, "study.yaml: larger than 1 MB", parse_large, NULL);
    /* Two aliases of two aliases of ...: 2^28 ends, but every node is looked at once. */
    char text[4096] = "a0: &a0 [1, 1]\n";
    for (int i = 1; i < 28; i++)
        sprintf(text + strlen(text), "a%d: &a%d [*a%d, *a%d]\n", i, i, i - 1, i - 1);
    deck_free(parse(text));
}

static void check_keys(const void *argument)
{
    static const char *const known[] = {"density", "youngs_modulus", "poissons_ratio", NULL};
    deck_keys(deck_root(parse(argument)), known);
}

static void check_sections(const void *argument)
{
    sections_read(parse(argument));
}

/* What hspost would find after the run stops every tool at the start: names and values of post. */
static void test_values_of_post(void **state)
{
    (void)state;
    struct deck *deck = parse("title: A\npost: {window: 2 %}\n");
    struct sections sections = sections_read(deck);
    assert_string_equal(sections.title, "A");
    assert_true(deck_is_map(sections.post));
    assert_int_equal(sections.solver.index, 0);
    deck_free(deck);
    static const struct fault faults[] = {
        {"title: [A]\n", "study.yaml:1:8: expected a single value"},
        {"post: {windw: 1}\n", "study.yaml:1:8: unknown key 'windw' (did you mean window?"},
        {"post: {window: 2}\n", "study.yaml:1:16: 2 is out of range, expected 1e-09 to 1"},
        {"post: {modulus: 210 GPa, section: 2 mm}\n", "study.yaml:1:35: "},
        {"post: {modulus_range: [0.4, 0.1]}\n",
         "study.yaml:1:29: 'modulus_range' must rise, expected more than 0.4"},
        {"post: {modulus_rows: 4}\n", "study.yaml:1:22: 'modulus_rows' is a list of 2 numbers"},
        {"post: 3\n", "study.yaml:1:7: "},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        assert_dies(EXIT_USER, faults[i].message, check_sections, faults[i].text);
}

static void test_unknown_keys(void **state)
{
    (void)state;
    assert_dies(
        EXIT_USER,
        "study.yaml:2:1: unknown key 'poison' (did you mean poissons_ratio? known: density, "
        "youngs_modulus, poissons_ratio)",
        check_keys, "density: 1\npoison: 0.3\n");
    assert_dies(EXIT_USER, "study.yaml:1:1: unknown key 'xyz' (known: density", check_keys,
                "xyz: 1\n");
    assert_dies(EXIT_USER, "unknown key 'domian' (did you mean domain?", check_sections,
                "domian: 1\n");
    assert_dies(EXIT_USER,
                "study.yaml:1:8: unknown key 'titel' (did you mean title? known: title, ",
                check_sections, "post: {titel: x}\n");
    assert_dies(EXIT_USER, "study.yaml:1:7: expected a mapping", check_sections, "post: 1\n");
}

enum getter { NUMBER, LENGTH, INTEGER, BOOLEAN, TEXT, CHOICE, COUNT, GET };
struct wrong {
    enum getter getter;
    const char *text, *message;
};

static void get_wrong(const void *argument)
{
    static const char *const names[] = {"explicit", "static"};
    const struct wrong *wrong = argument;
    struct deck_node root = deck_root(parse(wrong->text)), node = deck_value(root, 0);
    switch (wrong->getter) {
    case NUMBER:
        deck_number(node, "Pa", 0, 1e12);
        break;
    case LENGTH:
        deck_length(node, 25e-6, 1e-6, INFINITY);
        break;
    case INTEGER:
        deck_integer(node, 1, 10);
        break;
    case BOOLEAN:
        deck_bool(node);
        break;
    case TEXT:
        deck_string(node);
        break;
    case CHOICE:
        deck_choice(node, names, 2);
        break;
    case COUNT:
        deck_count(node);
        break;
    case GET:
        deck_get(root, "b");
        break;
    }
}

static void test_wrong_values(void **state)
{
    static const struct wrong wrongs[] = {
        {NUMBER, "a: 5 mm", "study.yaml:1:4: 'mm' is a length, expected a stress in Pa"},
        {NUMBER, "a: 210.0e9GPa", "1:4: 2.1e+20 Pa is out of range, expected 0 to 1e+12 Pa"},
        {NUMBER, "a: -1", "1:4: -1 Pa is out of range"},
        {NUMBER, "a: [1]", "1:4: expected a single value"},
        {NUMBER, "a:", "a value is missing here"},
        {NUMBER, "a: nan", "'nan' is not a number"},
        {LENGTH, "a: 3 spacing s", "unknown unit 'spacing s'"},
        {LENGTH, "a: spacings", "'spacings' is not a number"},
        {LENGTH, "a: x spacings", "1:4: 'x spacings' is not a length"},
        {LENGTH, "a: 3 mm spacings", "'3 mm spacings' is not a length"},
        {LENGTH, "a: 0 spacings", "0 m is out of range, expected at least 1e-06 m"},
        {INTEGER, "a: 2.5", "'2.5' is not a whole number"},
        {INTEGER, "a: 0x4", "'0x4' is not a whole number"},
        {INTEGER, "a: 1e1", "'1e1' is not a whole number"},
        {INTEGER, "a: 11", "11 is out of range, expected 1 to 10"},
        {INTEGER, "a: 99999999999999999999", "is out of range"},
        {BOOLEAN, "a: maybe", "'maybe' is not known here"},
        {TEXT, "a: ''", "1:4: a value is missing here"},
        {CHOICE, "a: explicite", "did you mean explicit? expected one of: explicit, static"},
        {COUNT, "a: 1", "1:4: expected a list"},
        {GET, "a: 1", "study.yaml:1:1: key 'b' is missing here"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof wrongs / sizeof *wrongs; i++)
        assert_dies(EXIT_USER, wrongs[i].message, get_wrong, &wrongs[i]);
}

static void test_nearest(void **state)
{
    static const char *const names[] = {"horizon", "influence", "safety"};
    (void)state;
    assert_string_equal(nearest_name("horzion", names, 3), "horizon");
    assert_string_equal(nearest_name("Safety", names, 3), "safety");
    assert_null(nearest_name("q", names, 3));
    assert_null(nearest_name("", names, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),         cmocka_unit_test(test_decks_that_are_refused),
        cmocka_unit_test(test_bombs),          cmocka_unit_test(test_unknown_keys),
        cmocka_unit_test(test_values_of_post), cmocka_unit_test(test_wrong_values),
        cmocka_unit_test(test_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
