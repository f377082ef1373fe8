/* The deck's section macroscopic: how a periodic body is deformed as a whole. */
#include "memory.h"
#include "scene.h"

struct given {
    struct deck_node value[MACROSCOPIC_KINDS];
    int component;
};
#define AT(member) offsetof(struct given, member)
#define VALUE(kind, unit, most)                                                                    \
    KEY_NODE, AT(value) + (kind) * sizeof(struct deck_node), unit, -(most), most, .form = "VALUE"

const char *const scene_components[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz", NULL};

/* The last rows are the kinds, in their order. */
static const struct key rows[] = {
    {"component", KEY_CHOICE, AT(component), .names = scene_components, .required = true,
     .help = "of the mean deformation gradient F, row and column: xy is the change along y of the "
             "displacement along x"},
    {"rate", VALUE(MACROSCOPIC_RATE, "1/s", 1e9), .help = "of this component of F"},
    {"strain", VALUE(MACROSCOPIC_STRAIN, "1", 10), .help = "this component of F - 1"},
    {"stress", VALUE(MACROSCOPIC_STRESS, "Pa", 1e13),
     .help = "mean nominal (first Piola-Kirchhoff) stress, whose component of F is found"},
};
enum { FIRST_KIND = 1 };

const struct section section_macroscopic = {
    .path = "macroscopic",
    .help =
        "How a periodic body (domain.periodic) is deformed as a whole: a list of entries with a "
        "component and one of the three values, a number with its unit, an expression in t, "
        "{ramp: TIME, to: NUMBER}, or a table as in boundary.  Components that no entry names have "
        "no mean stress, but for "
        "those that only turn the body (yx, zx, zy, and those of an axis that is not periodic), "
        "which stay 0: so {component: xx, rate: 1 1/s} alone is uniaxial tension.",
    .keys = KEYS(rows)};

static struct scene_component read_entry(struct deck_node where)
{
    struct given given = {0};
    int kind = -1;
    keys_read(where, &section_macroscopic, 0, 0, &given, NULL);
    for (int k = 0; k < MACROSCOPIC_KINDS; k++) {
        if (given.value[k].index == 0) continue;
        if (kind >= 0)
            deck_error(given.value[k], "'%s' beside '%s', expected one of them",
                       rows[FIRST_KIND + k].name, rows[FIRST_KIND + kind].name);
        kind = k;
    }
    if (kind < 0) deck_error(where, "expected one of: rate, strain, stress");
    const struct key *row = &rows[FIRST_KIND + kind];
    return (struct scene_component){
        where, given.component, (enum macroscopic_kind)kind,
        value_read(given.value[kind], row->unit, row->low, row->high, VALUE_IN_TIME)};
}

void scene_read_macroscopic(struct scene *scene, struct deck_node list)
{
    scene->periodic_load = list;
    if (list.index == 0) return;
    scene->n_components = deck_count(list);
    scene->components = memory_new((size_t)scene->n_components, sizeof *scene->components);
    for (int i = 0; i < scene->n_components; i++) {
        scene->components[i] = read_entry(deck_item(list, i));
        for (int k = 0; k < i; k++)
            if (scene->components[k].component == scene->components[i].component)
                deck_error(scene->components[i].where, "the component %s is said twice",
                           scene_components[scene->components[i].component]);
    }
}
