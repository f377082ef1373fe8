/* Abaqus and CalculiX input (.inp) with one element a voxel: C3D8 and its kin, or four-node
 * elements of a plane.  The values are sets of elements; one that holds all elements says nothing
 * and is passed over.  Where all names end in different numbers these are the values, else 1, 2, 3
 * ... */
#include "image_text.h"

#include "die.h"
#include "image_points.h"
#include "memory.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LINE = 4096, CORNERS = 8 };

struct place {
    int64_t number;
    double at[3];
};

struct element {
    int64_t number;
    int corners;
    int64_t corner[CORNERS];
    int set; /* -1: none yet */
};

/* A set of elements, as lines of numbers, or of names of sets. */
struct set {
    char *name;
    int64_t count;
    int64_t *elements;
    double value;
};

struct inp {
    struct image_text text;
    int64_t n_places, n_elements;
    struct place *places;
    struct element *elements;
    int n_sets;
    struct set *sets;
};

/* --- lines --------------------------------------------------------------------------------------
 */

/* The value of "key=value" on a keyword's line, without blanks; NULL where there is none. */
static char *parameter(const char *line, const char *key)
{
    for (const char *comma = strchr(line, ','); comma; comma = strchr(comma + 1, ',')) {
        const char *at = comma + 1 + strspn(comma + 1, " \t");
        const size_t length = strlen(key);
        if (strncasecmp(at, key, length) != 0) continue;
        at += length;
        at += strspn(at, " \t");
        if (*at != '=' && *at != ',' && *at != '\0') continue;
        if (*at != '=') return memory_text("");
        at += 1 + strspn(at + 1, " \t\"");
        return memory_print("%.*s", (int)strcspn(at, ", \t\""), at);
    }
    return NULL;
}

static bool is_keyword(const char *line, const char *keyword)
{
    const size_t length = strlen(keyword);
    const char *at = line + 1 + strspn(line + 1, " \t");
    return strncasecmp(at, keyword, length) == 0 && !isalpha((unsigned char)at[length]);
}

/* The next line of data; false at a keyword, which stays, and at the end. */
static bool data_line(struct image_text *text, char *line)
{
    struct image_text before = *text;
    while (image_line(text, line, LINE)) {
        if (strncmp(line, "**", 2) == 0 || line[strspn(line, " \t")] == '\0') {
            before = *text;
            continue;
        }
        if (*line != '*') return true;
        *text = before;
        return false;
    }
    return false;
}

/* Numbers between commas; returns how many. */
static int read_numbers(struct image_text *text, const char *line, int most, double *out)
{
    const char *rest = line;
    for (int n = 0;; n++) {
        rest += strspn(rest, " \t,");
        if (*rest == '\0') return n;
        char *end;
        const double value = strtod(rest, &end);
        if (end == rest || n == most) image_refuse(text, "found '%.40s', expected numbers", line);
        out[n] = value;
        rest = end;
    }
}

/* --- keywords -----------------------------------------------------------------------------------
 */

static void read_nodes(struct inp *inp)
{
    char line[LINE];
    double numbers[16];
    while (data_line(&inp->text, line)) {
        const int n = read_numbers(&inp->text, line, 16, numbers);
        if (n < 3) image_refuse(&inp->text, "a node needs a number and coordinates: '%.40s'", line);
        inp->places = memory_grow(inp->places, inp->n_places, sizeof *inp->places);
        inp->places[inp->n_places++] =
            (struct place){(int64_t)numbers[0], {numbers[1], numbers[2], n > 3 ? numbers[3] : 0}};
    }
}

static struct set *set_of(struct inp *inp, const char *name)
{
    for (int i = 0; i < inp->n_sets; i++)
        if (strcasecmp(inp->sets[i].name, name) == 0) return &inp->sets[i];
    inp->sets = memory_grow(inp->sets, inp->n_sets, sizeof *inp->sets);
    inp->sets[inp->n_sets] = (struct set){.name = memory_text(name)};
    return &inp->sets[inp->n_sets++];
}

static void add_member(struct set *set, int64_t element)
{
    set->elements = memory_grow(set->elements, set->count, sizeof *set->elements);
    set->elements[set->count++] = element;
}

/* How many corners elements of the type have; 0: no voxel. */
static int corners_of(const char *type)
{
    static const char *const flat[] = {"CPS4", "CPE4", "CAX4", "S4", "M3D4", "CGPE4"};
    if (strncasecmp(type, "C3D8", 4) == 0 || strncasecmp(type, "DC3D8", 5) == 0 ||
        strncasecmp(type, "EC3D8", 5) == 0)
        return 8;
    for (size_t i = 0; i < sizeof flat / sizeof *flat; i++)
        if (strncasecmp(type, flat[i], strlen(flat[i])) == 0) return 4;
    return 0;
}

static void read_elements(struct inp *inp, const char *keyword)
{
    char line[LINE], *type = parameter(keyword, "type"), *name = parameter(keyword, "elset");
    const int corners = type ? corners_of(type) : 0;
    if (corners == 0)
        image_refuse(
            &inp->text,
            "elements of the type '%.20s' are no voxels: one hexahedron of eight nodes, or "
            "one rectangle of four, for each is read",
            type ? type : "");
    double numbers[32];
    int n = 0;
    while (data_line(&inp->text, line)) {
        n += read_numbers(&inp->text, line, 32 - n, numbers + n);
        if (n < corners + 1) continue;
        if (n > corners + 1)
            image_refuse(&inp->text, "more nodes than the element has: '%.40s'", line);
        struct element element = {(int64_t)numbers[0], corners, {0}, -1};
        for (int c = 0; c < corners; c++) element.corner[c] = (int64_t)numbers[c + 1];
        inp->elements = memory_grow(inp->elements, inp->n_elements, sizeof *inp->elements);
        inp->elements[inp->n_elements++] = element;
        if (name) add_member(set_of(inp, name), element.number);
        n = 0;
    }
    if (n > 0) image_refuse(&inp->text, "an element with fewer nodes than %d", corners);
    free(type);
    free(name);
}

static void read_set(struct inp *inp, const char *keyword)
{
    char line[LINE], *name = parameter(keyword, "elset"), *range = parameter(keyword, "generate");
    char *internal = parameter(keyword, "internal");
    double numbers[64];
    if (!name) image_refuse(&inp->text, "a set without a name");
    while (data_line(&inp->text, line)) {
        if (internal) continue; /* faces of Abaqus/CAE's surfaces */
        if (isalpha((unsigned char)line[strspn(line, " \t")])) continue; /* a set of sets */
        const int n = read_numbers(&inp->text, line, 64, numbers);
        struct set *set = set_of(inp, name);
        const double step = range && n > 2 ? numbers[2] : 1;
        if (range && (n < 2 || !(step >= 1) || numbers[1] - numbers[0] > 1e9))
            image_refuse(&inp->text, "expected first, last and step: '%.40s'", line);
        for (double i = numbers[0]; range && i <= numbers[1]; i += step)
            add_member(set, (int64_t)i);
        for (int i = 0; !range && i < n; i++) add_member(set, (int64_t)numbers[i]);
    }
    free(name);
    free(range);
    free(internal);
}

static void read_all(struct inp *inp)
{
    char line[LINE], skipped[LINE];
    while (image_line(&inp->text, line, sizeof line)) {
        if (*line != '*' || line[1] == '*') continue;
        if (is_keyword(line, "include"))
            image_refuse(&inp->text, "parts of it lie in another file (*INCLUDE): put them in");
        if (is_keyword(line, "node"))
            read_nodes(inp);
        else if (is_keyword(line, "element"))
            read_elements(inp, line);
        else if (is_keyword(line, "elset"))
            read_set(inp, line);
        else
            while (data_line(&inp->text, skipped)) continue;
    }
    if (inp->n_elements == 0) image_refuse(&inp->text, "there are no elements in it");
}

/* --- voxels -------------------------------------------------------------------------------------
 */

static int compare_places(const void *a, const void *b)
{
    const int64_t left = ((const struct place *)a)->number,
                  right = ((const struct place *)b)->number;
    return (left > right) - (left < right);
}

static int compare_elements(const void *a, const void *b)
{
    const int64_t left = ((const struct element *)a)->number,
                  right = ((const struct element *)b)->number;
    return (left > right) - (left < right);
}

/* Each element's set; overlapping ones say nothing clear. */
static void assign_sets(struct inp *inp)
{
    const char *prefix = inp->text.source->array;
    for (int s = 0; s < inp->n_sets; s++) {
        struct set *set = &inp->sets[s];
        if (prefix && strncasecmp(set->name, prefix, strlen(prefix)) != 0) continue;
        if (!prefix && set->count >= inp->n_elements && inp->n_sets > 1) continue;
        for (int64_t i = 0; i < set->count; i++) {
            const struct element wanted = {.number = set->elements[i]};
            struct element *element = bsearch(&wanted, inp->elements, (size_t)inp->n_elements,
                                              sizeof wanted, compare_elements);
            if (!element || element->set == s) continue;
            if (element->set >= 0)
                die_user(
                    "%s: the element %lld is in the sets %s and %s: say by 'array' how the names "
                    "of those that are meant begin",
                    inp->text.source->path, (long long)wanted.number, inp->sets[element->set].name,
                    set->name);
            element->set = s;
        }
    }
}

/* The number at the end of a name, -1 where there is none. */
static double number_at_end(const char *name)
{
    const char *end = name + strlen(name), *at = end;
    while (at > name && isdigit((unsigned char)at[-1])) at--;
    return at < end ? strtod(at, NULL) : -1;
}

static void name_sets(struct inp *inp, struct image *image)
{
    bool *used = memory_new((size_t)inp->n_sets + 1, sizeof *used);
    bool numbered = true;
    for (int64_t i = 0; i < inp->n_elements; i++)
        if (inp->elements[i].set >= 0) used[inp->elements[i].set] = true;
    for (int s = 0; s < inp->n_sets; s++) {
        inp->sets[s].value = number_at_end(inp->sets[s].name);
        if (used[s]) numbered = numbered && inp->sets[s].value > 0;
        for (int other = 0; other < s && used[s]; other++)
            if (used[other] && inp->sets[other].value == inp->sets[s].value) numbered = false;
    }
    for (int s = 0, next = 1; s < inp->n_sets; s++) {
        if (!used[s]) continue;
        if (!numbered) inp->sets[s].value = next++;
        image_add_name(image, inp->sets[s].value, inp->sets[s].name);
    }
    free(used);
}

/* The middle of an element, which has to be a box along the axes. */
static void middle_of(const struct inp *inp, const struct element *element, double middle[3])
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int pass = 0; pass < 2; pass++)
        for (int c = 0; c < element->corners; c++) {
            const struct place wanted = {.number = element->corner[c]};
            const struct place *place =
                bsearch(&wanted, inp->places, (size_t)inp->n_places, sizeof wanted, compare_places);
            if (!place)
                die_user("%s: the element %lld has the node %lld, which is not there",
                         inp->text.source->path, (long long)element->number,
                         (long long)wanted.number);
            for (int axis = 0; axis < 3; axis++) {
                const double at = place->at[axis], slack = 1e-3 * (high[axis] - low[axis]);
                low[axis] = fmin(low[axis], at);
                high[axis] = fmax(high[axis], at);
                if (pass && fmin(at - low[axis], high[axis] - at) > slack)
                    die_user("%s: the element %lld is no box along the axes: no voxel",
                             inp->text.source->path, (long long)element->number);
            }
        }
    for (int axis = 0; axis < 3; axis++) middle[axis] = 0.5 * (low[axis] + high[axis]);
}

void image_inp_read(const struct image_source *source, struct image *image)
{
    static const char advice[] = "one element for each voxel of a box is read";
    struct inp inp = {.text = image_text_of(source)};
    struct image_points points = {0};
    read_all(&inp);
    qsort(inp.places, (size_t)inp.n_places, sizeof *inp.places, compare_places);
    qsort(inp.elements, (size_t)inp.n_elements, sizeof *inp.elements, compare_elements);
    assign_sets(&inp);
    name_sets(&inp, image);
    for (int64_t i = 0; i < inp.n_elements; i++) {
        double middle[3];
        const int set = inp.elements[i].set;
        middle_of(&inp, &inp.elements[i], middle);
        image_points_add(&points, middle[0], middle[1], middle[2],
                         set < 0 ? 0 : inp.sets[set].value);
    }
    image_points_fill(source, &points, -1, advice, image);
    image_add_name(image, 0, "no set");
    image_add_name(image, -1, "no element");
    image_points_free(&points);
    for (int s = 0; s < inp.n_sets; s++) {
        free(inp.sets[s].name);
        free(inp.sets[s].elements);
    }
    free(inp.sets);
    free(inp.places);
    free(inp.elements);
}
