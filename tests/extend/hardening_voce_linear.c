
/* sigma_y = Y + Q (1 - exp(-b p)) + H p */
static const struct key voce_linear_keys[] = {
    YIELD(0), SATURATION(1, "saturation", "Q"),
    NUMBER(2, "modulus", "H", "Pa", 0, 1e13, "hardening modulus"), RATE(3, "rate", "b")};
static double voce_linear_stress(const struct hardening *h, double p)
{
    const double *a = h->parameter;
    return a[0] - a[1] * expm1(-a[3] * p) + a[2] * p;
}
static double voce_linear_slope(const struct hardening *h, double p)
{
    const double *a = h->parameter;
    return a[1] * a[3] * exp(-a[3] * p) + a[2];
}
