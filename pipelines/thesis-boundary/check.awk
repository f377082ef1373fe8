# What the four variants must show: awk -v study=thesis-boundary -v rows=4 -f pipelines/must.awk -f check.awk table.csv

FNR > 1 {
    mean[$1] = $2
    most[$1] = $3
    x[$1] = $5
    y[$1] = $6
}

END {
    # What is a mirror image of itself stays so but for rounding; per cent.
    must(y[1] < 1e-6, "1: asymmetric about y = 0 by " y[1] " %")
    must(x[3] < 1e-6 && y[3] < 1e-6, "3: asymmetric by " x[3] " and " y[3] " %")
    # 3 is the even stretch itself.
    must(off(most[3], mean[3]) < 1e-6 * mean[3] || most[3] == mean[3], "3: not even, " mean[3] " and " most[3] " %")
    # The right end of 1 stretches twice as much as the gauge, 6 % in plane strain; 5 % for the elastic part and the steps of 50 um.
    must(off(most[1], 100 * 2 / sqrt(3) * log(1.06)) < 0.05 * most[1], "1: largest plastic strain " most[1] " %")
    must(x[1] > 20 && x[2] > 20 && y[2] > 10, "1 and 2 must be asymmetric: " x[1] ", " x[2] ", " y[2] " %")
    # A held edge at one end and inertia leave a little.
    must(x[4] < 5 && y[4] < 5, "4: asymmetric by " x[4] " and " y[4] " %")
    # Equivalent plastic strain in plane strain over that in tension at equal stretch; 1 % for the elastic part.
    must(off(mean[3] / mean[4], 2 / sqrt(3)) < 0.01 * 2 / sqrt(3), "3 over 4: " mean[3] / mean[4])
    complete(mean, "mean")
    complete(most, "largest strain")
    complete(x, "asymmetry")
    complete(y, "asymmetry")
    finish()
}
