#include "text_output.h"

#include "die.h"

#include <errno.h>
#include <stdbool.h>
#include <string.h>

struct text_output text_output_open(const char *name)
{
    struct text_output output = {.file = stdout};
    if (!name || strcmp(name, "-") == 0) return output;
    output.name = name;
    output.spool = spool_output(name);
    output.file = fopen(output.spool.path, "w");
    if (!output.file) die_run("cannot write %s: %s", output.spool.path, strerror(errno));
    return output;
}

void text_output_close(struct text_output *output)
{
    bool written = fflush(output->file) == 0 && !ferror(output->file);
    if (!output->name) {
        if (!written) die_run("cannot write to standard output");
        return;
    }
    if (fclose(output->file) != 0 || !written)
        die_run("cannot write %s: %s", output->name, strerror(errno));
    spool_finish(&output->spool);
}
