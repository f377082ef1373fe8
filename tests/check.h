/* check.h - cmocka's headers in their order, and comparisons of doubles. */
#ifndef HS_CHECK_H
#define HS_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |value - expected| <= tolerance, printing all three where it fails; NaN fails. */
#define assert_near(value, expected, tolerance)                                                    \
    do {                                                                                           \
        double near_value = (value), near_expected = (expected), near_tolerance = (tolerance);     \
        if (!(fabs(near_value - near_expected) <= near_tolerance))                                 \
            fail_msg("%s = %.17g, expected %.17g within %.3g (off by %.3g)", #value, near_value,   \
                     near_expected, near_tolerance, fabs(near_value - near_expected));             \
    } while (0)

/* The same, relative to |expected|. */
#define assert_relative(value, expected, tolerance)                                                \
    assert_near(value, expected, (tolerance)*fabs((double)(expected)))

#endif
