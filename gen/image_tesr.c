/* Neper's voxels (.tesr), versions 2 and later: text or binary8, 16, 32; cells are the values. */
#include "image_text.h"

#include "die.h"
#include "memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void read_general(struct image_text *text, struct image *image, double count[3])
{
    const double dimensions = image_number(text, "the dimension");
    if (dimensions != 2 && dimensions != 3)
        image_refuse(text, "%g dimensions, 2 and 3 are read", dimensions);
    const int n = (int)dimensions;
    for (int axis = 0; axis < n; axis++) count[axis] = image_number(text, "a number of voxels");
    for (int axis = 0; axis < n; axis++) image->edge[axis] = image_number(text, "a voxel's edge");
    if (n == 2) {
        count[2] = 1;
        image->edge[2] = image->edge[0];
    }
}

/* Passes over the section's words up to the next one. */
static void skip_section(struct image_text *text)
{
    char word[256];
    struct image_text before = *text;
    while (image_word(text, word, sizeof word) && strncmp(word, "**", 2) != 0) before = *text;
    *text = before;
}

static void read_binary(struct image_text *text, int bits, struct image *image)
{
    const struct image_source *source = text->source;
    const int64_t voxels = image_voxels(image);
    const enum scalar type = bits == 8 ? SCALAR_UINT8 : bits == 16 ? SCALAR_INT16 : SCALAR_INT32;
    const size_t wanted = (size_t)voxels * scalar_size(type);
    /* The values begin behind the line's end. */
    while (text->at < source->length && source->bytes[text->at] != '\n') text->at++;
    text->at++;
    if (text->at > source->length || source->length - text->at < wanted)
        image_refuse(text, "damaged or cut off: the file ends within the values");
    scalars_decode(source->bytes + text->at, voxels, type, false, image->value);
    text->at += wanted;
}

static void read_data(struct image_text *text, struct image *image)
{
    char word[256];
    int bits = 0;
    if (!image_word(text, word, sizeof word)) image_refuse(text, "the file ends within **data");
    if (word[0] == '*' && strncmp(word, "**", 2) != 0)
        image_refuse(text, "the values lie in another file (%.40s): write them into this one",
                     word);
    if (strcmp(word, "ascii") == 0)
        image_numbers(text, "a cell's number", image_voxels(image), image->value);
    else if (sscanf(word, "binary%d", &bits) == 1 && (bits == 8 || bits == 16 || bits == 32))
        read_binary(text, bits, image);
    else
        image_refuse(text, "found '%.40s', expected ascii, binary8, binary16 or binary32", word);
}

void image_tesr_read(const struct image_source *source, struct image *image)
{
    struct image_text text = image_text_of(source);
    double count[3] = {0, 0, 0};
    char word[256];
    bool sized = false, filled = false;
    if (source->array) die_user("%s: .tesr has one array, its cells", source->path);
    while (image_word(&text, word, sizeof word) && !filled) {
        if (strcmp(word, "**general") == 0) {
            read_general(&text, image, count);
            /* Without *size of cells it has one byte a voxel at least. */
            image_size(source, image, count, (double)source->length);
            sized = true;
            skip_section(&text);
        } else if (strcmp(word, "**data") == 0) {
            if (!sized) image_refuse(&text, "**data before **general");
            read_data(&text, image);
            filled = true;
        } else if (strncmp(word, "**", 2) == 0) {
            skip_section(&text);
        } else if (strcmp(word, "***tesr") != 0 && strcmp(word, "***end") != 0) {
            image_refuse(&text, "found '%.40s', expected a section such as **data", word);
        }
    }
    if (!filled) image_refuse(&text, "the file ends without **data");
}
