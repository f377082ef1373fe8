#include "units.h"

#include "die.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

enum { LONGEST_UNIT = 64 };

static const struct {
    const char *unit, *name;
} dimensions[] = {
    {"1", "a pure number"},
    {"m", "a length"},
    {"m2", "an area"},
    {"m3", "a volume"},
    {"s", "a time"},
    {"1/s", "a rate"},
    {"m/s", "a velocity"},
    {"m/s2", "an acceleration"},
    {"kg", "a mass"},
    {"kg/m3", "a density"},
    {"N", "a force"},
    {"Pa", "a stress"},
    {"J", "an energy"},
    {"K", "a temperature"},
    {"Pa s", "a viscosity"},
    {"1/m", "an inverse length"},
    {"N/m3", "a force density"},
};
enum { DIMENSIONS = sizeof dimensions / sizeof *dimensions };

/* Read once a process: the database is a megabyte of XML. */
static ut_system *unit_system(void)
{
    static ut_system *units;
    if (units == NULL) {
        ut_set_error_message_handler(ut_ignore);
        units = ut_read_xml(NULL);
        if (units == NULL) die_run("cannot read the units database of UDUNITS-2");
    }
    return units;
}

/* Convertible is not enough: UDUNITS also converts a unit to its reciprocal. */
static bool same_dimension(const ut_unit *a, const ut_unit *b)
{
    ut_unit *quotient = ut_divide(a, b);
    bool same = quotient != NULL && ut_is_dimensionless(quotient);
    ut_free(quotient);
    return same;
}

/* "/s" is "1/s". */
static ut_unit *parse(const char *unit)
{
    char text[LONGEST_UNIT + 2];
    if (strlen(unit) > LONGEST_UNIT) return NULL;
    snprintf(text, sizeof text, "%s%s", *unit == '/' ? "1" : "", unit);
    return ut_parse(unit_system(), text, UT_UTF8);
}

static const char *dimension(const ut_unit *unit)
{
    const char *name = "of another dimension";
    for (int i = 0; i < DIMENSIONS; i++) {
        ut_unit *candidate = parse(dimensions[i].unit);
        if (same_dimension(unit, candidate)) name = dimensions[i].name;
        ut_free(candidate);
    }
    return name;
}

/* "a length in m", "a pure number". */
static const char *wanted(const char *expected)
{
    static char text[64];
    ut_unit *unit = parse(expected);
    bool pure = strcmp(expected, "1") == 0;
    if (unit == NULL) die_run("units_read: the program asks for '%s'", expected);
    snprintf(text, sizeof text, "%s%s%s", dimension(unit), pure ? "" : " in ",
             pure ? "" : expected);
    ut_free(unit);
    return text;
}

/* Length of a decimal number at the start of text, 0 where there is none.  strtod alone would also
 * take nan, inf and hexadecimal numbers. */
static size_t number_length(const char *text)
{
    size_t length = *text == '+' || *text == '-';
    size_t whole = strspn(text + length, "0123456789"), part = 0;
    length += whole;
    if (text[length] == '.') {
        part = strspn(text + length + 1, "0123456789");
        length += 1 + part;
    }
    if (whole + part == 0) return 0;
    if (tolower((unsigned char)text[length]) == 'e') {
        size_t sign = text[length + 1] == '+' || text[length + 1] == '-';
        size_t power = strspn(text + length + 1 + sign, "0123456789");
        if (power > 0) length += 1 + sign + power;
    }
    return length;
}

/* factor is exact for 1e-6 and its like only as a division by the inverse. */
static double scaled(double number, double factor)
{
    double inverse = round(1 / factor);
    bool reciprocal = factor < 1 && fabs(inverse * factor - 1) < 1e-15;
    return reciprocal ? number / inverse : number * factor;
}

static const char *complain(const char *format, ...) __attribute__((format(printf, 1, 2)));
static const char *complain(const char *format, ...)
{
    static char message[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    return message;
}

/* UDUNITS would read "m 2" as two metres.  Numbers are meant only as the 1 of "1/s" and as powers,
 * which follow a letter, a sign or a bracket. */
static bool has_no_factor(const char *unit)
{
    bool inverse = *unit == '1' && unit[1 + strspn(unit + 1, " ")] == '/';
    for (const char *c = unit + inverse; *c != '\0'; c++) {
        unsigned char before = c == unit ? ' ' : (unsigned char)c[-1];
        if (isdigit((unsigned char)*c) && (isspace(before) || strchr("/*.", before) != NULL))
            return false;
    }
    return true;
}

/* Multiplies *number by the unit. */
static const char *convert(const char *name, ut_unit *unit, ut_unit *target, double *number)
{
    cv_converter *converter = ut_get_converter(unit, target);
    if (converter == NULL) return complain("'%s' cannot be converted", name);
    double origin = cv_convert_double(converter, 0), factor = cv_convert_double(converter, 1);
    cv_free(converter);
    if (origin != 0) return complain("'%s' has an origin of its own", name);
    *number = scaled(*number, factor);
    return isfinite(*number) ? NULL : complain("number too large in '%s'", name);
}

static const char *apply_unit(const char *name, const char *expected, double *number)
{
    if (strlen(name) > LONGEST_UNIT || !has_no_factor(name))
        return complain("'%.40s' is not a unit, expected %s", name, wanted(expected));
    ut_unit *unit = parse(name), *target = parse(expected);
    const char *fault;
    if (unit == NULL)
        fault = complain("unknown unit '%s', expected %s", name, wanted(expected));
    else if (!same_dimension(unit, target))
        fault = complain("'%s' is %s, expected %s", name, dimension(unit), wanted(expected));
    else
        fault = convert(name, unit, target, number);
    ut_free(unit);
    ut_free(target);
    return fault;
}

const char *units_read(const char *text, const char *expected, double *value)
{
    while (isspace((unsigned char)*text)) text++;
    size_t length = number_length(text);
    if (length == 0 || strncasecmp(text + strspn(text, "+-"), "0x", 2) == 0)
        return complain("'%.40s' is not a number, expected %s", text, wanted(expected));
    double number = strtod(text, NULL);
    if (!isfinite(number)) return complain("'%.40s' is too large", text);
    const char *unit = text + length + strspn(text + length, " \t");
    const char *fault = *unit == '\0' ? NULL : apply_unit(unit, expected, &number);
    if (fault == NULL) *value = number;
    return fault;
}

/* The unit of the table that measures the same; NULL where there is none. */
static const char *kin_of(const char *name)
{
    const char *kin = *name ? NULL : "1";
    ut_unit *unit = kin ? NULL : parse(name);
    for (int i = 0; unit && !kin && i < DIMENSIONS; i++) {
        ut_unit *candidate = parse(dimensions[i].unit);
        if (same_dimension(unit, candidate)) kin = dimensions[i].unit;
        ut_free(candidate);
    }
    ut_free(unit);
    return kin;
}

bool units_read_any(const char *text, double *value)
{
    const size_t length = number_length(text);
    const char *expected = length ? kin_of(text + length + strspn(text + length, " \t")) : NULL;
    return expected && !units_read(text, expected, value);
}
