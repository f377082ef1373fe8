# The programme of a looped test as what hssolve takes, or CalculiX:
#   awk -v to="0.01 0.02 0.03 0.04" -v down="0.002 0.003 0.004" [-v calculix=1] -f programme.awk
# Strain between the grips (0.7 mm apart) to each of the first numbers, and back by the second ones in between.
BEGIN {
    length_m = 0.7e-3
    n = split(to, up, " "); split(down, back, " ")
    for (i = 1; i <= n; i++) {
        x[++k] = up[i]
        if (i < n) x[++k] = up[i] - back[i]
    }
    if (calculix) {
        print "*AMPLITUDE, NAME=PROGRAMME, TIME=TOTAL TIME"
        for (i = 0; i <= k; i++) printf "%d,%.9g\n", i, x[i] / up[n]
        exit
    }
    print "boundary:"
    for (side = -1; side <= 1; side += 2) {
        printf "  - {set: grip_%s, direction: x, displacement: [[0, 0]", side < 0 ? "left" : "right"
        for (i = 1; i <= k; i++) printf ", [%d, %.9g]", i, side * length_m / 2 * x[i]
        print "]}"
    }
    printf "solver: {type: quasi_static, %sstep: 0.02 s, end_time: %d s}\n", formulation == "corner" ? "" : "horizon: 1, stabilisation: {law: mix, share: 0.1}, ", k
}
