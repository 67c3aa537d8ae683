# beam-frequency.gp -- first frequency and damping of the beam of Toth (2012) against its elements
# needs: beam-frequency.csv of plots/beam-table; drawn by plots/figures-beam.sh, not with a run
load 'style.gp'
set datafile columnheaders
table = 'beam-frequency.csv'

set terminal pngcairo size 1700, 800 font 'Sans,18'
set output '../beam-frequency.png'
set multiplot layout 1, 2 title "beam of Toth (2012) against its number of elements: (44) and (45)"
set logscale x
set xrange [1.8:110]
set xtics (2, 3, 5, 10, 20, 30, 50, 100)
set xlabel 'elements'
set lmargin 9
set rmargin 2.5

set ylabel 'first frequency / theory'
set yrange [0.6:1.05]
set ytics 0.1
set key bottom right spacing 1.2 samplen 2.5
plot 1 lc rgb grey lw 1 notitle, \
    table using 1:'consistent' with linespoints lw 2.5 pt 7 ps 1.2 lc rgb pick(1) \
        title 'inertia = consistent', \
    table using 1:'lumped_ends' with linespoints lw 2.5 pt 9 ps 1.4 lc rgb pick(3) \
        title 'lumped-ends: (44), halves at the ends', \
    table using 1:'lumped' with linespoints lw 2.5 pt 5 ps 1.2 lc rgb pick(2) \
        title 'lumped: (44) as printed'

set ylabel 'damping ratio of the first mode'
set logscale y
set yrange [0.01:40]
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
set key top left Left reverse
set label 1 'creeps back' at 1.95, 1 offset 0, 0.6 textcolor rgb '#606060'
set label 2 'swings' at 1.95, 1 offset 0, -0.6 textcolor rgb '#606060'
plot 1 lc rgb '#404040' lw 1.5 dt '-' notitle, \
    table using 1:'lumped_drag' with linespoints lw 2.5 pt 5 ps 1.2 lc rgb pick(2) \
        title 'drag = 0.01: (45), with (44) as printed', \
    table using 1:'consistent_drag' with linespoints lw 2 dt '-' pt 6 ps 1.2 lc rgb pick(4) \
        title 'the same with consistent inertia', \
    table using 1:'consistent_ratio' with linespoints lw 2.5 pt 7 ps 1.2 lc rgb pick(1) \
        title 'damping_ratio = 0.02, consistent inertia'
unset multiplot
