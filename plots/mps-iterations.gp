# mps-iterations.gp -- products of a solve against particles, in the method mps
# needs: iterations.csv of plots/figures-mps.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 900, 560 font 'Sans,17'
set output '../mps-iterations.png'
set logscale x
set xrange [500:200000]
set yrange [0:100]
set rmargin 5
set xlabel 'particles of the fluid'
set ylabel 'products a solve'
set key top left Left reverse
grow(n) = 18.9 * sqrt(n / 800.0)
plot 'iterations.csv' using 1:2 with linespoints lw 2 pt 7 ps 1.4 lc rgb pick(1) \
        title 'dam break to 0.05 s, IC(0), residual 1e-6', \
    grow(x) with lines lw 1.5 dt 2 lc rgb grey title 'as √N'
