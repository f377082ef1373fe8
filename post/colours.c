#include "colours.h"

#include <math.h>
#include <string.h>

/* Lightness 15 + 75 share; a* and b* turn from violet through blue and green to yellow. */
static const double controls[][3] = {
    {0.192, 0.076, 0.362}, {0.218, 0.178, 0.491}, {0.189, 0.301, 0.561},
    {0.180, 0.420, 0.579}, {0.231, 0.535, 0.556}, {0.301, 0.650, 0.498},
    {0.447, 0.756, 0.401}, {0.690, 0.839, 0.295}, {0.992, 0.892, 0.217},
};
enum { LAST = sizeof controls / sizeof *controls - 1 };

static const double unknown[3] = {0.6, 0.6, 0.6};

void colour_of(double share, double colour[3])
{
    if (isnan(share)) {
        memcpy(colour, unknown, sizeof unknown);
        return;
    }
    double place = fmin(fmax(share, 0), 1) * LAST;
    int lower = place < LAST ? (int)place : LAST - 1;
    double part = place - lower;
    for (int k = 0; k < 3; k++)
        colour[k] = (1 - part) * controls[lower][k] + part * controls[lower + 1][k];
}
