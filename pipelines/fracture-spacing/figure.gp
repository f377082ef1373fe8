# Nominal stress against the gauge's strain of the slow bars: gnuplot -c figure.gp FOLDER OUT.svg
set terminal svg size 900,640 font "DejaVu Sans,14" background "white"
set output ARG2
set datafile separator ","
set ylabel "Nominal stress (MPa)"
set yrange [0:]
set grid lc rgb "#d0d0d0"
set border 3
set tics nomirror
spacings = "25 16.7 12.5"
colours = "#000000 #0072b2 #d55e00"
file(phase, spacing, damage) = ARG1."/".phase."-5-".spacing."-".damage."/columns.csv"
# Up to where the halves swing back.
stress(row, force, extension) = (parted = row > 0 && (parted || (force < 0 && extension > 1e-5)), parted ? NaN : force/0.02)
parted = 0
set multiplot layout 2,2
do for [phase in "cg ufg"] {
    do for [damage in "local length"] {
        set title (phase eq "cg" ? "CG" : "UFG").(damage eq "local" ? ", damage as it is" : ", with length: 25 um")
        set xlabel phase eq "ufg" ? "Strain of the gauge (%)" : ""
        set xrange [0:phase eq "cg" ? 45 : 8]
        set key bottom left samplen 2
        plot for [i = 1:3] file(phase, word(spacings, i), damage) every 3::1 using (100*$4/0.5e-3):(stress($0, $3, $4)) with lines lw 2 \
             lc rgb word(colours, i) title word(spacings, i)." um"
    }
}
