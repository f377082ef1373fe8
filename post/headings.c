#include "headings.h"

#include "rows.h"
#include "units.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 200 };

/* Names in small letters, the likelier first; a unit that does not suit rules a row out, so that
 * a name may stand in two. */
static const struct {
    const char *name, *column, *unit;
    bool has_default; /* without a unit it is in SI */
    const char *names;
} quantities[QUANTITIES] = {
    {"strain", "engineering_strain", "1", true,
     "|engineering strain|eng strain|eng. strain|technische dehnung|tensile strain|axial strain"
     "|extensometer strain|longitudinal strain|strain|strain 1|strain gauge 1|dehnung|dehnung "
     "1|längsdehnung|axialdehnung|ingenieurdehnung|e"
     "|eps|epsilon|ε|elongation|extension|deformation|verformung|extensometer|percent strain"
     /* by the crosshead, where there is another one */
     "|nominal strain|nenndehnung|nominelle dehnung|"},
    {"stress", "engineering_stress_Pa", "Pa", false,
     "|engineering stress|eng stress|eng. stress|nominal stress|technische "
     "spannung|nennspannung|tensile stress|axial stress"
     "|zugspannung|ingenieurspannung|stress|spannung|s|r|sigma|sig|σ|"},
    {"force", "force_N", "N", false,
     "|force|standard force|standardkraft|load|kraft|prüfkraft|axial force|axial load|tensile "
     "force|zugkraft|axialkraft|last|primary force"
     "|load cell|kraftaufnehmer|f|force 1|load 1|"},
    {"extension", "extension_m", "m", false,
     "|extensometer|extensometer extension|extensometer 1|axial extension|strain 1|strain "
     "extension|längenänderung|verlängerung"
     "|dehnung|feindehnung|dehnweg|wegaufnehmer|elongation|extension|deformation|verformung"
     "|displacement|displacement 1|axial displacement|axialweg|standard travel"
     "|standardweg|weg|crosshead|crosshead displacement|crosshead extension|crosshead "
     "travel|traversenweg|traverse|traverse absolut|kolbenweg|maschinenweg|stroke"
     "|position|dl|Δl|∆l|δl|"},
    {"time", "time_s", "s", true,
     "|time|test time|elapsed time|running time|zeit|prüfzeit|testzeit|versuchszeit|t|"},
    {"transverse", "transverse_strain", "1", true,
     "|transverse strain|width strain|lateral strain|querdehnung|breitendehnung|strain 2|dehnung "
     "quer|"},
    {"true_strain", "true_strain", "1", true,
     "|true strain|wahre dehnung|logarithmic strain|umformgrad|"},
    {"true_stress", "true_stress_Pa", "Pa", false,
     "|true stress|wahre spannung|flow stress|fließspannung|"},
};

static const struct {
    const char *fact, *si, *names;
} sizes[] = {
    {"section_m2", "m2",
     "|s0|section|area|cross section|cross-section|cross sectional area|cross-sectional "
     "area|initial area|initial section"
     "|specimen area|sample area|original cross-sectional area|dimension "
     "area|querschnitt|anfangsquerschnitt"
     "|querschnittsfläche|probenquerschnitt|"},
    {"gauge_length_m", "m",
     "|l0|gauge length|gage length|initial gauge length|original gauge length|extensometer "
     "gauge length"
     "|extensometer gage length|dimension length|specimen "
     "length|messlänge|meßlänge|anfangsmesslänge|le|"},
    {"thickness_m", "m",
     "|a0|thickness|specimen thickness|dicke|probendicke|anfangsdicke|blechdicke|"},
    {"width_m", "m", "|b0|width|specimen width|breite|probenbreite|anfangsbreite|"},
    {"diameter_m", "m",
     "|d0|diameter|specimen diameter|durchmesser|probendurchmesser|anfangsdurchmesser|"},
};
enum { SIZES = sizeof sizes / sizeof *sizes };

static const char specimens[] =
    "|specimen|specimen name|specimen id|specimen label|sample|sample name|sample id|probe"
    "|probenname|probenbezeichnung|probenkennung|";

const char *quantity_name(enum quantity quantity)
{
    return quantities[quantity].name;
}
const char *quantity_column(enum quantity quantity)
{
    return quantities[quantity].column;
}
const char *quantity_unit(enum quantity quantity)
{
    return quantities[quantity].unit;
}

/* A byte of UTF-8, and the one before it, as a small letter, umlauts among them; Δ stays. */
static char small(char letter, char before)
{
    const unsigned char byte = (unsigned char)letter;
    const bool capital = byte == 0x84 || byte == 0x96 || byte == 0x9C; /* Ä, Ö, Ü behind 0xC3 */
    return (char)(capital && (unsigned char)before == 0xC3 ? byte + 0x20 : tolower(byte));
}

/* In small letters, with single blanks for blanks, underscores, colons and equals signs, and
 * without what stands in brackets, of which the last goes to unit (NULL: lost). */
static void normalise(const char *text, char name[LONGEST], char unit[LONGEST])
{
    size_t n = 0, m = 0;
    int depth = 0;
    for (; *text && n < LONGEST - 1 && m < LONGEST - 1; text++) {
        const bool opens = strchr("([{", *text), closes = strchr(")]}", *text);
        if (opens && depth == 0) m = 0;
        if (depth > 0 && unit && !opens && !closes) unit[m++] = *text;
        depth += opens - (closes && depth > 0);
        if (depth > 0 || closes) continue;
        const bool blank = isspace((unsigned char)*text) || strchr("_:=\"", *text);
        if (blank && (n == 0 || name[n - 1] == ' ')) continue;
        name[n] = blank ? ' ' : small(*text, n > 0 ? name[n - 1] : ' ');
        n++;
    }
    while (n > 0 && name[n - 1] == ' ') n--;
    name[n] = '\0';
    if (unit) unit[m] = '\0';
}

/* "verlaengerung" as "verlängerung". */
static void fold_umlauts(const char *name, char folded[LONGEST])
{
    size_t n = 0;
    for (; *name; name++) {
        const char *umlaut = name[1] != 'e' ? NULL
                             : *name == 'a' ? "ä"
                             : *name == 'o' ? "ö"
                             : *name == 'u' ? "ü"
                                            : NULL;
        folded[n++] = umlaut ? umlaut[0] : *name;
        if (umlaut) folded[n++] = umlaut[1];
        name += umlaut != NULL;
    }
    folded[n] = '\0';
}

/* Place of a name in a list "|a|b|", -1 where it is not in it. */
static int place_as_written(const char *name, const char *names)
{
    char sought[LONGEST + 2];
    snprintf(sought, sizeof sought, "|%s|", name);
    const char *found = *name ? strstr(names, sought) : NULL;
    int place = 0;
    for (const char *c = names; found && c < found; c++) place += *c == '|';
    return found ? place : -1;
}

static int place_in(const char *name, const char *names)
{
    char folded[LONGEST];
    const int place = place_as_written(name, names);
    fold_umlauts(name, folded);
    return place >= 0 ? place : place_as_written(folded, names);
}

/* The same of a name alone, or of one and its symbol: "kraft f", "messlänge l0". */
static int place_of(const char *name, const char *names)
{
    const char *blank = strrchr(name, ' ');
    const int place = place_in(name, names);
    if (place >= 0 || !blank || place_in(blank + 1, names) < 0) return place;
    char alone[LONGEST];
    snprintf(alone, sizeof alone, "%.*s", (int)(blank - name), name);
    return place_in(alone, names);
}

double heading_factor(const char *unit, const char *si)
{
    char text[LONGEST + 2];
    double factor = NAN;
    if (strcmp(si, "1") == 0 && strcmp(unit, "-") == 0) return 1;
    snprintf(text, sizeof text, "1 %.*s", LONGEST - 2, unit);
    return *unit && !units_read(text, si, &factor) ? factor : NAN;
}

bool heading_is_unit(const char *text)
{
    static const char *const kinds[] = {"1", "Pa", "N", "m", "s", "m2", "K", "m/s", "1/s", "J"};
    char unit[LONGEST], name[LONGEST];
    normalise(text, name, unit);
    const char *inner = *unit && !*name ? unit : text; /* "[%]", but not "strain [%]" */
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (!isnan(heading_factor(inner, kinds[i]))) return true;
    return strcmp(inner, "°C") == 0 || strcmp(inner, "V") == 0;
}

/* The quantity of that name whose unit suits. */
static struct heading look_up(const char *name, const char *unit)
{
    for (int q = 0; q < QUANTITIES; q++) {
        struct heading heading = {(enum quantity)q, place_of(name, quantities[q].names), NAN, ""};
        if (heading.rank < 0) continue;
        const double usual = quantities[q].has_default ? 1 : NAN;
        heading.factor = *unit ? heading_factor(unit, quantities[q].unit) : usual;
        if (*unit && isnan(heading.factor)) continue;
        snprintf(heading.unit, sizeof heading.unit, "%.31s", unit);
        return heading;
    }
    return (struct heading){QUANTITIES, -1, NAN, ""};
}

/* "force n", "stress, mpa", "load / kn", "weg in mm": a unit behind the name, as it was written. */
static struct heading look_up_tail(const char *text, char name[LONGEST])
{
    static const char *const joins[] = {" /", " in", ",", ";", ""};
    char *blank = strrchr(name, ' ');
    struct heading heading = {QUANTITIES, -1, NAN, ""};
    const char *unit = text + strlen(text);
    while (unit > text && !strchr(" _", unit[-1])) unit--;
    if (!blank || unit == text) return heading;
    *blank = '\0';
    for (size_t i = 0; i < sizeof joins / sizeof *joins && heading.quantity == QUANTITIES; i++) {
        const size_t n = strlen(name), m = strlen(joins[i]);
        if (n <= m || strcmp(name + n - m, joins[i]) != 0) continue;
        char stem[LONGEST];
        snprintf(stem, sizeof stem, "%.*s", (int)(n - m), name);
        heading = look_up(stem, unit);
    }
    return heading;
}

/* Unit in brackets of the heading, else of the row of units; "" where there is none. */
static void unit_of(const char *text, const char *below, char name[LONGEST], char unit[LONGEST])
{
    char unused[LONGEST];
    normalise(text, name, unit);
    if (heading_is_unit(unit)) return;
    *unit = '\0';
    if (!below) return;
    normalise(below, unused, unit);
    if (!*unit) snprintf(unit, LONGEST, "%.*s", LONGEST - 1, below);
}

struct heading heading_read(const char *text, const char *unit)
{
    char name[LONGEST], own[LONGEST];
    unit_of(text, unit, name, own);
    struct heading heading = look_up(name, own);
    return heading.quantity == QUANTITIES ? look_up_tail(text, name) : heading;
}

struct heading heading_as(enum quantity quantity, const char *text, const char *unit)
{
    char name[LONGEST], own[LONGEST];
    unit_of(text, unit, name, own);
    const char *si = quantities[quantity].unit, *tail = text + strlen(text);
    while (tail > text && !strchr(" _/", tail[-1])) tail--;
    if (!*own && tail > text && !isnan(heading_factor(tail, si)))
        snprintf(own, sizeof own, "%.*s", LONGEST - 1, tail);
    struct heading heading = {quantity, 0, quantities[quantity].has_default ? 1 : NAN, ""};
    if (*own) heading.factor = heading_factor(own, si);
    snprintf(heading.unit, sizeof heading.unit, "%.31s", own);
    return heading;
}

const char *heading_size(const char *words, char decimal, double *value)
{
    char text[LONGEST], name[LONGEST], unit[LONGEST];
    snprintf(text, sizeof text, "%.*s", LONGEST - 1, words);
    char *token = text, *rest = text;
    double number = NAN;
    for (; *rest; token = rest) { /* to the first number that stands alone */
        token += strspn(token, " \t:=\"");
        rest = token + strcspn(token, " \t:=\"");
        char alone[LONGEST];
        snprintf(alone, sizeof alone, "%.*s", (int)(rest - token), token);
        if (decimal == ',' && rows_is_grouped(alone, '.')) return NULL;
        if (rows_number(alone, decimal, &number) || rows_number(alone, '.', &number)) break;
        number = NAN;
    }
    if (isnan(number)) return NULL;
    char behind[LONGEST], within[LONGEST], unused[LONGEST];
    snprintf(behind, sizeof behind, "%s", rest + strspn(rest, " \t\""));
    *token = '\0';
    normalise(text, name, unit);
    normalise(behind, unused, within);
    if (*within) snprintf(behind, sizeof behind, "%s", within);
    for (int i = 0; i < SIZES; i++) {
        if (place_of(name, sizes[i].names) < 0) continue;
        double factor = heading_factor(*unit ? unit : behind, sizes[i].si);
        *value = number * factor;
        return isnan(factor) ? NULL : sizes[i].fact;
    }
    return NULL;
}

bool heading_is_specimen(const char *words)
{
    char name[LONGEST];
    normalise(words, name, NULL);
    return place_of(name, specimens) >= 0;
}
