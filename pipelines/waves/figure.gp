# Dispersion on the lattice, and the strain that a grip of 10 m/s leaves behind its front: gnuplot -c figure.gp FOLDER OUT.svg
set terminal svg size 900,400 font 'DejaVu Sans,13' background 'white'
set output ARG2
set datafile separator ','
set grid lc rgb '#dddddd'
set border 3
set tics nomirror
colour(i) = word('#000000 #0072b2 #56b4e9 #009e73 #d55e00 #cc79a7', i)
set multiplot layout 1,2
bodies = '"corner" "mix 1 constant" "mix 2 constant" "mix 3 constant" "ordinary 3.015 linear" "bond-based 3.015 constant"'
set xlabel 'Spacings per wavelength (inverse scale)'
set ylabel 'Speed of longitudinal waves, lattice over solid'
set xrange [0:0.5]
set yrange [0:1.3]
set xtics ('32' 1./32, '16' 1./16, '8' 0.125, '5' 0.2, '4' 0.25, '3' 1./3, '2' 0.5)
set key top right samplen 2 font ',11'
is(name) = strcol(1) eq name ? 1 : NaN
run(name) = strcol(1).(strcol(2) eq '' ? '' : ' '.strcol(2).' '.strcol(3)) eq name && strcol(4) eq '100' && strcol(5) eq 'P' ? 1 : NaN
plot for [i = 1:words(bodies)] ARG1.'/dispersion.csv' every ::1 using (column(2)*is(word(bodies, i))):3 with lines lw 2 lc rgb colour(i) title word(bodies, i), \
     for [i = 1:words(bodies)] ARG1.'/lattice.csv' every ::1 using (run(word(bodies, i))/column(6)):7 with points pt 7 ps 0.6 lc rgb colour(i) notitle
set xlabel 'From the grip (mm)'
set ylabel 'Strain (%)'
set xrange [0:3]
set yrange [0:1.4]
set xtics auto
set key top right
structures = 'CG R40 HS40 UFG'
of(name, from) = strcol(1) eq name && strcol(2) eq from ? 1 : NaN
plot for [i = 1:4] ARG1.'/profiles.csv' every ::1 using (column(3)*of(word(structures, i), 'explicit')):4 with lines lw 2 lc rgb colour(i == 1 ? 1 : i == 2 ? 4 : i == 3 ? 5 : 2) title word(structures, i), \
     for [i = 1:4] ARG1.'/profiles.csv' every ::1 using (column(3)*of(word(structures, i), 'static')):4 with lines lw 1.5 dt 2 lc rgb colour(i == 1 ? 1 : i == 2 ? 4 : i == 3 ? 5 : 2) notitle
