/* The head of a classic netCDF file: "CDF", version, number of records, then lists of dimensions,
 * attributes and variables, all big-endian.  Format: Unidata, "The NetCDF File Format
 * Specifications", appendix B of the netCDF User's Guide. */
#include "die.h"
#include "exodus_file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct head {
    FILE *stream;
    const char *shown;
    uint64_t bytes; /* of the file */
    int width;      /* of counts: 4, in version 5 8 */
    int offset;     /* of positions: 4, from version 2 on 8 */
    uint64_t records;
    int64_t unlimited;  /* the dimension of records; -1: none */
    const char *wanted; /* name of a variable that is looked for; NULL: none */
    int64_t place;      /* where it begins */
};

enum { DIMENSIONS = 10, VARIABLES = 11, ATTRIBUTES = 12, TYPES = 12 };

static _Noreturn void damaged(const struct head *head, const char *what)
{
    die_user("%s: not a netCDF file, or a truncated or damaged one (%s)", head->shown, what);
}

static uint64_t get_number(const struct head *head, int width)
{
    uint64_t number = 0;
    for (int i = 0; i < width; i++) {
        int byte = fgetc(head->stream);
        if (byte == EOF) damaged(head, "ends in its head");
        number = number << 8 | (uint64_t)byte;
    }
    return number;
}

/* A count of things that take at least size bytes each in the head. */
static uint64_t get_count(const struct head *head, uint64_t size)
{
    uint64_t count = get_number(head, head->width);
    if (count > head->bytes / size) damaged(head, "a count larger than the file");
    return count;
}

static void skip(const struct head *head, uint64_t bytes)
{
    uint64_t padded = (bytes + 3) / 4 * 4, at = (uint64_t)ftello(head->stream);
    if (padded > head->bytes - at) damaged(head, "ends in its head");
    fseeko(head->stream, (off_t)padded, SEEK_CUR);
}

/* Whether it is the one that is looked for. */
static bool get_name(const struct head *head)
{
    char name[NC_MAX_NAME + 4] = "";
    uint64_t length = get_count(head, 1), padded = (length + 3) / 4 * 4;
    if (length > NC_MAX_NAME) damaged(head, "a name too long");
    if (fread(name, 1, padded, head->stream) < padded) damaged(head, "ends in its head");
    name[length] = '\0';
    return head->wanted && strcmp(name, head->wanted) == 0;
}

/* The tag and length of a list; an absent one has the tag 0. */
static uint64_t get_list(const struct head *head, uint64_t expected)
{
    uint64_t tag = get_number(head, 4), count = get_count(head, 8);
    if (tag != expected && !(tag == 0 && count == 0)) damaged(head, "a list expected");
    return count;
}

static uint64_t get_type_size(const struct head *head)
{
    static const uint64_t sizes[TYPES] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    uint64_t type = get_number(head, 4);
    if (type == 0 || type >= TYPES) damaged(head, "an unknown type");
    return sizes[type];
}

static void check_attributes(const struct head *head)
{
    uint64_t count = get_list(head, ATTRIBUTES);
    for (uint64_t i = 0; i < count; i++) {
        get_name(head);
        uint64_t size = get_type_size(head);
        skip(head, get_count(head, size) * size);
    }
}

static void check_variables(struct head *head, uint64_t dimensions)
{
    uint64_t count = get_list(head, VARIABLES);
    for (uint64_t i = 0; i < count; i++) {
        const bool wanted = get_name(head);
        bool to_come = false; /* its first record is */
        uint64_t rank = get_count(head, 4);
        if (rank > NC_MAX_VAR_DIMS) damaged(head, "a variable of too many dimensions");
        for (uint64_t d = 0; d < rank; d++) {
            const uint64_t dimension = get_number(head, head->width);
            if (dimension >= dimensions) damaged(head, "an unknown dimension");
            to_come |= d == 0 && head->records == 0 && (int64_t)dimension == head->unlimited;
        }
        check_attributes(head);
        get_type_size(head);
        get_number(head, head->width); /* size: too large a one is capped by the writers */
        uint64_t begin = get_number(head, head->offset);
        if (begin > head->bytes && !to_come) damaged(head, "a variable beyond its end");
        if (wanted) head->place = (int64_t)begin;
    }
}

/* False where it is HDF5, whose library checks what it reads. */
static bool check_head(struct head *head)
{
    char magic[4] = "";
    size_t got = fread(magic, 1, sizeof magic, head->stream);
    if (got == 4 && memcmp(magic, "\211HDF", 4) == 0) return false;
    if (got < 4 || memcmp(magic, "CDF", 3) != 0) damaged(head, "no magic number");
    if (magic[3] != 1 && magic[3] != 2 && magic[3] != 5) damaged(head, "unknown version");
    head->width = magic[3] == 5 ? 8 : 4;
    head->offset = magic[3] == 1 ? 4 : 8;
    /* Every record holds a time at least; all bits set means "as many as the length gives". */
    uint64_t records = get_number(head, head->width);
    uint64_t streaming = head->width == 4 ? UINT32_MAX : UINT64_MAX;
    if (records != streaming && records > head->bytes / 4) damaged(head, "too many records");
    head->records = records;
    uint64_t dimensions = get_list(head, DIMENSIONS);
    for (uint64_t i = 0; i < dimensions; i++) {
        get_name(head);
        const uint64_t length = get_number(head, head->width);
        if (length > INT64_MAX / 8) damaged(head, "a dimension too large");
        if (length == 0) head->unlimited = (int64_t)i;
    }
    check_attributes(head);
    check_variables(head, dimensions);
    return true;
}

/* Where the wanted variable begins; whether the file is a classic one. */
static bool walk(const char *path, const char *shown, const char *wanted, int64_t *place)
{
    struct stat status;
    struct head head = {.stream = fopen(path, "rb"),
                        .shown = shown,
                        .unlimited = -1,
                        .wanted = wanted,
                        .place = -1};
    if (head.stream == NULL || fstat(fileno(head.stream), &status) != 0)
        die_user("%s: cannot be opened", shown);
    head.bytes = (uint64_t)status.st_size;
    const bool classic = check_head(&head);
    fclose(head.stream);
    *place = head.place;
    return classic;
}

bool exodus_check_header(const char *path, const char *shown)
{
    int64_t place;
    return walk(path, shown, NULL, &place);
}

int64_t exodus_variable_place(const char *path, const char *shown, const char *name)
{
    int64_t place;
    walk(path, shown, name, &place);
    if (place < 0) die_user("%s: no variable %s in it", shown, name);
    return place;
}

void exodus_set_records(const char *path, const char *shown, int64_t records)
{
    FILE *stream = fopen(path, "r+b");
    if (stream == NULL) die_run("%s: cannot be written", shown);
    fseeko(stream, 3, SEEK_SET);
    const int width = fgetc(stream) == 5 ? 8 : 4;
    fseeko(stream, 4, SEEK_SET);
    for (int i = width - 1; i >= 0; i--) fputc((int)(records >> (8 * i) & 0xFF), stream);
    if (fclose(stream) != 0) die_run("%s: cannot be written", shown);
}
