#include "html.h"

#include "csv.h"
#include "encoding.h"
#include "memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Code points that are no characters, which XML refuses. */
static bool is_none(const char *text)
{
    return strncmp(text, "\xEF\xBF\xBE", 3) == 0 || strncmp(text, "\xEF\xBF\xBF", 3) == 0;
}

static const char *entity(char c)
{
    return c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : NULL;
}

void html_text(FILE *page, const char *text)
{
    const char *set;
    char *known = encoding_to_utf8(text, (long)strlen(text), &set);
    for (const char *c = known ? known : ""; *c; c++) {
        if (is_none(c))
            c += 2;
        else if (entity(*c))
            fputs(entity(*c), page);
        else
            fputc((unsigned char)*c < 0x20 && *c != '\n' && *c != '\t' ? ' ' : *c, page);
    }
    free(known);
}

void html_words(FILE *page, const char *name)
{
    char *words = memory_text(name);
    for (char *c = words; *c; c++)
        if (*c == '_') *c = ' ';
    html_text(page, words);
    free(words);
}

/* Of the last digit that is shown. */
static int decimals_of(double value, double error)
{
    enum { DIGITS_OF_ERROR = 2, DIGITS = 4, MOST_DIGITS = 6 };
    const double size = fabs(value);
    const bool known = error > 0 && isfinite(error);
    if (!(size > 0)) return known ? DIGITS_OF_ERROR - 1 - (int)floor(log10(error)) : 0;
    const int first = (int)floor(log10(size));
    const int by_error =
        known ? DIGITS_OF_ERROR - 1 - (int)floor(log10(error)) : DIGITS - 1 - first;
    return by_error < MOST_DIGITS - 1 - first ? by_error : MOST_DIGITS - 1 - first;
}

static void write_rounded(FILE *page, double value, int decimals)
{
    static const double least = 1e-4, most = 1e6;
    const double size = fabs(value);
    if (value != 0 && (size < least || size >= most))
        fprintf(page, "%.*e", (int)fmax(0, floor(log10(size)) + decimals), value);
    else
        fprintf(page, "%.*f", decimals > 0 ? decimals : 0, value);
}

static void write_data(FILE *page, double value, int decimals)
{
    fputs("<data value=\"", page);
    csv_number(page, value);
    fputs("\">", page);
    write_rounded(page, value, decimals);
    fputs("</data>", page);
}

void html_number(FILE *page, double value, double error)
{
    if (isinf(value)) fputs(value > 0 ? "∞" : "-∞", page);
    if (isfinite(value)) write_data(page, value, decimals_of(value, error));
}

void html_quantity(FILE *page, double value, double error, const char *unit)
{
    html_number(page, value, error);
    if (isfinite(value) && error > 0 && isfinite(error)) {
        fputs(" ± ", page);
        write_data(page, error, decimals_of(error, error));
    }
    if (isnan(value) || strcmp(unit, "1") == 0) return;
    fputs(" <span class=\"unit\">", page);
    html_text(page, unit);
    fputs("</span>", page);
}

void html_picture(FILE *page, const char *type, const void *bytes, size_t length)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = bytes;
    fprintf(page, "src=\"data:%s;base64,", type);
    for (size_t i = 0; i < length; i += 3) {
        const size_t there = length - i < 3 ? length - i : 3;
        const unsigned triple = (unsigned)b[i] << 16 | (there > 1 ? (unsigned)b[i + 1] << 8 : 0) |
                                (there > 2 ? b[i + 2] : 0);
        for (size_t k = 0; k < 4; k++)
            fputc(k <= there ? digits[triple >> (18 - 6 * k) & 63] : '=', page);
    }
    fputc('"', page);
}

void html_table(FILE *page)
{
    fputs("<table>\n<colgroup><col class=\"name\"/><col/></colgroup>\n", page);
}

void html_section(FILE *page, const char *id, const char *heading)
{
    fprintf(page, "<section id=\"%s\">\n<h2>%s</h2>\n", id, heading);
}

void html_end(FILE *page)
{
    fputs("</section>\n", page);
}
