#include "checkpoint_file.h"

#include "die.h"
#include "memory.h"
#include "spool.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { NAME = 80, MARK = 24, WORD = sizeof(union checkpoint_word), BLOCK = 1 << 22 };

static const char mark[MARK] = "hstools checkpoint 2\n";
static const int64_t order_of_bytes = 0x0102030405060708;

struct head {
    char mark[MARK];
    int64_t order, bytes;
};

struct table {
    char name[NAME];
    int64_t width, blocks;
    uint64_t checksum; /* of what is before */
};

struct block {
    int64_t rows;
    uint64_t checksum; /* of the words behind it */
};

struct checkpoint_file {
    struct ranks ranks;
    int descriptor;
    char *name;
    bool reads;
    int failure;       /* errno of the first write that failed; 0: none */
    int64_t at, bytes; /* where the next table or block begins; of the whole file */
    /* Of the table that is being written: where this rank's next block goes, numbers of a row, rows
     * that wait to be one. */
    int64_t own, width, waiting;
    union checkpoint_word *words;
};

/* --- bytes ------------------------------------------------------------------------------------ */

/* A polynomial over the words, modulo 2^64, mixed at each of them: any single change shows. */
static uint64_t checksum(const void *bytes, size_t length)
{
    uint64_t sum = length, word;
    for (size_t i = 0; i < length; i += sizeof word) {
        memcpy(&word, (const char *)bytes + i, sizeof word);
        sum = (sum ^ word) * 0x9E3779B97F4A7C15U;
        sum ^= sum >> 29;
    }
    return sum;
}

static void put(struct checkpoint_file *file, const void *bytes, size_t count, int64_t at)
{
    if (file->failure == 0 && !spool_write_at(file->descriptor, bytes, count, at))
        file->failure = errno;
}

void checkpoint_file_refuse(const struct checkpoint_file *file, const char *reason)
{
    char *older = memory_print("%s.1", file->name);
    const bool there = access(older, R_OK) == 0;
    die_user("%s: %s%s%s", file->name, reason, there ? "; an older one is " : "",
             there ? older : "");
}

static void get(struct checkpoint_file *file, void *bytes, size_t count)
{
    char *to = bytes;
    if (count > (size_t)(file->bytes - file->at))
        checkpoint_file_refuse(file, "damaged: it ends where more is said to come");
    while (count > 0) {
        const ssize_t done = pread(file->descriptor, to, count, file->at);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) die_run("%s: cannot be read: %s", file->name, strerror(errno));
        if (done == 0) checkpoint_file_refuse(file, "changed while it was read");
        to += done;
        file->at += done;
        count -= (size_t)done;
    }
}

/* --- files ------------------------------------------------------------------------------------ */

struct checkpoint_file *checkpoint_file_create(const char *path, struct ranks ranks)
{
    struct checkpoint_file *file = memory_new(1, sizeof *file);
    *file = (struct checkpoint_file){.ranks = ranks, .name = memory_text(path)};
    if (ranks.rank != 0) ranks_wait();
    const int create = ranks.rank == 0 ? O_CREAT | O_TRUNC : 0;
    file->descriptor = open(path, O_RDWR | O_CLOEXEC | create, 0666);
    if (file->descriptor < 0) file->failure = errno;
    struct head head = {.order = order_of_bytes};
    memcpy(head.mark, mark, MARK);
    if (ranks.rank == 0) {
        put(file, &head, sizeof head, 0);
        ranks_wait();
    }
    file->at = sizeof head;
    return file;
}

struct checkpoint_file *checkpoint_file_open(const char *name)
{
    struct checkpoint_file *file = memory_new(1, sizeof *file);
    struct head head;
    struct stat status;
    *file = (struct checkpoint_file){.name = memory_text(name), .reads = true};
    file->descriptor = open(name, O_RDONLY | O_CLOEXEC);
    if (file->descriptor < 0 || fstat(file->descriptor, &status) != 0)
        checkpoint_file_refuse(file, memory_print("cannot be opened: %s", strerror(errno)));
    if (!S_ISREG(status.st_mode)) die_user("%s is no file, expected a checkpoint", name);
    file->bytes = status.st_size;
    if (file->bytes < (int64_t)sizeof head)
        checkpoint_file_refuse(file, "too short for a checkpoint of hssolve");
    get(file, &head, sizeof head);
    const size_t kind = strcspn(mark, "0123456789");
    if (memcmp(head.mark, mark, kind) != 0)
        checkpoint_file_refuse(file, "no checkpoint of hssolve");
    if (memcmp(head.mark, mark, MARK) != 0)
        checkpoint_file_refuse(file, "a checkpoint of another version of hssolve's format");
    if (head.order != order_of_bytes)
        checkpoint_file_refuse(file, "written by a machine with another order of bytes");
    if (head.bytes == 0) checkpoint_file_refuse(file, "was never finished");
    if (head.bytes != file->bytes) checkpoint_file_refuse(file, "truncated or damaged: its length");
    return file;
}

static void reach_disk(struct checkpoint_file *file)
{
    if (file->failure == 0 && fsync(file->descriptor) != 0) file->failure = errno;
}

/* The length goes in when all the rest is there. */
static void finish(struct checkpoint_file *file)
{
    double failure;
    reach_disk(file);
    failure = -file->failure;
    ranks_minimum(&failure, 1);
    file->failure = (int)-failure;
    if (file->ranks.rank == 0) {
        put(file, &file->at, sizeof file->at, (int64_t)offsetof(struct head, bytes));
        reach_disk(file);
    }
    ranks_share(&file->failure, sizeof file->failure);
}

const char *checkpoint_file_close(struct checkpoint_file *file)
{
    if (!file->reads) finish(file);
    const int failure = file->failure;
    if (file->descriptor >= 0) close(file->descriptor);
    free(file->name);
    free(file);
    return failure ? strerror(failure) : NULL;
}

bool checkpoint_file_reads(const struct checkpoint_file *file)
{
    return file->reads;
}

/* --- tables ----------------------------------------------------------------------------------- */

/* Rows of a whole block: some MB, whatever a rank has. */
static int64_t block_rows(int64_t width)
{
    const int64_t rows = BLOCK / ((width + 1) * WORD);
    return rows > 0 ? rows : 1;
}

static int64_t block_count(int64_t width, int64_t rows)
{
    return (rows + block_rows(width) - 1) / block_rows(width);
}

static int64_t table_bytes(int64_t width, int64_t rows)
{
    return block_count(width, rows) * (int64_t)sizeof(struct block) + rows * (width + 1) * WORD;
}

void checkpoint_file_begin(struct checkpoint_file *file, const char *name, int64_t width,
                           int64_t rows)
{
    struct table table = {.width = width};
    int64_t *all = memory_new((size_t)file->ranks.size, sizeof *all), at;
    if (strlen(name) >= NAME) die_run("'%s' is too long a name for a checkpoint", name);
    strcpy(table.name, name);
    ranks_tell_all(rows, all);
    for (int r = 0; r < file->ranks.size; r++) table.blocks += block_count(width, all[r]);
    table.checksum = checksum(&table, offsetof(struct table, checksum));
    if (file->ranks.rank == 0) put(file, &table, sizeof table, file->at);
    at = file->at + (int64_t)sizeof table;
    for (int r = 0; r < file->ranks.size; at += table_bytes(width, all[r++]))
        if (r == file->ranks.rank) file->own = at;
    file->at = at;
    file->width = width;
    const int64_t most = rows < block_rows(width) ? rows : block_rows(width);
    file->words = memory_new((size_t)(most * (width + 1)), sizeof *file->words);
    free(all);
}

static void write_block(struct checkpoint_file *file)
{
    const size_t bytes = (size_t)(file->waiting * (file->width + 1) * WORD);
    const struct block block = {file->waiting, checksum(file->words, bytes)};
    put(file, &block, sizeof block, file->own);
    put(file, file->words, bytes, file->own + (int64_t)sizeof block);
    file->own += (int64_t)(sizeof block + bytes);
    file->waiting = 0;
}

union checkpoint_word *checkpoint_file_row(struct checkpoint_file *file)
{
    if (file->waiting == block_rows(file->width)) write_block(file);
    return file->words + file->waiting++ * (file->width + 1);
}

void checkpoint_file_end(struct checkpoint_file *file)
{
    if (file->waiting > 0) write_block(file);
    free(file->words);
    file->words = NULL;
}

int64_t checkpoint_file_table(struct checkpoint_file *file, const char *name, int64_t *width)
{
    struct table table;
    get(file, &table, sizeof table);
    if (table.checksum != checksum(&table, offsetof(struct table, checksum)))
        checkpoint_file_refuse(file, "damaged: a table's head");
    if (strcmp(table.name, name) != 0 || (*width >= 0 && table.width != *width))
        checkpoint_file_refuse(
            file, memory_print("another version of hssolve wrote it: '%s' of %lld numbers, "
                               "expected '%s' of %lld",
                               table.name, (long long)table.width, name, (long long)*width));
    *width = table.width;
    return table.blocks;
}

union checkpoint_word *checkpoint_file_block(struct checkpoint_file *file, int64_t width,
                                             int64_t *rows)
{
    struct block block;
    get(file, &block, sizeof block);
    if (block.rows < 0 || block.rows > (file->bytes - file->at) / ((width + 1) * WORD))
        checkpoint_file_refuse(file, "damaged: more rows than it has bytes");
    const size_t bytes = (size_t)(block.rows * (width + 1) * WORD);
    union checkpoint_word *words = memory_new(bytes + 1, 1);
    get(file, words, bytes);
    if (block.checksum != checksum(words, bytes))
        checkpoint_file_refuse(file, "damaged: a checksum is not that of its numbers");
    *rows = block.rows;
    return words;
}

static void write_bytes(struct checkpoint_file *file, const char *name, const char *bytes,
                        int64_t length)
{
    int64_t width = (length + WORD - 1) / WORD;
    ranks_share(&width, sizeof width);
    checkpoint_file_begin(file, name, width, file->ranks.rank == 0 ? 1 : 0);
    if (file->ranks.rank == 0) {
        union checkpoint_word *words = checkpoint_file_row(file);
        words[0].key = length;
        if (length > 0) memcpy(words + 1, bytes, (size_t)length);
    }
    checkpoint_file_end(file);
}

void checkpoint_file_bytes(struct checkpoint_file *file, const char *name, char **bytes,
                           int64_t *length)
{
    int64_t width = -1;
    if (!file->reads) {
        write_bytes(file, name, *bytes, *length);
        return;
    }
    *bytes = NULL;
    for (int64_t left = checkpoint_file_table(file, name, &width); left > 0; left--) {
        int64_t rows;
        union checkpoint_word *words = checkpoint_file_block(file, width, &rows);
        if (rows == 1 && words[0].key >= 0 && words[0].key <= width * WORD) {
            *length = words[0].key;
            *bytes = memory_new((size_t)*length + 1, 1);
            memcpy(*bytes, words + 1, (size_t)*length);
        }
        free(words);
    }
    if (!*bytes) checkpoint_file_refuse(file, "damaged: a text is missing");
}

enum { PIECE = 4095 }; /* numbers of a row of a copy */

/* A row holds the next bytes, its key says how many they are. */
static void write_copy(struct checkpoint_file *file, const char *name, int from)
{
    const int64_t most = PIECE * WORD, end = from < 0 ? 0 : lseek(from, 0, SEEK_END),
                  length = end > 0 ? end : 0;
    checkpoint_file_begin(file, name, PIECE, (length + most - 1) / most);
    for (int64_t at = 0; at < length; at += most) {
        union checkpoint_word *words = checkpoint_file_row(file);
        const int64_t count = length - at < most ? length - at : most;
        memset(words, 0, (size_t)most + WORD);
        words[0].key = count;
        if (pread(from, words + 1, (size_t)count, at) != count)
            die_run("%s: cannot be read again for a checkpoint", name);
    }
    checkpoint_file_end(file);
}

void checkpoint_file_copy(struct checkpoint_file *file, const char *name, int descriptor)
{
    int64_t width = PIECE, at = 0;
    if (!file->reads) {
        write_copy(file, name, descriptor);
        return;
    }
    for (int64_t left = checkpoint_file_table(file, name, &width); left > 0; left--) {
        int64_t rows;
        union checkpoint_word *words = checkpoint_file_block(file, width, &rows), *row = words;
        for (int64_t r = 0; r < rows; r++, row += width + 1) {
            const int64_t count = row->key;
            if (count < 0 || count > width * WORD)
                checkpoint_file_refuse(file, "damaged: a copy's length");
            if (descriptor >= 0 && pwrite(descriptor, row + 1, (size_t)count, at) != count)
                die_run("cannot write a temporary file: %s", strerror(errno));
            at += count;
        }
        free(words);
    }
}
