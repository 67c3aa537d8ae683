# pressure-ways.gp -- what ways to a pressure cost and give: a dam break and still water at several
# spacings, a line a way, its points spacings
# needs: the tables of plots/figures-pressure.sh, which draws this
load 'style.gp'
set datafile separator ' '
ways = system("awk 'NR > 1 && !seen[$1]++ { print $1 }' dam.csv")
only(table, way) = sprintf("< awk '$1 == \"%s\"' %s.csv", way, table)
array say[6] = ['front, from its finest run', 'front, from Martin, Moyce', 'energy defect / E0', \
    'force noise / rho g H^2', 'bed: abs(mean - 1)', 'bed: deviation']
array table[6] = ['dam', 'dam', 'dam', 'dam', 'still', 'still']
array column_of_row[6] = [6, 7, 8, 9, 6, 7]
shown(row, x) = row == 5 ? abs(x - 1) : x > 0 ? x : NaN
shape(i) = word('7 5 9 13 11 6 4 8 12', i) + 0
dash_of(i) = i > 7 ? 2 : 1

set terminal pngcairo size 1500, 1900 font 'Sans,16'
set output '../pressure-ways.png'
set multiplot layout 6, 2 margins 0.085, 0.785, 0.045, 0.98 spacing 0.075, 0.025
set logscale xy
set format y '10^{%T}'
set dashtype 2 (8, 5)
do for [row = 1:6] {
    do for [side = 0:1] {
        set ylabel side ? '' : say[row] offset 1.5, 0
        set xlabel row < 6 ? '' : side ? 'CPU time / s' : 'sums over pairs' offset 0, 0.4
        set format x row < 6 ? '' : '10^{%T}'
        if (side) { set xrange [0.03:300] } else { set xrange [700:300000] }
        unset key
        plot for [i = 1:words(ways)] only(table[row], word(ways, i)) \
            using (column(4 + side)):(shown(row, column(column_of_row[row]))) \
            with linespoints lw 2.2 ps 1.4 pt shape(i) dt dash_of(i) lc rgb pick(i) notitle
    }
}
# The legend: a key beside a low plot would leave out what does not fit beside it.
unset border
unset tics
unset label
unset xlabel
unset ylabel
unset logscale
set margins at screen 0.792, at screen 0.99, at screen 0.05, at screen 0.98
set xrange [0:1]
set yrange [0:1]
set key at graph 0, 1 left top Left reverse samplen 3 spacing 1.3
plot for [i = 1:words(ways)] NaN with linespoints lw 2.2 ps 1.4 pt shape(i) dt dash_of(i) \
    lc rgb pick(i) title word(ways, i)
unset multiplot
