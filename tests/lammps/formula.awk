# awk -v style=pmb|lps -v horizon=d -v spacing=h -v bulk=K [-v shear=G] -f formula.awk PARTICLES
# What LAMMPS' peri/pmb and peri/lps compute, written anew from these formulas; input and output
# as of "forces".
#
# X: reference, x: current position; xi = X_j - X_i, e = |x_j - x_i| - |xi|, n = (x_j - x_i)/|x_j - x_i|.
# Bonds: |xi| <= d, none beyond.  Partial volume (the same in all sums):
#   nu(|xi|) = (d + h/2 - |xi|)/h where |xi| >= d - h/2, else 1; that is 1/2 at the horizon
# pmb:  f_i = sum_j c e/|xi| nu V_j n,   c = 18 K/(pi d^4)                        (given to the pair style)
# lps:  omega = 1/|xi|
#       m_i = sum_j omega |xi|^2 nu V_j              weighted volume, with the same partial volumes
#       theta_i = 3/m_i sum_j omega |xi| e nu V_j
#       t_ij = omega/m_i ((3 K - 5 G) theta_i |xi| + 15 G e)
#       f_i = sum_j (t_ij + t_ji) nu V_j n
# The strength of contact is zero while |x_j - x_i| >= min(0.9 |xi|, 1.35 h) for all pairs.

function distance(a, i, j) {
    return sqrt((a[j, 1] - a[i, 1]) ^ 2 + (a[j, 2] - a[i, 2]) ^ 2 + (a[j, 3] - a[i, 3]) ^ 2)
}

{
    n++
    for (a = 1; a <= 3; a++) {
        X[n, a] = $a
        x[n, a] = $a + $(a + 4)
    }
    V[n] = $4
}

END {
    lps = style == "lps"
    c = 18 * bulk / (atan2(0, -1) * horizon ^ 4)
    for (i = 1; i <= n; i++) {
        m = sum = 0
        for (j = 1; j <= n; j++) {
            if (j == i || (xi = distance(X, i, j)) > horizon) continue
            nu = xi >= horizon - spacing / 2 ? (horizon + spacing / 2 - xi) / spacing : 1
            m += xi * nu * V[j]
            sum += (distance(x, i, j) - xi) * nu * V[j]
        }
        M[i] = m
        theta[i] = lps ? 3 / m * sum : 0
    }
    for (i = 1; i <= n; i++) {
        f[1] = f[2] = f[3] = 0
        for (j = 1; j <= n; j++) {
            if (j == i || (xi = distance(X, i, j)) > horizon) continue
            nu = xi >= horizon - spacing / 2 ? (horizon + spacing / 2 - xi) / spacing : 1
            r = distance(x, i, j)
            if (lps)
                t = (3 * bulk - 5 * shear) * (theta[i] / M[i] + theta[j] / M[j]) \
                    + 15 * shear * (r / xi - 1) * (1 / M[i] + 1 / M[j])
            else
                t = c * (r / xi - 1)
            for (a = 1; a <= 3; a++) f[a] += t * nu * V[j] * (x[j, a] - x[i, a]) / r
        }
        printf "%.17g %.17g %.17g %.17g\n", f[1], f[2], f[3], theta[i]
    }
}
