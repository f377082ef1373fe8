/* targets.h - what reads files of users, one function a kind; any bytes end in an answer or an
 * error with its place. */
#ifndef HS_FUZZ_TARGETS_H
#define HS_FUZZ_TARGETS_H

#include <stddef.h>
#include <stdint.h>

/* The names of libFuzzer (clang -fsanitize=fuzzer).  The environment variable HS_FUZZ chooses the
 * target. */
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* Those of hspost: tables of testing machines and histories, to their properties; fields, to a
 * slice. */
void target_table(const char *path);
void target_frames(const char *path);

/* Inputs that were taken for good so far. */
long targets_accepted(void);

#endif
