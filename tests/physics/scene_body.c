#include "scene_body.h"

#include "check.h"

#include "initial.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

void scene_body_new(struct scene_body *it, const struct small_case *wanted, const char *sections,
                    double damping, double dt)
{
    char *text = memory_print("{%s, solver: {type: explicit, horizon: 1, end_time: 1}}", sections);
    small_body_new(&it->small, wanted);
    it->deck = deck_parse(text, strlen(text), "test");
    it->scene = scene_read(it->deck);
    it->domain = small_body_domain(&it->small.lattice);
    scene_resolve(&it->scene, &it->domain, &it->domain, &it->small.lattice);
    it->boundary = boundary_new(&it->scene, &it->small.body, 1e12);
    initial_set(&it->scene, &it->small.body, SCENE_DISPLACEMENT);
    initial_set(&it->scene, &it->small.body, SCENE_VELOCITY);
    it->integration = integration_new(true, dt, damping, &it->small.materials, &it->small.body,
                                      &it->boundary, it->small.model);
    free(text);
}

void scene_body_free(struct scene_body *it)
{
    integration_free(&it->integration);
    boundary_free(&it->boundary);
    scene_free(&it->scene);
    domain_free(&it->domain);
    deck_free(it->deck);
    small_body_free(&it->small);
}

void scene_body_step(struct scene_body *it)
{
    verlet_step(&it->integration, &it->small.body, &it->boundary, it->small.model, true, false);
    integration_raise_loads(&it->integration, &it->small.body, &it->boundary, false);
}
