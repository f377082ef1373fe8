#include "die.h"

#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { CLEANERS = 16, LONGEST_MESSAGE = 8192 };

/* The one place where a process keeps what concerns its end.  It leaves by _Exit: functions that
 * die free nothing, which is no leak to be reported. */
static struct {
    const char *program;
    void (*leave)(int code);
    void (*wait)(void);
    void (*clean[CLEANERS])(void);
    int n_clean;
    void (*volatile at_signals[CLEANERS])(void); /* ended by NULL */
    bool quiet;
} process = {.program = "hstools", .leave = _Exit};

void die_set_program(const char *name)
{
    process.program = name;
}

const char *die_program(void)
{
    return process.program;
}

void die_set_exit(void (*leave)(int code))
{
    process.leave = leave;
}

void die_set_wait(void (*wait)(void))
{
    process.wait = wait;
}

void die_at_exit(void (*clean)(void))
{
    for (int i = 0; i < process.n_clean; i++)
        if (process.clean[i] == clean) return;
    if (process.n_clean == CLEANERS) die_run("more than %d functions at exit", CLEANERS);
    process.clean[process.n_clean++] = clean;
}

static void clean_and_die(int signal_number)
{
    for (int i = 0; i < CLEANERS && process.at_signals[i]; i++) process.at_signals[i]();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

void die_at_signals(void (*clean)(void))
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    int n = 0;
    while (n < CLEANERS && process.at_signals[n] && process.at_signals[n] != clean) n++;
    if (n == CLEANERS) die_run("more than %d functions at signals", CLEANERS);
    process.at_signals[n] = clean;
    for (int i = 0; i < 3; i++) {
        struct sigaction old;
        if (sigaction(signals[i], NULL, &old) == 0 && old.sa_handler == SIG_DFL)
            signal(signals[i], clean_and_die);
    }
}

void note_set_quiet(int quiet)
{
    process.quiet = quiet != 0;
}

/* Messages quote what was found in files, so nothing in them may steer the terminal.  No memory is
 * allocated: there may be none. */
static void print(const char *kind, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));
static void print(const char *kind, const char *format, va_list arguments)
{
    char text[LONGEST_MESSAGE];
    vsnprintf(text, sizeof text, format, arguments);
    for (char *c = text; *c != '\0'; c++)
        if (((unsigned char)*c < ' ' && *c != '\n' && *c != '\t') || *c == '\177') *c = '?';
    fprintf(stderr, "%s: %s%s\n", process.program, kind, text);
}

static _Noreturn void leave(int code)
{
    /* Each function is taken off before it runs: one that dies itself does not come round again. */
    while (process.n_clean > 0) process.clean[--process.n_clean]();
    process.leave(code);
    abort();
}

void die_user(const char *format, ...)
{
    va_list arguments;
    if (process.wait) process.wait();
    va_start(arguments, format);
    print("", format, arguments);
    va_end(arguments);
    leave(EXIT_USER);
}

void die_run(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print("", format, arguments);
    va_end(arguments);
    leave(EXIT_RUN);
}

void warn(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print("warning: ", format, arguments);
    va_end(arguments);
}

void note(const char *format, ...)
{
    if (process.quiet) return;
    va_list arguments;
    va_start(arguments, format);
    print("", format, arguments);
    va_end(arguments);
}
