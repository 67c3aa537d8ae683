# seed-search.gp -- CPU time of a search for neighbours against particles: by comparing all with
# all, and by cells
# needs: search.csv of plots/search-table; drawn by plots/figures-search.sh, not with a run
load 'style.gp'
set terminal pngcairo size 900, 640 font 'Sans,17'
set output '../seed-search.png'
set logscale xy
set format y '10^{%T}'
set xrange [500:110000]
set yrange [5e-6:30]
set rmargin 4
set xlabel 'particles'
set ylabel 'CPU time [s]'
set key top left Left reverse
plot 'search.csv' using 1:4 skip 1 with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(1) \
        title 'comparing coordinates of all: Toth (2012), 3.7', \
    '' using 1:5 skip 1 with linespoints lw 2 pt 5 ps 1.3 lc rgb pick(2) \
        title 'the list of this program, made anew', \
    '' using 1:6 skip 1 with linespoints lw 2 pt 9 ps 1.5 lc rgb pick(3) \
        title 'one sum of W over its pairs', \
    0.03 * (x / 1e4)**2 with lines lw 1.5 dt 2 lc rgb grey title 'as N²', \
    3.6e-4 * (x / 1e4) with lines lw 1.5 dt 3 lc rgb grey title 'as N'
