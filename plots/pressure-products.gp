# pressure-products.gp -- products of a solve for a pressure that looks ahead against particles
# needs: products.csv of plots/figures-pressure.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 900, 560 font 'Sans,17'
set output '../pressure-products.png'
set logscale xy
set xrange [500:200000]
set yrange [1:100]
set rmargin 5
set xlabel 'particles of the fluid'
set ylabel 'products a solve'
set key top left Left reverse
only(way) = sprintf("< awk '$1 == \"%s\"' products.csv", way)
grow(n) = 4.1 * sqrt(n / 1800.0)
plot only('look-ahead') using 3:($6 / $5) with linespoints lw 2 pt 7 ps 1.4 lc rgb pick(2) \
        title 'look-ahead, 30 U, dam break to 0.03 s', \
    only('still') using 3:($6 / $5) with linespoints lw 2 pt 5 ps 1.4 lc rgb pick(3) \
        title 'the same, still water to 0.03 s', \
    grow(x) with lines lw 1.5 dt 2 lc rgb grey title 'as √N'
