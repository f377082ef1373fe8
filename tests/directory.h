/* directory.h - a directory of the test's own, entered before the group and removed behind it. */
#ifndef HS_DIRECTORY_H
#define HS_DIRECTORY_H

#include "memory.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int enter_directory(void **state)
{
    char *directory = strdup("/tmp/hstools-test-XXXXXX");
    if (mkdtemp(directory) == NULL || chdir(directory) != 0) return -1;
    *state = directory;
    return 0;
}

static int leave_directory(void **state)
{
    char *command = memory_print("rm -r %s", (char *)*state);
    int status = system(command);
    free(command);
    free(*state);
    return status;
}

#endif
