/* What is said while an equilibrium is searched, to who looks at no terminal. */
#include "dies.h"
#include "directory.h"

#include "progress.h"
#include "ranks.h"

#include <stdlib.h>
#include <unistd.h>

/* What one call says on standard error. */
static void say(struct progress *progress, char *text, int size)
{
    fflush(stderr);
    const int kept = dup(STDERR_FILENO);
    assert_non_null(freopen("said", "w", stderr));
    progress_search(progress, 3, 120, 0.01, 1e-3);
    fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    FILE *file = fopen("said", "r");
    text[fread(text, 1, (size_t)size - 1, file)] = '\0';
    fclose(file);
}

static void every_ten_seconds_a_line(void **state)
{
    (void)state;
    char text[200];
    const double now = ranks_clock();
    struct progress progress = {true, false, now - 20, now - 10.5};
    say(&progress, text, sizeof text);
    assert_string_equal(text, "hssolve: step 3: 120 evaluations, residual 1.0e-02 of 1.0e-03\n");
    progress.last = ranks_clock() + 1000; /* however slow the machine is */
    say(&progress, text, sizeof text);
    assert_string_equal(text, "");
    progress = (struct progress){false, false, now - 20, now - 10.5};
    say(&progress, text, sizeof text);
    assert_string_equal(text, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_ten_seconds_a_line)};
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
