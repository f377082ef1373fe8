#include "columns.h"

#include "die.h"
#include "input.h"
#include "text_output.h"

#include <math.h>

void columns_write(const char *file, const char *output, const char *maker)
{
    struct input input = input_read(file, NULL);
    const struct table *table = &input.table;
    if (!input.is_history) die_user("%s: no history of hssolve", input.name);
    struct text_output out = text_output_open(output);
    fputs(maker, out.file);
    fprintf(out.file, "# input: %s, %ld bytes, cksum %lu\n", input.name, input.bytes,
            (unsigned long)input.checksum);
    /* What makes strains and stresses of displacements and forces. */
    static const char *const sizes[] = {"gauge_length_m", "section_m2"};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        const double size = attributes_number(&input.attributes, sizes[k], NAN);
        if (!isnan(size)) fprintf(out.file, "# %s: %.17g\n", sizes[k], size);
    }
    for (int j = 0; j < table->n_columns; j++)
        fprintf(out.file, "%s%s", j ? "," : "", table->columns[j].name);
    fputc('\n', out.file);
    for (long i = 0; i < table->n_rows; i++) {
        for (int j = 0; j < table->n_columns; j++) {
            const double value = table->columns[j].values[i];
            if (j) fputc(',', out.file);
            if (!isnan(value)) fprintf(out.file, "%.17g", value);
        }
        fputc('\n', out.file);
    }
    text_output_close(&out);
    input_free(&input);
}
