#include "snapshot.h"

#include "die.h"
#include "memory.h"
#include "variable.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const axes[3] = {"X", "Y", "Z"};

/* --- variables -------------------------------------------------------------------------------- */

/* Index of the component of a vector; -1 where there is none. */
static int component(const struct frames *frames, const char *vector, int axis)
{
    char *name = memory_print("%s%s", vector, axes[axis]);
    int found = frames_find(frames, name);
    free(name);
    return found;
}

static double *read_values(const struct frames *frames, int variable, int64_t frame)
{
    double *values = memory_new((size_t)frames->n_nodes, sizeof *values);
    exodus_frames_read(frames, variable, frame, values);
    return values;
}

/* sqrt(x^2 + y^2 + z^2); z may be missing. */
static double *read_magnitude(const struct frames *frames, const char *vector, int64_t frame)
{
    double *sum = memory_new((size_t)frames->n_nodes, sizeof *sum);
    for (int axis = 0; axis < 3; axis++) {
        int variable = component(frames, vector, axis);
        if (variable < 0) continue;
        double *values = read_values(frames, variable, frame);
        for (int64_t i = 0; i < frames->n_nodes; i++) sum[i] += values[i] * values[i];
        free(values);
    }
    for (int64_t i = 0; i < frames->n_nodes; i++) sum[i] = sqrt(sum[i]);
    return sum;
}

static bool is_vector(const struct frames *frames, const char *name)
{
    return component(frames, name, 0) >= 0 && component(frames, name, 1) >= 0;
}

static _Noreturn void die_of_variable(const struct frames *frames, const char *file,
                                      const char *name)
{
    char *known = memory_text("");
    for (int i = 0; i < frames->n_variables; i++)
        known = memory_append(known, "%s%s", i > 0 ? ", " : "", frames->variables[i]);
    die_user("%s: no variable '%s'; there are %s; a vector's name without X, Y, Z stands for "
             "its magnitude",
             file, name, known);
}

/* Known of the domain, too. */
static double *read_phase(const struct domain *domain)
{
    double *values = memory_new((size_t)domain->n_nodes, sizeof *values);
    for (int64_t i = 0; i < domain->n_nodes; i++) values[i] = domain->phase[i];
    return values;
}

static void read_field(struct snapshot *snapshot, const struct view_request *request,
                       const struct frames *frames, const char *name)
{
    const int64_t frame = snapshot->frame - 1;
    int variable = frames_find(frames, name), of = variable;
    struct field field = {.name = memory_text(name), .phase = strcmp(name, "Phase") == 0};
    if (variable >= 0) {
        field.values = read_values(frames, variable, frame);
    } else if (field.phase) {
        field.values = read_phase(&snapshot->domain);
    } else if (is_vector(frames, name)) {
        field.values = read_magnitude(frames, name, frame);
        of = component(frames, name, 0);
    } else {
        die_of_variable(frames, request->frames, name);
    }
    field.unit =
        field.phase ? "1" : variable_unit(&snapshot->domain.attributes, frames->variables[of]);
    snapshot->fields[snapshot->n_fields++] = field;
}

static void read_fields(struct snapshot *snapshot, const struct view_request *request,
                        const struct frames *frames)
{
    char *names = memory_text(request->variables), *rest = names;
    size_t most = (size_t)frames->n_variables;
    for (const char *c = names; c && *c; c++) most += *c == ',';
    snapshot->fields = memory_new(most + 1, sizeof *snapshot->fields);
    if (!names)
        for (int i = 0; i < frames->n_variables; i++)
            read_field(snapshot, request, frames, frames->variables[i]);
    for (char *name; names && (name = strsep(&rest, ","));)
        read_field(snapshot, request, frames, name);
    free(names);
}

static void read_displacement(struct snapshot *snapshot, const struct view_request *request,
                              const struct frames *frames)
{
    if (request->factor == 0) return;
    if (!is_vector(frames, "Displacement"))
        die_user("--deformed: %s has no DisplacementX and DisplacementY", request->frames);
    for (int axis = 0; axis < 3; axis++) {
        int variable = component(frames, "Displacement", axis);
        if (variable >= 0)
            snapshot->displacement[axis] = read_values(frames, variable, snapshot->frame - 1);
    }
}

/* --- frames ----------------------------------------------------------------------------------- */

/* The frame nearest to a time that is not further outside than half the distance of two frames. */
static int64_t frame_at(const struct frames *frames, const struct view_request *request)
{
    int64_t last = frames->n_frames - 1, best = 0;
    const double *time = frames->time;
    for (int64_t i = 1; i <= last; i++)
        if (fabs(time[i] - request->at_time) < fabs(time[best] - request->at_time)) best = i;
    double interval = last > 0 ? time[last] - time[last - 1] : 0;
    double margin = fmax(0.5 * interval, 1e-3 * fabs(time[last])); /* times are typed rounded */
    if (request->at_time < time[0] - margin || request->at_time > time[last] + margin)
        die_user("--time %s: %s has frames from %g s to %g s", request->time, request->frames,
                 time[0], time[last]);
    return best + 1;
}

static int64_t choose_frame(const struct frames *frames, const struct view_request *request)
{
    if (!isnan(request->at_time)) return frame_at(frames, request);
    if (request->frame_number == 0) return frames->n_frames;
    if (request->frame_number > frames->n_frames)
        die_user("--frame %ld: %s has %lld frames", request->frame_number, request->frames,
                 (long long)frames->n_frames);
    return request->frame_number;
}

/* --- particles -------------------------------------------------------------------------------- */

/* On a lattice the spacing; else by the volume, of a sheet over its thickness. */
static double *find_sides(const struct domain *domain)
{
    double *side = memory_new((size_t)domain->n_nodes, sizeof *side);
    double spacing = attributes_number(&domain->attributes, "spacing_m", NAN);
    double thickness = attributes_number(&domain->attributes, "thickness_m", NAN);
    for (int64_t i = 0; i < domain->n_nodes; i++)
        side[i] = spacing > 0     ? spacing
                  : thickness > 0 ? sqrt(domain->volume[i] / thickness)
                                  : cbrt(domain->volume[i]);
    return side;
}

const double *snapshot_axis(const struct snapshot *snapshot, int axis)
{
    const struct domain *domain = &snapshot->domain;
    return axis == 0 ? domain->x : axis == 1 ? domain->y : domain->z;
}

/* The particle nearest to a position; of two equally near (the middle of an even number of layers)
 * the upper one. */
static int64_t nearest(const double *x, int64_t count, double position, double slack)
{
    int64_t best = 0;
    for (int64_t i = 1; i < count; i++) {
        double gain = fabs(x[best] - position) - fabs(x[i] - position);
        if (gain > slack || (gain > -slack && x[i] > x[best] + slack)) best = i;
    }
    return best;
}

int64_t *snapshot_slice(const struct snapshot *snapshot, int normal, double position, double *found,
                        int64_t *count)
{
    enum { ROUNDING = 1000000 }; /* a millionth of a side is no distance */
    int64_t n = snapshot->domain.n_nodes, *nodes = memory_new((size_t)n, sizeof *nodes);
    const double *x = snapshot_axis(snapshot, normal), *side = snapshot->side;
    double low = domain_smallest(x, n), high = domain_largest(x, n);
    if (isnan(position)) position = 0.5 * (low + high);
    int64_t middle = nearest(x, n, position, side[0] / ROUNDING);
    if (fabs(x[middle] - position) > side[middle] * (0.5 + 1.0 / ROUNDING) &&
        !(position > low && position < high))
        die_user("--slice: no particle at %c = %g m; the body reaches from %g m to %g m",
                 "xyz"[normal], position, low, high);
    *found = x[middle];
    *count = 0;
    for (int64_t i = 0; i < n; i++)
        if (fabs(x[i] - *found) < side[i] * (0.5 - 1.0 / ROUNDING)) nodes[(*count)++] = i;
    return nodes;
}

/* --- all -------------------------------------------------------------------------------------- */

static void read_frame(struct snapshot *snapshot, const struct view_request *request)
{
    snapshot->time = snapshot->frames.time[snapshot->frame - 1];
    read_fields(snapshot, request, &snapshot->frames);
    read_displacement(snapshot, request, &snapshot->frames);
}

static void free_frame(struct snapshot *snapshot)
{
    for (int i = 0; i < snapshot->n_fields; i++) {
        free(snapshot->fields[i].name);
        free(snapshot->fields[i].values);
    }
    free(snapshot->fields);
    snapshot->fields = NULL;
    snapshot->n_fields = 0;
    for (int axis = 0; axis < 3; axis++) {
        free(snapshot->displacement[axis]);
        snapshot->displacement[axis] = NULL;
    }
}

/* The edge along x is that of y and z where they have none of their own. */
static void find_edges(const struct attributes *facts, double edge[3])
{
    edge[0] = attributes_number(facts, "spacing_m", 0);
    edge[1] = attributes_number(facts, "spacing_y_m", edge[0]);
    edge[2] = attributes_number(facts, "spacing_z_m", edge[0]);
}

struct snapshot snapshot_read(const struct view_request *request)
{
    struct snapshot snapshot = {.input = spool_input(request->frames)};
    snapshot.frames = exodus_frames_open(&snapshot.input);
    snapshot.n_frames = snapshot.frames.n_frames;
    snapshot.domain = exodus_read_domain(&snapshot.input);
    snapshot.frame = choose_frame(&snapshot.frames, request);
    snapshot.side = find_sides(&snapshot.domain);
    find_edges(&snapshot.domain.attributes, snapshot.edge);
    read_frame(&snapshot, request);
    return snapshot;
}

void snapshot_go(struct snapshot *snapshot, const struct view_request *request, int64_t frame)
{
    free_frame(snapshot);
    snapshot->frame = frame;
    read_frame(snapshot, request);
}

void snapshot_free(struct snapshot *snapshot)
{
    free_frame(snapshot);
    free(snapshot->side);
    domain_free(&snapshot->domain);
    exodus_frames_close(&snapshot->frames);
    spool_close(&snapshot->input);
}
