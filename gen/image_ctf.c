/* EBSD map of Oxford Instruments' Channel 5 (.ctf): rows of points, lengths in micrometres.  The
 * grid follows from the points; its head is believed where it agrees with them. */
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

static void read_head(const char *line, struct ebsd_head *head)
{
    static const char *const keys[2][2] = {{"XCells\t", "YCells\t"}, {"XStep\t", "YStep\t"}};
    for (int axis = 0; axis < 2; axis++) {
        const size_t cells = strlen(keys[0][axis]), step = strlen(keys[1][axis]);
        if (strncasecmp(line, keys[0][axis], cells) == 0) head->count[axis] = atof(line + cells);
        if (strncasecmp(line, keys[1][axis], step) == 0) head->step[axis] = atof(line + step);
    }
}

void image_ctf_read(const struct image_source *source, struct image *image)
{
    struct image_text text = image_text_of(source);
    struct ebsd_head head = {{0, 0}, {0, 0}};
    char line[LINE], *names[MOST_COLUMNS];
    while (image_line(&text, line, sizeof line)) {
        read_head(line, &head);
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
            ebsd_read(&text, &columns, &head, image);
            return;
        }
    }
    image_refuse(&text, "the file ends without the line of its columns (Phase X Y ...)");
}
