/* The deck's section output: records, columns and frames. */
#include "memory.h"
#include "node_values.h"
#include "scene.h"

#include <ctype.h>
#include <string.h>

static void read_fields(struct scene_fields *fields, struct deck_node map)
{
    deck_keys(map, (const char *const[]){"frames", "every", "variables", NULL});
    if (deck_has(map, "frames") == deck_has(map, "every"))
        deck_error(map, "give one of frames and every");
    if (deck_has(map, "frames"))
        fields->frames = (int)deck_integer(deck_get(map, "frames"), 1, 1000000);
    else
        fields->every = value_every(deck_get(map, "every"), false);
    struct deck_node list = deck_get(map, "variables");
    fields->n_variables = deck_count(list);
    if (deck_count(list) == 0) deck_error(list, "no variables; for no fields leave out 'fields'");
    fields->variables = memory_new((size_t)deck_count(list), sizeof(int));
    for (int i = 0; i < deck_count(list); i++)
        fields->variables[i] = node_value_read(deck_item(list, i));
}

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

static struct scene_quantity read_quantity(struct deck_node where)
{
    static const char *const reductions[] = {"sum", "mean", "min", "max"};
    deck_keys(where,
              (const char *const[]){"name", "quantity", "reduce", "nearest", SELECTION_KEYS, NULL});
    struct scene_quantity quantity = {.where = where,
                                      .name = read_name(deck_get(where, "name")),
                                      .value = node_component_read(deck_get(where, "quantity"))};
    if (deck_has(where, "nearest")) {
        quantity.place = deck_get(where, "nearest");
        for (int i = 0; i < deck_count(where); i++)
            if (strcmp(deck_key(where, i), "name") != 0 &&
                strcmp(deck_key(where, i), "quantity") != 0 &&
                strcmp(deck_key(where, i), "nearest") != 0)
                deck_error(deck_value(where, i), "'%s' beside 'nearest', which is one node",
                           deck_key(where, i));
        return quantity;
    }
    quantity.reduction =
        (enum scene_reduction)deck_choice(deck_get(where, "reduce"), reductions, 4);
    quantity.nodes.selection = selection_read(where);
    return quantity;
}

static void read_quantities(struct scene *scene, struct deck_node list)
{
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

void scene_read_output(struct scene *scene, struct deck_node output)
{
    deck_keys(output, (const char *const[]){"history", "quantities", "fields", NULL});
    if (deck_has(output, "history"))
        scene->history = (int)deck_integer(deck_get(output, "history"), 1, 10000000);
    if (deck_has(output, "quantities")) read_quantities(scene, deck_get(output, "quantities"));
    if (deck_has(output, "fields")) read_fields(&scene->fields, deck_get(output, "fields"));
}
