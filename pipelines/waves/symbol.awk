# Frequencies of plane waves on the lattice: what -v body says (formulation, horizon, influence) against waves of the solid.
#
# Of the equations of docs/theory.md linearised for u = d exp(i k.x), with the spacing, V and mu as units: rho w^2 d = D d. Summed
# here over the family itself; nothing is taken from hssolve.  symbol(body, kx, ky, kz) fills D[1..3, 1..3]; frequency(d) is
# (d.D d)^1/2 for a direction d that D keeps.
#   q     what the gradient of a formulation makes of k
#   A(q)  acoustic tensor of the solid, (lambda + mu) q q + mu q.q 1

function set_moduli(poisson) {
    lambda = 2 * poisson / (1 - 2 * poisson)
    bulk = lambda + 2 / 3
}

function influence_of(name, r, horizon,   x) {
    if (name == "constant") return 1
    if (name == "steep") return r ^ -8
    if (name == "inverse") return 1 / r
    if (name == "linear") return 1 - r / horizon
    if (name == "gaussian") { x = 2 * r / horizon; return exp(-x * x) }
    print "influence " name > "/dev/stderr"
    exit 1
}

# Half of the family: of each pair +xi, -xi the later one.
function set_family(horizon, influence,   reach, x, y, z, r) {
    n_bonds = 0
    reach = int(horizon)
    for (x = -reach; x <= reach; x++)
        for (y = -reach; y <= reach; y++)
            for (z = -reach; z <= reach; z++) {
                r = sqrt(x * x + y * y + z * z)
                if (r == 0 || r > horizon || x < 0 || x == 0 && y < 0 || x == 0 && y == 0 && z < 0) continue
                n_bonds++
                xi[n_bonds, 1] = x; xi[n_bonds, 2] = y; xi[n_bonds, 3] = z
                length_of[n_bonds] = r
                weight[n_bonds] = influence_of(influence, r, horizon)
            }
}

function clear(   a, b) { for (a = 1; a <= 3; a++) for (b = 1; b <= 3; b++) D[a, b] = 0 }

# D += factor A(q)
function add_acoustic(factor, q1, q2, q3,   q, a, b) {
    q[1] = q1; q[2] = q2; q[3] = q3
    for (a = 1; a <= 3; a++) {
        for (b = 1; b <= 3; b++) D[a, b] += factor * (lambda + 1) * q[a] * q[b]
        D[a, a] += factor * (q1 * q1 + q2 * q2 + q3 * q3)
    }
}

function phase_of(b) { return k[1] * xi[b, 1] + k[2] * xi[b, 2] + k[3] * xi[b, 3] }

# S = sum w xi sin(k.xi) and K_11 = sum w xi_1^2 over the family: (correspondence.1) makes q = S/K_11 of k.
function set_gradient(   b, a) {
    K11 = 0
    for (a = 1; a <= 3; a++) S[a] = 0
    for (b = 1; b <= n_bonds; b++) {
        K11 += 2 * weight[b] * xi[b, 1] * xi[b, 1]
        for (a = 1; a <= 3; a++) S[a] += 2 * weight[b] * xi[b, a] * sin(phase_of(b))
    }
    for (a = 1; a <= 3; a++) q[a] = S[a] / K11
}

# (mix.2): of a bond along axis a the gradient is that of both ends, its column along the bond is the bond's own.
function mix(share,   a, c) {
    add_acoustic(1 - share, q[1], q[2], q[3])
    for (a = 1; a <= 3; a++) {
        c = cos(k[a] / 2)
        add_acoustic(share / 3, a == 1 ? 2 * sin(k[1] / 2) : c * q[1], a == 2 ? 2 * sin(k[2] / 2) : c * q[2], a == 3 ? 2 * sin(k[3] / 2) : c * q[3])
    }
}

# (capped.1) to (capped.3), below the cap.
function capped(stiffness,   b, z, a, sum) {
    add_acoustic(1, q[1], q[2], q[3])
    for (b = 1; b <= n_bonds; b++) {
        z = 2 * sin(phase_of(b) / 2) - cos(phase_of(b) / 2) * (q[1] * xi[b, 1] + q[2] * xi[b, 2] + q[3] * xi[b, 3])
        sum += 2 * weight[b] * z * z
    }
    for (a = 1; a <= 3; a++) D[a, a] += stiffness * (lambda + 4) / K11 * sum
}

# (corner.1), (corner.2), and (flowing.2) below its limit; h: amplitude of the mode in the plane across an axis, whose part along it is in
# the shear strains of (flowing.1).
function corner(share,   a, b, s, c, h, all) {
    for (a = 1; a <= 3; a++) { s[a] = sin(k[a] / 2); c[a] = cos(k[a] / 2) }
    add_acoustic(1, 2 * s[1] * c[2] * c[3], 2 * c[1] * s[2] * c[3], 2 * c[1] * c[2] * s[3])
    h[1] = c[1] * s[2] * s[3]; h[2] = s[1] * c[2] * s[3]; h[3] = s[1] * s[2] * c[3]
    all = 8 / 3 * (h[1] ^ 2 + h[2] ^ 2 + h[3] ^ 2) + 4 / 3 * (s[1] * s[2] * s[3]) ^ 2
    for (a = 1; a <= 3; a++) for (b = 1; b <= 3; b++)
        D[a, b] += share * (a == b ? all - 8 / 9 * h[a] ^ 2 : 8 / 9 * h[a] * h[b])
}

# factor sum w over |xi|^power of the bonds' directions: what stretching does.
function add_bonds(factor, power,   b, i, j, each) {
    for (b = 1; b <= n_bonds; b++) {
        each = factor * 2 * weight[b] * (1 - cos(phase_of(b))) / length_of[b] ^ (2 + power)
        for (i = 1; i <= 3; i++) for (j = 1; j <= 3; j++) D[i, j] += each * xi[b, i] * xi[b, j]
    }
}

# (bond_based.2), c = 18 K/M, M the integral of w r over the ball.
function bond_based(influence,   M, n, r, i) {
    n = 2000
    for (i = 0; i < n; i++) {
        r = (i + 0.5) / n * horizon
        M += 4 * pi * r ^ 3 * influence_of(influence, r, horizon) * horizon / n
    }
    add_bonds(18 * bulk / M, 1)
}

# The linear solid: bulk modulus by the dilatation, 15 mu/m by the bonds' extensions.
function ordinary(   m, b, i, j) {
    for (b = 1; b <= n_bonds; b++) m += 2 * weight[b] * length_of[b] ^ 2
    for (i = 1; i <= 3; i++) for (j = 1; j <= 3; j++) D[i, j] += 3 * (3 * bulk - 5) / (m * m) * S[i] * S[j]
    add_bonds(30 / m, 0)
}

function symbol(body, kx, ky, kz,   word, family) {
    split(body, word, " ")
    k[1] = kx; k[2] = ky; k[3] = kz
    clear()
    set_moduli(word[1] == "bond-based" ? 0.25 : 0.31)
    if (word[1] == "corner") { corner(1); return }
    horizon = word[2]
    family = word[2] " " word[3]
    if (family != family_at_hand) set_family(horizon, word[3])
    family_at_hand = family
    set_gradient()
    if (word[1] == "mix") mix(0.1)
    if (word[1] == "capped") capped(0.3)
    if (word[1] == "bond-based") bond_based(word[3])
    if (word[1] == "ordinary") ordinary()
}

function frequency(d1, d2, d3,   d, i, j, sum) {
    d[1] = d1; d[2] = d2; d[3] = d3
    for (i = 1; i <= 3; i++) for (j = 1; j <= 3; j++) sum += d[i] * D[i, j] * d[j]
    return sqrt(sum / (d1 * d1 + d2 * d2 + d3 * d3))
}

BEGIN { pi = atan2(0, -1) }
