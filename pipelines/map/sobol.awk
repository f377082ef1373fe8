# Sobol's indices by a surrogate: awk -v factors=7 -v degree=3 -v names=arrangement -f sobol.awk MAP
#
# MAP: a header, rows of a run's name, so many factors, and what came out of it.  The surrogate is a polynomial of this total degree,
# by least squares, in polynomials of each factor that are orthonormal over its own values; of the factor that is a name, no number,
# they are all of degree 1.  The indices are sums of its squared coefficients (Sudret, Reliab. Eng. Syst. Saf. 93 (2008) 964):
# first, of a factor alone, and total, of all terms with it.  error: share of the variance that the surrogate does not
# predict at points left out, one by one, by the leverages (Blatman, Sudret, J. Comput. Phys. 230 (2011) 2345).

function orthonormal(j, most,   i, k, m, sum, norm) {
    for (i = 1; i <= runs; i++) P[j, 0, i] = 1
    for (k = 1; k <= most; k++) {
        for (i = 1; i <= runs; i++) P[j, k, i] = P[j, k - 1, i] * x[j, i]
        for (m = 0; m < k; m++) {
            sum = 0
            for (i = 1; i <= runs; i++) sum += P[j, k, i] * P[j, m, i]
            for (i = 1; i <= runs; i++) P[j, k, i] -= sum / runs * P[j, m, i]
        }
        norm = 0
        for (i = 1; i <= runs; i++) norm += P[j, k, i] ^ 2
        if (norm < 1e-8 * runs) return k - 1 # it has no more values
        for (i = 1; i <= runs; i++) P[j, k, i] /= sqrt(norm / runs)
    }
    return most
}

# All products of factors from j on with what is left of the degree.
function terms_from(j, left,   k, m) {
    if (j > factors) {
        terms++
        for (m = 1; m <= factors; m++) power[terms, m] = now[m]
        return
    }
    for (k = 0; k <= largest[j] && (k == 0 || (j == nominal ? 1 : k) <= left); k++) {
        now[j] = k
        terms_from(j + 1, left - (k == 0 ? 0 : j == nominal ? 1 : k))
    }
}

# A = L L^T, in place below the diagonal.
function factorise(   a, b, k, s) {
    for (a = 1; a <= terms; a++)
        for (b = 1; b <= a; b++) {
            s = A[a, b]
            for (k = 1; k < b; k++) s -= A[a, k] * A[b, k]
            if (a == b && s <= 0) { print "sobol.awk: " terms " terms are too many for " runs " runs" > "/dev/stderr"; failed = 1; exit 1 }
            A[a, b] = a == b ? sqrt(s) : s / A[b, b]
        }
}
# v becomes L^-1 v, then where back L^-T of it.
function solve(v, back,   a, k) {
    for (a = 1; a <= terms; a++) { for (k = 1; k < a; k++) v[a] -= A[a, k] * v[k]; v[a] /= A[a, a] }
    for (a = terms; back && a >= 1; a--) { for (k = a + 1; k <= terms; k++) v[a] -= A[k, a] * v[k]; v[a] /= A[a, a] }
}

function fit(column,   i, a, j, mean, spread, left, value, all, v, alone, only) {
    for (i = 1; i <= runs; i++) mean += y[column, i] / runs
    for (a = 1; a <= terms; a++) { v[a] = 0; for (i = 1; i <= runs; i++) v[a] += phi[i, a] * y[column, i] }
    solve(v, 1)
    for (i = 1; i <= runs; i++) {
        value = 0
        for (a = 1; a <= terms; a++) value += v[a] * phi[i, a]
        left += ((y[column, i] - value) / (1 - leverage[i])) ^ 2
        spread += (y[column, i] - mean) ^ 2
    }
    for (a = 1; a <= terms; a++) {
        only = 0
        for (j = 1; j <= factors; j++) if (power[a, j]) only = only ? -1 : j
        if (only) all += v[a] ^ 2
        if (only > 0) first[only] += v[a] ^ 2
        for (j = 1; j <= factors; j++) if (power[a, j]) total[j] += v[a] ^ 2
    }
    for (j = 1; j <= factors; j++) {
        printf "%s,%s,%.4f,%.4f\n", head[1 + factors + column], head[1 + j], first[j] / all, total[j] / all
        delete first[j]; delete total[j]
    }
    printf "%s,deviation,%.5g,\n%s,error,%.4f,\n", head[1 + factors + column], sqrt(spread / runs), head[1 + factors + column], left / spread
}

BEGIN { FS = ","; if (!degree) degree = 3 }
NR == 1 { columns = NF - 1 - factors; for (i = 1; i <= NF; i++) { head[i] = $i; if ($i == names) nominal = i - 1 }; next }
{
    runs++
    for (j = 1; j <= factors; j++) { x[j, runs] = $(1 + j); if (runs == 1 || $(1 + j) + 0 < low[j]) low[j] = $(1 + j) + 0
        if (runs == 1 || $(1 + j) + 0 > high[j]) high[j] = $(1 + j) + 0 }
    for (c = 1; c <= columns; c++) y[c, runs] = $(1 + factors + c)
}
END {
    if (failed) exit 1
    for (j = 1; j <= factors; j++) {
        for (i = 1; i <= runs; i++) x[j, i] = (2 * x[j, i] - low[j] - high[j]) / (high[j] - low[j])
        largest[j] = orthonormal(j, degree)
    }
    terms_from(1, degree)
    for (i = 1; i <= runs; i++)
        for (a = 1; a <= terms; a++) { phi[i, a] = 1; for (j = 1; j <= factors; j++) phi[i, a] *= P[j, power[a, j], i] }
    for (a = 1; a <= terms; a++) for (b = 1; b <= a; b++) { s = 0; for (i = 1; i <= runs; i++) s += phi[i, a] * phi[i, b]; A[a, b] = s }
    factorise()
    for (i = 1; i <= runs; i++) {
        for (a = 1; a <= terms; a++) v[a] = phi[i, a]
        solve(v, 0)
        for (a = 1; a <= terms; a++) leverage[i] += v[a] ^ 2
    }
    print "of,factor,first,total"
    for (c = 1; c <= columns; c++) fit(c)
}
