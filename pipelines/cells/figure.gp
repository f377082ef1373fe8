# Mean curves of the structures at 40 % UFG, and a standard deviation of the seeds: gnuplot -e 'folder="..."' figure.gp > cells.svg
set terminal svg size 640,480 font 'DejaVu Sans,14' background 'white'
set datafile separator ','
set key bottom right
set xlabel 'Engineering strain (%)'
set ylabel 'Engineering stress (MPa)'
set xrange [0:20]
set yrange [0:900]
set grid lc rgb '#dddddd'
set style fill solid 0.25 noborder
wanted(fraction) = fraction == 0.4 ? 1 : NaN
mean(name) = folder.'/'.name.'/gathered/mean.csv'
plot mean('large') using (100*column('engineering_strain')):(wanted(column('domain.ufg_fraction'))*(column('mean_stress_MPa')-column('standard_deviation_MPa'))):(column('mean_stress_MPa')+column('standard_deviation_MPa')) with filledcurves lc rgb '#009e73' notitle, \
    mean('large') using (100*column('engineering_strain')):(wanted(column('domain.ufg_fraction'))*column('mean_stress_MPa')) with lines lw 2 lc rgb '#009e73' title 'random, ten samples of 128 cells', \
    mean('sc') using (100*column('engineering_strain')):(wanted(column('domain.ufg_fraction'))*column('mean_stress_MPa')) with lines lw 2 dt 3 lc rgb '#555555' title 'harmonic, sc along a wall', \
    mean('fcc') using (100*column('engineering_strain')):(wanted(column('domain.ufg_fraction'))*column('mean_stress_MPa')) with lines lw 2 dt 2 lc rgb '#0072b2' title 'harmonic, fcc', \
    mean('bcc') using (100*column('engineering_strain')):(wanted(column('domain.ufg_fraction'))*column('mean_stress_MPa')) with lines lw 2 lc rgb '#d55e00' title 'harmonic, bcc'
