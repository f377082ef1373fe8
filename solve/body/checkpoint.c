#include "checkpoint.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_WIDTH = 32 };

/* A strip of bonds as it is looked up: by its offset and first lower end. */
struct bond_key {
    int64_t offset, site, strip;
};

struct checkpoint {
    struct checkpoint_file *file;
    const struct body *body;
    struct bond_key *bonds; /* in order; NULL: not asked for yet */
};

struct checkpoint *checkpoint_new(struct checkpoint_file *file, const struct body *body)
{
    struct checkpoint *checkpoint = memory_new(1, sizeof *checkpoint);
    checkpoint->file = file;
    checkpoint->body = body;
    return checkpoint;
}

void checkpoint_free(struct checkpoint *checkpoint)
{
    free(checkpoint->bonds);
    free(checkpoint);
}

bool checkpoint_reads(const struct checkpoint *checkpoint)
{
    return checkpoint_file_reads(checkpoint->file);
}

/* --- numbers ---------------------------------------------------------------------------------- */

void checkpoint_numbers(struct checkpoint *c, const char *name, double *values, int64_t count)
{
    if (!checkpoint_reads(c)) {
        const bool here = c->body->ranks.rank == 0;
        checkpoint_file_begin(c->file, name, count, here ? 1 : 0);
        if (here) {
            union checkpoint_word *words = checkpoint_file_row(c->file);
            words[0].key = 0;
            memcpy(words + 1, values, (size_t)count * sizeof *values);
        }
        checkpoint_file_end(c->file);
        return;
    }
    for (int64_t left = checkpoint_file_table(c->file, name, &count); left > 0; left--) {
        int64_t rows;
        union checkpoint_word *words = checkpoint_file_block(c->file, count, &rows);
        if (rows > 0) memcpy(values, words + 1, (size_t)count * sizeof *values);
        free(words);
    }
}

void checkpoint_integer(struct checkpoint *c, const char *name, int64_t *value)
{
    double number = (double)*value; /* exact below 2^53 */
    checkpoint_numbers(c, name, &number, 1);
    *value = (int64_t)number;
}

void checkpoint_flag(struct checkpoint *c, const char *name, bool *flag)
{
    double number = *flag ? 1 : 0;
    checkpoint_numbers(c, name, &number, 1);
    *flag = number > 0;
}

/* --- rows of points --------------------------------------------------------------------------- */

/* Rows are gone through twice: how many they are decides where a rank's lie in the file. */
struct rows {
    struct checkpoint *of;
    const char *name;
    int64_t count, width;
    bool counted;
};

static void add_row(struct rows *rows, int64_t key, double *const places[])
{
    if (!rows->counted) {
        rows->count++;
        return;
    }
    union checkpoint_word *word = checkpoint_file_row(rows->of->file);
    word++->key = key;
    for (int64_t k = 0; k < rows->width; k++) word++->number = *places[k];
}

/* Behind a walk through all of them; whether another is to follow. */
static bool once_more(struct rows *rows)
{
    struct checkpoint_file *file = rows->of->file;
    if (rows->counted)
        checkpoint_file_end(file);
    else
        checkpoint_file_begin(file, rows->name, rows->width, rows->count);
    rows->counted = !rows->counted;
    return rows->counted;
}

/* Copies of a site that a rank may have: in a periodic body its images, a period up or down along
 * each axis. */
static int copies(const struct checkpoint *c)
{
    const struct lattice *lattice = c->body->lattice;
    return lattice_is_periodic(lattice) && !lattice_is_row(lattice) ? 27 : 1;
}

/* Where a key's numbers go on this rank, of a copy; false: it has none. */
typedef bool find_places(struct checkpoint *c, const void *of, int64_t key, int copy,
                         double *places[]);

static void read_rows(struct checkpoint *c, const char *name, int64_t width, find_places *find,
                      const void *of)
{
    double *places[MOST_WIDTH];
    for (int64_t left = checkpoint_file_table(c->file, name, &width); left > 0; left--) {
        int64_t rows;
        union checkpoint_word *words = checkpoint_file_block(c->file, width, &rows);
        for (int64_t r = 0; r < rows; r++) {
            const union checkpoint_word *word = words + r * (width + 1);
            for (int copy = 0; copy < copies(c); copy++) {
                if (!find(c, of, word->key, copy, places)) continue;
                for (int64_t k = 0; k < width; k++) *places[k] = word[k + 1].number;
            }
        }
        free(words);
    }
}

/* Box site of a copy of a site of the lattice, the first of which is itself; -1 where this rank
 * does not look at it. */
static int64_t own_site(const struct checkpoint *c, int64_t number, int copy)
{
    static const int shifts[] = {0, -1, 1};
    const struct lattice *lattice = c->body->lattice;
    int at[3];
    if (number < 0 || number >= c->body->lattice->n_sites)
        checkpoint_file_refuse(c->file, "of another body: it has sites that this one has not");
    lattice_position(lattice, number, at);
    for (int a = 0; a < 3; a++, copy /= 3) {
        if (copy % 3 && !lattice->periodic[a]) return -1;
        at[a] += shifts[copy % 3] * lattice->size[a];
    }
    const int64_t site = grid_site(&c->body->grid, at);
    return site >= 0 && c->body->grid.flags[site] ? site : -1;
}

/* --- fields ----------------------------------------------------------------------------------- */

struct field_list {
    double *const *fields;
    int count;
};

static bool find_field(struct checkpoint *c, const void *of, int64_t key, int copy,
                       double *places[])
{
    const struct field_list *list = of;
    const int64_t site = own_site(c, key, copy);
    for (int k = 0; site >= 0 && k < list->count; k++) places[k] = list->fields[k] + site;
    return site >= 0;
}

void checkpoint_fields(struct checkpoint *c, const char *name, double *const fields[], int count)
{
    const struct field_list list = {fields, count};
    if (checkpoint_reads(c)) {
        read_rows(c, name, count, find_field, &list);
        return;
    }
    struct rows rows = {.of = c, .name = name, .width = count};
    const struct strips *owned = &c->body->owned;
    do {
        for (int64_t s = 0; s < owned->count; s++)
            for (int i = 0; i < owned->items[s].count; i++) {
                double *places[MOST_WIDTH];
                const int64_t site = owned->items[s].site + i;
                for (int k = 0; k < count; k++) places[k] = fields[k] + site;
                add_row(&rows, body_number(c->body, site), places);
            }
    } while (once_more(&rows));
}

/* --- points in strips ------------------------------------------------------------------------- */

struct point_list {
    const struct strips *strips;
    checkpoint_place *place;
    void *owner;
    int64_t *strip_of; /* box field: 1 + number of the strip, 0: none */
};

static bool find_point(struct checkpoint *c, const void *of, int64_t key, int copy,
                       double *places[])
{
    const struct point_list *list = of;
    const int64_t site = own_site(c, key, copy), strip = site < 0 ? 0 : list->strip_of[site];
    if (strip == 0) return false;
    const int point = (int)(site - list->strips->items[strip - 1].site);
    return list->place(list->owner, strip - 1, point, true, places);
}

static void read_points(struct checkpoint *c, const char *name, int width, struct point_list *list)
{
    list->strip_of = memory_new((size_t)c->body->grid.n_sites, sizeof *list->strip_of);
    for (int64_t s = 0; s < list->strips->count; s++)
        for (int i = 0; i < list->strips->items[s].count; i++)
            list->strip_of[list->strips->items[s].site + i] = s + 1;
    read_rows(c, name, width, find_point, list);
    free(list->strip_of);
}

void checkpoint_points(struct checkpoint *c, const char *name, const struct strips *strips,
                       int width, checkpoint_place *place, void *owner)
{
    struct point_list list = {.strips = strips, .place = place, .owner = owner};
    if (checkpoint_reads(c)) {
        read_points(c, name, width, &list);
        return;
    }
    struct rows rows = {.of = c, .name = name, .width = width};
    do {
        for (int64_t s = 0; s < strips->count; s++)
            for (int i = 0; i < strips->items[s].count; i++) {
                double *places[MOST_WIDTH];
                const int64_t site = strips->items[s].site + i;
                if ((c->body->grid.flags[site] & SITE_OWNED) && place(owner, s, i, false, places))
                    add_row(&rows, body_number(c->body, site), places);
            }
    } while (once_more(&rows));
}

/* Component by component. */
struct components {
    const struct strips *strips;
    const struct bonds *bonds;
    int count;
    double *state;
};

static bool place_in_strip(void *owner, int64_t strip, int point, bool make, double *places[])
{
    const struct components *of = owner;
    const struct strip *at = &of->strips->items[strip];
    (void)make;
    for (int k = 0; k < of->count; k++)
        places[k] = of->state + of->count * at->store + (int64_t)k * at->stride + point;
    return true;
}

void checkpoint_strips(struct checkpoint *c, const char *name, const struct strips *strips,
                       int components, double *state)
{
    struct components of = {.strips = strips, .count = components, .state = state};
    if (state) checkpoint_points(c, name, strips, components, place_in_strip, &of);
}

/* --- bonds ------------------------------------------------------------------------------------ */

static int compare_keys(const void *a, const void *b)
{
    const struct bond_key *s = a, *t = b;
    if (s->offset != t->offset) return s->offset < t->offset ? -1 : 1;
    if (s->site != t->site) return s->site < t->site ? -1 : 1;
    return (s->strip > t->strip) - (s->strip < t->strip);
}

static void sort_bonds(struct checkpoint *c)
{
    const struct bonds *bonds = c->body->bonds;
    c->bonds = memory_new((size_t)bonds->count + 1, sizeof *c->bonds);
    for (int64_t s = 0; s < bonds->count; s++) {
        const struct bond_view view = bonds_view(bonds, &bonds->strips[s]);
        c->bonds[s] = (struct bond_key){bonds->strips[s].offset, bond_lower(&view, 0), s};
    }
    qsort(c->bonds, (size_t)bonds->count, sizeof *c->bonds, compare_keys);
}

/* Number of strips whose key is not beyond this one. */
static int64_t count_up_to(const struct checkpoint *c, const struct bond_key *key)
{
    int64_t low = 0, high = c->body->bonds->count;
    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (compare_keys(&c->bonds[middle], key) <= 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

struct bond_list {
    checkpoint_place *place;
    void *owner;
};

/* A scattered strip has one lower end, which may have more of them. */
static bool find_bond(struct checkpoint *c, const void *of, int64_t key, int copy, double *places[])
{
    const struct bond_list *list = of;
    const struct bonds *bonds = c->body->bonds;
    const int64_t n = c->body->lattice->n_sites;
    const bool scattered = lattice_is_scattered(c->body->lattice);
    const int64_t lower = own_site(c, scattered ? key / n : key % n, copy),
                  upper = scattered ? own_site(c, key % n, copy) : -1;
    if (lower < 0 || (scattered && upper < 0)) return false;
    const struct bond_key wanted = {scattered ? -1 : key / n, lower, INT64_MAX};
    for (int64_t i = count_up_to(c, &wanted) - 1; i >= 0; i--) {
        const struct bond_key *found = &c->bonds[i];
        const struct bond_view view = bonds_view(bonds, &bonds->strips[found->strip]);
        if (found->offset != wanted.offset) return false;
        if (!scattered) {
            const int64_t point = lower - found->site;
            if (point >= view.count) return false;
            return list->place(list->owner, found->strip, (int)point, true, places);
        }
        if (found->site != lower) return false;
        for (int k = 0; k < view.count; k++)
            if (bond_upper(&view, k) == upper)
                return list->place(list->owner, found->strip, k, true, places);
    }
    return false;
}

static int64_t key_of_bond(const struct checkpoint *c, const struct bond_strip *strip,
                           const struct bond_view *view, int k)
{
    const int64_t n = c->body->lattice->n_sites, lower = body_number(c->body, bond_lower(view, k));
    if (strip->offset >= 0) return strip->offset * n + lower;
    return lower * n + body_number(c->body, bond_upper(view, k));
}

void checkpoint_bonds(struct checkpoint *c, const char *name, int width, checkpoint_place *place,
                      void *owner)
{
    const struct bonds *bonds = c->body->bonds;
    if (checkpoint_reads(c)) {
        const struct bond_list list = {place, owner};
        if (!c->bonds) sort_bonds(c);
        read_rows(c, name, width, find_bond, &list);
        return;
    }
    struct rows rows = {.of = c, .name = name, .width = width};
    do {
        for (int64_t s = 0; s < bonds->count; s++) {
            const struct bond_view view = bonds_view(bonds, &bonds->strips[s]);
            for (int k = 0; k < view.count; k++) {
                double *places[MOST_WIDTH];
                if ((c->body->grid.flags[bond_lower(&view, k)] & SITE_OWNED) &&
                    place(owner, s, k, false, places))
                    add_row(&rows, key_of_bond(c, &bonds->strips[s], &view, k), places);
            }
        }
    } while (once_more(&rows));
}

static bool place_in_bonds(void *owner, int64_t strip, int point, bool make, double *places[])
{
    const struct components *of = owner;
    const struct bond_strip *at = &of->bonds->strips[strip];
    (void)make;
    for (int k = 0; k < of->count; k++)
        places[k] =
            of->state + of->count * at->store + (int64_t)k * bonds_stride(at->count) + point;
    return true;
}

void checkpoint_bond_strips(struct checkpoint *c, const char *name, int components, double *state)
{
    struct components of = {.bonds = c->body->bonds, .count = components, .state = state};
    if (state) checkpoint_bonds(c, name, components, place_in_bonds, &of);
}
