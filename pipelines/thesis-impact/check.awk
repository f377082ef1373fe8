# What the impacts must show: awk -v study=thesis-impact -v rows=4 [-v small=yes] -v blank="middle_broken_ns ends_broken_ns" -f pipelines/must.awk -f check.awk table.csv

FNR == 1 { next }
{
    step[$1, $2] = $3
    middle[$1, $2] = $7
    ends[$1, $2] = $8
    # 10 % for what the surfaces of eight layers change, and for the plate's wave, 5 % faster than a bar's.
    if ($1 == "elastic") must($5 > 0.9 * bar && $5 < 1.1 * bar, $1 " " $2 ": wave at " $5 " m/s, of a bar " bar)
}

BEGIN {
    bar = sqrt(210e9 / 7850)
}

END {
    must(step["elastic", 450] > 0 && step["elastic", 45] > 0, "the elastic runs are missing")
    # The bond sum of Silling and Askari's step, over |xi| in spacings and a family of 122, horizon 3.015, and a volume
    # of dx^2 in place of dx^3, times the thesis' factor 0.01.
    for (x = -3; x <= 3; x++)
        for (y = -3; y <= 3; y++)
            for (z = -3; z <= 3; z++) {
                r = sqrt(x * x + y * y + z * z)
                if (r > 0 && r <= 3.015) sum += 1 / r
            }
    dx = 25e-6
    K = 210e9 / (3 * (1 - 2 * 0.31))
    right = sqrt(2 * 7850 / (sum * 18 * K / (atan2(0, -1) * (3.015 * dx) ^ 4 * dx) * dx ^ 3))
    wrong = right * sqrt(dx)
    printf "step of the bond sum %.3g s, with dx^2 %.3g s, a hundredth of that %.3g s (thesis 1.78e-13 s); here %.3g s, ratio %.0f\n",
           right, wrong, wrong / 100, step["elastic", 450], step["elastic", 450] / 1.78e-13
    must(wrong / 100 > 0.85 * 1.78e-13 && wrong / 100 < 1.15 * 1.78e-13, "the thesis' step is not explained")
    must(middle["elastic", 450] != "" && middle["elastic", 450] > 400 && middle["elastic", 450] < 700, "elastic, 450 m/s: the middle must break as the waves meet")
    must(ends["elastic", 450] > middle["elastic", 450], "elastic, 450 m/s: the ends must break later")
    must(middle["elastic", 45] == "" && ends["elastic", 45] == "", "elastic, 45 m/s must not break")
    if (small != "") finish()
    must(step["plastic", 450] > 0 && step["plastic", 45] > 0, "the plastic runs are missing")
    must(middle["plastic", 450] == "" && ends["plastic", 450] != "" && ends["plastic", 450] < 400, "plastic, 450 m/s: the grips must tear off")
    must(middle["plastic", 45] == "" && ends["plastic", 45] == "", "plastic, 45 m/s must not break")
    finish()
}
