#include "dies.h"

#include "keys.h"
#include "memory.h"
#include "options.h"

#include <stdlib.h>

/* What the options of one run are read into. */
struct chosen {
    bool quiet;
    const char *output, *seed;
    int operand;
};

static struct chosen choose(int argc, char **argv)
{
    struct chosen chosen = {0};
    const struct option_row rows[] = {
        {'o', "output", "FILE", "where to write", NULL, &chosen.output},
        {0, "seed", "N", "seed of the random numbers", NULL, &chosen.seed},
        {'q', "quiet", NULL, "say nothing", &chosen.quiet, NULL},
    };
    static const struct key key = {"size", KEY_NUMBER, .unit = "m", .high = 1, .help = "Its size."};
    static const struct section section = {.path = "test", .help = "Tests.", .keys = {1, &key}};
    static const struct section *const sections[] = {&section, NULL};
    const struct option_table table = {"hstest", "[deck]", "Tests the options.", rows, 3, sections};
    chosen.operand = options_read(&table, argc, argv);
    return chosen;
}

static void test_options_are_read(void **state)
{
    char *argv[] = {"hstest",   "-q",     "study.yaml", "--output=first",
                    "-osecond", "--seed", "7",          NULL};
    (void)state;
    struct chosen chosen = choose(7, argv);
    assert_true(chosen.quiet);
    assert_string_equal(chosen.output, "second");
    assert_string_equal(chosen.seed, "7");
    assert_string_equal(argv[chosen.operand], "study.yaml");
    char *again[] = {"hstest", NULL};
    chosen = choose(1, again);
    assert_false(chosen.quiet);
    assert_null(chosen.output);
    assert_int_equal(chosen.operand, 1);
}

static void choose_one(const void *argument)
{
    char *argv[] = {"hstest", memory_text(argument), NULL};
    choose(2, argv);
}

static void test_wrong_options(void **state)
{
    (void)state;
    assert_dies(EXIT_USER, "unrecognized option '--outputs'", choose_one, "--outputs");
    assert_dies(EXIT_USER, "invalid option -- 'x'", choose_one, "-x");
    assert_dies(EXIT_USER, "requires an argument", choose_one, "-o");
    assert_dies(EXIT_USER, "try 'hstest --help'", choose_one, "--quiet=1");
}

static void print_to_messages(const void *option)
{
    dup2(STDERR_FILENO, STDOUT_FILENO);
    choose_one(option);
}

static void print_to_full_disk(const void *option)
{
    if (freopen("/dev/full", "w", stdout) == NULL) _exit(99);
    choose_one(option);
}

static void test_help_and_version(void **state)
{
    (void)state;
    assert_dies(0, "Usage: hstest [deck]\n\nTests the options.", print_to_messages, "--help");
    assert_dies(0, "  -o, --output FILE           where to write\n", print_to_messages, "-h");
    assert_dies(0, "      --seed N                seed of", print_to_messages, "-h");
    assert_dies(0, "libyaml ", print_to_messages, "--version");
    assert_dies(0, "      --keys[=FORMAT]         print", print_to_messages, "-h");
    assert_dies(0, "test\n    Tests.\n\n  size [m, 0 to 1; default 0]", print_to_messages,
                "--keys");
    assert_dies(0, ".It Cm size", print_to_messages, "--keys=mdoc");
    assert_dies(0, "| `size` |", print_to_messages, "--keys=markdown");
    assert_dies(EXIT_USER, "--keys=html: expected text, mdoc or markdown", choose_one,
                "--keys=html");
    assert_dies(EXIT_RUN, "cannot write to standard output", print_to_full_disk, "-V");
}

static void test_command_is_quoted(void **state)
{
    char *argv[] = {"hsgen", "two words.yaml", "-o", "it's", "", "a=1,b"};
    (void)state;
    char *command = options_command(6, argv);
    assert_string_equal(command, "hsgen 'two words.yaml' -o 'it'\\''s' '' a=1,b");
    free(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_options_are_read),
        cmocka_unit_test(test_wrong_options),
        cmocka_unit_test(test_help_and_version),
        cmocka_unit_test(test_command_is_quoted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
