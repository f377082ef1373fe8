/* die.h - messages for people, and the end of a failed program.
 *
 * stdout is for data; every line printed here goes to stderr behind the program's name. Exit
 * codes: 2, the user can mend it (option, deck, input file); 1, the run failed (disk, memory,
 * non-finite numbers, lost energy balance); 143, it was asked to stop and did so in order (what
 * a shell says of SIGTERM).  Never 0. */
#ifndef HS_DIE_H
#define HS_DIE_H

enum { EXIT_RUN = 1, EXIT_USER = 2, EXIT_STOPPED = 143 };

#define HS_PRINTF(text, first) __attribute__((format(printf, text, first)))

/* Name that stands before each message, e.g. "hsgen".  Called once, first thing in main. */
void die_set_program(const char *name);
const char *die_program(void);

/* Called instead of _Exit() by the functions below; the solver sets it to end all ranks.
 * It must not return. */
void die_set_exit(void (*leave)(int code));

/* One more function to run before leaving (remove an unfinished output file); the last given runs
 * first. */
void die_at_exit(void (*clean)(void));

/* The same for the end by SIGINT, SIGTERM or SIGHUP, where these are not ignored (nohup) or
 * handled by others (MPI). The function runs in a signal handler: it may call what is safe there
 * alone. */
void die_at_signals(void (*clean)(void));

/* Called before a user's error is told.  A rank that follows another waits here: the first meets
 * the same error, tells it once and ends them all. */
void die_set_wait(void (*wait)(void));

/* The user's error, exit 2.  Say what was wrong, where, and what was expected. */
_Noreturn void die_user(const char *format, ...) HS_PRINTF(1, 2);

/* A failed run, exit 1. */
_Noreturn void die_run(const char *format, ...) HS_PRINTF(1, 2);

/* Something a user should know, and something he may like to know (silent after --quiet). */
void warn(const char *format, ...) HS_PRINTF(1, 2);
void note(const char *format, ...) HS_PRINTF(1, 2);
void note_set_quiet(int quiet);

#endif
