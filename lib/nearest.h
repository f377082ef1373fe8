/* nearest.h - "did you mean ...?" */
#ifndef HS_NEAREST_H
#define HS_NEAREST_H

/* The name most like text, NULL where none is like it.  Likeness is twice the longest common
 * subsequence over the sum of both lengths (Dice), case ignored; 0.6 is demanded. */
const char *nearest_name(const char *text, const char *const names[], int count);

/* "a, b, c"; the caller frees it. */
char *nearest_list(const char *const names[], int count);

#endif
