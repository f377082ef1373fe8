# Time of a step a node against the size of the body: gnuplot -c runs.gp runs.csv OUT.svg
set terminal svg size 640,420 font "DejaVu Sans,14" background "white"
set output ARG2
set datafile separator ","
set logscale x
set xlabel "nodes"
set ylabel "ns a node, step and rank"
set yrange [0:*]
set grid lc rgb "#d0d0d0"
set key outside right top samplen 2 spacing 1.2
pick(model, ranks) = sprintf("< awk -F, '$1 == \"%s\" && $3 == %d {print $2 \",\" $4}' %s", model, ranks, ARG1)
models = "bond_based ordinary ordinary_plastic 'correspondence mix'"
plot for [i = 1:4] pick(word(models, i), 1) using 1:2 with linespoints pt 7 ps 0.7 lc i title word(models, i), \
     for [i = 1:4] pick(word(models, i), 2) using 1:2 with linespoints pt 6 ps 0.7 dt 2 lc i title "2 ranks"
