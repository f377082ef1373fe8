#include "output.h"

#include "die.h"

#include <errno.h>
#include <string.h>

struct output output_open(const char *path)
{
    if (strcmp(path, "-") == 0)
        die_user("'-': standard output is for the domain; give this file a name");
    struct output output = {.spool = spool_output(path)};
    output.stream = fopen(output.spool.path, "w");
    if (!output.stream) die_run("%s: %s", path, strerror(errno));
    return output;
}

void output_close(struct output *output)
{
    int failed = ferror(output->stream);
    failed = fclose(output->stream) != 0 || failed;
    if (failed) die_run("%s: %s", output->spool.path, strerror(errno));
    spool_finish(&output->spool);
}
