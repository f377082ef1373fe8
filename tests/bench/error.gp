# Error of the stress at 10 % and of E against CPU time: gnuplot -c error.gp error.csv OUT.svg
set terminal svg size 760,560 font "DejaVu Sans,14" background "white"
set output ARG2
set datafile separator ","
set logscale xy
set xlabel "CPU time of the run (s)"
set ylabel "relative error"
set grid lc rgb "#d0d0d0"
set key outside right top samplen 1 spacing 1.2
pick(quantity, model) = sprintf("< awk -F, '$6 == \"%s\" && $1 == \"%s\" && $9 != 0 {e = $9 < 0 ? -$9 : $9; print $10 \",\" e}' %s", quantity, model, ARG1)
models = "'correspondence mix' 'correspondence capped' ordinary_plastic ordinary bond_based"
plot for [i = 1:3] pick("stress_at_10_percent_MPa", word(models, i)) using 1:2 with points pt 7 ps 0.9 lc i title "10 % strain, ".word(models, i), \
     for [i = 1:5] pick("E_MPa", word(models, i)) using 1:2 with points pt 6 ps 0.9 lc i title "E, ".word(models, i)
