#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

enum { ONLY_SET = 1, UNUSED_ID = 0 };

static char title[] = "hstools history";

struct exodus_history {
    struct exodus_file file;
    int64_t written;
};

struct exodus_history *exodus_history_open(const struct spool *output,
                                           const struct history *history, int64_t expected)
{
    struct exodus_history *written = memory_new(1, sizeof *written);
    struct exodus_file file = exodus_create(output, &history->attributes);
    const int columns = history->n_columns;
    exodus_wrote(&file, ex_put_init(file.id, title, 3, 0, 0, 0, 0, 0), "the sizes");
    for (int i = 0; i < columns; i++) exodus_check_name(&file, history->columns[i]);
    exodus_wrote(&file, ex_put_variable_param(file.id, EX_GLOBAL, columns), "the columns");
    exodus_wrote(&file, ex_put_variable_names(file.id, EX_GLOBAL, columns, history->columns),
                 "the columns' names");
    if (expected > 0) {
        exodus_sync(&file);
        spool_reserve(file.path, file.shown, expected * 8 * ((int64_t)columns + 1));
    }
    *written = (struct exodus_history){file, 0};
    return written;
}

static void add_records(struct exodus_history *written, const struct history *history)
{
    const struct exodus_file *file = &written->file;
    const int columns = history->n_columns;
    for (; written->written < history->n_records; written->written++) {
        const int64_t i = written->written;
        const int step = (int)i + 1;
        const double *record = history->values + i * columns;
        exodus_wrote(file,
                     ex_put_var(file->id, step, EX_GLOBAL, ONLY_SET, UNUSED_ID, columns, record),
                     "a record");
        exodus_wrote(file, ex_put_time(file->id, step, &history->time[i]), "a time");
    }
}

void exodus_history_add(struct exodus_history *written, const struct history *history)
{
    if (written->written == history->n_records) return;
    add_records(written, history);
    exodus_sync(&written->file);
}

void exodus_history_close(struct exodus_history *written, const struct history *history)
{
    add_records(written, history);
    exodus_renew_numbers(&written->file, &history->attributes);
    exodus_finish(&written->file);
    free(written);
}

void exodus_write_history(const struct spool *output, const struct history *history)
{
    exodus_history_close(exodus_history_open(output, history, 0), history);
}

static void read_columns(const struct exodus_file *file, struct history *history)
{
    int columns;
    exodus_read(file, ex_get_variable_param(file->id, EX_GLOBAL, &columns), "the columns");
    history->n_records = ex_inquire_int(file->id, EX_INQ_TIME);
    if (columns == 0 || history->n_records == 0)
        die_user("%s: no history in it, expected the output of hssolve", file->shown);
    exodus_bound(file, columns, 8, "columns");
    exodus_bound(file, history->n_records, 8 * ((int64_t)columns + 1), "records");
    char **names = exodus_names(columns);
    exodus_read(file, ex_get_variable_names(file->id, EX_GLOBAL, columns, names), "the names");
    history->columns = memory_new((size_t)columns, sizeof *history->columns);
    for (int i = 0; i < columns; i++) history->columns[i] = memory_text(names[i]);
    history->n_columns = columns;
    free(names);
}

struct history exodus_read_history(const struct spool *input)
{
    struct history history = {0};
    struct exodus_file file = exodus_open(input, false);
    read_columns(&file, &history);
    size_t records = (size_t)history.n_records, columns = (size_t)history.n_columns;
    history.time = memory_new(records, sizeof(double));
    history.values = memory_new(records * columns, sizeof(double));
    exodus_read(&file, ex_get_all_times(file.id, history.time), "the times");
    for (size_t i = 0; i < records; i++)
        exodus_read(&file,
                    ex_get_var(file.id, (int)i + 1, EX_GLOBAL, ONLY_SET, UNUSED_ID,
                               history.n_columns, history.values + i * columns),
                    "a record");
    history.attributes = exodus_read_attributes(&file);
    exodus_close(&file);
    return history;
}

void history_free(struct history *history)
{
    for (int i = 0; i < history->n_columns; i++) free(history->columns[i]);
    free(history->columns);
    free(history->time);
    free(history->values);
    attributes_free(&history->attributes);
    *history = (struct history){0};
}
