/* simd.h - one source, several vector widths.
 *
 * A function marked HS_SIMD is compiled for the baseline, AVX2 and AVX-512, and the loader picks
 * one by the processor.  Contraction is off (Makefile) but where the code says so (fused), so all
 * of them give the same bits; HS_NARROW leaves the baseline alone, to test that, and HS_NO_AVX512
 * takes the widest away, to time the others.  clang makes the baseline alone, or what
 * CFLAGS=-march=native asks for, with the same bits. */
#ifndef HS_SIMD_H
#define HS_SIMD_H

#include <stddef.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(HS_SANITIZE) &&    \
    !defined(HS_NARROW)
#ifdef HS_NO_AVX512
#define HS_SIMD __attribute__((noinline, target_clones("arch=x86-64-v3", "default")))
#else
#define HS_SIMD                                                                                    \
    __attribute__((noinline, target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
#else
#define HS_SIMD __attribute__((noinline))
#endif
#define HS_INLINE static inline __attribute__((always_inline))

/* Before rows of LANES numbers: a vector that lies across two lines of the cache costs twice. */
#define HS_ALIGNED _Alignas(64)

/* a b + c, rounded once: an instruction where the processor has it, else a function of the library
 * that comes to the same bits, at several times the cost. */
HS_INLINE double fused(double a, double b, double c)
{
    return __builtin_fma(a, b, c);
}

/* (ax, ay, az) . (bx, by, bz) */
HS_INLINE double dot3(double ax, double bx, double ay, double by, double az, double bz)
{
    return fused(ax, bx, fused(ay, by, az * bz));
}

/* a b - c d */
HS_INLINE double minor_of(double a, double b, double c, double d)
{
    return fused(a, b, -(c * d));
}

/* Asks for numbers that will soon be read: rows of short arrays, one behind the other, are more
 * than a processor sees coming. */
HS_INLINE void prefetch(const void *from, size_t bytes)
{
    for (size_t i = 0; i < bytes; i += 64) __builtin_prefetch((const char *)from + i, 0, 3);
}

/* Strips of the lattice are cut at multiples of this many sites in x, whatever part a rank holds.
 */
enum { LANES = 64 };

#endif
