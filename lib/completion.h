/* completion.h - what a shell completes a program's command line by. */
#ifndef HS_COMPLETION_H
#define HS_COMPLETION_H

#include "option_row.h"

/* A script for bash or zsh on standard output: the options of the rows, files where an argument is
 * one.  Dies (exit 2) at another shell. */
void completion_print(const char *shell, const char *program, const struct option_row *const rows[],
                      int count);

#endif
