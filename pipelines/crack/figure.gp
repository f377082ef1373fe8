# Tip against time: gnuplot -c figure.gp FOLDER OUT.svg
set terminal svg size 640,440 font "DejaVu Sans,14" background "white"
set output ARG2
set datafile separator ","
set xlabel "Time (µs)"
set ylabel "Tip of the crack (mm)"
set xrange [0:46]
set yrange [-3:52]
set grid lc rgb "#d0d0d0"
set border 3
set tics nomirror
set key bottom right samplen 2
plot ARG1."/track-1mm.csv" every ::1 using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb "#0072b2" title "spacing 1 mm", \
     ARG1."/track-0.5mm.csv" every ::1 using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb "#d55e00" title "spacing 0.5 mm", \
     3.136 * (x - 5.2) with lines lw 2 dt (2, 4) lc rgb "#777777" title "Rayleigh waves", \
     0.4 * 3.136 * (x - 5.2) with lines lw 2 dt (6, 4) lc rgb "#777777" title "0.4 of their speed"
