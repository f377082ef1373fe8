/* The deck's section output: records, columns and frames. */
#include "memory.h"
#include "node_values.h"
#include "scene.h"

#include <ctype.h>
#include <string.h>

/* --- columns ---------------------------------------------------------------------------------- */

/* The name becomes a column: one word that a table of text can hold. */
static const char *read_name(struct deck_node where)
{
    enum { LONGEST = 32 }; /* what Exodus keeps of a name everywhere */
    const char *name = deck_string(where);
    size_t length = 0;
    while (isalnum((unsigned char)name[length]) || name[length] == '_') length++;
    if (name[length] != '\0' || length > LONGEST)
        deck_error(where, "'%.60s' is no name for a column: up to %d letters, digits and _", name,
                   LONGEST);
    return name;
}

static const char *const reductions[] = {"sum", "mean", "min", "max", NULL};

struct given {
    struct scene_quantity quantity;
    struct deck_node name, value, selector[SELECTORS];
};
#define OF(member) offsetof(struct given, member)

static const struct key quantity_keys[] = {
    {"name", KEY_NODE, OF(name), .form = "NAME", .required = true,
     .help = "of the column: up to 32 letters, digits and _"},
    {"quantity", KEY_NODE, OF(value), .form = "a value of nodes, with its component",
     .required = true,
     .help = "such as stress_xx, displacement_x, damage; forces are those on nodes, in N"},
    {"reduce", KEY_CHOICE, OF(quantity.reduction), .names = reductions,
     .otherwise = "required without nearest", .help = "of the nodes selected; mean: by volume"},
    {"nearest", KEY_NODE, OF(quantity.place), .form = "[x, y, z]",
     .help = "in place of reduce and selector: the node nearest to a place, in m or spacings"},
    SELECTION_KEYS(OF(selector)),
};
static const struct section section_quantity = {
    .path = "output.quantities",
    .help = "Each entry is a column of the history: a quantity of some nodes, or of one.  The "
            "force that a support exerts is minus the sum of force and external_force over its "
            "nodes, as long as they are not accelerated; of corner such sums are over all corners "
            "of the "
            "particles, those that they share with others, too.",
    .keys = KEYS(quantity_keys)};

/* One node has nothing to be reduced. */
static void refuse_beside_nearest(struct deck_node where)
{
    for (int i = 0; i < deck_count(where); i++) {
        const char *key = deck_key(where, i);
        if (strcmp(key, "name") != 0 && strcmp(key, "quantity") != 0 && strcmp(key, "nearest") != 0)
            deck_error(deck_value(where, i), "'%s' beside 'nearest', which is one node", key);
    }
}

static struct scene_quantity read_quantity(struct deck_node where)
{
    struct given given = {0};
    keys_read(where, &section_quantity, 0, 0, &given, NULL);
    given.quantity.where = where;
    given.quantity.name = read_name(given.name);
    given.quantity.value = node_component_read(given.value);
    if (given.quantity.place.index)
        refuse_beside_nearest(where);
    else {
        deck_get(where, "reduce"); /* dies */
        given.quantity.nodes.selection = selection_read(where, given.selector);
    }
    return given.quantity;
}

static void read_quantities(struct scene *scene, struct deck_node list)
{
    if (list.index == 0) return;
    scene->n_quantities = deck_count(list);
    scene->quantities = memory_new((size_t)scene->n_quantities, sizeof *scene->quantities);
    for (int i = 0; i < scene->n_quantities; i++) {
        scene->quantities[i] = read_quantity(deck_item(list, i));
        for (int k = 0; k < i; k++)
            if (strcmp(scene->quantities[i].name, scene->quantities[k].name) == 0)
                deck_error(deck_get(scene->quantities[i].where, "name"), "two columns named '%s'",
                           scene->quantities[i].name);
    }
}

/* --- fields, and the section ------------------------------------------------------------------ */

#define AT(member) offsetof(struct scene, member)

static const struct variant *value_words(int i)
{
    enum { MOST = 64 };
    static struct variant words[MOST]; /* a copy of the table, which does not change */
    const struct node_value value = node_value(i);
    if (!value.name || i >= MOST) return NULL;
    words[i] = (struct variant){.name = value.name, .help = value.help};
    return &words[i];
}

static const struct section section_values = {
    .path = "output.fields.variables",
    .help = "Values of nodes.  As a quantity a vector or tensor has its component behind: "
            "displacement_x, stress_xx (yy, zz, xy, yz, zx).",
    .chooser = "NAME",
    .variant = value_words,
    .usual = -1};

static const struct key fields_keys[] = {
    {"frames", KEY_INTEGER, AT(fields.frames), NULL, 1, 1e6, .otherwise = "by every",
     .help = "beside the start, roughly, and the end"},
    {"every", KEY_NODE, AT(fields.given.every), .form = "N steps", .help = "in place of frames"},
    {"variables", KEY_NODE, AT(fields.given.variables), .form = "[NAME, ...]", .required = true,
     .section = &section_values, .help = "values of nodes"},
};
static const struct section section_fields = {
    .path = "output.fields",
    .help = "Fields for ParaView, written where hssolve is given -o FILE.",
    .keys = KEYS(fields_keys)};

static const struct key checkpoint_keys[] = {
    {"every", KEY_NODE, AT(checkpoint.given), .form = "N steps, or a time", .otherwise = "10 min",
     .help = "from one to the next: 10 min, 1000 steps"},
    {"keep", KEY_INTEGER, AT(checkpoint.keep), NULL, 1, 100, .usual = 2,
     .help = "how many: NAME, the one before NAME.1, and so on"},
};
static const struct section section_checkpoint = {
    .path = "output.checkpoint",
    .help =
        "The whole state of the run, from which hssolve --restart goes on to the same bits; one "
        "is written at each signal, too.",
    .keys = KEYS(checkpoint_keys)};

static const struct key output_keys[] = {
    {"history", KEY_INTEGER, AT(history), NULL, 1, 1e7, .usual = 500,
     .help = "number of records, roughly; denser at the start"},
    {"quantities", KEY_NODE, AT(columns), .form = "list of mappings", .section = &section_quantity,
     .help = "columns of your own"},
    {"fields", KEY_SECTION, .section = &section_fields, .help = "pictures of the body"},
    {"checkpoint", KEY_SECTION, .section = &section_checkpoint,
     .help = "states from which the run can go on"},
};
const struct section section_output = {
    .path = "output", .help = "What is written of a run.", .keys = KEYS(output_keys)};

static void finish_fields(struct scene_fields *fields, struct deck_node map)
{
    const struct deck_node list = fields->given.variables;
    if ((fields->frames > 0) == (fields->given.every.index != 0))
        deck_error(map, "give one of frames and every");
    if (!fields->frames) fields->every = value_every(fields->given.every, false);
    fields->n_variables = deck_count(list);
    if (deck_count(list) == 0) deck_error(list, "no variables; for no fields leave out 'fields'");
    fields->variables = memory_new((size_t)deck_count(list), sizeof(int));
    for (int i = 0; i < deck_count(list); i++)
        fields->variables[i] = node_value_read(deck_item(list, i));
}

/* Steps, or a time. */
static void finish_checkpoint(struct scene_checkpoint *checkpoint)
{
    const struct deck_node every = checkpoint->given;
    checkpoint->seconds = 600;
    if (!every.index) return;
    const bool steps = strstr(deck_string(every), "step") != NULL;
    checkpoint->steps = steps ? value_every(every, false) : 0;
    checkpoint->seconds = steps ? 0 : deck_number(every, "s", 1e-3, 1e9);
}

void scene_read_output(struct scene *scene, struct deck_node output)
{
    keys_read(output, &section_output, 0, 0, scene, NULL);
    read_quantities(scene, scene->columns);
    finish_checkpoint(&scene->checkpoint);
    if (scene->fields.given.variables.index)
        finish_fields(&scene->fields, deck_get(output, "fields"));
}
