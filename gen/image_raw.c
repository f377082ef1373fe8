/* Values without a head, described in the deck: x fastest, then y, then z. */
#include "image.h"

#include "die.h"

void image_raw_read(const struct image_source *source, struct image *image)
{
    const struct image_raw *raw = source->raw;
    const double count[3] = {(double)raw->count[0], (double)raw->count[1], (double)raw->count[2]};
    const double size = (double)scalar_size(raw->type), skip = (double)raw->skip;
    const double bytes = count[0] * count[1] * count[2] * size + skip;
    if (bytes != (double)source->length)
        die_user("%s: %zu bytes; %g x %g x %g values of %s behind %g bytes are %.0f", source->path,
                 source->length, count[0], count[1], count[2], scalar_names[raw->type], skip,
                 bytes);
    image_size(source, image, count, (double)source->length / size);
    scalars_decode(source->bytes + raw->skip, image_voxels(image), raw->type, raw->big_endian,
                   image->value);
}
