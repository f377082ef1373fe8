/* colours.h - one colour for one number. */
#ifndef HS_COLOURS_H
#define HS_COLOURS_H

/* sRGB of a share from 0 (dark violet) to 1 (yellow), the ends beyond; grey for what is no
 * number. Equal steps of the share are equal steps of CIELAB lightness, 15 to 90: the order can
 * be seen, also in print and by colour-blind readers. */
void colour_of(double share, double colour[3]);

#endif
