#include "text_edits.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

void text_edits_add(struct text_edits *edits, size_t begin, size_t end, const char *text)
{
    edits->items = memory_grow(edits->items, edits->count, sizeof *edits->items);
    edits->items[edits->count++] = (struct text_edit){begin, end, memory_text(text)};
}

int text_edits_clash(const struct text_edits *edits)
{
    for (int i = 0; i < edits->count; i++)
        for (int k = 0; k < edits->count; k++)
            if (i != k && edits->items[i].begin >= edits->items[k].begin &&
                edits->items[i].begin < edits->items[k].end)
                return i;
    return -1;
}

static int by_begin(const void *a, const void *b)
{
    const struct text_edit *first = a, *second = b;
    return (first->begin > second->begin) - (first->begin < second->begin);
}

/* Empty lines for those of the old text that the new one has not. */
static char *add_lines(char *end, const struct text_edit *edit, const char *text)
{
    int lines = 0;
    for (size_t i = edit->begin; i < edit->end; i++) lines += text[i] == '\n';
    for (const char *c = edit->text; *c; c++) lines -= *c == '\n';
    for (; lines > 0; lines--) *end++ = '\n';
    return end;
}

char *text_edits_apply(struct text_edits *edits, const char *text)
{
    size_t length = 2 * strlen(text), at = 0;
    for (int i = 0; i < edits->count; i++) length += strlen(edits->items[i].text);
    char *result = memory_new(length + 1, 1), *end = result;
    if (edits->count > 1) qsort(edits->items, (size_t)edits->count, sizeof *edits->items, by_begin);
    for (int i = 0; i < edits->count; i++) {
        const struct text_edit *edit = &edits->items[i];
        end = mempcpy(end, text + at, edit->begin - at);
        end = stpcpy(end, edit->text);
        end = add_lines(end, edit, text);
        at = edit->end;
    }
    /* Of which none is needed at the end. */
    if (text[at] == '\0')
        while (end - result > 1 && end[-1] == '\n' && end[-2] == '\n') end--;
    strcpy(end, text + at);
    return result;
}

void text_edits_free(struct text_edits *edits)
{
    for (int i = 0; i < edits->count; i++) free(edits->items[i].text);
    free(edits->items);
    *edits = (struct text_edits){0};
}
