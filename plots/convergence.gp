# convergence.gp -- for four flows: error of space against spacing, and beside it that of time with
# four tolerances
# needs: the tables of plots/figures-convergence.sh, which draws this
load 'style.gp'
set datafile separator ' '
cases = 'rest vortices drop column'
array say[4] = ['A01, water at rest: pressure, L2, after 4 s', \
    'A04, vortices: rate of decay to 0.05 s', 'A07b, a drop flies apart: semi-axes', \
    'B01, a column collapses: T at Z = 3']
array length[4] = ['H', 'L', 'R', 'a']
array coarsest[4] = [10, 25, 10, 20]    # four times the spacing of the finest
tols = '1e-1 1e-2 1e-3 1e-4'
only(tol) = sprintf("< awk '$2 == \"%s\"' %s", tol, file)
size(e) = abs(e) > 1e-13 ? abs(e) : NaN

set terminal pngcairo size 1500, 1100 font 'Sans,17'
set output '../convergence.png'
set multiplot layout 2, 2 margins 0.085, 0.8, 0.075, 0.965 spacing 0.085, 0.125
set logscale xy
set format y '10^{%T}'
set ylabel 'relative error' offset 1, 0
set yrange [1e-10:1]
do for [k = 1:4] {
    file = word(cases, k).'.csv'
    set title say[k] offset 0, -0.6
    n = coarsest[k]
    set xrange [n / 1.2:n * 4.8]
    set xtics (n, 2 * n, 4 * n)
    set xlabel length[k].' / dx' offset 0, 0.5
    if (k == 2) { set key at screen 0.81, 0.965 left top Left reverse samplen 2 spacing 1.3 } \
    else { unset key }
    plot only('1e-6') using 1:(size($3)) with linespoints lw 4 pt 7 ps 1.6 \
            lc rgb pick(7) title 'of space', \
        for [i = 1:4] only(word(tols, i)) using 1:(size($4)) \
            with linespoints lw 2 pt 6 ps 1.3 lc rgb pick(i) \
            title 'of time, tol = '.word(tols, i), \
        1 / x lw 1.5 dt '-' lc rgb grey title 'first order'
}
unset multiplot
