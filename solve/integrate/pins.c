#include "pins.h"

#include "memory.h"

#include <math.h>
#include <stdlib.h>

struct pins pins_new(const int64_t *candidates, int64_t count)
{
    struct pins pins = {.count = count < MOST_PINS ? (int)count : MOST_PINS};
    const size_t n = (size_t)pins.count;
    pins.node = memory_new(n, sizeof *pins.node);
    pins.factor = memory_new(n * n, sizeof *pins.factor);
    pins.force = memory_new(n, sizeof *pins.force);
    for (int i = 0; i < pins.count; i++) pins.node[i] = candidates[i * count / pins.count];
    return pins;
}

void pins_free(struct pins *pins)
{
    free(pins->node);
    free(pins->factor);
    free(pins->force);
    *pins = (struct pins){0};
}

void pins_factorise(struct pins *pins)
{
    /* M^-1 is known in single precision, and nodes of scattered bodies may share a site. */
    static const double slack = 1e-5;
    const int n = pins->count;
    double *L = pins->factor, largest = 0;
    for (int i = 0; i < n; i++) largest = fmax(largest, L[i * n + i]);
    for (int i = 0; i < n; i++) {
        L[i * n + i] += slack * largest;
        for (int j = 0; j <= i; j++) {
            double sum = L[i * n + j];
            for (int k = 0; k < j; k++) sum -= L[i * n + k] * L[j * n + k];
            L[i * n + j] = i == j ? sqrt(fmax(sum, slack * largest)) : sum / L[j * n + j];
        }
    }
}

void pins_solve(struct pins *pins)
{
    const int n = pins->count;
    const double *L = pins->factor;
    double *x = pins->force;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) x[i] -= L[i * n + k] * x[k];
        x[i] /= L[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) x[i] -= L[k * n + i] * x[k];
        x[i] /= L[i * n + i];
    }
}
