# Error of E against the spacing: gnuplot -c figure.gp table.csv OUT.svg
set terminal svg size 900,440 font "DejaVu Sans,14" background "white"
set output ARG2
set datafile separator ","
set xlabel "Spacing (mm)"
set xrange [-0.15:4.2]
set yrange [-42:28]
set grid lc rgb "#d0d0d0"
set border 3
set tics nomirror
horizons = "2.015 3.015 4.015 5.015"
colours = "#000000 #0072b2 #009e73 #d55e00"
is(h, v, c) = strcol(1) eq "stress" && strcol(2) eq h && strcol(4) eq v && strcol(5) eq c
set multiplot layout 1,2
do for [volumes in "whole partial"] {
    set title volumes." volumes"
    set ylabel volumes eq "whole" ? "Error of E (%)" : ""
    if (volumes eq "whole") { set key bottom right samplen 2 width -2 } else { set key top right samplen 2 }
    plot for [i = 1:4] ARG1 using 3:(is(word(horizons, i), volumes, "none") ? $8 : NaN) with linespoints pt 7 ps 0.6 lw 2 lc rgb word(colours, i) title (volumes eq "whole" ? "horizon ".word(horizons, i) : ""), \
         for [i = 1:4] ARG1 using 3:(is(word(horizons, i), volumes, "energy") ? $8 : NaN) with linespoints pt 6 ps 0.6 lw 2 dt (6, 4) lc rgb word(colours, i) notitle, \
         for [i = 1:4] ARG1 using (0):(is(word(horizons, i), volumes, "none") ? $9 : NaN) with points pt 2 ps 1 lw 2 lc rgb word(colours, i) notitle, \
         NaN with lines lw 2 lc rgb "#777777" title (volumes eq "whole" ? "" : "no surface correction"), \
         NaN with lines lw 2 dt (6, 4) lc rgb "#777777" title (volumes eq "whole" ? "" : "energy"), \
         NaN with points pt 2 lw 2 lc rgb "#777777" title (volumes eq "whole" ? "" : "lattice without edges")
}
