/* property.h - a property of a report by its name. */
#ifndef HS_PROPERTY_H
#define HS_PROPERTY_H

#include "check.h"
#include "properties.h"

#include <string.h>

/* Fails where there is none of that name: NAN says "there, but not valid". */
static inline const struct property *property_of(const struct properties *list, const char *name)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->items[i].name, name) == 0) return &list->items[i];
    fail_msg("no property '%s'", name);
    return NULL;
}

static inline double property_value(const struct properties *list, const char *name)
{
    return property_of(list, name)->value;
}

#endif
