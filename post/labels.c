#include "labels.h"

#include "memory.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 80 };

/* Line i of a text without blanks around it and without a comment; *length 0 beyond the end. */
static const char *line_of(const char *text, int i, size_t *length)
{
    for (; i > 0 && text; i--) {
        text = strchr(text, '\n');
        text = text ? text + 1 : NULL;
    }
    *length = 0;
    if (!text) return "";
    text += strspn(text, " \t-");
    size_t n = strcspn(text, "\n");
    const char *comment = memchr(text, '#', n);
    if (comment) n = (size_t)(comment - text);
    while (n > 0 && strchr(" \t\r", text[n - 1])) n--;
    *length = n;
    return text;
}

static int count_lines(const char *text)
{
    int n = 0;
    for (; *text; text++) n += *text == '\n';
    return n;
}

static bool differ(const char *a, const char *b, int line)
{
    size_t n, m;
    const char *first = line_of(a, line, &n), *second = line_of(b, line, &m);
    return n != m || memcmp(first, second, n) != 0;
}

/* Lines of deck k that are not the same in all sisters; "" where decks are missing or of other
 * lengths. */
static char *what_varies(const struct label labels[], const char *const decks[], int count, int k)
{
    char *text = memory_text("");
    for (int i = 0; i < count; i++) {
        if (strcmp(labels[i].title, labels[k].title) != 0) continue;
        if (!decks[i] || !decks[k] || count_lines(decks[i]) != count_lines(decks[k])) return text;
    }
    for (int line = 0; line < count_lines(decks[k]) + 1; line++) {
        bool varies = false;
        for (int i = 0; i < count; i++)
            varies = varies || (strcmp(labels[i].title, labels[k].title) == 0 &&
                                differ(decks[i], decks[k], line));
        size_t n;
        const char *words = line_of(decks[k], line, &n);
        if (!varies || strlen(text) + n > LONGEST) continue;
        text = memory_append(text, "%s%.*s", *text ? "; " : "", (int)n, words);
    }
    return text;
}

/* "seed 2; ...", what means are taken over. */
static char *scatter_of(const struct varied *varied)
{
    char *text = memory_text("");
    for (int i = 0; i < varied->count; i++) {
        const struct varied_item *item = &varied->items[i];
        if (item->role != VARIED_SCATTER) continue;
        text = memory_append(text, "%s%s %s", *text ? "; " : "", item->name, item->value);
    }
    return text;
}

static int sisters(const struct label labels[], int count, const char *title)
{
    int n = 0;
    for (int i = 0; i < count; i++) n += strcmp(labels[i].title, title) == 0;
    return n;
}

static bool taken(const struct label labels[], int k)
{
    for (int i = 0; i < k; i++)
        if (strcmp(labels[i].curve, labels[k].curve) == 0) return true;
    return false;
}

static const char *base_of(const char *file)
{
    const char *slash = strrchr(file, '/');
    return slash ? slash + 1 : file;
}

struct label *labels_make(const char *const titles[], const char *const files[],
                          const char *const decks[], const struct varied varied[], int count)
{
    struct label *labels = memory_new((size_t)count, sizeof *labels);
    for (int k = 0; k < count; k++)
        labels[k] = (struct label){NULL, titles[k], files[k], NULL, varied[k]};
    for (int k = 0; k < count; k++) {
        struct label *label = &labels[k];
        const bool alone = sisters(labels, count, label->title) == 1;
        label->varied = label->values.count ? scatter_of(&label->values)
                        : alone             ? memory_text("")
                                            : what_varies(labels, decks, count, k);
        const char *tells = *label->varied ? label->varied : base_of(label->file);
        label->curve =
            alone ? memory_text(label->title) : memory_print("%s (%s)", label->title, tells);
        if (!taken(labels, k)) continue;
        free(label->curve);
        label->curve = memory_print("%s (%s)", label->title, label->file);
    }
    return labels;
}

size_t labels_shared(const struct label labels[], int count)
{
    const char *first = labels[0].title;
    size_t shared = count > 1 ? strlen(first) : 0;
    for (int k = 1; k < count; k++) {
        size_t same = 0;
        while (same < shared && labels[k].title[same] == first[same]) same++;
        shared = same;
    }
    while (shared > 1 && strncmp(first + shared - 2, ", ", 2) != 0) shared--;
    return shared > 1 ? shared : 0;
}

void labels_free(struct label labels[], int count)
{
    for (int k = 0; k < count; k++) {
        free(labels[k].curve);
        free(labels[k].varied);
        varied_free(&labels[k].values);
    }
    free(labels);
}

bool labels_differ_in(const struct label *a, const struct label *b, enum varied_role role)
{
    if (a->values.count != b->values.count) return false;
    for (int i = 0; i < a->values.count; i++) {
        const struct varied_item *first = &a->values.items[i], *second = &b->values.items[i];
        if (strcmp(first->name, second->name) != 0 || first->role != second->role) return false;
        if (first->role != VARIED_SCATTER && first->role != role &&
            strcmp(first->value, second->value) != 0)
            return false;
    }
    return true;
}
