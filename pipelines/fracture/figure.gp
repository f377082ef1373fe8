# Curves to separation: gnuplot -c figure.gp FOLDER OUT.svg
set terminal svg size 760,520 font "DejaVu Sans,15" background "white"
set output ARG2
set datafile separator ","
set xlabel "Engineering strain of the gauge (%)"
set ylabel "Engineering stress (MPa)"
set yrange [0:2000]
set grid lc rgb "#d0d0d0"
set border 3
set tics nomirror
set key top right samplen 2.5 spacing 1.25
runs = "ufg hs40 r40 cg"
names = "'UFG' 'HS40' 'R40' 'CG'"
colours = "#0072b2 #d55e00 #009e73 #000000"
plot for [i = 1:4] sprintf("%s/%s/curve.csv", ARG1, word(runs, i)) using (100 * $5):6 with lines lw 2.5 lc rgb word(colours, i) title word(names, i)
