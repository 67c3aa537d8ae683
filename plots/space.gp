# space.gp -- a dam break on a box in 3D: errors of time, of space and of chance against CPU time
# needs: the table of plots/figures-space.sh, which draws this
load 'style.gp'
set datafile separator ' '
array say[3] = ['front', 'impulse on the box', 'pressures P1 to P4, 20 ms means']
methods = 'cks43 ark436 opt53 dv leapfrog'
only(method) = sprintf("< awk '$1 == \"time\" && $2 ~ /^%s/' runs.csv", method)
rows(what) = sprintf("< awk '$1 == \"%s\"' runs.csv", what)
chance(k) = system(sprintf("awk '$1 == \"chance\" && $4 == \"0.037\" { print $%d }' runs.csv", 7 + k)) + 0.0

set terminal pngcairo size 1900, 640 font 'Sans,17'
set output '../space.png'
set label 2 "squares, from the left:\n55.5, 37, 27.75, 18.5 mm" at screen 0.77, 0.42 left tc rgb '#606060'
set multiplot layout 1, 3 margins 0.055, 0.76, 0.13, 0.92 spacing 0.045, 0.1
set logscale xy
set format y '10^{%T}'
set xrange [2:400]
set yrange [3e-4:3]
set xlabel 'CPU time / s' offset 0, 0.4
do for [k = 1:3] {
    set title say[k] offset 0, -0.6
    set ylabel k == 1 ? 'relative error' : '' offset 1, 0
    luck = chance(k)
    set arrow 1 from graph 0, first luck to graph 1, first luck nohead lw 2 dt '.' lc rgb grey
    set label 1 'chance, 37 mm' at graph 0.02, first luck * 0.8 left tc rgb '#606060'
    if (k == 3) { set key at screen 0.77, 0.9 left top Left reverse samplen 3 spacing 1.3 } \
    else { unset key }
    plot for [i = 1:words(methods)] only(word(methods, i)) using 7:(column(7 + k)) \
            with linespoints lw 2.2 pt 7 ps 1.3 lc rgb pick(i) \
            title 'of time, 37 mm: '.word(methods, i), \
        rows('space') using 7:(column(7 + k)) with linespoints lw 4 pt 5 ps 1.6 lc rgb pick(7) \
            title 'of space, against 18.5 mm', \
        rows(k == 3 ? 'experiment' : 'space') using 7:(k == 3 ? column(7 + k) : 1e-9) \
            with linespoints lw 2 dt '-' pt 4 ps 1.6 lc rgb pick(7) \
            title 'against the experiment'
}
unset multiplot
