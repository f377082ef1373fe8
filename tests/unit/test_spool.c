#include "dies.h"
#include "directory.h"

#include "memory.h"
#include "spool.h"
#include "taken.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>

static int count_files(void)
{
    int count = 0;
    DIR *directory = opendir(".");
    for (struct dirent *entry; (entry = readdir(directory)) != NULL;)
        count += entry->d_name[0] != '.';
    closedir(directory);
    return count;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static void expect_text(const char *path, const char *text)
{
    long length;
    char *found = spool_text(path, 1000, &length);
    assert_string_equal(found, text);
    assert_int_equal(length, strlen(text));
    free(found);
}

/* Runs a function with this descriptor in place of another; pipes and full disks are made so. */
static void replace(int descriptor, int standard)
{
    if (dup2(descriptor, standard) < 0) _exit(99);
}

/* --- inputs ----------------------------------------------------------------------------------- */

static void test_named_input_is_opened_in_place(void **state)
{
    (void)state;
    write_text("in", "data");
    struct spool spool = spool_input("in");
    assert_string_equal(spool.path, "in");
    assert_int_equal(spool.descriptor, -1);
    spool_close(&spool);
    unlink("in");
}

static void test_pipe_becomes_seekable(void **state)
{
    /* More than a pipe holds, so that it is filled while it is read. */
    enum { BYTES = 300000 };
    int ends[2];
    (void)state;
    char *sent = memory_new(BYTES, 1), *got = memory_new(BYTES, 1);
    for (int i = 0; i < BYTES; i++) sent[i] = (char)(i * 7 + i / 256);
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0) _exit(write(ends[1], sent, BYTES) != BYTES);
    close(ends[1]);
    char *name = memory_print("/proc/self/fd/%d", ends[0]);
    struct spool spool = spool_input(name);
    FILE *file = fopen(spool.path, "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    assert_int_equal(ftell(file), BYTES);
    rewind(file);
    assert_int_equal(fread(got, 1, BYTES, file), BYTES);
    assert_memory_equal(sent, got, BYTES);
    fclose(file);
    spool_close(&spool);
    waitpid(child, NULL, 0);
    close(ends[0]);
    free(name);
    free(sent);
    free(got);
    assert_int_equal(count_files(), 0);
}

static void read_input(const void *name)
{
    struct spool spool = spool_input(name);
    spool_close(&spool);
}

static void read_empty_pipe(const void *unused)
{
    (void)unused;
    int ends[2];
    if (pipe(ends) != 0) _exit(99);
    close(ends[1]);
    replace(ends[0], STDIN_FILENO);
    read_input("-");
}

static void read_long_text(const void *name)
{
    long length;
    free(spool_text(name, 3, &length));
}

static void test_inputs_that_are_refused(void **state)
{
    (void)state;
    write_text("empty", "");
    write_text("long", "four");
    assert_dies(EXIT_USER, "cannot open missing: No such file", read_input, "missing");
    assert_dies(EXIT_USER, ". is a directory", read_input, ".");
    assert_dies(EXIT_USER, "empty is empty", read_input, "empty");
    assert_dies(EXIT_USER, "standard input is empty (did the", read_empty_pipe, NULL);
    assert_dies(EXIT_USER, "long is larger than 3 bytes", read_long_text, "long");
    unlink("empty");
    unlink("long");
}

/* --- outputs ---------------------------------------------------------------------------------- */

static void test_output_appears_when_finished(void **state)
{
    (void)state;
    write_text("out", "old");
    taken_forget();
    struct spool spool = spool_output("out");
    write_text(spool.path, "new");
    expect_text("out", "old");
    spool_finish(&spool);
    expect_text("out", "new");
    assert_int_equal(count_files(), 1);
    unlink("out");
}

static void test_link_stays_a_link(void **state)
{
    struct stat status;
    (void)state;
    write_text("target", "old");
    assert_int_equal(symlink("target", "link"), 0);
    taken_forget();
    struct spool spool = spool_output("link");
    write_text(spool.path, "new");
    spool_finish(&spool);
    expect_text("target", "new");
    assert_int_equal(lstat("link", &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    unlink("target");
    unlink("link");
}

static void test_several_outputs_dropped(void **state)
{
    (void)state;
    taken_forget();
    struct spool first = spool_output("first"), second = spool_output("second");
    assert_int_equal(count_files(), 2);
    spool_close(&first);
    spool_close(&second);
    assert_int_equal(count_files(), 0);
}

static void write_output(const void *name)
{
    taken_forget();
    struct spool spool = spool_output(name);
    write_text(spool.path, "some data");
    spool_finish(&spool);
}

static void die_with_output(const void *name)
{
    taken_forget();
    struct spool spool = spool_output(name);
    write_text(spool.path, "half");
    die_run("lost energy balance");
}

static void finish_on_full_disk(const void *unused)
{
    (void)unused;
    replace(open("/dev/full", O_WRONLY), STDOUT_FILENO);
    write_output("-");
}

static void finish_on_closed_output(const void *unused)
{
    (void)unused;
    close(STDOUT_FILENO);
    write_output(NULL);
}

static void test_failures_leave_nothing(void **state)
{
    (void)state;
    assert_dies(EXIT_RUN, "lost energy balance", die_with_output, "out");
    assert_dies(EXIT_USER, "cannot write nowhere/out: No such file", write_output, "nowhere/out");
    assert_dies(EXIT_USER, ". is a directory", write_output, ".");
    assert_dies(EXIT_RUN, "cannot write /dev/full: No space left", write_output, "/dev/full");
    assert_dies(EXIT_RUN, "cannot write standard output: No space left", finish_on_full_disk, NULL);
    assert_dies(EXIT_USER, "standard output is closed", finish_on_closed_output, NULL);
    assert_int_equal(count_files(), 0);
}

/* Returns how a child ended that ran a function with a pipe as its standard output; the pipe's
 * content, as far as it was read, is in text. */
static int run_into_pipe(void (*run)(const void *), bool reader, char text[static 100])
{
    int ends[2], status;
    assert_int_equal(pipe(ends), 0);
    if (!reader) close(ends[0]);
    pid_t child = fork();
    if (child == 0) {
        replace(ends[1], STDOUT_FILENO);
        run("-");
        _exit(0);
    }
    close(ends[1]);
    ssize_t got = reader ? read(ends[0], text, 99) : 0;
    text[got > 0 ? got : 0] = '\0';
    assert_int_equal(waitpid(child, &status, 0), child);
    if (reader) close(ends[0]);
    return status;
}

static void write_with_sigpipe_ignored(const void *name)
{
    signal(SIGPIPE, SIG_IGN);
    write_output(name);
}

static void test_pipe_outputs(void **state)
{
    char text[100];
    (void)state;
    assert_int_equal(run_into_pipe(write_output, true, text), 0);
    assert_string_equal(text, "some data");
    int status = run_into_pipe(write_with_sigpipe_ignored, false, text);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE);
}

static void interrupt(const void *unused)
{
    (void)unused;
    taken_forget();
    spool_output("out");
    raise(SIGTERM);
}

static void test_signal_leaves_nothing(void **state)
{
    char text[100];
    (void)state;
    int status = run_into_pipe(interrupt, true, text);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
    assert_int_equal(count_files(), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_named_input_is_opened_in_place),
        cmocka_unit_test(test_pipe_becomes_seekable),
        cmocka_unit_test(test_inputs_that_are_refused),
        cmocka_unit_test(test_output_appears_when_finished),
        cmocka_unit_test(test_link_stays_a_link),
        cmocka_unit_test(test_several_outputs_dropped),
        cmocka_unit_test(test_failures_leave_nothing),
        cmocka_unit_test(test_pipe_outputs),
        cmocka_unit_test(test_signal_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
