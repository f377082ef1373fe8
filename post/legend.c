#include "legend.h"

#include "colours.h"
#include "memory.h"
#include "scale.h"

#include <math.h>
#include <stdlib.h>

/* Points. */
enum { WIDTH = 14, NAME_DISTANCE = 22, TICK_DISTANCE = 24 };

double legend_least_height(const struct snapshot *snapshot)
{
    for (int i = 0; i < snapshot->n_fields; i++)
        if (snapshot->fields[i].phase) return snapshot->domain.n_phases * NAME_DISTANCE;
    return 0;
}

char *legend_title(const struct field *field, const double range[2])
{
    struct scale scale = scale_make(range, field->unit, 1);
    char *title =
        *scale.unit ? memory_print("%s (%s)", field->name, scale.unit) : memory_text(field->name);
    scale_free(&scale);
    return title;
}

static void draw_bar(struct canvas *canvas, double height, const struct scale *scale)
{
    static const double black[3] = {0, 0, 0};
    for (int k = 0; k < (int)height; k++) {
        double colour[3];
        colour_of(1 - (k + 0.5) / height, colour);
        canvas_cell(canvas, 0, k, WIDTH, fmin(2, height - k), colour); /* no seam in SVG */
    }
    canvas_frame(canvas, 0, 0, WIDTH, height);
    for (int k = 0; k < scale->n_ticks; k++) {
        double share = (scale->ticks[k] - scale->low) / (scale->high - scale->low);
        char *text = scale_text(scale, scale->ticks[k]);
        canvas_box(canvas, WIDTH, height * (1 - share) - 0.5, 4, 1, black);
        canvas_text(canvas, WIDTH + 7, height * (1 - share) + 5, ALIGN_LEFT, text);
        free(text);
    }
}

static void draw_names(struct canvas *canvas, const struct domain *domain)
{
    for (int k = 0; k < domain->n_phases; k++) {
        canvas_box(canvas, 0, k * NAME_DISTANCE, WIDTH, WIDTH, canvas_phase_colour(k));
        canvas_text(canvas, WIDTH + 7, k * NAME_DISTANCE + 12, ALIGN_LEFT, domain->phase_names[k]);
    }
}

void legend_draw(struct canvas *canvas, const struct snapshot *snapshot, const struct field *field,
                 const double range[2], double height)
{
    if (field->phase) {
        draw_names(canvas, &snapshot->domain);
        return;
    }
    struct scale scale = scale_make(range, field->unit, (int)height / TICK_DISTANCE);
    draw_bar(canvas, height, &scale);
    scale_free(&scale);
}
