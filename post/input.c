#include "input.h"

#include "die.h"
#include "encoding.h"
#include "foreign.h"
#include "kept_history.h"
#include "memory.h"
#include "spool.h"
#include "text_table.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const long largest = 1L << 30;

/* POSIX.1-2017, cksum: polynomial 0x04C11DB7, bytes from the most significant bit, then the length
 * from its least significant byte. */
static uint32_t checksum_byte(uint32_t sum, unsigned byte)
{
    sum ^= (uint32_t)byte << 24;
    for (int bit = 0; bit < 8; bit++) sum = sum & 0x80000000U ? sum << 1 ^ 0x04C11DB7U : sum << 1;
    return sum;
}

uint32_t input_checksum(const unsigned char *bytes, long length)
{
    uint32_t sum = 0;
    for (long i = 0; i < length; i++) sum = checksum_byte(sum, bytes[i]);
    for (; length > 0; length >>= 8) sum = checksum_byte(sum, (unsigned)(length & 0xFF));
    return ~sum;
}

static char *read_bytes(const struct spool *spool, const char *name, long *length)
{
    FILE *file = fopen(spool->path, "rb");
    if (!file || fseek(file, 0, SEEK_END) != 0 || (*length = ftell(file)) < 0)
        die_user("cannot read %s: %s", name, strerror(errno));
    if (*length > largest) die_user("%s: larger than 1 GB, expected a history or a table", name);
    rewind(file);
    char *bytes = memory_new((size_t)*length + 1, 1);
    if (fread(bytes, 1, (size_t)*length, file) != (size_t)*length)
        die_run("cannot read %s: %s", name, strerror(errno));
    fclose(file);
    return bytes;
}

static struct table table_of_history(const struct history *history, const char *name)
{
    struct table table = {.n_rows = (long)history->n_records};
    if (table.n_rows == 0) die_user("%s: a history without records", name);
    memcpy(table_add(&table, "time_s"), history->time, (size_t)table.n_rows * sizeof(double));
    for (int j = 0; j < history->n_columns; j++) {
        if (table_find(&table, history->columns[j])) continue;
        double *values = table_add(&table, history->columns[j]);
        for (long i = 0; i < table.n_rows; i++) {
            values[i] = history->values[i * history->n_columns + j];
            /* A ratio of energies has no value before there is any. */
            if (!isfinite(values[i])) values[i] = NAN;
        }
    }
    return table;
}

static void read_history(struct input *input, const struct spool *spool)
{
    struct history history = exodus_read_history(spool);
    input->table = table_of_history(&history, input->name);
    input->attributes = history.attributes;
    history.attributes = (struct attributes){0};
    history_free(&history);
}

static void read_table(struct input *input, const char *bytes, const char *columns_of)
{
    const char *set;
    foreign_refuse(bytes, input->bytes, input->name);
    char *text = encoding_to_utf8(bytes, input->bytes, &set);
    if (!text) die_user("%s: neither an Exodus history nor a table of text", input->name);
    input->table = text_table_read(text, input->name, columns_of, &input->attributes);
    if (strcmp(set, "UTF-8") != 0) note("%s: characters of %s", input->name, set);
    free(text);
}

struct input input_read(const char *name, const char *columns_of)
{
    struct input input = {.standard = !name || strcmp(name, "-") == 0};
    input.name = memory_text(input.standard ? "standard input" : name);
    struct spool spool = spool_input(name);
    char *bytes = read_bytes(&spool, input.name, &input.bytes);
    input.checksum = input_checksum((const unsigned char *)bytes, input.bytes);
    input.is_history = strncmp(bytes, "CDF", 3) == 0 || strncmp(bytes, "\x89HDF", 4) == 0;
    if (input.is_history && bytes[0] != 'C') foreign_refuse_hdf5(bytes, input.bytes, input.name);
    if (input.is_history) kept_history(&spool);
    if (input.is_history)
        read_history(&input, &spool);
    else
        read_table(&input, bytes, columns_of);
    input.content = bytes;
    spool_close(&spool);
    return input;
}

void input_free(struct input *input)
{
    free(input->content);
    free(input->name);
    table_free(&input->table);
    attributes_free(&input->attributes);
    *input = (struct input){0};
}
