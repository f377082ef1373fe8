#include "export.h"

#include "die.h"
#include "output.h"

#include <string.h>
#include <strings.h>

static const struct {
    const char *ending;
    export_format *write;
} formats[] = {{".vti", export_vti}, {".inp", export_inp}};

static export_format *format_of(const char *path)
{
    const size_t length = strlen(path);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const size_t end = strlen(formats[i].ending);
        if (length > end && strcasecmp(path + length - end, formats[i].ending) == 0)
            return formats[i].write;
    }
    die_user("--export %s: expected a name that ends with .vti (ParaView, DAMASK) or .inp (Abaqus, "
             "CalculiX)",
             path);
}

void export_check_name(const char *path)
{
    (void)format_of(path);
}

void export_write(const struct export_source *source, const char *path)
{
    export_format *write = format_of(path);
    if (source->structure->sites->volume)
        die_user("--export %s: cells are cut (volumes: cut), and a voxel is a whole one", path);
    struct output output = output_open(path);
    write(source, output.stream);
    output_close(&output);
}
