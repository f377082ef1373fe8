/* dies.h - run something that is meant to end the program, in a child, and look at its last words.
 */
#ifndef HS_DIES_H
#define HS_DIES_H

#include "check.h"
#include "die.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Fails unless run(argument) ends with this code and a message that holds this text. */
static inline void assert_dies(int code, const char *text, void (*run)(const void *),
                               const void *argument)
{
    char said[4096] = "";
    FILE *messages = tmpfile();
    assert_non_null(messages);
    pid_t child = fork();
    if (child == 0) {
        dup2(fileno(messages), STDERR_FILENO);
        die_set_exit(_exit);
        run(argument);
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    rewind(messages);
    said[fread(said, 1, sizeof said - 1, messages)] = '\0';
    fclose(messages);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != code || strstr(said, text) == NULL)
        fail_msg("status %#x, said: %s\nexpected exit code %d and \"%s\"", (unsigned)status, said,
                 code, text);
}

/* Exit code of run(argument) in a child that says nothing, 0 where it comes back; 100: it crashed.
 */
static inline int code_of(void (*run)(const void *), const void *argument)
{
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stderr)) _exit(99);
        die_set_exit(_exit);
        run(argument);
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 100;
}

#endif
