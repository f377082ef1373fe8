/* image_text.h - words and lines of a file's text, with the place for messages. */
#ifndef HS_IMAGE_TEXT_H
#define HS_IMAGE_TEXT_H

#include "image.h"

struct image_text {
    const struct image_source *source;
    size_t at;
    int64_t line; /* from 1, of the place */
};

struct image_text image_text_of(const struct image_source *source);

/* The next word between white space, cut off at `room`; false at the end. */
bool image_word(struct image_text *text, char *word, size_t room);

/* The rest of the line, without its end, cut off at `room`; false at the end of the file. */
bool image_line(struct image_text *text, char *line, size_t room);

/* A number, or a message of what was found instead of `what`. */
double image_number(struct image_text *text, const char *what);

/* `count` numbers into out. */
void image_numbers(struct image_text *text, const char *what, int64_t count, double *out);

/* "file:line: ", exit 2. */
_Noreturn void image_refuse(const struct image_text *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Splits at white space in place; returns how many fields, `most` at most are entered. */
int image_split(char *line, char *fields[], int most);

#endif
