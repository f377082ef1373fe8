#include "node_values.h"

#include "corners.h"
#include "damage.h"
#include "laws.h"
#include "memory.h"
#include "model.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- sources ---------------------------------------------------------------------------------- */

static const double *phase(const struct body *body, const struct damage *damage, int component,
                           double *buffer)
{
    (void)damage, (void)component;
    for (int64_t i = 0; i < body->grid.n_sites; i++)
        if (body->grid.flags[i] & SITE_OWNED) buffer[i] = body->grid.phase[i];
    return buffer;
}

static const double *grain(const struct body *body, const struct damage *damage, int component,
                           double *buffer)
{
    (void)damage, (void)component;
    for (int64_t i = 0; i < body->grid.n_sites; i++)
        if (body->grid.flags[i] & SITE_OWNED)
            buffer[i] = body->lattice->grain ? body->lattice->grain[body_number(body, i)] : 0;
    return buffer;
}

static const double *damage_of(const struct body *body, const struct damage *damage, int component,
                               double *buffer)
{
    (void)body, (void)component;
    damage_index(damage, buffer);
    return buffer;
}

static void stress(const struct node_state *state, int component, double *values)
{
    memcpy(values, state->cauchy[component], (size_t)state->count * sizeof *values);
}

static void von_mises(const struct node_state *state, int component, double *values)
{
    const double(*s)[LANES] = state->cauchy;
    (void)component;
    for (int i = 0; i < state->count; i++) {
        const double xy = s[0][i] - s[1][i], yz = s[1][i] - s[2][i], zx = s[2][i] - s[0][i],
                     shear = s[3][i] * s[3][i] + s[4][i] * s[4][i] + s[5][i] * s[5][i];
        values[i] = sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * shear);
    }
}

/* --- table ------------------------------------------------------------------------------------ */

static const struct node_value table[] = {
    {"displacement", "m", 3, .member = offsetof(struct body, u),
     .help = "from the reference position"},
    {"velocity", "m/s", 3, .member = offsetof(struct body, v), .help = "0 in equilibria"},
    {"force", "N/m3", 3, .density = true, .member = offsetof(struct body, f),
     .help = "inner force on a node, per volume"},
    {"external_force", "N/m3", 3, .density = true, .member = offsetof(struct body, b),
     .help = "loads on a node, per volume"},
    {"stress", "Pa", 6, .observe = stress, .help = "Cauchy stress"},
    {"von_mises", "Pa", 1, .observe = von_mises, .help = "of the Cauchy stress"},
    {"damage", "1", 1, .field = damage_of,
     .help = "0 to 1: share of the family's volume that bonds no longer reach, or the loss of "
             "stress by ductile damage where that is more"},
    {"phase", "1", 1, .label = true, .field = phase,
     .help = "number of the material, in the order of the domain's blocks, from 0"},
    {"grain", "1", 1, .label = true, .field = grain,
     .help = "id of the grain that the domain gives the node, such as that of an image; 0: none"},
};
enum { VALUES = sizeof table / sizeof *table };

struct node_value node_value(int i)
{
    if (i < VALUES) return table[i];
    const struct state *state = law_state(i - VALUES);
    return state ? (struct node_value){state->name, state->unit, state->components,
                                       .help = state->help}
                 : (struct node_value){0};
}

struct node_component node_component(int i)
{
    struct node_value value;
    for (int k = 0; (value = node_value(k)).name; k++) {
        if (value.label) continue;
        if (i < value.components) return (struct node_component){value, i};
        i -= value.components;
    }
    return (struct node_component){0};
}

/* --- names ------------------------------------------------------------------------------------ */

static const char *suffix(struct node_component which)
{
    static const char *const axes[] = {"x", "y", "z"}, *const planes[] = {"xx", "yy", "zz",
                                                                          "xy", "yz", "zx"},
                             *const full[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    switch (which.value.components) {
    case 3:
        return axes[which.component];
    case 6:
        return planes[which.component];
    case 9:
        return full[which.component];
    default:
        return "";
    }
}

char *node_component_variable(struct node_component which)
{
    char *text = memory_print("_%s%s", which.value.name, suffix(which)), *end = text;
    const size_t name = 1 + strlen(which.value.name);
    for (const char *c = text; *c; c++)
        if (*c == '_')
            *end++ = (char)toupper((unsigned char)*++c);
        else
            *end++ = (char)(c < text + name ? *c : toupper((unsigned char)*c));
    *end = '\0';
    return text;
}

static int choose(struct deck_node word, char **names, int count)
{
    const int chosen = deck_choice(word, (const char *const *)names, count);
    for (int i = 0; i < count; i++) free(names[i]);
    free(names);
    return chosen;
}

int node_value_read(struct deck_node word)
{
    int count = 0;
    while (node_value(count).name) count++;
    char **names = memory_new((size_t)count, sizeof *names);
    for (int i = 0; i < count; i++) names[i] = memory_text(node_value(i).name);
    return choose(word, names, count);
}

int node_component_read(struct deck_node word)
{
    int count = 0;
    while (node_component(count).value.name) count++;
    char **names = memory_new((size_t)count, sizeof *names);
    for (int i = 0; i < count; i++) {
        const struct node_component which = node_component(i);
        names[i] = memory_print("%s%s%s", which.value.name, which.value.components > 1 ? "_" : "",
                                suffix(which));
    }
    return choose(word, names, count);
}

/* --- fields ----------------------------------------------------------------------------------- */

struct node_values {
    const struct damage *damage;
    double *buffer; /* box field */
};

struct node_values *node_values_new(const struct body *body, const struct damage *damage)
{
    struct node_values *values = memory_new(1, sizeof *values);
    values->damage = damage;
    values->buffer = memory_new((size_t)body->grid.n_sites, sizeof *values->buffer);
    return values;
}

void node_values_free(struct node_values *values)
{
    if (!values) return;
    free(values->buffer);
    free(values);
}

static double *member_of(const struct body *body, struct node_component which)
{
    return ((double *const *)((const char *)body + which.value.member))[which.component];
}

const double *node_values_at_corners(struct node_values *values, struct node_component which,
                                     const struct body *body)
{
    const double *field = member_of(body, which);
    if (!field) body_clear(body, &values->buffer, 1);
    return field ? field : values->buffer;
}

const double *node_values_field(struct node_values *values, struct node_component which,
                                struct model *model, const struct body *body)
{
    double *buffer = values->buffer;
    if (which.value.member) {
        double *field = member_of(body, which);
        if (field) return corners_mean(body, field, buffer);
        body_clear(body, &buffer, 1);
        return buffer;
    }
    if (which.value.field) return which.value.field(body, values->damage, which.component, buffer);
    const int state = which.value.observe ? -1 : law_state_number(which.value.name);
    const struct strips *strips = model_strips(model, body);
    for (int64_t s = 0; s < strips->count; s++) {
        const struct strip *strip = &strips->items[s];
        struct node_state seen;
        double lanes[LANES], *out = buffer + strip->site;
        if (state >= 0) {
            memcpy(out, model_state(model, strip, state, which.component, lanes),
                   (size_t)strip->count * sizeof *out);
            continue;
        }
        model_observe(model, body, strip, &seen);
        which.value.observe(&seen, which.component, out);
    }
    return buffer;
}
