/* random.h - seeded random streams (GSL's taus2, period 2^88; L'Ecuyer 1996, 1999).
 *
 * One integer seed gives one stream a purpose ("positions", "labels", ...), so that drawing one
 * more number for one purpose never shifts another.  The same on every machine. */
#ifndef HS_RANDOM_H
#define HS_RANDOM_H

#include <stdint.h>

struct random_stream;

struct random_stream *random_new(long seed, const char *purpose);
void random_free(struct random_stream *stream);

double random_uniform(struct random_stream *stream);                   /* [0, 1) */
double random_gaussian(struct random_stream *stream);                  /* mean 0, deviation 1 */
uint64_t random_integer(struct random_stream *stream, uint64_t below); /* 0 ... below - 1 */

/* "GSL 2.7.1" */
const char *random_library(void);

/* A hash of (seed, purpose, number): an order for ties that needs no state. */
uint64_t random_hash(long seed, const char *purpose, uint64_t number);

#endif
