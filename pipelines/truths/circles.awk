# Displacements and stresses around a circle in plane strain, exact, against those of particles.
#
#   awk -F, -v shape=hole|inclusion|cylinder -v radius=R -v E=... -v nu=... -v contrast=... -v stress=S -f circles.awk nodes.csv
#   awk -v ... -v expressions=yes -f circles.awk      the displacements as two expressions of the deck, a line each
#
# Lengths in m; 1e-30 keeps the expressions finite at the centre, where no body is.  hole, inclusion: in an infinite plane under S along x, the inclusion stiffer by the contrast, Poisson's ratio
# one; Muskhelishvili's potentials phi = p z/2 + A R^2/z, psi = B R^2/z - q z + A R^4/z^3 outside, p = q = S/2, with A, B from
# the continuity of displacements and tractions on |z| = R (of a hole this is Kirsch's solution, of an inclusion Eshelby's:
# its strain is uniform).  cylinder: Lame's, S the pressure within R, the outer surface at 2 R free.
#
# Out: what of the displacements' disturbance is wrong (root of the mean square over R < r < 2 R), the same of the stresses
# over S, of the greatest stress (hole: the particles at its top; inclusion: the mean within) or the hoop stress of the outer
# layer (cylinder); in per cent.

BEGIN {
    mu = E / (2 * (1 + nu))
    kappa = 3 - 4 * nu
    R = radius
    p = q = stress / 2
    m = shape == "inclusion" ? 1 / contrast : 1e12
    A = q * (1 - 1 / m) / (kappa / m + 1) # m = mu_1/mu_2: q (mu_1 - mu_2)/(kappa mu_2 + mu_1)
    B = p * ((kappa - 1) - m * (kappa - 1)) / (2 + m * (kappa - 1))
    if (expressions) {
        if (shape == "cylinder") {
            c = stress * (1 + nu) / (3 * E)
            f = sprintf("%.12g*(%.12g+%.12g/(x*x+y*y+1e-30))", c, 1 - 2 * nu, 4 * R * R)
            print "t*x*" f
            print "t*y*" f
            exit
        }
        # 2 mu u = (kappa - 1) p z/2 - B R^2/conj z + (kappa A R^2/r + q r) exp(-i t) + (A R^2/r - A R^4/r^3) exp(3 i t)
        r2 = "(x*x+y*y+1e-30)"
        radial = sprintf("(%.12g-%.12g/%s)", (kappa - 1) * p / 2, B * R * R, r2)
        single = sprintf("(%.12g/%s+%.12g)", kappa * A * R * R, r2, q)
        triple = sprintf("(%.12g/%s^2*(1-%.12g/%s))", A * R * R, r2, R * R, r2)
        printf "t*%.12g*x*(%s+%s+%s*(x*x-3*y*y))\n", 0.5 / mu, radial, single, triple
        printf "t*%.12g*y*(%s-%s+%s*(3*x*x-y*y))\n", 0.5 / mu, radial, single, triple
        exit
    }
}

# u[1], u[2]; s["xx"], s["yy"], s["xy"]
function exact(x, y,    r, t, c, w, v) {
    r = sqrt(x * x + y * y)
    t = atan2(y, x)
    if (shape == "cylinder") {
        c = stress / 3
        w = c * (1 + nu) / E * ((1 - 2 * nu) * r + 4 * R * R / r)
        u[1] = w * cos(t); u[2] = w * sin(t)
        v = 4 * R * R * c / (r * r)
        s["xx"] = c - v * cos(2 * t); s["yy"] = c + v * cos(2 * t); s["xy"] = -v * sin(2 * t)
        return
    }
    if (shape == "inclusion" && r < R) {
        s["xx"] = p + B + q - A; s["yy"] = p + B - q + A; s["xy"] = 0
        return
    }
    w = (kappa - 1) * p / 2 * r - B * R * R / r
    v = kappa * A * R * R / r + q * r
    c = A * R * R / r - A * R ^ 4 / r ^ 3
    u[1] = ((w + v) * cos(t) + c * cos(3 * t)) / (2 * mu)
    u[2] = ((w - v) * sin(t) + c * sin(3 * t)) / (2 * mu)
    # sum and difference of the normal stresses, twice the shear
    w = 2 * p - 4 * A * R * R / (r * r) * cos(2 * t)
    v = 2 * ((2 * A * R * R / r ^ 2 - 3 * A * R ^ 4 / r ^ 4) * cos(4 * t) - q - B * R * R / (r * r) * cos(2 * t))
    s["xx"] = (w - v) / 2; s["yy"] = (w + v) / 2
    s["xy"] = -(2 * A * R * R / r ^ 2 - 3 * A * R ^ 4 / r ^ 4) * sin(4 * t) + B * R * R / (r * r) * sin(2 * t)
}

# Without the hole or inclusion.
function undisturbed(x, y) {
    n[1] = shape == "cylinder" ? 0 : ((kappa - 1) * p / 2 + q) * x / (2 * mu)
    n[2] = shape == "cylinder" ? 0 : ((kappa - 1) * p / 2 - q) * y / (2 * mu)
}

/^x_m/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
/^#/ { next }
{
    r = sqrt($1 * $1 + $2 * $2)
    exact($1, $2)
    has = "StressXX" in column
    if (shape == "inclusion" && r < R) {
        peak += $column["StressXX"] / s["xx"]
        peaks++
        next
    }
    inside = shape == "cylinder" ? R + held : R
    if (r < inside || r > 2 * R) next
    undisturbed($1, $2)
    for (a = 1; a <= 2; a++) {
        wrong += ($(3 + a) - u[a]) ^ 2
        whole += (u[a] - n[a]) ^ 2
    }
    if (!has) next
    places++
    off += ($column["StressXX"] - s["xx"]) ^ 2 + ($column["StressYY"] - s["yy"]) ^ 2 + 2 * ($column["StressXY"] - s["xy"]) ^ 2
    if (shape == "hole" && $1 * $1 < spacing * spacing && r < R + 0.99 * spacing) {
        peak += $column["StressXX"] / s["xx"]
        peaks++
    }
    if (shape == "cylinder" && r > 2 * R - spacing) {
        peak += ($column["StressXX"] + $column["StressYY"]) / (s["xx"] + s["yy"])
        peaks++
    }
}

END {
    if (expressions) exit
    printf "%.4g ", 100 * sqrt(wrong / whole)
    if (places && off > 0) printf "%.4g %.4g\n", 100 * sqrt(off / places) / stress, 100 * (peak / peaks - 1)
    else print "none none"
}
