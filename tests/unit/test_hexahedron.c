/* Hexahedra: volume and centroid against closed forms.  All tolerances are rounding: 1e-14 of the value or
 * of the size, eight Gauss points of about ten operations each. */
#include "check.h"

#include "hexahedron.h"

static const struct hexahedron cube = {{
    {0, 0, 0},
    {1, 0, 0},
    {1, 1, 0},
    {0, 1, 0},
    {0, 0, 1},
    {1, 0, 1},
    {1, 1, 1},
    {0, 1, 1},
}};

/* The unit cube moved by an affine map: its determinant, and the image of its middle. */
static void parallelepipeds(void **state)
{
    static const double map[3][3] = {{2, 0.3, -0.4}, {0.1, 1.5, 0.7}, {-0.2, 0.6, 0.9}},
                        shift[3] = {10, -20, 30};
    (void)state;
    struct hexahedron moved;
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) {
            moved.corner[i][a] = shift[a];
            for (int b = 0; b < 3; b++) moved.corner[i][a] += map[a][b] * cube.corner[i][b];
        }
    const double determinant = 2 * (1.5 * 0.9 - 0.7 * 0.6) - 0.3 * (0.1 * 0.9 - 0.7 * -0.2) +
                               -0.4 * (0.1 * 0.6 - 1.5 * -0.2);
    double centroid[3];
    assert_relative(hexahedron_volume(&moved, centroid), determinant, 1e-14);
    for (int a = 0; a < 3; a++) {
        double middle = shift[a] + 0.5 * (map[a][0] + map[a][1] + map[a][2]);
        assert_relative(centroid[a], middle, 1e-14);
    }
}

/* A square of side 2 below, of side 1 above, height 3: V = h (A + B + sqrt(A B)) / 3 = 7, centroid at
 * h (A + 2 sqrt(A B) + 3 B) / (4 (A + sqrt(A B) + B)) = 33 / 28 above the base. */
static void frusta(void **state)
{
    static const struct hexahedron frustum = {{
        {-1, -1, 0},
        {1, -1, 0},
        {1, 1, 0},
        {-1, 1, 0},
        {-0.5, -0.5, 3},
        {0.5, -0.5, 3},
        {0.5, 0.5, 3},
        {-0.5, 0.5, 3},
    }};
    double centroid[3];
    (void)state;
    assert_relative(hexahedron_volume(&frustum, centroid), 7, 1e-14);
    assert_near(centroid[0], 0, 1e-14);
    assert_near(centroid[1], 0, 1e-14);
    assert_relative(centroid[2], 3 * (4 + 2 * 2 + 3 * 1) / (4.0 * (4 + 2 + 1)), 1e-14);
}

/* One corner of the cube lifted by e: the upper face is z = 1 + e x y, warped.  V = 1 + e/4; the moments are
 * 1/2 + e/6 along x and y, (1 + e/2 + e^2/9) / 2 along z.  The mean of the corners is elsewhere. */
static void warped_faces(void **state)
{
    (void)state;
    for (double e = -0.5; e < 2; e += 0.5) {
        struct hexahedron warped = cube;
        warped.corner[6][2] = 1 + e;
        double centroid[3], volume = 1 + e / 4;
        assert_relative(hexahedron_volume(&warped, centroid), volume, 1e-14);
        assert_relative(centroid[0], (0.5 + e / 6) / volume, 1e-14);
        assert_relative(centroid[1], (0.5 + e / 6) / volume, 1e-14);
        assert_relative(centroid[2], 0.5 * (1 + e / 2 + e * e / 9) / volume, 1e-14);
    }
}

static void mirrored_ones_are_negative(void **state)
{
    (void)state;
    struct hexahedron mirrored;
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) mirrored.corner[i][a] = cube.corner[(i + 4) % 8][a];
    double centroid[3];
    assert_relative(hexahedron_volume(&mirrored, centroid), -1, 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelepipeds),
        cmocka_unit_test(frusta),
        cmocka_unit_test(warped_faces),
        cmocka_unit_test(mirrored_ones_are_negative),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
