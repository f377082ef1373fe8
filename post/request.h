/* request.h - the command line of hspost. */
#ifndef HS_REQUEST_H
#define HS_REQUEST_H

#include "choices.h"
#include "hardening.h"
#include "view_request.h"

#include <stdbool.h>

struct request {
    const char *output, *properties, *json, *plot, *voigt, *reuss, *loops, *plot_loops;
    const char *tidy, *mean, *statistics, *extrapolate, *extrapolate_properties, *sensitivities;
    const char *report, *crate;       /* file of the page, folder; NULL */
    const char *files_from;           /* names of further files, one a line; NULL */
    const char *material, *calibrate; /* name of the phase, directory of its test; NULL */
    double x_range[2],
        y_range[2]; /* of the figure, in the units of its axes; NAN where not given */
    double density, poissons_ratio; /* kg/m^3, -; NAN where not given */
    const char *law_name;           /* as given; NULL */
    const char *deck;
    const char *columns_of; /* of a table (text_table.h); NULL: by its headings */
    bool true_curve, whole, band, difference, columns, check, accept, quiet;
    double fraction;                 /* of the second curve; NAN where not given */
    double strain_range[2];          /* NAN where not given */
    const struct hardening_law *law; /* of the constituents */
    const char **choices;            /* texts of the options of post_section; NULL: not given */
    struct view_request view;
    int n_files;              /* with --check perhaps none */
    const char *const *files; /* [n_files]; "-": standard input */
    char *list;               /* what files_from holds, and files of it, */
    const char **listed;      /* together with those of the command line; NULL: all are of that */
};

/* Reads and checks it; dies (exit 2) where options do not go together. */
struct request request_read(int argc, char **argv);
void request_free(struct request *request);

#endif
