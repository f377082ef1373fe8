#include "deck.h"
#include "memory.h"
#include "nearest.h"
#include "units.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* "0 to 0.5", "at least 0", "any number". */
static char *range(double low, double high)
{
    if (isfinite(low) && isfinite(high)) return memory_print("%g to %g", low, high);
    if (isfinite(low)) return memory_print("at least %g", low);
    if (isfinite(high)) return memory_print("at most %g", high);
    return memory_text("any number");
}

static double within(struct deck_node node, double value, const char *unit, double low, double high)
{
    if (value >= low && value <= high) return value;
    const char *shown = strcmp(unit, "1") == 0 ? "" : unit;
    deck_error(node, "%g%s%s is out of range, expected %s%s%s", value, *shown ? " " : "", shown,
               range(low, high), *shown ? " " : "", shown);
}

double deck_number(struct deck_node node, const char *unit, double low, double high)
{
    double value = 0;
    const char *fault = units_read(deck_string(node), unit, &value);
    if (fault != NULL) deck_error(node, "%s", fault);
    return within(node, value, unit, low, high);
}

/* Length of what stands before the word "spacings", 0 where it does not end the text. */
static size_t before_spacings(const char *text)
{
    static const char *const words[] = {"spacings", "spacing"};
    for (int i = 0; i < 2; i++) {
        size_t length = strlen(text), word = strlen(words[i]);
        if (length > word && strcmp(text + length - word, words[i]) == 0) return length - word;
    }
    return 0;
}

double deck_length(struct deck_node node, double spacing, double low, double high)
{
    const char *text = deck_string(node);
    size_t length = before_spacings(text);
    if (length == 0) return deck_number(node, "m", low, high);
    char *number = memory_text(text);
    double value = 0;
    while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
    number[length] = '\0';
    const char *fault = units_read(number, "1", &value);
    if (fault != NULL || length == 0 || !isdigit((unsigned char)number[length - 1]))
        deck_error(node, "'%.40s' is not a length, expected such as 25 um or 3 spacings", text);
    free(number);
    return within(node, value * spacing, "m", low, high);
}

long deck_integer(struct deck_node node, long low, long high)
{
    const char *text = deck_string(node);
    const char *digits = text + (*text == '+' || *text == '-');
    size_t count = strspn(digits, "0123456789");
    errno = 0;
    long value = strtol(text, NULL, 10);
    if (count == 0 || digits[count] != '\0')
        deck_error(node, "'%.40s' is not a whole number", text);
    if (errno == ERANGE || value < low || value > high)
        deck_error(node, "%.40s is out of range, expected %ld to %ld", text, low, high);
    return value;
}

bool deck_bool(struct deck_node node)
{
    static const char *const names[] = {"false", "true"};
    return deck_choice(node, names, 2) == 1;
}

int deck_choice(struct deck_node node, const char *const names[], int count)
{
    const char *text = deck_string(node);
    for (int i = 0; i < count; i++)
        if (strcmp(text, names[i]) == 0) return i;
    const char *nearest = nearest_name(text, names, count);
    deck_error(node, "'%.60s' is not known here (%s%s%sexpected one of: %s)", text,
               nearest ? "did you mean " : "", nearest ? nearest : "", nearest ? "? " : "",
               nearest_list(names, count));
}
