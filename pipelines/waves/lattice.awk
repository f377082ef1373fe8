# Of each run of lattice.yaml the speed of its wave over that of the solid, as it was run and by the exact symbol:
#   awk -v folder=FOLDER -f csv.awk -f symbol.awk -f lattice.awk FOLDER/study.csv
#
# At steps of the same length the scheme makes u(n+1) - 2 u(n) + u(n-1) = -w^2 dt^2 u(n) exactly of a motion of one frequency w of the
# body: w is found by least squares, and `rest` is what does not obey, over the root mean square of w^2 u.

# w^2, and the rest.
function fit(n, motion, name,   i, dt, step, u, a, uu, ua, aa) {
    dt = motion[n, "time_s"] / n
    for (i = 1; i < n; i++) {
        step = motion[i + 1, "time_s"] - motion[i, "time_s"]
        if (step > 1.0001 * dt || step < 0.9999 * dt) stop("steps of several lengths")
        u = motion[i, name]
        a = (2 * u - motion[i + 1, name] - motion[i - 1, name]) / (dt * dt)
        uu += u * u; ua += u * a; aa += a * a
    }
    rest = aa > 0 ? sqrt(1 - ua * ua / (uu * aa) > 0 ? 1 - ua * ua / (uu * aa) : 0) : 1
    return ua / uu
}

BEGIN { print "formulation,horizon,influence,direction,kind,spacings_along_x,speed,exact,difference,rest" }

FNR > 1 {
    run = read_run()
    split(is["wave"], wave, " ")
    split(is["body"], body, " ")
    shears = wave[2] == "S"
    diagonal = wave[1] == "110"
    last = read_columns(folder "/" run "/columns.csv", "time_s u v", motion)
    number = 2 * pi / wave[3]
    symbol(is["body"], number, diagonal ? number : 0, 0)
    exact = shears ? frequency(0, 1, 0) : frequency(1, diagonal, 0)
    solid = number * (shears ? 1 : sqrt((lambda + 2) * (1 + diagonal)))
    shear = 210e9 / 2 / (1 + lambda / 2 / (lambda + 1)) # lambda/mu = 2 nu/(1 - 2 nu)
    measured = sqrt(fit(last, motion, shears ? "v" : "u") * 8900 * 25e-6 ^ 2 / shear)
    printf "%s,%s,%s,%s,%s,%s,%.5f,%.5f,%.1e,%.1e\n", body[1], body[2], body[3], wave[1], wave[2], wave[3], measured / solid, exact / solid, measured / exact - 1, rest
}
