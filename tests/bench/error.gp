# Error against CPU time, a panel a quantity: gnuplot -c error.gp error.csv front.awk OUT.svg
set terminal svg size 900,820 font "DejaVu Sans,13" background "white" noenhanced
set output ARG3
set datafile separator ","
set logscale xy
set xrange [0.03:300]
set yrange [8e-6:1]
set format y "%g"
set grid lc rgb "#e4e4e4"
set key off
set multiplot layout 2,2 margins 0.085,0.98,0.19,0.95 spacing 0.085,0.1
kinds = "corner 'corner 1e-4' 'correspondence mix' 'correspondence capped' ordinary_plastic ordinary bond_based"
names = "'corner' 'corner, accuracy 1e-4' 'correspondence, mix' 'correspondence, capped' 'ordinary plastic, horizon 3.015' 'ordinary, 3.015' 'bond-based, 3.015'"
colour(i) = word("#0072b2 #000000 #d55e00 #e69f00 #009e73 #cc79a7 #56b4e9", i)
# Rows of a kind that differ in the spacing alone, in the order of their cost; and all others.  The point out of sight keeps kinds
# without rows in the key.
usual = "$2 == \"quasi_static\" && ($4 == 1 || ($4 == \"3.015\" && $5 == \"linear\"))"
rows(quantity, which) = sprintf("< awk -F, '$6 == \"%s\" && %s {e = $9 < 0 ? -$9 : $9; print $10 \",\" (e > 1e-5 ? e : 1e-5)}' %s | sort -t, -k1g; echo; echo 1e-9,1", quantity, which, ARG1)
series(quantity, kind) = rows(quantity, sprintf("$1 == \"%s\" && %s", kind, usual))
moving(quantity, kind) = rows(quantity, sprintf("$1 == \"%s\" && $2 ~ /explicit/", kind))
others(quantity) = rows(quantity, sprintf("!(%s) && $2 !~ /explicit/", usual))
front(quantity) = sprintf("< awk -v quantity=%s -f %s %s | tr ' ' ,", quantity, ARG2, ARG1)
asked = "E_MPa Rp02_MPa stress_at_10_percent_MPa strain_at_maximum"
heads = "'E' 'Rp0.2' 'stress at 10 %' 'strain at the largest load'"
do for [p = 1:4] {
    q = word(asked, p)
    set title word(heads, p) offset 0,-0.6
    set xlabel (p > 2 ? "CPU time of the run, s" : "") offset 0,0.5
    set ylabel (p % 2 ? "relative error" : "") offset 1,0
    if (p == 1) { set key at screen 0.5,0.005 center bottom maxrows 6 samplen 2 spacing 1.1 font ",12" width -2 } else { set key off }
    plot front(q) using 1:2 with steps lw 7 lc rgb "#dddddd" title "nothing cheaper is nearer", \
         for [i = 1:7] series(q, word(kinds, i)) using 1:2 with linespoints pt 7 ps 0.7 lw 1.5 lc rgb colour(i) title word(names, i), \
         moving(q, "corner") using 1:2 with linespoints pt 4 ps 0.9 dt 2 lc rgb colour(1) title "corner, explicit at 20, 10, 5 m/s", \
         moving(q, "correspondence mix") using 1:2 with linespoints pt 4 ps 0.9 dt 2 lc rgb colour(3) title "mix, explicit at 20, 10, 5 m/s", \
         others(q) using 1:2 with points pt 6 ps 0.7 lc rgb "#999999" title "other horizons, influences, corrections"
}
unset multiplot
