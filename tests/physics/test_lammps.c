/* The forces of bond-based and ordinary materials are those of LAMMPS' pair styles peri/pmb and
 * peri/lps: always against tests/lammps/formula.awk, which says what LAMMPS computes, and where it
 * is installed against itself. */
#include "check.h"

#include "memory.h"
#include "random.h"
#include "small_body.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SIDE = 6, COUNT = SIDE * SIDE * SIDE };
#define HORIZON 3.015 /* spacings */

/* 3 K is far from 5 G: both terms of the ordinary force count. */
static const char *const materials[] = {
    "{A: {model: bond_based, density: 7800, bulk_modulus: 130 GPa}}",
    "{A: {model: ordinary, density: 7800, bulk_modulus: 130 GPa, shear_modulus: 50 GPa}}"};
static const char *const styles[] = {"pmb", "lps"}, *const influences[] = {"constant", "inverse"};
#define MODULI "130e9", "50e9"

struct particles {
    double x[3][COUNT], volume[COUNT], u[3][COUNT];
};

/* Of a lattice; scattered: each moved by up to a fifth of the spacing, and its volume up to a tenth
 * off. */
static void make_particles(struct particles *p, bool scattered)
{
    struct random_stream *stream = random_new(11, "particles");
    for (int i = 0; i < COUNT; i++) {
        const int at[3] = {i % SIDE, i / SIDE % SIDE, i / (SIDE * SIDE)};
        for (int a = 0; a < 3; a++) {
            p->x[a][i] = at[a] * SMALL_SPACING;
            if (scattered) p->x[a][i] += 0.2 * SMALL_SPACING * (2 * random_uniform(stream) - 1);
            p->u[a][i] = 0.01 * SMALL_SPACING * (2 * random_uniform(stream) - 1);
        }
        p->volume[i] = SMALL_SPACING * SMALL_SPACING * SMALL_SPACING;
        if (scattered) p->volume[i] *= 1 + 0.1 * (2 * random_uniform(stream) - 1);
    }
    random_free(stream);
}

static void write_particles(const struct particles *p, const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < COUNT; i++)
        fprintf(file, "%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", p->x[0][i], p->x[1][i],
                p->x[2][i], p->volume[i], p->u[0][i], p->u[1][i], p->u[2][i]);
    assert_int_equal(fclose(file), 0);
}

/* Site of a particle. */
static int64_t site_of(const struct small_body *small, int particle)
{
    int at[3];
    lattice_position(&small->lattice, particle, at);
    return grid_site(&small->body.grid, at);
}

static void our_forces(const struct particles *p, int style, bool partial, bool scattered,
                       double f[3][COUNT])
{
    struct small_body small;
    struct particles copy = *p;
    uint8_t phase[COUNT] = {0};
    struct domain points = {.n_nodes = COUNT,
                            .x = copy.x[0],
                            .y = copy.x[1],
                            .z = copy.x[2],
                            .volume = copy.volume,
                            .phase = phase};
    attributes_set_number(&points.attributes, "mean_spacing_m", SMALL_SPACING);
    small_body_new(&small, &(struct small_case){{SIDE, SIDE, SIDE},
                                                HORIZON,
                                                family_influence(influences[style]),
                                                NULL,
                                                materials[style],
                                                .n_phases = 1,
                                                .partial = partial,
                                                .points = scattered ? &points : NULL});
    for (int i = 0; i < COUNT; i++)
        for (int a = 0; a < 3; a++) small.body.u[a][site_of(&small, i)] = p->u[a][i];
    small_body_force(&small, false, false);
    for (int i = 0; i < COUNT; i++)
        for (int a = 0; a < 3; a++) f[a][i] = small.body.f[a][site_of(&small, i)];
    small_body_free(&small);
    attributes_free(&points.attributes);
}

/* Their rows "fx fy fz theta"; the exit code. */
static int their_forces(const char *command, double f[3][COUNT])
{
    FILE *pipe = popen(command, "r");
    int rows = 0;
    double x, y, z, theta;
    assert_non_null(pipe);
    while (fscanf(pipe, "%lf %lf %lf %lf", &x, &y, &z, &theta) == 4 && rows < COUNT) {
        f[0][rows] = x;
        f[1][rows] = y;
        f[2][rows++] = z;
    }
    const int status = pclose(pipe);
    if (status == 0) assert_int_equal(rows, COUNT);
    return WEXITSTATUS(status);
}

/* A millionth of the true spacing makes their volumes whole. */
static char *formula_command(const char *path, int style, bool partial)
{
    return memory_print("awk -v style=%s -v horizon=%.17g -v spacing=%.17g -v bulk=%s -v shear=%s "
                        "-f tests/lammps/formula.awk %s",
                        styles[style], HORIZON * SMALL_SPACING,
                        SMALL_SPACING * (partial ? 1 : 1e-6), MODULI, path);
}
static char *lammps_command(const char *path, int style, bool partial)
{
    return memory_print("tests/lammps/forces %s %s %.17g %.17g %s %s", styles[style], path,
                        HORIZON * SMALL_SPACING, SMALL_SPACING * (partial ? 1 : 1e-6), MODULI);
}

/* Extensions of a hundredth of a bond are taken from positions of five spacings, which are rounded
 * to 1e-16 of themselves: some 1e-13 of a bond's force.  Returns 77 where the other program is not
 * there. */
static int compare(char *(*command_of)(const char *, int, bool))
{
    const char *directory = getenv("TMPDIR");
    char *path = memory_print("%s/hs_particles_XXXXXX", directory ? directory : "/tmp");
    const int handle = mkstemp(path);
    int code = 0;
    assert_true(handle >= 0);
    fclose(fdopen(handle, "w"));
    for (int n = 0; n < 8 && code == 0; n++) {
        const int style = n & 1;
        const bool partial = n & 2, scattered = n & 4;
        struct particles p;
        double ours[3][COUNT], theirs[3][COUNT], square = 0, worst = 0;
        make_particles(&p, scattered);
        write_particles(&p, path);
        char *command = command_of(path, style, partial);
        code = their_forces(command, theirs);
        free(command);
        if (code != 0) break;
        our_forces(&p, style, partial, scattered, ours);
        for (int i = 0; i < COUNT; i++)
            for (int a = 0; a < 3; a++) {
                square += theirs[a][i] * theirs[a][i];
                worst = fmax(worst, fabs(ours[a][i] - theirs[a][i]));
            }
        if (getenv("HS_SHOW"))
            printf("# %s, %s volumes, %s: %.1e of the root mean square\n", styles[style],
                   partial ? "partial" : "whole", scattered ? "scattered" : "lattice",
                   worst / sqrt(square / COUNT));
        assert_true(square > 0);
        assert_near(worst, 0, 1e-12 * sqrt(square / COUNT));
    }
    remove(path);
    free(path);
    return code;
}

static void test_forces_are_the_formulas(void **state)
{
    (void)state;
    assert_int_equal(compare(formula_command), 0);
}

static void test_forces_are_those_of_lammps(void **state)
{
    (void)state;
    const int code = compare(lammps_command);
    if (code == 77) skip();
    assert_int_equal(code, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forces_are_the_formulas),
        cmocka_unit_test(test_forces_are_those_of_lammps),
    };
    return cmocka_run_group_tests_name("lammps", tests, small_ranks_start, small_ranks_stop);
}
