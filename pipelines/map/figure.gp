# Total and first indices: gnuplot -c figure.gp indices.csv map.svg
set terminal svg size 760,360 font 'DejaVu Sans,13' background 'white'
set output ARG2
set datafile separator ','
set style data histograms
set style fill solid 0.8 noborder
set boxwidth 0.9
set yrange [0:1]
set ylabel 'Total index'
set grid y lc rgb '#dddddd'
set key top right
set xtics ('fraction' 0, 'yield of UFG' 1, 'hardening of UFG' 2, 'hardening of CG' 3, 'arrangement' 4, 'jitter' 5, 'particles' 6) rotate by -20
of(what) = sprintf("< awk -F, '$1 == \"%s\" && $4 != \"\"' %s", what, ARG1)
plot of('Rp02_MPa') using 4 lc rgb '#0072b2' title 'Rp0.2', of('MPa_at_2') using 4 lc rgb '#56b4e9' title 'stress at 2 %', \
    of('MPa_at_10') using 4 lc rgb '#009e73' title 'stress at 10 %', of('gain') using 4 lc rgb '#d55e00' title 'gain of the mixture at 2 %'
