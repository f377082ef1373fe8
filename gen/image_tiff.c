/* TIFF by libtiff: one page, or a stack of pages of one size, first page lowest; grey values,
 * indices of a palette, or colours as 0xRRGGBB (#ff8000 in the deck).  The first row is at the top,
 * so that the body stands as one sees it. */
#include "image.h"

#include "die.h"
#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tiffio.h>

/* --- the file in memory --------------------------------------------------------------------------
 */

struct tiff_input {
    const struct image_source *source;
    toff_t at;
};

static tmsize_t give(thandle_t handle, void *bytes, tmsize_t length)
{
    struct tiff_input *input = handle;
    const toff_t end = input->source->length;
    const toff_t left = input->at < end ? end - input->at : 0;
    const size_t taken = (toff_t)length < left ? (size_t)length : (size_t)left;
    memcpy(bytes, input->source->bytes + input->at * (taken > 0), taken);
    input->at += taken;
    return (tmsize_t)taken;
}

static tmsize_t take_nothing(thandle_t handle, void *bytes, tmsize_t length)
{
    (void)handle, (void)bytes, (void)length;
    return 0;
}

static toff_t move(thandle_t handle, toff_t offset, int from)
{
    struct tiff_input *input = handle;
    if (from == SEEK_SET) input->at = offset;
    if (from == SEEK_CUR) input->at += offset;
    if (from == SEEK_END) input->at = input->source->length + offset;
    return input->at;
}

static int leave(thandle_t handle)
{
    (void)handle;
    return 0;
}

static toff_t length_of(thandle_t handle)
{
    return ((struct tiff_input *)handle)->source->length;
}

/* --- pages ---------------------------------------------------------------------------------------
 */

struct page {
    uint32_t width, height;
    uint16_t bits, samples, format, planar, photometric;
};

static struct page page_of(TIFF *tiff)
{
    struct page page = {.bits = 1, .samples = 1, .format = SAMPLEFORMAT_UINT};
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &page.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &page.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &page.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &page.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &page.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &page.planar);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &page.photometric);
    if (page.format == SAMPLEFORMAT_VOID) page.format = SAMPLEFORMAT_UINT;
    return page;
}

static bool is_colour(const struct page *page)
{
    return page->samples >= 3 && page->bits == 8 && page->format == SAMPLEFORMAT_UINT &&
           page->planar == PLANARCONFIG_CONTIG;
}

static void check_page(const struct image_source *source, const struct page *page)
{
    const bool grey =
        page->samples == 1 && page->bits <= 64 && (page->bits & (page->bits - 1)) == 0;
    const bool number = page->format == SAMPLEFORMAT_UINT || page->format == SAMPLEFORMAT_INT ||
                        (page->format == SAMPLEFORMAT_IEEEFP && page->bits >= 32);
    if ((!grey && !is_colour(page)) || !number)
        die_user("%s: %d values of %d bits a pixel are not read: grey values of 1 to 64 bits and "
                 "colours of 3 x 8 are",
                 source->path, page->samples, page->bits);
}

static double sample(const unsigned char *row, int64_t x, const struct page *page, bool big_endian)
{
    if (is_colour(page)) {
        const unsigned char *at = row + (size_t)x * page->samples;
        return (double)(at[0] << 16 | at[1] << 8 | at[2]);
    }
    if (page->bits < 8) {
        const int64_t bit = x * page->bits;
        return (double)(row[bit / 8] >> (8 - page->bits - bit % 8) & ((1 << page->bits) - 1));
    }
    static const enum scalar whole[] = {SCALAR_UINT8, SCALAR_UINT16, SCALAR_UINT32, SCALAR_UINT64};
    static const enum scalar with_sign[] = {SCALAR_INT8, SCALAR_INT16, SCALAR_INT32, SCALAR_INT64};
    static const enum scalar real[] = {SCALAR_FLOAT32, SCALAR_FLOAT32, SCALAR_FLOAT32,
                                       SCALAR_FLOAT64};
    const int width = page->bits == 8 ? 0 : page->bits == 16 ? 1 : page->bits == 32 ? 2 : 3;
    const enum scalar type = page->format == SAMPLEFORMAT_IEEEFP ? real[width]
                             : page->format == SAMPLEFORMAT_INT  ? with_sign[width]
                                                                 : whole[width];
    return scalar_at(row + (size_t)x * scalar_size(type), type, big_endian);
}

static _Noreturn void refuse_damaged(const struct image_source *source, int page)
{
    die_user(
        "%s: page %d cannot be unpacked: damaged, cut off, or packed in a way that libtiff here "
        "does not know",
        source->path, page + 1);
}

/* One page as rows; the caller frees it. */
static unsigned char *read_rows(TIFF *tiff, const struct page *page,
                                const struct image_source *source, int number, size_t *wide)
{
    *wide = (size_t)TIFFScanlineSize64(tiff);
    unsigned char *rows = memory_new(*wide * page->height + 1, 1);
    if (!TIFFIsTiled(tiff)) {
        for (uint32_t y = 0; y < page->height; y++)
            if (TIFFReadScanline(tiff, rows + *wide * y, y, 0) < 0) refuse_damaged(source, number);
        return rows;
    }
    uint32_t tile_width = 0, tile_height = 0;
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height);
    const size_t tile_row = (size_t)TIFFTileRowSize64(tiff), size = (size_t)TIFFTileSize64(tiff);
    const size_t bits = (size_t)page->bits * page->samples;
    if (tile_width == 0 || tile_height == 0 || size > 64 * source->length * SCALARS_INFLATION ||
        tile_width * bits % 8 != 0 || size < tile_row * tile_height)
        refuse_damaged(source, number);
    unsigned char *tile = memory_new(size + 1, 1);
    for (uint32_t y = 0; y < page->height; y += tile_height)
        for (uint32_t x = 0; x < page->width; x += tile_width) {
            if (TIFFReadTile(tiff, tile, x, y, 0, 0) < 0) refuse_damaged(source, number);
            const size_t from = x * bits / 8;
            const size_t length = *wide - from < tile_row ? *wide - from : tile_row;
            for (uint32_t row = 0; row < tile_height && y + row < page->height; row++)
                memcpy(rows + *wide * (y + row) + from, tile + tile_row * row, length);
        }
    free(tile);
    return rows;
}

/* Of the chain of pages, which libtiff takes for whole where the file ends in it: each has a number
 * of entries, the entries, and the place of the next page or 0. */
static int count_pages(const struct image_source *source)
{
    const bool big_endian = source->bytes[0] == 'M', big = source->bytes[big_endian ? 3 : 2] == 43;
    const size_t word = big ? 8 : 4, short_word = big ? 8 : 2, entry = big ? 20 : 12;
    const enum scalar place = big ? SCALAR_UINT64 : SCALAR_UINT32;
    const enum scalar number = big ? SCALAR_UINT64 : SCALAR_UINT16;
    const double length = (double)source->length;
    int pages = 0;
    for (double at = (double)word;; pages++) {
        if (at + (double)word > length || pages > UINT16_MAX) refuse_damaged(source, pages);
        at = scalar_at(source->bytes + (size_t)at, place, big_endian);
        if (at == 0) return pages;
        if (at + (double)short_word > length) refuse_damaged(source, pages);
        const double entries = scalar_at(source->bytes + (size_t)at, number, big_endian);
        at += (double)short_word + entries * (double)entry;
    }
}

static void take_page(TIFF *tiff, const struct image_source *source, int number,
                      struct image *image)
{
    const uint16_t one = 1;
    const bool big_endian =
        *(const unsigned char *)&one == 0; /* libtiff gives the machine's order */
    const struct page page = page_of(tiff);
    check_page(source, &page);
    if (page.width != image->count[0] || page.height != image->count[1])
        die_user("%s: page %d has %u x %u pixels, the first one %lld x %lld", source->path,
                 number + 1, page.width, page.height, (long long)image->count[0],
                 (long long)image->count[1]);
    size_t wide;
    unsigned char *rows = read_rows(tiff, &page, source, number, &wide);
    const int64_t width = image->count[0], height = image->count[1];
    for (int64_t y = 0; y < height; y++)
        for (int64_t x = 0; x < width; x++)
            image->value[x + width * (height - 1 - y + height * number)] =
                sample(rows + wide * (size_t)y, x, &page, big_endian);
    free(rows);
}

void image_tiff_read(const struct image_source *source, struct image *image)
{
    struct tiff_input input = {source, 0};
    if (source->array) die_user("%s: TIFF has one array, without a name", source->path);
    TIFFSetErrorHandler(NULL);
    TIFFSetWarningHandler(NULL);
    TIFF *tiff = TIFFClientOpen(source->path, "rm", &input, give, take_nothing, move, leave,
                                length_of, NULL, NULL);
    if (!tiff) die_user("%s: damaged or cut off: libtiff cannot read its head", source->path);
    const int pages = count_pages(source);
    if (!TIFFSetDirectory(tiff, 0)) refuse_damaged(source, 0);
    const struct page first = page_of(tiff);
    const double count[3] = {first.width, first.height, pages};
    check_page(source, &first);
    /* Runs of one value are packed further than by zlib, in some of its codes. */
    image_size(source, image, count, 8 * SCALARS_INFLATION * (double)source->length);
    for (int page = 0; page < pages; page++) {
        if (!TIFFSetDirectory(tiff, (tdir_t)page)) refuse_damaged(source, page);
        take_page(tiff, source, page, image);
    }
    TIFFClose(tiff);
}
