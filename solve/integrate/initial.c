#include "initial.h"

#include "members.h"

void initial_set(const struct scene *scene, struct body *body, enum scene_kind kind)
{
    for (int k = 0; k < scene->n_initial; k++) {
        const struct scene_entry *entry = &scene->initial[k];
        if (entry->kind != kind) continue;
        double *field =
            kind == SCENE_VELOCITY ? body->v[entry->direction] : body->u[entry->direction];
        struct members members = members_of_nodes(body, entry->nodes.numbers, entry->nodes.count);
        for (int64_t i = 0; i < members.count; i++) {
            double x[3];
            body_position(body, members.sites[i], x);
            field[members.sites[i]] = value_at(&entry->value, x, 0);
        }
        members_free(&members);
    }
}
