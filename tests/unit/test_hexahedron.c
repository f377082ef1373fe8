/* Hexahedra: volume and centroid against closed forms.  All tolerances are rounding: 1e-14 of the
 * value or of the size, eight Gauss points of about ten operations each. */
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

/* A square of side 2 below, of side 1 above, height 3: V = h (A + B + sqrt(A B)) / 3 = 7, centroid
 * at h (A + 2 sqrt(A B) + 3 B) / (4 (A + sqrt(A B) + B)) = 33 / 28 above the base. */
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

/* One corner of the cube lifted by e: the upper face is z = 1 + e x y, warped.  V = 1 + e/4; the
 * moments are 1/2 + e/6 along x and y, (1 + e/2 + e^2/9) / 2 along z.  The mean of the corners is
 * elsewhere. */
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

static const struct hexahedron distorted = {{
    {0.1, -0.2, 0.05},
    {1.2, 0.1, -0.1},
    {0.9, 1.1, 0.2},
    {-0.1, 0.8, -0.15},
    {0.15, 0.1, 0.9},
    {1.1, -0.1, 1.2},
    {1.3, 1.2, 1.05},
    {0.05, 0.9, 1.1},
}};

/* The integral of grad u over the volume is that of u n over the six faces, which are bilinear: two
 * Gauss points along each of their coordinates are exact.  Motions of one corner each. */
static void mean_gradient_by_the_surface(void **state)
{
    static const int face[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                   {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};
    const double place = sqrt(1. / 3);
    struct hexahedron_shape shape;
    double surface[8][3] = {{0}}, centroid[3];
    (void)state;
    for (int f = 0; f < 6; f++)
        for (int point = 0; point < 4; point++) {
            const double p = point & 1 ? place : -place, q = point & 2 ? place : -place;
            const double N[4] = {(1 - p) * (1 - q) / 4, (1 + p) * (1 - q) / 4,
                                 (1 + p) * (1 + q) / 4, (1 - p) * (1 + q) / 4},
                         by_p[4] = {-(1 - q) / 4, (1 - q) / 4, (1 + q) / 4, -(1 + q) / 4},
                         by_q[4] = {-(1 - p) / 4, -(1 + p) / 4, (1 + p) / 4, (1 - p) / 4};
            double t[3] = {0}, s[3] = {0};
            for (int k = 0; k < 4; k++)
                for (int a = 0; a < 3; a++) {
                    t[a] += by_p[k] * distorted.corner[face[f][k]][a];
                    s[a] += by_q[k] * distorted.corner[face[f][k]][a];
                }
            for (int k = 0; k < 4; k++)
                for (int a = 0; a < 3; a++)
                    surface[face[f][k]][a] +=
                        N[k] * (t[(a + 1) % 3] * s[(a + 2) % 3] - t[(a + 2) % 3] * s[(a + 1) % 3]);
        }
    assert_true(hexahedron_shape(&distorted, &shape));
    const double volume = hexahedron_volume(&distorted, centroid);
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++)
            assert_near(volume * shape.gradient[i][a], surface[i][a], 1e-15);
}

/* Values a + b x + sum_m h_m s_m at the corners come back, the affine ones as nothing; the gradient
 * of an affine motion is its own. */
static void amplitudes_of_a_motion(void **state)
{
    static const int r[8] = {-1, 1, 1, -1, -1, 1, 1, -1}, s[8] = {-1, -1, 1, 1, -1, -1, 1, 1},
                     t[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
    static const double h[4] = {0.3, -0.2, 0.7, 0.1}, b[3] = {1.5, -0.4, 0.8};
    struct hexahedron_shape shape;
    (void)state;
    assert_true(hexahedron_shape(&distorted, &shape));
    double found[4] = {0}, affine[4] = {0}, gradient[3] = {0};
    for (int i = 0; i < 8; i++) {
        const double modes = h[0] * r[i] * s[i] + h[1] * s[i] * t[i] + h[2] * t[i] * r[i] +
                             h[3] * r[i] * s[i] * t[i];
        double u = 0.2;
        for (int a = 0; a < 3; a++) u += b[a] * distorted.corner[i][a];
        for (int m = 0; m < 4; m++) {
            found[m] += shape.amplitude[m][i] * (u + modes);
            affine[m] += shape.amplitude[m][i] * u;
        }
        for (int a = 0; a < 3; a++) gradient[a] += u * shape.gradient[i][a];
    }
    for (int m = 0; m < 4; m++) {
        assert_near(found[m], h[m], 1e-14);
        assert_near(affine[m], 0, 1e-14);
    }
    for (int a = 0; a < 3; a++) assert_near(gradient[a], b[a], 1e-14);
}

/* In a box of the edges l the mean of |grad rs|^2 is 4/3 (1/l_x^2 + 1/l_y^2), of |grad rst|^2 4/9
 * of the sum of all three; different modes have nothing in common. */
static void spread_of_a_box(void **state)
{
    static const double l[3] = {1, 0.5, 3};
    struct hexahedron box;
    struct hexahedron_shape shape;
    double all = 0;
    (void)state;
    for (int i = 0; i < 8; i++)
        for (int a = 0; a < 3; a++) box.corner[i][a] = l[a] * cube.corner[i][a];
    for (int a = 0; a < 3; a++) all += 4. / 9 / (l[a] * l[a]);
    assert_true(hexahedron_shape(&box, &shape));
    for (int m = 0; m < 4; m++)
        for (int n = 0; n < 4; n++) {
            const double one = l[m % 3], other = l[(m + 1) % 3];
            const double own = m == 3 ? all : 4. / 3 * (1 / (one * one) + 1 / (other * other));
            assert_near(shape.spread[m][n], m == n ? own : 0, 1e-14 * 10);
        }
}

static void inside_out(void **state)
{
    struct hexahedron turned = cube;
    struct hexahedron_shape shape;
    (void)state;
    for (int a = 0; a < 3; a++) turned.corner[6][a] = 0.2; /* beyond the plane of its neighbours */
    double centroid[3];
    assert_true(hexahedron_volume(&turned, centroid) > 0);
    assert_false(hexahedron_shape(&turned, &shape));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelepipeds),
        cmocka_unit_test(frusta),
        cmocka_unit_test(warped_faces),
        cmocka_unit_test(mirrored_ones_are_negative),
        cmocka_unit_test(mean_gradient_by_the_surface),
        cmocka_unit_test(amplitudes_of_a_motion),
        cmocka_unit_test(spread_of_a_box),
        cmocka_unit_test(inside_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
