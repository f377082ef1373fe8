/* PGM as text (P2): width, height, the largest value, and the values, first row on top. */
#include "image_text.h"

void image_pgm_read(const struct image_source *source, struct image *image)
{
    struct image_text text = image_text_of(source);
    char magic[8];
    image_word(&text, magic, sizeof magic);
    const double width = image_number(&text, "a width"), height = image_number(&text, "a height");
    image_number(&text, "the largest value");
    image_size(source, image, (const double[3]){width, height, 1}, (double)source->length);
    for (int64_t y = image->count[1] - 1; y >= 0; y--)
        image_numbers(&text, "a grey value", image->count[0], image->value + y * image->count[0]);
}
