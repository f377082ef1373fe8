# Simple shear of J2 in logarithmic strain: shear and normal stress [Pa] at the end.
#
#   awk -v end=3 -v steps=300000 -v E=210e9 -v nu=0.3 -v yield=185e6 -v hardening=898e6 -f shear.awk
#
# Independent of the solver: b_e of the plane in closed form by its principal values, the radial return in principal
# logarithmic strains, as many steps as it takes (their error is of the first order: 300,000 leave less than 1e-5).

BEGIN {
    mu = E / (2 * (1 + nu))
    K = E / (3 * (1 - 2 * nu))
    g = end / steps
    bxx = byy = bzz = 1
    for (n = 1; n <= steps; n++) {
        # f b f^T with f = 1 + g e_x (x) e_y
        bxx += 2 * g * bxy + g * g * byy
        bxy += g * byy
        m = (bxx + byy) / 2
        d = (bxx - byy) / 2
        r = sqrt(d * d + bxy * bxy)
        c = r > 0 ? d / r : 1
        s = r > 0 ? bxy / r : 0
        e1 = log(m + r) / 2
        e2 = log(m - r) / 2
        e3 = log(bzz) / 2
        v = (e1 + e2 + e3) / 3
        q = 2 * mu * sqrt(1.5 * ((e1 - v) ^ 2 + (e2 - v) ^ 2 + (e3 - v) ^ 2))
        Y = yield + hardening * p
        k = 1
        if (q > Y) {
            dp = (q - Y) / (3 * mu + hardening)
            p += dp
            k = 1 - 3 * mu * dp / q
        }
        e1 = v + k * (e1 - v)
        e2 = v + k * (e2 - v)
        e3 = v + k * (e3 - v)
        m = (exp(2 * e1) + exp(2 * e2)) / 2
        r = (exp(2 * e1) - exp(2 * e2)) / 2
        bxx = m + r * c
        byy = m - r * c
        bxy = r * s
        bzz = exp(2 * e3)
        v = (e1 + e2 + e3) / 3
        t1 = 2 * mu * (e1 - v) + 3 * K * v
        t2 = 2 * mu * (e2 - v) + 3 * K * v
    }
    printf "%.9g %.9g\n", (t1 - t2) / 2 * s, (t1 + t2) / 2 + (t1 - t2) / 2 * c
}
