# What the plate must show: awk -v study=load-steps -v rows=22 -f pipelines/must.awk -f check.awk held.csv loads.csv
# loads.csv: deck, frame, load on the right half in N, most damage, damage of the left and of the right half.

# E and nu of the material (a, b, d) on the lattice without edges: the energy a theta^2 + b sum delta e^2/|xi| V,
# theta = d delta sum e/|xi| V, of a uniform strain.
function lattice(   x, y, r, C11, C12, t, K, mu, a, b, d, horizon) {
    K = 140
    mu = 80
    horizon = 3.1
    a = (K - 2 * mu) / 2
    b = 6 * mu / (atan2(0, -1) * horizon ^ 4)
    d = 2 / (atan2(0, -1) * horizon ^ 3)
    for (x = -3; x <= 3; x++)
        for (y = -3; y <= 3; y++) {
            r = sqrt(x * x + y * y)
            if (r == 0 || r > horizon) continue
            t += d * horizon * x * x / r ^ 2
            C11 += 2 * b * horizon * x ^ 4 / r ^ 3
            C12 += 2 * b * horizon * x * x * y * y / r ^ 3
        }
    C11 += 2 * a * t * t
    C12 += 2 * a * t * t
    lattice_strain = 100 * (203.636363636364 / (C11 - C12 * C12 / C11) - 1)
    lattice_nu = C12 / C11
}

FNR == 1 {
    file++
    next
}
file == 1 {
    strain[$1, $2] = $6
    nu[$1, $2] = $4
}
file == 2 {
    load[$1, $2] = $3
    damage[$1, $2] = $4
    must(off($5, $6) <= 1e-9 * ($5 + 1e-9), $1 ": damage is not symmetric in frame " $2 ": " $5 " and " $6)
}

END {
    # Edges soften by a share horizon/width and are gone in the extrapolation to spacing 0; what a lattice leaves
    # of an integral remains.  Half a per cent is for the ends, one width apart: the strain is not uniform yet.
    lattice()
    limit = 2 * strain["madenci_oterkus", "1mm"] - strain["madenci_oterkus", "2mm"]
    must(off(limit, lattice_strain) < 0.6, "strain at spacing 0 off by " limit " %, on the lattice " lattice_strain " %")
    must(off(nu["madenci_oterkus", "1mm"], lattice_nu) < 0.006, "Poisson's ratio " nu["madenci_oterkus", "1mm"] ", on the lattice " lattice_nu)
    # `ordinary` has its family's own sums: only the edges are left, less than horizon/width at 2 mm/8.
    must(off(strain["ordinary", "2mm"], 0) < 1.6 && off(strain["ordinary", "1mm"], 0) < 1, "ordinary: strain off by " strain["ordinary", "2mm"] " and " strain["ordinary", "1mm"] " %")
    for (frame = 2; frame <= 7; frame++) {
        must(off(load["study", frame], 150 * (frame - 1)) < 1e-6, "load in frame " frame ": " load["study", frame] " N")
        # 6 MPa doubled by waves are a strain of 6e-5, against a critical stretch of 87e-5.
        must(damage["study", frame] == 0, "damage at " (frame - 1) " MPa")
    }
    must(damage["strong", 7] > 0.9, "30 MPa a step must break it")
    lattice()
    printf "lattice: strain %+.2f %%, Poisson's ratio %.4f; extrapolated %+.2f %%\n", lattice_strain, lattice_nu, limit
    complete(strain, "strain")
    complete(nu, "Poisson's ratio")
    complete(load, "load")
    complete(damage, "damage")
    finish()
}
