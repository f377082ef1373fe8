/* text_edits.h - replacements in a text, made all at once. */
#ifndef HS_TEXT_EDITS_H
#define HS_TEXT_EDITS_H

#include <stddef.h>

struct text_edit {
    size_t begin, end; /* bytes that are replaced */
    char *text;
};

struct text_edits {
    int count;
    struct text_edit *items;
};

/* A copy of text is put there later. */
void text_edits_add(struct text_edits *edits, size_t begin, size_t end, const char *text);

/* Index of an edit that lies in the range of another one, -1 where each has its own. */
int text_edits_clash(const struct text_edits *edits);

/* The text with all of them made, in whatever order they came; empty lines where one has fewer than
 * what it replaces keep the numbers of those that follow.  The caller frees it. */
char *text_edits_apply(struct text_edits *edits, const char *text);
void text_edits_free(struct text_edits *edits);

#endif
