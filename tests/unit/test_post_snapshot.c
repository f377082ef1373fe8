/* What is drawn of particle fields: sizes and layers, of lattices, scattered particles and sheets.
 */
#include "dies.h"
#include "directory.h"
#include "taken.h"

#include "exodus.h"
#include "snapshot.h"

enum { NODES = 8 };

/* Eight particles, the upper four at height; spacing and thickness are left out where 0. */
static void write_body(const char *name, double height, double spacing, double thickness)
{
    static const char *const names[] = {"DisplacementX", "DisplacementY", "Damage"};
    char phase[] = "A", *phases[] = {phase};
    double x[NODES], y[NODES], z[NODES], volume[NODES], damage[NODES];
    uint8_t of[NODES] = {0};
    for (int i = 0; i < NODES; i++) {
        x[i] = i % 2;
        y[i] = i / 2 % 2;
        z[i] = i < 4 ? 0 : height;
        volume[i] = i == 7 ? 0.125 : 1;
        damage[i] = 0.1 * i;
    }
    struct domain domain = {
        .n_nodes = NODES, .x = x, .y = y, .z = z, .volume = volume, .phase = of};
    domain.n_phases = 1;
    domain.phase_names = phases;
    if (spacing > 0) attributes_set_number(&domain.attributes, "spacing_m", spacing);
    if (thickness > 0) attributes_set_number(&domain.attributes, "thickness_m", thickness);
    taken_forget();
    struct spool output = spool_output(name);
    struct exodus_fields *fields = exodus_fields_open(&output, &domain, 3, names);
    exodus_fields_write(fields, 1, (const double *const[]){x, y, damage});
    exodus_fields_close(fields);
    spool_finish(&output);
    attributes_free(&domain.attributes);
}

static struct snapshot read_body(const char *name)
{
    struct view_request request = {.frames = name, .csv = true, .variables = "Displacement,Damage"};
    view_request_check(&request, false);
    request.factor = 1;
    return snapshot_read(&request);
}

static void expect_slice(const struct snapshot *snapshot, double position, double found,
                         const char *nodes)
{
    double at;
    int64_t count, *chosen = snapshot_slice(snapshot, 2, position, &at, &count);
    char text[NODES + 1] = "";
    for (int64_t k = 0; k < count; k++) text[k] = (char)('0' + chosen[k]);
    assert_string_equal(text, nodes);
    assert_true(at == found);
    free(chosen);
}

static void test_layers_of_a_lattice(void **state)
{
    (void)state;
    write_body("lattice.e", 1, 1, 0);
    struct snapshot snapshot = read_body("lattice.e");
    assert_true(snapshot.side[7] == 1);
    expect_slice(&snapshot, NAN, 1, "4567");
    expect_slice(&snapshot, 0.4, 0, "0123");
    expect_slice(&snapshot, -0.5, 0, "0123");
    expect_slice(&snapshot, 1.5, 1, "4567");
    snapshot_free(&snapshot);
}

/* A cube of 1 m at 0 m is cut by planes up to 0.5 m away; that of 0.5 m up to 0.25 m. */
static void test_scattered_particles(void **state)
{
    (void)state;
    write_body("scattered.e", 0.3, 0, 0);
    struct snapshot snapshot = read_body("scattered.e");
    assert_true(snapshot.side[0] == 1);
    assert_near(snapshot.side[7], 0.5, 1e-16); /* cube root to the last bit */
    expect_slice(&snapshot, 0, 0, "0123456");
    expect_slice(&snapshot, 0.3, 0.3, "01234567");
    snapshot_free(&snapshot);
}

static void test_sheet(void **state)
{
    (void)state;
    write_body("sheet.e", 0, 0, 0.25);
    struct snapshot snapshot = read_body("sheet.e");
    assert_true(snapshot.side[0] == 2);
    expect_slice(&snapshot, NAN, 0, "01234567");
    snapshot_free(&snapshot);
}

static void test_fields(void **state)
{
    (void)state;
    write_body("fields.e", 1, 1, 0);
    struct snapshot snapshot = read_body("fields.e");
    assert_int_equal(snapshot.n_fields, 2);
    assert_string_equal(snapshot.fields[0].unit, "m");
    assert_string_equal(snapshot.fields[1].unit, "1");
    assert_true(snapshot.fields[0].values[3] == sqrt(2)); /* there is no z */
    assert_true(snapshot.fields[1].values[3] == 0.1 * 3);
    assert_true(snapshot.displacement[0][1] == 1 && snapshot.displacement[2] == NULL);
    assert_true(snapshot.time == 1 && snapshot.frame == 1 && snapshot.n_frames == 1);
    snapshot_free(&snapshot);
}

static void try_slice(const void *name)
{
    struct snapshot snapshot = read_body(name);
    double found;
    int64_t count;
    free(snapshot_slice(&snapshot, 2, 1.6, &found, &count));
    snapshot_free(&snapshot);
}

static void test_beyond_the_body(void **state)
{
    (void)state;
    write_body("body.e", 1, 1, 0);
    assert_dies(EXIT_USER, "no particle at z = 1.6 m; the body reaches from 0 m to 1 m", try_slice,
                "body.e");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layers_of_a_lattice),
        cmocka_unit_test(test_scattered_particles),
        cmocka_unit_test(test_sheet),
        cmocka_unit_test(test_fields),
        cmocka_unit_test(test_beyond_the_body),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
