/* drive.c - the targets without a fuzzer: files as they are, then COUNT copies of them, changed
 * here and there.
 *
 *   HS_FUZZ=TARGET fuzz COUNT FILE...
 *
 * The changes are the same in each run. */
#include "memory.h"
#include "random.h"
#include "targets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bytes {
    uint8_t *items;
    size_t size;
};

static struct bytes read_file(const char *name)
{
    struct bytes bytes = {0};
    FILE *file = fopen(name, "r");
    if (!file || fseek(file, 0, SEEK_END) != 0) exit(2);
    bytes.size = (size_t)ftell(file);
    rewind(file);
    bytes.items = memory_new(bytes.size + 1, 1);
    if (fread(bytes.items, 1, bytes.size, file) != bytes.size) exit(2);
    fclose(file);
    return bytes;
}

/* One to four changes; heads of files are met as often as all the rest. */
static void change(struct bytes *bytes, int64_t seed)
{
    enum { HEAD = 4000 };
    static const uint32_t odd[] = {0,          1,          2,          7,
                                   255,        0x7fffffff, 65536,      0x80000000,
                                   0xffffffff, 0x7ff00000, 0xfff00000, 0x00100000};
    const uint64_t changes = 1 + random_hash(seed, "changes", 0) % 4;
    for (uint64_t k = 0; k < changes && bytes->size > 8; k++) {
        const uint64_t r = random_hash(seed, "kind", k), at = random_hash(seed, "at", k),
                       value = random_hash(seed, "value", k);
        const size_t end = (at & 1) && bytes->size > HEAD ? HEAD : bytes->size,
                     i = (size_t)((at >> 1) % end);
        if (r % 6 == 0) bytes->items[i] ^= (uint8_t)(1u << value % 8);
        if (r % 6 == 1) bytes->items[i] = (uint8_t)value;
        if (r % 6 == 2 && i + 4 <= bytes->size) /* as netCDF writes numbers */
            for (int b = 0; b < 4; b++)
                bytes->items[i / 4 * 4 + (size_t)b] = (uint8_t)(odd[value % 12] >> (24 - 8 * b));
        if (r % 6 == 3) bytes->size = i + 1;
        if (r % 6 == 4) bytes->items[i] = (uint8_t) "0123456789.-e{}[]:, \n#'\"/%"[value % 26];
        if (r % 6 == 5) { /* a piece again somewhere else */
            const size_t from = (size_t)(value % bytes->size);
            size_t length = bytes->size - (from > i ? from : i);
            if (length > 16) length = 16;
            memmove(bytes->items + i, bytes->items + from, length);
        }
    }
}

int main(int argc, char **argv)
{
    const long count = argc > 2 ? strtol(argv[1], NULL, 10) : 0;
    const int files = argc - 2;
    if (files < 1) return 2;
    LLVMFuzzerInitialize(&argc, &argv);
    if (!freopen("/dev/null", "w", stderr)) return 2;
    for (int k = 0; k < files; k++) {
        struct bytes bytes = read_file(argv[k + 2]);
        LLVMFuzzerTestOneInput(bytes.items, bytes.size);
        free(bytes.items);
    }
    const long whole = targets_accepted();
    for (long n = 0; n < count; n++) {
        struct bytes bytes = read_file(argv[2 + n % files]);
        change(&bytes, n);
        LLVMFuzzerTestOneInput(bytes.items, bytes.size);
        free(bytes.items);
    }
    printf("%d files, %ld taken; %ld changed, %ld taken\n", files, whole, count,
           targets_accepted() - whole);
    return whole == files ? 0 : 1;
}
