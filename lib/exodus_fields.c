#include "die.h"
#include "exodus.h"
#include "exodus_file.h"
#include "memory.h"

#include <stdlib.h>

enum { UNUSED_ID = 0 };

struct exodus_fields {
    struct exodus_file file;
    int64_t n_nodes;
    int n_variables, n_frames;
};

struct exodus_fields *exodus_fields_open(const struct spool *output, const struct domain *domain,
                                         int n_variables, const char *const names[])
{
    struct exodus_fields *fields = memory_new(1, sizeof *fields);
    struct exodus_file file = exodus_create(output, &domain->attributes);
    exodus_put_domain(&file, domain);
    /* The library wants names that it could write to. */
    char **copies = memory_new((size_t)n_variables, sizeof *copies);
    for (int i = 0; i < n_variables; i++) {
        exodus_check_name(&file, names[i]);
        copies[i] = memory_text(names[i]);
    }
    exodus_wrote(&file, ex_put_variable_param(file.id, EX_NODAL, n_variables), "the variables");
    exodus_wrote(&file, ex_put_variable_names(file.id, EX_NODAL, n_variables, copies),
                 "the variables' names");
    for (int i = 0; i < n_variables; i++) free(copies[i]);
    free(copies);
    *fields = (struct exodus_fields){file, domain->n_nodes, n_variables, 0};
    return fields;
}

void exodus_fields_write(struct exodus_fields *fields, double time, const double *const values[])
{
    const struct exodus_file *file = &fields->file;
    int frame = ++fields->n_frames;
    for (int i = 0; i < fields->n_variables; i++)
        exodus_wrote(
            file,
            ex_put_var(file->id, frame, EX_NODAL, i + 1, UNUSED_ID, fields->n_nodes, values[i]),
            "a frame");
    exodus_wrote(file, ex_put_time(file->id, frame, &time), "a frame's time");
    exodus_wrote(file, ex_update(file->id), "a frame");
}

void exodus_fields_close(struct exodus_fields *fields)
{
    if (fields == NULL) return;
    exodus_finish(&fields->file);
    free(fields);
}
