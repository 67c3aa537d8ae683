# pressure-stiffness.gp -- what a stiffer fluid costs with a pressure that looks ahead and without,
# and whether its solves grow with the particles
# needs: the table of plots/figures-pressure.sh, which draws this
load 'style.gp'
set datafile separator ' '
U = 1.98
ways = 'linear look-ahead no-tension'
array say[3] = ['linear', 'look-ahead', 'look-ahead, no tension']
only(i, what) = sprintf("< awk '$1 == \"%s\" && %s' stiff.csv", word(ways, i), what)

set terminal pngcairo size 1700, 560 font 'Sans,17'
set output '../pressure-stiffness.png'
set multiplot layout 1, 3 margins 0.075, 0.985, 0.14, 0.95 spacing 0.06, 0.1
set logscale xy
set xlabel 'c0 / U' offset 0, 0.4
set xrange [8:250]
set key top left Left reverse samplen 2
set ylabel 'right-hand sides' offset 1, 0
plot for [i = 1:3] only(i, '$3 == 1800') using ($2 / U):4 with linespoints lw 2.5 pt 7 ps 1.4 \
    lc rgb pick(i) title say[i]
unset key
set ylabel 'CPU time / s' offset 1, 0
plot for [i = 1:3] only(i, '$3 == 1800') using ($2 / U):6 with linespoints lw 2.5 pt 7 ps 1.4 \
    lc rgb pick(i)
set xlabel 'particles, c0 = 30 U'
set ylabel 'products a right-hand side' offset 1, 0
unset logscale y
set xrange [600:30000]
set yrange [0:12]
plot for [i = 2:3] only(i, '$2 == 59.4') using 3:($5 / $4) with points pt 7 ps 1.8 lc rgb pick(i)
unset multiplot
