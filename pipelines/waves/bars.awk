# Of each run of bars.yaml the speed of its pulse, and the force that it leaves on the standing end:
#   awk -v folder=FOLDER -f csv.awk -f bars.awk FOLDER/study.csv
#
# Whatever the lattice and the sides of a bar do to short waves, the centre of the force's impulse moves with the long ones: their group
# speed is the slope at k = 0.  It arrives L/c after the middle of the push, and again 2 L/c later.  What one end gives, rho c A u of a
# displacement u, a standing end takes twice.

BEGIN {
    rho = 8900; E = 210e9; nu = 0.31; push = 300e-9; moved = 150e-9
    solid["bar"] = sqrt(E / rho)
    solid["plate"] = sqrt(E / (1 - nu * nu) / rho)
    solid["plane"] = sqrt(E * (1 - nu) / (1 + nu) / (1 - 2 * nu) / rho)
    section["bar"] = 0.2e-3 ^ 2; section["plate"] = 0.2e-3 * 0.1e-3; section["plane"] = 0.1e-3 ^ 2
    print "geometry,formulation,first_m_per_s,back_and_forth_m_per_s,solid_m_per_s,difference_percent,impulse_percent,reflected_percent"
}

FNR > 1 {
    run = read_run()
    split(is["body"], body, " ")
    c = solid[body[1]]
    match(is["domain"], /grips: {length: [0-9]/)
    held = substr(is["domain"], RSTART + RLENGTH - 1, 1)
    free = (200 - 2 * held + (body[2] == "corner" ? 0 : 1)) * 25e-6 # from the last held nodes on
    last = read_columns(folder "/" run "/columns.csv", "time_s force_right_N", motion)
    split("", impulse)
    split("", moment)
    for (i = 1; i <= last; i++) {
        pass = int((motion[i, "time_s"] - push / 2) / (2 * free / c)) + 1 # of the pulse: between, it is at the other end
        impulse[pass] += motion[i, "force_right_N"] * (motion[i, "time_s"] - motion[i - 1, "time_s"])
        moment[pass] += motion[i, "force_right_N"] * motion[i, "time_s"] * (motion[i, "time_s"] - motion[i - 1, "time_s"])
    }
    first = moment[1] / impulse[1]
    again = moment[2] / impulse[2]
    speed = 2 * free / (again - first)
    printf "%s,%s,%.0f,%.0f,%.0f,%.2f,%.2f,%.2f\n", body[1], body[2], free / (first - push / 2), speed, c, 100 * (speed / c - 1),
        100 * impulse[1] / (2 * rho * c * section[body[1]] * moved), 100 * impulse[2] / impulse[1]
}
