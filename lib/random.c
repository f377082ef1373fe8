#include "random.h"

#include "die.h"
#include "memory.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_version.h>
#include <stdlib.h>

struct random_stream {
    gsl_rng *generator;
};

const char *random_library(void)
{
    return "GSL " GSL_VERSION;
}

/* The finaliser of SplitMix64: Steele, Lea, Flood, OOPSLA 2014, variant 13 of Stafford. */
static uint64_t mix(uint64_t bits)
{
    bits += 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

uint64_t random_hash(long seed, const char *purpose, uint64_t number)
{
    uint64_t bits = mix((uint64_t)seed);
    for (const char *c = purpose; *c != '\0'; c++) bits = mix(bits ^ (unsigned char)*c);
    return mix(bits ^ mix(number));
}

struct random_stream *random_new(long seed, const char *purpose)
{
    struct random_stream *stream = memory_new(1, sizeof *stream);
    stream->generator = gsl_rng_alloc(gsl_rng_taus2);
    if (stream->generator == NULL) die_run("out of memory for a random generator");
    uint64_t bits = random_hash(seed, purpose, 0);
    gsl_rng_set(stream->generator, (unsigned long)((bits ^ (bits >> 32)) & UINT32_MAX));
    return stream;
}

void random_free(struct random_stream *stream)
{
    if (stream == NULL) return;
    gsl_rng_free(stream->generator);
    free(stream);
}

double random_uniform(struct random_stream *stream)
{
    return gsl_rng_uniform(stream->generator);
}

double random_gaussian(struct random_stream *stream)
{
    return gsl_ran_ugaussian(stream->generator);
}

uint64_t random_integer(struct random_stream *stream, uint64_t below)
{
    if (below == 0) die_run("random_integer: no number lies below 0");
    /* Numbers of an incomplete last round are drawn again, so that all are equally likely. */
    uint64_t surplus = (UINT64_MAX % below + 1) % below, bits;
    do {
        bits = (uint64_t)gsl_rng_get(stream->generator) << 32;
        bits |= gsl_rng_get(stream->generator);
    } while (bits > UINT64_MAX - surplus);
    return bits % below;
}
