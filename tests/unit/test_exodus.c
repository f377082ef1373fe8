#include "directory.h"
#include "files.h"
#include "taken.h"

#include "exodus.h"
#include "memory.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>

enum { NODES = 24, SETS = 3 };

static const char long_name[] = "a_phase_with_a_name_of_more_than_thirty_two_characters_in_it";

static struct domain small_domain(void)
{
    static const int64_t left[] = {0, 4, 8, 12, 16, 20}, right[] = {3, 7, 11, 15, 19, 23};
    struct domain domain = domain_new(NODES, 3, (const char *const[]){"CG", "absent", long_name});
    for (int i = 0; i < NODES; i++) {
        domain.x[i] = 25e-6 * (i % 4);
        domain.y[i] = 25e-6 * (i / 4 % 3);
        domain.z[i] = 25e-6 * (i / 12);
        domain.volume[i] = (1 + i) * 1e-15;
        domain.phase[i] = i % 5 == 0 ? 2 : 0; /* none of phase 1 */
    }
    domain_add_set(&domain, "grip_left", 6, left);
    domain_add_set(&domain, "nobody", 0, NULL);
    domain_add_set(&domain, "grip_right", 6, right);
    attributes_set_number(&domain.attributes, "spacing_m", 25e-6);
    attributes_set_text(&domain.attributes, "deck", "title: \xc3\xa9\n# \"quoted\"\n");
    attributes_set_text(&domain.attributes, "empty", "");
    attributes_set_text(&domain.attributes, "program", "hsgen 0.1.0\nand more");
    attributes_set_text(&domain.attributes, "command",
                        "hsgen a_command_line/that_is/longer/than_the_eighty_characters/of_one/"
                        "information/record.yaml -o domain.g");
    return domain;
}

static void write_domain(const char *name)
{
    struct domain domain = small_domain();
    taken_forget();
    struct spool output = spool_output(name);
    exodus_write_domain(&output, &domain);
    spool_finish(&output);
    domain_free(&domain);
}

static void expect_same(const struct domain *read, const struct domain *written)
{
    assert_int_equal(read->n_nodes, written->n_nodes);
    assert_memory_equal(read->x, written->x, NODES * sizeof(double));
    assert_memory_equal(read->y, written->y, NODES * sizeof(double));
    assert_memory_equal(read->z, written->z, NODES * sizeof(double));
    assert_memory_equal(read->volume, written->volume, NODES * sizeof(double));
    assert_memory_equal(read->phase, written->phase, NODES);
    assert_int_equal(read->n_phases, written->n_phases);
    for (int i = 0; i < written->n_phases; i++)
        assert_string_equal(read->phase_names[i], written->phase_names[i]);
    assert_int_equal(read->n_sets, written->n_sets);
    for (int i = 0; i < written->n_sets; i++) {
        const struct node_set *a = &read->sets[i], *b = &written->sets[i];
        assert_string_equal(a->name, b->name);
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->nodes, b->nodes, (size_t)b->count * sizeof *b->nodes);
    }
    assert_int_equal(read->attributes.count, written->attributes.count);
    for (int i = 0; i < written->attributes.count; i++) {
        const struct attribute *a = &read->attributes.items[i], *b = &written->attributes.items[i];
        assert_string_equal(a->name, b->name);
        assert_true(a->number == b->number);
        assert_true((a->text == NULL) == (b->text == NULL));
        if (b->text != NULL) assert_string_equal(a->text, b->text);
    }
}

static void test_domain_comes_back(void **state)
{
    (void)state;
    write_domain("domain.g");
    struct domain written = small_domain(), read = read_domain("domain.g");
    expect_same(&read, &written);
    assert_null(domain_set(&read, "grip"));
    domain_free(&written);
    domain_free(&read);
}

/* Positions and volumes that stay in the file are those that are read from it. */
static void test_domain_is_streamed(void **state)
{
    (void)state;
    struct domain written = small_domain(), read;
    write_domain("domain.g");
    struct spool input = spool_input("domain.g");
    assert_true(exodus_stream_domain(&input, &read));
    spool_close(&input);
    assert_null(read.x);
    for (int pass = 0; pass < 2; pass++) {
        struct domain_nodes nodes = {0};
        int64_t count = 0;
        while (domain_next(&read, &nodes))
            for (int64_t i = 0; i < nodes.count; i++, count++)
                assert_true(nodes.volume[i] == written.volume[nodes.first + i]);
        assert_int_equal(count, NODES);
    }
    domain_hold(&read);
    expect_same(&read, &written);
    domain_free(&read);
    domain_free(&written);
    /* Of one without a spacing it is not known that it has an order. */
    struct domain foreign = small_domain();
    attributes_free(&foreign.attributes);
    taken_forget();
    struct spool output = spool_output("foreign.g");
    exodus_write_domain(&output, &foreign);
    spool_finish(&output);
    domain_free(&foreign);
    input = spool_input("foreign.g");
    assert_false(exodus_stream_domain(&input, &read));
    assert_null(read.phase);
    spool_close(&input);
}

static void test_same_domain_same_bytes(void **state)
{
    size_t first_length, second_length;
    (void)state;
    write_domain("domain.g");
    write_domain("again.g");
    char *first = read_bytes("domain.g", &first_length);
    char *second = read_bytes("again.g", &second_length);
    assert_int_equal(first_length, second_length);
    assert_memory_equal(first, second, first_length);
    assert_memory_equal(first, "CDF\002", 4);
    free(first);
    free(second);
}

/* --- histories -------------------------------------------------------------------------------- */

static struct history small_history(void)
{
    enum { RECORDS = 5, COLUMNS = 3 };
    static const char *const names[COLUMNS] = {"force_left_N", "extension_m", "energy_drift"};
    struct history history = {.n_columns = COLUMNS, .n_records = RECORDS};
    history.columns = memory_new(COLUMNS, sizeof(char *));
    history.time = memory_new(RECORDS, sizeof(double));
    history.values = memory_new((size_t)RECORDS * COLUMNS, sizeof(double));
    for (int i = 0; i < COLUMNS; i++) history.columns[i] = memory_text(names[i]);
    for (int i = 0; i < RECORDS; i++) history.time[i] = i / 3.0;
    for (int i = 0; i < RECORDS * COLUMNS; i++) history.values[i] = sin(i);
    attributes_set_number(&history.attributes, "gauge_length_m", 2.5e-3);
    attributes_set_text(&history.attributes, "deck", "title: x\n");
    return history;
}

static void write_history(const char *name)
{
    struct history history = small_history();
    taken_forget();
    struct spool output = spool_output(name);
    exodus_write_history(&output, &history);
    spool_finish(&output);
    history_free(&history);
}

static void test_history_comes_back(void **state)
{
    (void)state;
    write_history("history.e");
    struct spool input = spool_input("history.e");
    struct history written = small_history(), read = exodus_read_history(&input);
    spool_close(&input);
    assert_int_equal(read.n_columns, written.n_columns);
    assert_int_equal(read.n_records, written.n_records);
    for (int i = 0; i < written.n_columns; i++)
        assert_string_equal(read.columns[i], written.columns[i]);
    assert_memory_equal(read.time, written.time, 5 * sizeof(double));
    assert_memory_equal(read.values, written.values, 15 * sizeof(double));
    assert_true(attributes_number(&read.attributes, "gauge_length_m", 0) == 2.5e-3);
    assert_true(attributes_number(&read.attributes, "no such", -1) == -1);
    assert_string_equal(attributes_text(&read.attributes, "deck"), "title: x\n");
    history_free(&written);
    history_free(&read);
}

/* --- fields ----------------------------------------------------------------------------------- */

static void write_frames(struct exodus_fields *fields, int first, int last)
{
    double x[NODES], y[NODES];
    const double *values[] = {x, y};
    for (int frame = first; frame <= last; frame++) {
        for (int i = 0; i < NODES; i++) {
            x[i] = frame + i;
            y[i] = -frame * i;
        }
        exodus_fields_write(fields, 0.5 * frame, values);
    }
}

static struct exodus_fields *open_fields(const struct spool *output, const struct domain *domain)
{
    static const char *const names[] = {"DisplacementX", "DisplacementY"};
    return exodus_fields_open(output, domain, 2, names);
}

/* The lines of ncdump that hold the frames, by a reader that is not ours. */
static void expect_dump(const char *variable, const char *name, const char *expected)
{
    char text[4096] = "";
    char *command =
        memory_print("ncdump -v %s %s | sed -n '/^data:/,$p' | tr -d ' \\n'", variable, name);
    FILE *dump = popen(command, "r");
    text[fread(text, 1, sizeof text - 1, dump)] = '\0';
    assert_int_equal(pclose(dump), 0);
    if (strstr(text, expected) == NULL) fail_msg("%s: %s, expected %s", name, text, expected);
    free(command);
}

static void write_fields(const char *name, int frames)
{
    struct domain domain = small_domain();
    taken_forget();
    struct spool output = spool_output(name);
    struct exodus_fields *fields = open_fields(&output, &domain);
    write_frames(fields, 1, frames);
    exodus_fields_close(fields);
    spool_finish(&output);
    domain_free(&domain);
}

static void test_fields_carry_the_domain_and_frames(void **state)
{
    (void)state;
    write_fields("run.e", 2);
    struct domain domain = small_domain(), read = read_domain("run.e");
    expect_same(&read, &domain);
    domain_free(&read);
    domain_free(&domain);
    if (system("command -v ncdump >/dev/null") != 0) skip();
    expect_dump("time_whole", "run.e", "time_whole=0.5,1;");
    expect_dump("vals_nod_var2", "run.e", "0,-2,-4,-6,-8,-10,");
}

static void test_frames_are_on_disk_at_once(void **state)
{
    struct stat before, after;
    (void)state;
    struct domain domain = small_domain();
    taken_forget();
    struct spool output = spool_output("run.e");
    struct exodus_fields *fields = open_fields(&output, &domain);
    write_frames(fields, 1, 1);
    assert_int_equal(stat(output.path, &before), 0);
    write_frames(fields, 2, 2);
    assert_int_equal(stat(output.path, &after), 0);
    /* A frame: two variables and the time. */
    assert_int_equal(after.st_size - before.st_size, (2 * NODES + 1) * (int)sizeof(double));
    exodus_fields_close(fields);
    spool_close(&output);
    domain_free(&domain);
}

static void test_frames_come_back(void **state)
{
    double values[NODES];
    (void)state;
    write_fields("run.e", 3);
    struct spool input = spool_input("run.e");
    struct frames frames = exodus_frames_open(&input);
    assert_int_equal(frames.n_nodes, NODES);
    assert_int_equal(frames.n_variables, 2);
    assert_string_equal(frames.variables[1], "DisplacementY");
    assert_int_equal(frames_find(&frames, "DisplacementY"), 1);
    assert_int_equal(frames_find(&frames, "Displacement"), -1);
    assert_int_equal(frames.n_frames, 3);
    for (int frame = 0; frame < 3; frame++) {
        assert_true(frames.time[frame] == 0.5 * (frame + 1));
        exodus_frames_read(&frames, 0, frame, values);
        for (int i = 0; i < NODES; i++) assert_true(values[i] == frame + 1 + i);
        exodus_frames_read(&frames, 1, frame, values);
        for (int i = 0; i < NODES; i++) assert_true(values[i] == -(frame + 1) * i);
    }
    exodus_frames_close(&frames);
    spool_close(&input);
}

/* --- what is refused -------------------------------------------------------------------------- */

static void try_history(const void *name)
{
    struct spool input = spool_input(name);
    struct history history = exodus_read_history(&input);
    history_free(&history);
    spool_close(&input);
}

static void try_frames(const void *name)
{
    struct spool input = spool_input(name);
    struct frames frames = exodus_frames_open(&input);
    double *values = memory_new((size_t)frames.n_nodes, sizeof *values);
    for (int64_t frame = 0; frame < frames.n_frames; frame++)
        for (int i = 0; i < frames.n_variables; i++) exodus_frames_read(&frames, i, frame, values);
    free(values);
    exodus_frames_close(&frames);
    spool_close(&input);
}

static void test_foreign_input_is_refused(void **state)
{
    (void)state;
    write_bytes("text", "time,stress\n0,0\n", 16);
    write_bytes("short", "CDF\002", 4);
    write_bytes("hdf5", "\211HDF\r\n\032\n________", 16);
    assert_dies(EXIT_USER, "text: not a netCDF file", try_domain, "text");
    assert_dies(EXIT_USER, "short: not a netCDF file, or a truncated or damaged one", try_domain,
                "short");
    assert_dies(EXIT_USER, "hdf5: cannot read it as Exodus", try_history, "hdf5");
    write_domain("domain.g");
    write_history("history.e");
    assert_dies(EXIT_USER, "domain.g: no history in it", try_history, "domain.g");
    write_fields("empty.e", 0);
    assert_dies(EXIT_USER, "history.e: no nodes in it", try_domain, "history.e");
    assert_dies(EXIT_USER, "text: not a netCDF file", try_frames, "text");
    assert_dies(EXIT_USER, "domain.g: no frames of fields in it", try_frames, "domain.g");
    assert_dies(EXIT_USER, "history.e: no frames of fields in it", try_frames, "history.e");
    assert_dies(EXIT_USER, "empty.e: ", try_frames, "empty.e");
}

static void expect_truncations_refused(const char *name, void (*try)(const void *))
{
    size_t length;
    char *bytes = read_bytes(name, &length);
    for (size_t cut = 1; cut < length; cut += 97) {
        write_bytes("cut.g", bytes, cut);
        assert_dies(EXIT_USER, "cut.g: ", try, "cut.g");
    }
    write_bytes("cut.g", bytes, length - 1);
    assert_dies(EXIT_USER, "truncated or damaged", try, "cut.g");
    free(bytes);
}

static void test_every_truncation_is_refused(void **state)
{
    (void)state;
    write_domain("domain.g");
    expect_truncations_refused("domain.g", try_domain);
    write_fields("run.e", 2);
    expect_truncations_refused("run.e", try_frames);
}

static void test_unfinished_is_refused(void **state)
{
    (void)state;
    struct domain domain = small_domain();
    taken_forget();
    struct spool output = spool_output("run.e");
    struct exodus_fields *fields = open_fields(&output, &domain);
    write_frames(fields, 1, 1);
    assert_dies(EXIT_USER, "was never finished", try_domain, output.path);
    exodus_fields_close(fields);
    spool_close(&output);
    domain_free(&domain);
}

static void test_damaged_bytes_do_no_harm(void **state)
{
    (void)state;
    write_domain("domain.g");
    expect_no_harm("domain.g", 61, try_domain);
    write_fields("run.e", 2);
    expect_no_harm("run.e", 61, try_frames);
}

static void write_on_full_disk(const void *name)
{
    struct rlimit limit = {2000, 2000};
    signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(99);
    write_domain(name);
}

static void test_full_disk(void **state)
{
    (void)state;
    assert_dies(EXIT_RUN, "full.g: cannot write", write_on_full_disk, "full.g");
    assert_int_not_equal(access("full.g", F_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_domain_comes_back),
        cmocka_unit_test(test_domain_is_streamed),
        cmocka_unit_test(test_same_domain_same_bytes),
        cmocka_unit_test(test_history_comes_back),
        cmocka_unit_test(test_fields_carry_the_domain_and_frames),
        cmocka_unit_test(test_frames_are_on_disk_at_once),
        cmocka_unit_test(test_frames_come_back),
        cmocka_unit_test(test_foreign_input_is_refused),
        cmocka_unit_test(test_every_truncation_is_refused),
        cmocka_unit_test(test_unfinished_is_refused),
        cmocka_unit_test(test_damaged_bytes_do_no_harm),
        cmocka_unit_test(test_full_disk),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
