#include "snapshot.h"
#include "study.h"
#include "targets.h"

#include <math.h>
#include <stdlib.h>

void target_table(const char *path)
{
    enum { CHOICES = 64 };
    const char *none[CHOICES] = {0};
    const struct request request = {.n_files = 1, .files = &path, .accept = true, .choices = none};
    struct study study = study_read(&request, "");
    study_free(&study);
}

void target_frames(const char *path)
{
    double found;
    int64_t count;
    const struct view_request request = {
        .frames = path, .csv = true, .position = NAN, .at_time = NAN, .normal = 2, .slice = "z"};
    struct snapshot snapshot = snapshot_read(&request);
    free(snapshot_slice(&snapshot, 2, NAN, &found, &count));
    snapshot_free(&snapshot);
}
