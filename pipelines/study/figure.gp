# Curves of the study over each other: gnuplot -c figure.gp FOLDER OUT.svg SPACING...
# The last spacing is drawn solid with its bounds, the others dashed.
folder = ARG1
set terminal svg size 760,520 font "DejaVu Sans,15" background "white"
set output ARG2
set datafile separator ","
set xlabel "Engineering strain (%)"
set ylabel "Engineering stress (MPa)"
set xrange [0:10]
set yrange [0:1000]
set grid lc rgb "#d0d0d0"
set border 3
set tics nomirror
set key outside right top samplen 2.5 spacing 1.25

spacings = ARG3." ".ARG4
finest = word(spacings, words(spacings))
runs = "ufg hs40 r40-seed2 r40-seed5 r40-seed9 cg"
names = "'UFG' 'HS40' 'R40, seed 2' 'R40, seed 5' 'R40, seed 9' 'CG'"
colours = "#0072b2 #d55e00 #009e73 #56b4e9 #cc79a7 #000000"
curve(i, s) = sprintf("%s/%s-%s/curve.csv", folder, word(runs, i), s)
bound(name) = sprintf("%s/%s-%s.csv", folder, name, finest)

coarser = words(spacings) > 1 ? word(spacings, 1) : ""
plot for [i = 1:6] curve(i, finest) using (100 * $5):6 with lines lw 2.5 lc rgb word(colours, i) title word(names, i), \
     for [s in coarser] for [i = 1:6] curve(i, s) using (100 * $5):6 with lines lw 1.5 dt (8, 6) lc rgb word(colours, i) notitle, \
     bound("voigt") using (100 * $5):6 with lines lw 2 dt (2, 4) lc rgb "#777777" title "Voigt", \
     bound("reuss") using (100 * $5):6 with lines lw 2 dt (2, 4) lc rgb "#aaaaaa" title "Reuss", \
     NaN with lines lw 2 lc rgb "#444444" title "solid: ".finest, \
     for [s in coarser] NaN with lines lw 1.5 dt (8, 6) lc rgb "#444444" title "dashed: ".s
