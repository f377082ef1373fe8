# The programme of a looped test as what CalculiX takes:
#   awk -v to="0.01 0.02 0.03 0.04" -v down="0.002 0.003 0.004" -f programme.awk
# Strain between the grips to each of the first numbers, and back by the second ones in between.
BEGIN {
    n = split(to, up, " "); split(down, back, " ")
    for (i = 1; i <= n; i++) {
        x[++k] = up[i]
        if (i < n) x[++k] = up[i] - back[i]
    }
    print "*AMPLITUDE, NAME=PROGRAMME, TIME=TOTAL TIME"
    for (i = 0; i <= k; i++) printf "%d,%.9g\n", i, x[i] / up[n]
}
