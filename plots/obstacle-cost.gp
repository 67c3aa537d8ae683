# obstacle-cost.gp -- right-hand sides until 0.3 s against spacing and against Young's modulus, and
# the peak against spacing
# needs: spacings.csv stiffness.csv of plots/figures-obstacle.sh, which draws this
load 'style.gp'
methods = 'imex3 imex4 imex5 dv cks43'
work = real(system("awk -F, '$1 == \"imex3\" && $2 > 4 && $2 < 4.1 { print $2 * $7; exit }' spacings.csv"))
of(i, file) = sprintf("< grep '^%s,' %s", word(methods, i), file)

set terminal pngcairo size 1600, 620 font 'Sans,17'
set output 'obstacle-cost.png'
set multiplot
set tmargin at screen 0.97
set bmargin at screen 0.165
unset key

set lmargin at screen 0.065
set rmargin at screen 0.325
set xlabel 'dx [mm]'
set ylabel 'peak of the tip [mm]'
set xrange [0:6.5]
set yrange [40:46]
set key top right samplen 2
plot for [i in '1 2 4'] of(i + 0, 'spacings.csv') using 2:3 \
        with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(i + 0) \
        title word(methods, i + 0)

set lmargin at screen 0.395
set rmargin at screen 0.66
set ylabel 'explicit right-hand sides'
set logscale y
set format y '10^{%T}'
set yrange [300:1e5]
unset key
plot for [i in '1 2 4'] of(i + 0, 'spacings.csv') using 2:7 \
        with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(i + 0), \
    (x > 1.9 ? work / x : NaN) lw 1.5 dt '-' lc rgb grey

set lmargin at screen 0.725
set rmargin at screen 0.99
set ylabel ''
set xlabel "Young's modulus E [Pa]"
set logscale x
set format x '10^{%T}'
set xrange [5e5:5e11]
set yrange [300:1e8]
set key at graph 0.98, 0.62 right top samplen 2
plot for [i = 1:5] of(i, 'stiffness.csv') using 2:7 \
    with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(i) \
    title word(methods, i).(i == 5 ? ', explicit' : '')
unset multiplot
