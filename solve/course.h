/* course.h - how a run advances.  To add a course: course_NAME.c, its name in the list of scene.h.
 */
#ifndef HS_COURSE_H
#define HS_COURSE_H

#include "scene.h"

struct checkpoint;
struct simulation;

struct course {
    /* Of a name that stands for several: which of them, once end_time is known; NULL: itself.
     * Collective. */
    const struct course *(*choose)(struct simulation *simulation);
    bool moving; /* it starts with inertia: velocities, and a step that is stable */
    /* After the first record, makes what the course remembers, simulation->own for what no other
     * needs to see. */
    void (*begin)(struct simulation *simulation);
    /* From the last record to the next or less; fills simulation->failure where it cannot. */
    void (*advance)(struct simulation *simulation);
    /* What it remembers of its own (checkpoint.h), made by begin; NULL: nothing. */
    void (*visit)(struct simulation *simulation, struct checkpoint *checkpoint);
};

#define COURSE(name, words) course_##name
extern const struct course COURSES(COURSE);

#endif
