#include "refinement.h"

#include "memory.h"
#include "units.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FINER = 8, FINEST = 16 };

/* --- the spacing ------------------------------------------------------------------------------ */

/* The first number of "25 um", "[25 um, 50 um, 50 um]", quoted or not. */
double refinement_spacing(const char *text, struct deck_node where)
{
    double value = 0;
    text += strspn(text, "[\"' ");
    char *first = memory_print("%.*s", (int)strcspn(text, ",]\"'"), text);
    const char *fault = units_read(first, "m", &value);
    if (fault) deck_error(where, "%s", fault);
    if (!(value > 0)) deck_error(where, "a spacing of %g m", value);
    free(first);
    return value;
}

/* "25 um" to "12.5 um". */
static char *divided(struct deck_node length, int by)
{
    const char *text = deck_string(length);
    char *unit;
    const double value = strtod(text, &unit);
    if (unit == text) deck_error(length, "'%.40s' is not a length", text);
    return memory_print("%.12g%s", value / by, unit);
}

static char *divided_spacing(struct deck_node spacing, int by)
{
    if (!deck_is_list(spacing)) return divided(spacing, by);
    char *text = memory_text("[");
    for (int i = 0; i < deck_count(spacing); i++) {
        char *one = divided(deck_item(spacing, i), by);
        text = memory_append(text, "%s%s", i ? ", " : "", one);
        free(one);
    }
    return memory_append(text, "]");
}

int refinement_count(struct deck_node refine)
{
    const int count = deck_is_list(refine) ? deck_count(refine) : 1;
    if (count < 1 || count > MOST_FINER)
        deck_error(refine, "%d numbers, expected 1 to %d", count, MOST_FINER);
    return count;
}

struct deck_node refinement_where(struct deck_node refine, int i)
{
    return deck_is_list(refine) ? deck_item(refine, i) : refine;
}

char *refinement_text(struct deck_node refine, int i, struct deck_node spacing)
{
    return divided_spacing(spacing, (int)deck_integer(refinement_where(refine, i), 2, FINEST));
}

/* --- lengths in spacings ---------------------------------------------------------------------- */

/* Length of "2 spacings" at the begin of a text, 0 where there is none; its number in *value. */
static size_t length_in_spacings(const char *text, double *value)
{
    static const char word[] = "spacing";
    char *end;
    if (!isdigit((unsigned char)*text) && *text != '.' && *text != '-') return 0;
    *value = strtod(text, &end);
    if (end == text) return 0;
    end += strspn(end, " \t");
    if (strncmp(end, word, sizeof word - 1) != 0) return 0;
    end += sizeof word - 1;
    if (*end == 's') end++;
    return isalnum((unsigned char)*end) ? 0 : (size_t)(end - text);
}

char *refinement_scale(const char *text, double factor)
{
    struct text_edits edits = {0};
    if (factor == 1) return memory_text(text);
    for (size_t i = 0; text[i];) {
        double value;
        const bool within =
            i > 0 && (isalnum((unsigned char)text[i - 1]) || strchr("._-", text[i - 1]));
        const size_t length = within ? 0 : length_in_spacings(text + i, &value);
        if (length) {
            char *scaled = memory_print("%.12g spacings", value * factor);
            text_edits_add(&edits, i, i + length, scaled);
            free(scaled);
        }
        i += length ? length : 1;
    }
    char *result = text_edits_apply(&edits, text);
    text_edits_free(&edits);
    return result;
}

/* --- cores ------------------------------------------------------------------------------------ */

static const char *const placing[] = {"lattice",       "core",   "core_distance",
                                      "core_diameter", "jitter", "offset"};

static bool places_cores(const char *key)
{
    for (size_t i = 0; i < sizeof placing / sizeof *placing; i++)
        if (strcmp(placing[i], key) == 0) return true;
    return false;
}

bool refinement_has_cores(const struct deck *deck)
{
    const struct deck_node domain = deck_get(deck_root(deck), "domain");
    bool has = false;
    for (int i = 0; i < deck_count(domain); i++) has = has || places_cores(deck_key(domain, i));
    return has && !deck_has(domain, "cores");
}

/* In place of the first of the keys stands the file; the others go, within {...} with the comma
 * behind them. */
static void edit_cores(const struct deck *deck, const char *cores, struct text_edits *edits)
{
    const struct deck_node domain = deck_get(deck_root(deck), "domain");
    bool put = false;
    for (int i = 0; i < deck_count(domain); i++) {
        if (!places_cores(deck_key(domain, i))) continue;
        const size_t begin = deck_span(deck_key_node(domain, i)).begin;
        size_t end = deck_span(deck_value(domain, i)).end;
        const bool last = i + 1 == deck_count(domain);
        if (put && !last && !deck_is_block(domain))
            end = deck_span(deck_key_node(domain, i + 1)).begin;
        char *text = put ? memory_text("") : memory_print("cores: %s", cores);
        text_edits_add(edits, begin, end, text);
        free(text);
        put = true;
    }
}

static bool edited(const struct text_edits *edits, size_t at)
{
    for (int i = 0; i < edits->count; i++)
        if (edits->items[i].begin <= at && at < edits->items[i].end) return true;
    return false;
}

static bool within(const struct deck_node nodes[], int count, struct deck_span span)
{
    for (int i = 0; i < count; i++) {
        const struct deck_span outer = deck_span(nodes[i]);
        if (outer.begin <= span.begin && span.end <= outer.end) return true;
    }
    return false;
}

void refinement_edit(const struct deck *deck, const struct deck_paths *paths,
                     const struct deck_node except[], int count, double factor, const char *cores,
                     struct text_edits *edits)
{
    if (cores) edit_cores(deck, cores, edits);
    for (int i = 0; factor != 1 && i < paths->count; i++) {
        const struct deck_node node = paths->items[i].node;
        double value;
        if (!deck_is_scalar(node)) continue;
        const struct deck_span span = deck_span(node);
        if (within(except, count, span)) continue;
        if (span.begin == span.end || edited(edits, span.begin)) continue;
        const char *text = deck_string(node);
        if (length_in_spacings(text, &value) != strlen(text)) continue;
        char *scaled = refinement_scale(text, factor);
        text_edits_add(edits, span.begin, span.end, scaled);
        free(scaled);
    }
}
