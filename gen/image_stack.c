/* A stack of files with a layer each, named by a pattern such as slices/s*.tif: lowest first, in
 * the order of the numbers in their names (s2 before s10). */
#include "image.h"

#include "die.h"
#include "memory.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int compare_names(const void *a, const void *b)
{
    return strverscmp(*(char *const *)a, *(char *const *)b);
}

bool image_is_stack(const char *path)
{
    return strpbrk(path, "*?") != NULL && access(path, F_OK) != 0;
}

static void check_layer(const char *path, const struct image *layer, const char *first_path,
                        const struct image *first)
{
    const int64_t *count = layer->count;
    if (count[2] != 1)
        die_user("%s: %lld layers, and a file of a stack has one", path, (long long)count[2]);
    if (count[0] != first->count[0] || count[1] != first->count[1])
        die_user("%s: %lld x %lld pixels, where %s has %lld x %lld", path, (long long)count[0],
                 (long long)count[1], first_path, (long long)first->count[0],
                 (long long)first->count[1]);
}

struct image image_read_stack(const char *pattern, const char *array, const struct image_raw *raw)
{
    glob_t found;
    struct image stack = {0};
    if (glob(pattern, GLOB_NOSORT, NULL, &found) != 0 || found.gl_pathc == 0)
        die_user("no file has a name like the image's, %s", pattern);
    char **paths = found.gl_pathv;
    const size_t layers = found.gl_pathc;
    qsort(paths, layers, sizeof *paths, compare_names);
    for (size_t l = 0; l < layers; l++) {
        struct image layer = image_read_file(paths[l], array, raw);
        check_layer(paths[l], &layer, paths[0], l == 0 ? &layer : &stack);
        const size_t area = (size_t)(layer.count[0] * layer.count[1]);
        if (l == 0) {
            const double count[3] = {(double)layer.count[0], (double)layer.count[1],
                                     (double)layers};
            const struct image_source source = {.path = pattern};
            stack = layer;
            image_size(&source, &stack, count, (double)area * count[2]);
            /* What one layer says of its thickness is not the distance of layers. */
            if (layers > 1) stack.edge[2] = 0;
            layer.n_names = 0;
            layer.names = NULL;
        }
        memcpy(stack.value + l * area, layer.value, area * sizeof *stack.value);
        image_free(&layer);
    }
    globfree(&found);
    return stack;
}
