#include "programme.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct entry {
    double strain, stress, between[2];
    int64_t cycles;
    struct deck_node reload, loops;
};
#define AT(member) offsetof(struct entry, member)

static const double most_strain = 10;

static const struct key rows[] = {
    {"to_strain", KEY_NUMBER, AT(strain), "1", -0.9, 10, .usual = NAN, .otherwise = "none",
     .help = "of the gauge, from wherever it is"},
    {"unload_to", KEY_NUMBER, AT(stress), "Pa", -1e12, 1e12, .usual = NAN, .otherwise = "none",
     .help = "engineering stress, at which the grips turn; negative: into compression; more than "
             "twice what any phase bears is refused"},
    {"reload", KEY_NODE, AT(reload), .form = "nothing, or true",
     .help = "to the strain from which it was unloaded"},
    {"loops_at", KEY_NODE, AT(loops), .form = "[e1, e2, ...]",
     .help = "rising strains, at each of which it is unloaded to unload_to (0 MPa without it) and "
             "reloaded"},
    {"cycles", KEY_INTEGER, AT(cycles), NULL, 1, 1e6, .otherwise = "none",
     .help = "how often it goes to the second strain of between, and to the first"},
    {"between", KEY_NUMBER, AT(between), "1", -0.9, 10, .size = 2, .rising = true, .usual = NAN,
     .otherwise = "none", .help = "strains, of cycles"},
};

const struct section section_programme = {
    .path = "solver.programme",
    .help =
        "A list of what is done one after the other, in place of end_strain: each entry has one of "
        "to_strain, unload_to, reload, loops_at and cycles.  As [{to_strain: 1 %}, {unload_to: 0 "
        "MPa}, {reload}, {to_strain: 2 %}], or [{loops_at: [1 %, 2 %]}, {to_strain: 3 %}].  The "
        "grips go back and forth with the velocities, numbers, that boundary gives them (periodic "
        "bodies with the rate of xx of macroscopic); each turn "
        "is followed by at least 30 steps of the elastic strain that it undoes.",
    .keys = KEYS(rows)};

static void add(struct programme *programme, enum leg_kind kind, double target,
                struct deck_node where)
{
    programme->legs = memory_grow(programme->legs, programme->count, sizeof *programme->legs);
    programme->legs[programme->count++] = (struct leg){kind, target, where};
}

static void add_loops(struct programme *programme, const struct entry *entry,
                      struct deck_node where)
{
    const double stress = isnan(entry->stress) ? 0 : entry->stress;
    double before = -1;
    for (int i = 0; i < deck_count(entry->loops); i++) {
        const struct deck_node item = deck_item(entry->loops, i);
        const double strain = deck_number(item, "1", -0.9, most_strain);
        if (!(strain > before))
            deck_error(item, "%g is not above the strain before it: loops are given as they rise",
                       strain);
        before = strain;
        add(programme, LEG_TO_STRAIN, strain, where);
        add(programme, LEG_TO_STRESS, stress, where);
        add(programme, LEG_RELOAD, NAN, where);
    }
}

static void add_cycles(struct programme *programme, const struct entry *entry,
                       struct deck_node where)
{
    if (isnan(entry->between[0])) deck_get(where, "between"); /* dies */
    for (int64_t i = 0; i < entry->cycles; i++) {
        add(programme, LEG_TO_STRAIN, entry->between[1], where);
        add(programme, LEG_TO_STRAIN, entry->between[0], where);
    }
}

static bool is_unloaded(const struct programme *programme)
{
    return programme->count > 0 && programme->legs[programme->count - 1].kind == LEG_TO_STRESS;
}

static void add_entry(struct programme *programme, struct deck_node where)
{
    struct entry entry;
    if (deck_is_scalar(where) && strcmp(deck_string(where), "reload") == 0)
        entry = (struct entry){NAN, NAN, {NAN, NAN}, 0, where, {0}};
    else
        keys_read(where, &section_programme, 0, 0, &entry, NULL);
    const bool loops = entry.loops.index != 0, reload = entry.reload.index != 0;
    const int count = !isnan(entry.strain) + (!isnan(entry.stress) && !loops) + reload + loops +
                      (entry.cycles > 0);
    if (count != 1 || (!isnan(entry.between[0]) && entry.cycles == 0))
        deck_error(where, "expected one of to_strain, unload_to, reload, loops_at (with unload_to, "
                          "or without) and cycles (with between)");
    if (reload && !is_unloaded(programme))
        deck_error(where, "reload follows nothing that unloads: unload_to stands before it");
    if (loops)
        add_loops(programme, &entry, where);
    else if (entry.cycles > 0)
        add_cycles(programme, &entry, where);
    else if (reload)
        add(programme, LEG_RELOAD, NAN, where);
    else if (!isnan(entry.stress))
        add(programme, LEG_TO_STRESS, entry.stress, where);
    else
        add(programme, LEG_TO_STRAIN, entry.strain, where);
}

struct programme programme_read(struct deck_node list)
{
    struct programme programme = {0};
    if (list.index == 0) return programme;
    for (int i = 0; i < deck_count(list); i++) add_entry(&programme, deck_item(list, i));
    if (!(programme_farthest(&programme) > 0))
        deck_error(list, "no strain to go to: expected to_strain, loops_at or cycles among it");
    return programme;
}

void programme_free(struct programme *programme)
{
    free(programme->legs);
    *programme = (struct programme){0};
}

double programme_farthest(const struct programme *programme)
{
    double farthest = 0;
    for (int i = 0; i < programme->count; i++)
        if (programme->legs[i].kind == LEG_TO_STRAIN)
            farthest = fmax(farthest, fabs(programme->legs[i].target));
    return farthest;
}

double programme_way(const struct programme *programme)
{
    const double back = 0.01;
    double way = 0, at = 0;
    for (int i = 0; i < programme->count; i++) {
        const struct leg *leg = &programme->legs[i];
        const bool strain = leg->kind == LEG_TO_STRAIN;
        way += strain ? fabs(leg->target - at) : back;
        if (strain) at = leg->target;
    }
    return way;
}
