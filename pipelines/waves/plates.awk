# Of each plate the pulses and what its grip's 10 m/s leave behind the front, beside what its own curve at rest asks for:
#   awk -v folder=FOLDER -v pulses=PULSES.csv -v fronts=FRONTS.csv -v profiles=PROFILES.csv -f csv.awk -f plates.awk FOLDER/study.csv
#
# The strip of von Karman and Taylor: with c(e)^2 = (dS/de)/rho, S and e nominal, strain e stands at x = c(e) t, and the grip's velocity is
# the integral of c de up to the strain behind the front.  At the standing end the velocity that an elastic front brings turns
# into the strain at which the integral from its own strain on is as large: its stress is the most that end feels of the first pass.

BEGIN {
    rho = 8900; elastic = sqrt(210e9 / rho)
    area = 0.4e-3 * 0.2e-3
    free = 4.9e-3; push = 300e-9; ramp = 50e-9; grip = 10
    print "structure,m_per_s,front_m_per_s,peak_MPa,elastic_MPa,peak_percent,second_peak_MPa,plastic_percent" > pulses
    print "structure,plateau_percent,static_plateau_percent,front_um,static_front_um,wall_MPa,static_wall_MPa" > fronts
    print "structure,from,mm,strain_percent" > profiles
}

# S(e) at rest: strain[0..n], stress[0..n]; records nearer than 1e-4 to the last one would give slopes of their rounding.
function read_static(run,   last, i, e, n) {
    last = read_columns(folder "/" run "/columns.csv", "extension_m force_right_N force_left_N", row)
    n = strain[0] = stress[0] = 0
    for (i = 1; i <= last; i++) {
        e = row[i, "extension_m"] / 2.5e-3
        if (e < strain[n] + 1e-4) continue
        strain[++n] = e
        stress[n] = (row[i, "force_right_N"] - row[i, "force_left_N"]) / 2 / area
    }
    return n
}

function speed(i) { return sqrt((stress[i + 1] - stress[i]) / (strain[i + 1] - strain[i]) / rho) }

# The strain at which the integral of c de from record `from` on is v; `at` is its record.
function strain_of(v, from,   i, more) {
    for (i = from; i < n_static; i++) {
        more = speed(i) * (strain[i + 1] - strain[i])
        if (v < more) break
        v -= more
    }
    if (i == n_static) return "" # the curve at rest ends before
    at = i
    return strain[i] + v / speed(i)
}

function stress_of(e) { return stress[at] + (e - strain[at]) / (strain[at + 1] - strain[at]) * (stress[at + 1] - stress[at]) }

function front_of_pulse(name, v,   last, i, level, cross, most, again, work, plastic, f) {
    last = read_columns(folder "/" run_of[name, "pulse " v] "/columns.csv", "time_s force_right_N plastic_energy_J external_work_J", row)
    level = 40e6 * area # of what arrives, below every yield
    most = again = cross = 0
    for (i = 1; i <= last; i++) {
        f = row[i, "force_right_N"]
        if (!cross && f >= level)
            cross = row[i, "time_s"] - (f - level) / (f - row[i - 1, "force_right_N"]) * (row[i, "time_s"] - row[i - 1, "time_s"])
        if (row[i, "time_s"] < push / 2 + 2 * free / elastic) { if (f > most) most = f }
        else if (f > again) again = f
    }
    if (v == 20) wall_of[name] = 1e-6 * most / area
    # When an elastic front of this shape, twice as strong at the standing end, comes to the level: sin^2(pi t/push).
    f = sqrt(level / (2 * rho * elastic * area * v))
    left = push / pi * atan2(f, sqrt(1 - f * f))
    printf "%s,%s,%.0f,%.1f,%.1f,%.1f,%.1f,%.1f\n", name, v, free / (cross - left), 1e-6 * most / area, 2e-6 * rho * elastic * v,
        100 * most / area / (2 * rho * elastic * v), 1e-6 * again / area, 100 * row[last, "plastic_energy_J"] / row[last, "external_work_J"] > pulses
}

# Strain between layers of particles i and i + 1, from 1 at the left, by their mean displacements.
function read_profile(file,   line, field, layer, n, i) {
    split("", sum)
    split("", n)
    while ((getline line < file) > 0) {
        if (line !~ /^[-0-9]/) continue
        split(line, field, ",")
        layer = int((field[1] + 2.5e-3) / 25e-6) + 1
        sum[layer] += field[4]
        n[layer]++
    }
    close(file)
    for (i = 1; i <= 200; i++) if (!n[i]) stop(file ": nothing in layer " i)
    for (i = 1; i < 200; i++) profile[i] = (sum[i + 1] / n[i + 1] - sum[i] / n[i]) / 25e-6
}

function behind_the_front(name,   last, i, k, time, plateau, front, expected, passed, yielding, wall, e) {
    last = read_columns(folder "/" run_of[name, "step 10"] "/columns.csv", "time_s", row)
    time = row[last, "time_s"] - ramp / 2
    read_profile(folder "/" run_of[name, "step 10"] "/profile.csv")
    for (i = 11; i <= 20; i++) plateau += profile[i] / 10
    for (i = 15; profile[i] > plateau / 2 || profile[i + 1] > plateau / 2; i++);
    front = i - 3 + (profile[i - 1] - plateau / 2) / (profile[i - 1] - profile[i]) # spacings from the grip's edge, two from the end
    n_static = read_static(run_of[name, "static"])
    expected = strain_of(grip, 0)
    for (i = 4; i < 200; i++) printf "%s,explicit,%.4f,%.4f\n", name, 25e-3 * (i - 2), 100 * profile[i] > profiles
    printf "%s,static,0,%.4f\n%s,static,%.4f,%.4f\n", name, 100 * expected, name, 1e3 * speed(at) * time, 100 * expected > profiles
    for (i = at; i >= 0; i--) printf "%s,static,%.4f,%.4f\n", name, 1e3 * speed(i) * time, 100 * strain[i] > profiles
    e = expected / 2
    for (k = 0; k < n_static && strain[k + 1] < e; k++);
    for (yielding = 0; yielding < n_static && speed(yielding) > elastic / 2; yielding++);
    wall = strain_of(stress[yielding] / rho / elastic, yielding)
    passed = speed(k) * time > free # and come back
    # Half the width of a front, 0.2 mm, before what came back from the other end, which makes another bar of the rest.
    if (!passed && speed(k) * time + 0.2e-3 > 2 * free - elastic * (time + ramp / 2)) stop(name ": its front has been met")
    printf "%s,%.3f,%.3f,%s,%s\n", name, 100 * plateau, 100 * expected, passed ? "," : sprintf("%.0f,%.0f", 25 * front, 1e6 * speed(k) * time),
        wall == "" ? "," : sprintf("%.1f,%.1f", wall_of[name], 1e-6 * stress_of(wall)) > fronts
}

BEGIN { pi = atan2(0, -1) }

FNR > 1 {
    run = read_run()
    run_of[is["structure"], is["case"]] = run
    if (is["case"] == "static") structure[++n_structures] = is["structure"]
}

END {
    for (s = 1; s <= n_structures; s++) {
        for (v = 1; v <= 50; v++) if ((structure[s], "pulse " v) in run_of) front_of_pulse(structure[s], v)
        behind_the_front(structure[s])
    }
}
