# sizes.gp -- a splash in the corner of a tank, and its error in tanks of many sizes by the norm
# of the error test
# needs: the table of plots/figures-sizes.sh, which draws this
load 'style.gp'
r = 0.9e-3
shade(kind, dye) = kind > 0 ? 0xb0b0b0 : dye == 1 ? 0x0072b2 : 0x9fcbe6

set terminal pngcairo size 1700, 700 font 'Sans,18'
set output '../sizes.png'
set multiplot
set datafile columnheaders

set lmargin at screen 0.015
set rmargin at screen 0.4
set tmargin at screen 0.9
set bmargin at screen 0.14
set border 0
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.008:0.125]
set yrange [-0.008:0.08]
set title 'after 10 ms: dark, whose error is measured'
plot 'splash.csv' using 1:2:(r):(shade(column('kind'), column('dye'))) skip 2 \
    with circles fs solid noborder lc rgb variable

set lmargin at screen 0.49
set rmargin at screen 0.985
set border 3
set size noratio
set xtics nomirror out
set ytics nomirror out
set grid
set title 'the same tol = 1e-4 in every tank'
set logscale xy
set xrange [1500:300000]
set yrange [5e-7:3e-4]
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'fluid particles in the tank'
set ylabel 'rms error of the splash / dx'
set key top left Left reverse samplen 3 spacing 1.2
norms = 'max p8 wrms'
array about[3] = ['max, the default', 'p8', 'wrms']
of(i) = strcol(1) eq word(norms, i) && $2 == 1e-4 ? $4 : NaN
stats 'sizes.csv' using (of(1)) nooutput
first = STATS_min
band(x) = first * x
set object 1 rectangle from graph 0, first band(0.5) to graph 1, first band(2) behind \
    fs solid 0.12 noborder fc rgb pick(1)
set label 1 'within a factor 2' at graph 0.98, first band(0.62) right tc rgb '#606060'
plot for [i = 1:3] 'sizes.csv' using 3:(of(i)) with linespoints lw 3 pt 7 ps 1.6 \
    lc rgb pick(i) title about[i]
unset multiplot
