/* EBSD map of Oxford Instruments' Channel 5 (.ctf): rows of points, lengths in micrometres.  Its
 * head is believed for the names of phases alone; the grid follows from the points. */
#include "image_ebsd.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LINE = 4096, MOST_COLUMNS = 64 };

/* "9.5;17.7;5.3 TAB 90;103;90 TAB Glaucophane TAB ...": the third field. */
static void read_phase(char *line, int number, struct image *image)
{
    char *field = line;
    for (int tab = 0; tab < 2 && field; tab++) {
        field = strchr(field, '\t');
        if (field) field++;
    }
    if (!field) return;
    field[strcspn(field, "\t")] = '\0';
    image_add_name(image, number, field);
}

void image_ctf_read(const struct image_source *source, struct image *image)
{
    struct image_text text = image_text_of(source);
    char line[LINE], *names[MOST_COLUMNS];
    while (image_line(&text, line, sizeof line)) {
        if (strncasecmp(line, "Phases\t", 7) == 0) {
            const int phases = atoi(line + 7);
            for (int i = 1; i <= phases && image_line(&text, line, sizeof line); i++)
                read_phase(line, i, image);
        } else if (strncasecmp(line, "Phase\t", 6) == 0) {
            const int count = image_split(line, names, MOST_COLUMNS);
            struct ebsd_columns columns = {count < MOST_COLUMNS ? count : MOST_COLUMNS, names, -1,
                                           -1};
            for (int i = 0; i < columns.count; i++) {
                if (strcasecmp(names[i], "X") == 0) columns.x = i;
                if (strcasecmp(names[i], "Y") == 0) columns.y = i;
            }
            if (columns.x < 0 || columns.y < 0) image_refuse(&text, "the columns have no X and Y");
            ebsd_read(&text, &columns, image);
            return;
        }
    }
    image_refuse(&text, "the file ends without the line of its columns (Phase X Y ...)");
}
