#include "nearest.h"

#include "memory.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_NAME = 64 };
static const double least_likeness = 0.6;

static size_t common_subsequence(const char *a, const char *b)
{
    size_t row[LONGEST_NAME + 1] = {0}, columns = strlen(b);
    for (; *a != '\0'; a++) {
        size_t diagonal = 0;
        for (size_t j = 1; j <= columns; j++) {
            size_t above = row[j];
            if (tolower((unsigned char)*a) == tolower((unsigned char)b[j - 1]))
                row[j] = diagonal + 1;
            else if (row[j - 1] > above)
                row[j] = row[j - 1];
            diagonal = above;
        }
    }
    return row[columns];
}

const char *nearest_name(const char *text, const char *const names[], int count)
{
    const char *nearest = NULL;
    double best = least_likeness;
    if (strlen(text) > LONGEST_NAME) return NULL;
    for (int i = 0; i < count; i++) {
        if (strlen(names[i]) > LONGEST_NAME) continue;
        double length = (double)(strlen(text) + strlen(names[i]));
        double likeness = 2 * (double)common_subsequence(text, names[i]) / length;
        if (likeness < best) continue;
        best = likeness;
        nearest = names[i];
    }
    return nearest;
}

char *nearest_list(const char *const names[], int count)
{
    size_t bytes = 1;
    for (int i = 0; i < count; i++) bytes += strlen(names[i]) + 2;
    char *list = memory_new(bytes, 1), *end = list;
    for (int i = 0; i < count; i++) end = stpcpy(stpcpy(end, i > 0 ? ", " : ""), names[i]);
    return list;
}
