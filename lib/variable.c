#include "variable.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* What was written before files could say it, and needs no attribute: to stay as it is. */
static const struct {
    const char *beginning, *unit;
} known[] = {
    {"Displacement", "m"},     {"Velocity", "m/s"}, {"Force", "N/m3"},
    {"ExternalForce", "N/m3"}, {"Stress", "Pa"},    {"VonMises", "Pa"},
};

const char *variable_unit(const struct attributes *file, const char *variable)
{
    char *attribute = memory_print("unit_%s", variable);
    const char *said = attributes_text(file, attribute);
    free(attribute);
    if (said) return said;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strncmp(variable, known[i].beginning, strlen(known[i].beginning)) == 0)
            return known[i].unit;
    return "1";
}

void variable_set_unit(struct attributes *file, const char *variable, const char *unit)
{
    if (strcmp(variable_unit(file, variable), unit) == 0) return;
    char *attribute = memory_print("unit_%s", variable);
    attributes_set_text(file, attribute, unit);
    free(attribute);
}
