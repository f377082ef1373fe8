/* PNG: grey values of 1 to 16 bits, indices of a palette, or colours as 0xRRGGBB (#ff8000 in the
 * deck); a transparency is passed over.  The first row is at the top, so that the body stands as
 * one sees it. */
#include "image.h"

#include "die.h"
#include "memory.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

struct png_input {
    const struct image_source *source;
    size_t at;
};

static _Noreturn void refuse(png_structp png, png_const_charp message)
{
    const struct png_input *input = png_get_io_ptr(png);
    die_user("%s: damaged or cut off PNG: %s", input->source->path, message);
}

static void say_nothing(png_structp png, png_const_charp message)
{
    (void)png, (void)message;
}

static void give(png_structp png, png_bytep bytes, png_size_t length)
{
    struct png_input *input = png_get_io_ptr(png);
    if (length > input->source->length - input->at) refuse(png, "the file ends");
    memcpy(bytes, input->source->bytes + input->at, length);
    input->at += length;
}

/* A pixel of the row, whatever its depth. */
static double pixel(const png_byte *row, int64_t x, int depth, int channels)
{
    if (channels >= 3) {
        const size_t size = depth == 16 ? 2 : 1;
        const png_byte *at = row + (size_t)x * (size_t)channels * size;
        return (double)(at[0] << 16 | at[size] << 8 | at[2 * size]);
    }
    if (depth == 16) return scalar_at(row + 2 * x * channels, SCALAR_UINT16, true);
    if (depth == 8) return row[x * channels];
    const int64_t bit = x * depth;
    return (double)(row[bit / 8] >> (8 - depth - bit % 8) & ((1 << depth) - 1));
}

void image_png_read(const struct image_source *source, struct image *image)
{
    struct png_input input = {source, 0};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, refuse, say_nothing);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info) die_run("out of memory for libpng");
    if (source->array) die_user("%s: PNG has one array, without a name", source->path);
    png_set_read_fn(png, &input, give);
    png_set_user_limits(png, 100000, 100000);
    png_read_info(png, info);
    const int64_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    const int depth = png_get_bit_depth(png, info), channels = png_get_channels(png, info);
    /* A byte packed by zlib is 1032 of them at most, and a pixel one bit at least. */
    const double count[3] = {(double)width, (double)height, 1};
    image_size(source, image, count, (double)source->length * SCALARS_INFLATION * 8);
    const size_t wide = png_get_rowbytes(png, info);
    png_byte *rows = memory_new(wide * (size_t)height, 1);
    png_bytep *row = memory_new((size_t)height, sizeof *row);
    for (int64_t y = 0; y < height; y++) row[y] = rows + (size_t)y * wide;
    png_read_image(png, row);
    for (int64_t y = 0; y < height; y++)
        for (int64_t x = 0; x < width; x++)
            image->value[x + width * (height - 1 - y)] = pixel(row[y], x, depth, channels);
    png_destroy_read_struct(&png, &info, NULL);
    free(row);
    free(rows);
}
