#include "dies.h"

#include "keys.h"

#include <math.h>
#include <stdlib.h>

/* A section that has everything. */
struct inner {
    double factor;
};
struct oven {
    double spacing, mass, edge, wall, corner[3], band[2], inner_length;
    int64_t trays;
    int colour;
    bool lit;
    const char *name;
    struct deck_node extra, door;
    struct inner inner;
};
struct gas {
    double pressure, thickness;
};

static const char *const colours[] = {"red", "green", NULL};
static const double usual_band[] = {0.1, 0.4};

#define PLACE(member) .place = offsetof(struct oven, member)

static const struct key lamp_rows[] = {
    {"length", KEY_LENGTH, PLACE(inner_length), .low = 0, .high = 1, .required = true},
    {"factor", KEY_NUMBER, PLACE(inner.factor), .unit = "1", .high = 9, .usual = 5},
};
static const struct section lamp = {.path = "oven.lamp", .help = "Light.", .keys = KEYS(lamp_rows)};

static const struct key door_rows[] = {
    {"width", KEY_NUMBER, .unit = "m", .high = 1, .help = "Of all doors."},
    {"handle", KEY_NUMBER, .unit = "m", .high = 1, .users = 2, .required = true},
};
static const struct variant *kind_of_oven(int i);
static const struct section door = {.path = "oven.door",
                                    .help = "Where the bread goes in.",
                                    .keys = KEYS(door_rows),
                                    .chooser = "type",
                                    .variant = kind_of_oven,
                                    .outside = true};

static const struct key rows[] = {
    {"spacing", KEY_SPACING, PLACE(spacing), .low = 1e-6, .high = 1, .required = true},
    {"mass", KEY_NUMBER, PLACE(mass), .unit = "kg", .low = 1e-3, .high = 1e6, .usual = 2,
     .help = "'Mass' without bread.  Weighed | cold."},
    {"edge", KEY_LENGTH, PLACE(edge), .low = 0, .high = HUGE_VAL, .usual = 0.5},
    {"wall", KEY_SPACINGS, PLACE(wall), .low = 1, .high = 10, .usual = 2},
    {"corner", KEY_LENGTH, PLACE(corner), .low = -1, .high = 1, .size = 3},
    {"band", KEY_NUMBER, PLACE(band), .unit = "1", .low = 0, .high = 1, .size = 2, .rising = true,
     .usuals = usual_band},
    {"trays", KEY_INTEGER, PLACE(trays), .low = 1, .high = 2147483647, .usual = 3},
    {"colour", KEY_CHOICE, PLACE(colour), .names = colours, .usual = 1},
    {"lit", KEY_FLAG, PLACE(lit), .usual = 1, .users = 1 << 0 | 1 << 1},
    {"name", KEY_TEXT, PLACE(name), .otherwise = "of the maker"},
    {"extra", KEY_NODE, PLACE(extra), .form = "list", .names = colours},
    {"lamp", KEY_SECTION, PLACE(inner), .section = &lamp},
    {"door", KEY_NODE, PLACE(door), .section = &door},
};

static const struct key gas_rows[] = {
    {"pressure", KEY_NUMBER, .place = offsetof(struct gas, pressure), .unit = "Pa", .low = 1,
     .high = 1e9, .required = true, .help = "Of the main."},
    {"thickness", KEY_LENGTH, .place = offsetof(struct gas, thickness), .high = 1, .usual = 0.25},
};
static const struct variant variants[] = {{.name = "electric", .help = "Plugged in."},
                                          {.name = "gas", .keys = KEYS(gas_rows)},
                                          {.name = "wood"}};
static const struct variant *kind_of_oven(int i)
{
    return i < 3 ? &variants[i] : NULL;
}

static const struct section section = {.path = "oven",
                                       .help = "Bakes.",
                                       .keys = KEYS(rows),
                                       .chooser = "type",
                                       .variant = kind_of_oven,
                                       .usual = 0};

static struct deck *parse(const char *text)
{
    return deck_parse(text, strlen(text), "oven.yaml");
}

static void test_every_kind_is_read(void **state)
{
    struct oven oven;
    struct gas gas;
    (void)state;
    struct deck *deck = parse(
        "type: gas\nmass: 3 g\ncorner: [0, 2 spacings, -1 cm]\nspacing: 2 mm\nedge: 3 spacings\n"
        "wall: 4 mm\nband: [0.2, 30 %]\ntrays: 7\ncolour: red\nlit: false\nname: Vesuv\n"
        "extra: [red]\nlamp: {length: 5 spacings}\npressure: 2 kPa\nthickness: 0.5 spacings\n");
    struct deck_node map = deck_root(deck);
    const int variant = keys_variant(map, &section);
    assert_int_equal(variant, 1);
    keys_read(map, &section, variant, 0, &oven, &gas);
    /* The deck's order does not matter: lengths in spacings follow the spacing of the table. */
    assert_true(oven.spacing == 2e-3 && oven.mass == 3e-3 && oven.edge == 3 * 2e-3);
    assert_true(oven.wall == 4e-3);
    assert_true(oven.corner[0] == 0 && oven.corner[1] == 2 * 2e-3 && oven.corner[2] == -1e-2);
    assert_true(oven.band[0] == 0.2 && oven.band[1] == 0.3);
    assert_int_equal(oven.trays, 7);
    assert_int_equal(oven.colour, 0);
    assert_false(oven.lit);
    assert_string_equal(oven.name, "Vesuv");
    assert_int_equal(deck_count(oven.extra), 1);
    assert_true(oven.inner_length == 5 * 2e-3 && oven.inner.factor == 5);
    assert_true(gas.pressure == 2e3 && gas.thickness == 0.5 * 2e-3);
    deck_free(deck);
}

static void assert_usual(const struct oven *oven)
{
    assert_true(oven->mass == 2 && oven->edge == 0.5);
    assert_true(oven->corner[0] == 0 && oven->corner[2] == 0);
    assert_true(oven->band[0] == 0.1 && oven->band[1] == 0.4);
    assert_int_equal(oven->trays, 3);
    assert_int_equal(oven->colour, 1);
    assert_true(oven->lit);
    assert_null(oven->name);
    assert_int_equal(oven->extra.index, 0);
    assert_true(oven->inner_length == 0 && oven->inner.factor == 5);
}

static void test_defaults(void **state)
{
    (void)state;
    struct oven oven;
    memset(&oven, 0xff, sizeof oven);
    struct deck *deck = parse("spacing: 2 mm\n");
    assert_int_equal(keys_variant(deck_root(deck), &section), 0);
    keys_read(deck_root(deck), &section, 0, 0, &oven, NULL);
    assert_usual(&oven);
    assert_true(oven.wall == 2 * 2e-3);
    /* No map at all: nothing is required of it. */
    memset(&oven, 0xff, sizeof oven);
    keys_read((struct deck_node){0}, &section, 0, 3e-3, &oven, NULL);
    assert_usual(&oven);
    assert_true(oven.wall == 2 * 3e-3 && oven.spacing == 0);
    deck_free(deck);
}

static void read_section(const void *text)
{
    struct oven oven;
    struct gas gas;
    struct deck_node map = deck_root(parse(text));
    const int variant = keys_variant(map, &section);
    keys_read(map, &section, variant, 0, &oven, &gas);
    if (oven.door.index) keys_check(oven.door, &door, variant);
}

static void test_what_is_refused(void **state)
{
    static const struct {
        const char *text, *message;
    } faults[] = {
        {"mass: 1\n", "oven.yaml:1:1: key 'spacing' is missing here"},
        {"spacing: 1\nmas: 2\n",
         "oven.yaml:2:1: unknown key 'mas' (did you mean mass? known: type, spacing"},
        {"spacing: 1\npresure: 2\n", "unknown key 'presure' (known: type, spacing, mass,"},
        {"type: gas\nspacing: 1\npresure: 2\n", "did you mean pressure?"},
        {"type: gsa\n",
         "oven.yaml:1:7: 'gsa' is not known here (did you mean gas? expected one of: "
         "electric, gas, wood)"},
        {"spacing: 1\npressure: 2\n",
         "oven.yaml:2:1: 'pressure' belongs to type: gas, not to type: electric"},
        {"spacing: 1\ntype: wood\nlit: true\n",
         "oven.yaml:3:1: 'lit' belongs to type: electric or gas, not to type: wood"},
        {"type: gas\nspacing: 1\n", "key 'pressure' is missing here"},
        {"spacing: 2 kg\n", "oven.yaml:1:10: "},
        {"spacing: 1\nmass: 1 mg\n", "1e-06 kg is out of range, expected 0.001 to 1e+06 kg"},
        {"spacing: 1 mm\nwall: 11 spacings\n", "0.011 m is out of range, expected 0.001 to 0.01 m"},
        {"spacing: 1\nedge: -1\n", "expected at least 0 m"},
        {"spacing: 1\ncorner: [0, 0]\n", "oven.yaml:2:9: 'corner' is a list of 3 lengths"},
        {"spacing: 1\nband: 0.3\n", "'band' is a list of 2 numbers"},
        {"spacing: 1\nband: [0.1, 2]\n", "oven.yaml:2:13: 2 is out of range, expected 0 to 1"},
        {"spacing: 1\nband: [0.4, 0.4]\n",
         "oven.yaml:2:13: 'band' must rise, expected more than 0.4"},
        {"spacing: 1\ntrays: 0\n", "0 is out of range, expected 1 to 2147483647"},
        {"spacing: 1\ncolour: reed\n", "did you mean red?"},
        {"spacing: 1\nlit: 1\n", "'1' is not known here"},
        {"spacing: 1\nname: [a]\n", "expected a single value"},
        {"spacing: 1\nlamp: {factor: 1}\n", "oven.yaml:2:7: key 'length' is missing here"},
        {"spacing: 1\nlamp: {length: 1, type: 1}\n", "unknown key 'type' (known: length, factor)"},
        {"spacing: 1\nlamp: 3\n", "oven.yaml:2:7: expected a mapping"},
        /* A chooser outside is no key of the section that it changes. */
        {"spacing: 1\ndoor: {type: gas}\n", "unknown key 'type' (known: width)"},
        {"spacing: 1\ndoor: {handle: 1}\n",
         "oven.yaml:2:8: 'handle' belongs to type: gas, not to type: electric"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        assert_dies(EXIT_USER, faults[i].message, read_section, faults[i].text);
}

static const char *print(enum keys_format format)
{
    static const struct section *const sections[] = {&section, &door, NULL};
    static char text[1 << 14];
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_non_null(file);
    keys_print(file, sections, format);
    fclose(file);
    return text;
}

static void assert_holds(enum keys_format format, const char *const parts[])
{
    const char *from = print(format);
    for (int i = 0; parts[i]; i++) {
        const char *found = strstr(from, parts[i]);
        if (!found) fail_msg("no '%s' in:\n%s", parts[i], from);
        from = found + strlen(parts[i]);
    }
}

static void test_manual_as_text(void **state)
{
    (void)state;
    assert_holds(
        KEYS_TEXT,
        (const char *const[]){
            "oven\n    Bakes.\n\n",
            "  type [electric, gas, wood; default electric]\n",
            "  spacing [m, 1e-6 to 1; required]\n",
            "  mass [kg, 0.001 to 1e6; default 2]\n      'Mass' without bread. Weighed | cold.\n",
            "  edge [m or spacings, at least 0; default 0.5]",
            "  wall [m or spacings, 1 to 10 spacings; default 2 spacings]",
            "  corner [list of 3, m or spacings, -1 to 1; default [0, 0, 0]]",
            "  band [[low, high], number, 0 to 1; default [0.1, 0.4]]",
            "  trays [whole number, 1 to 2147483647; default 3]",
            "  colour [red, green; default green]",
            "  lit [true or false; default true; electric and gas only]",
            "  name [text; default: of the maker]",
            "  extra [list of red, green; optional]",
            "  lamp [mapping; optional]",
            "  type: electric\n      Plugged in.\n",
            "  type: gas\n",
            "  pressure [Pa, 1 to 1e9; required]\n      Of the main.\n",
            "  type: wood\n",
            "oven.lamp\n    Light.\n\n",
            "  length [",
            "oven.door\n",
            "  width [m, 0 to 1; default 0]",
            "  handle [m, 0 to 1; required; gas only]",
            NULL});
    /* Each section once, though the door is named twice, and no chooser where it stands outside. */
    const char *first = strstr(print(KEYS_TEXT), "oven.door");
    assert_non_null(first);
    assert_null(strstr(first + 1, "oven.door"));
    assert_null(strstr(first, "type"));
}

static void test_manual_as_mdoc_and_markdown(void **state)
{
    (void)state;
    assert_holds(KEYS_MDOC,
                 (const char *const[]){
                     ".Ss oven\nBakes.\n.Bl -tag -width Ds\n.It Cm type\n",
                     ".It Cm mass\n[kg, 0.001 to 1e6; default 2]\n\\&'Mass' without bread.",
                     "\nWeighed | cold.\n", ".It Cm type : Li gas\n\n.Bl ",
                     ".It Cm pressure\n[Pa, 1 to 1e9; required]\nOf the main.\n",
                     ".El\n.It Cm type : Li wood\n", ".El\n.Ss oven.lamp\n", NULL});
    assert_holds(
        KEYS_MARKDOWN,
        (const char *const[]){"### oven\n\nBakes.\n\n| key | takes | what |\n|---|---|---|\n"
                              "| `type` | electric, gas, wood; default electric |",
                              "| `mass` | kg, 0.001 to 1e6; default 2 | "
                              "'Mass' without bread. Weighed \\| cold. |\n",
                              "| **`type: gas`** | |  |\n| `pressure` | Pa, 1 to 1e9; required | ",
                              "\n\n### oven.lamp\n", NULL});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_kind_is_read),
        cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_what_is_refused),
        cmocka_unit_test(test_manual_as_text),
        cmocka_unit_test(test_manual_as_mdoc_and_markdown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
