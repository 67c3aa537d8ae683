# forces.gp -- forces of the fluid on every wall, beam and body against time
# needs: forces.csv figures/constants.gp
load 'style.gp'
table = '../forces.csv'
eval read_names

ends = dim == 2 ? '.fx .fy' : '.fx .fy .fz'
directions = 'x y z'
set terminal pngcairo size 1200, 400 * words(ends) + 80 font 'Sans,17'
set output 'forces.png'
set multiplot layout words(ends), 1 title title noenhanced offset 0, -0.2
set xrange [0:*]
set lmargin 12
set rmargin 26
set key outside right top Left reverse samplen 2
set xlabel 'time [s]'
do for [e = 1:words(ends)] {
    set ylabel 'force, '.word(directions, e).(dim == 2 ? ' [N/m]' : ' [N]')
    end = word(ends, e)
    eval choose
    plot 0 lc rgb grey lw 1 notitle, for [k = 1:words(columns)] table \
        using 1:(column(int(word(columns, k)))) skip 2 with lines lw 2 lc rgb pick(k) \
        title stem(word(names, int(word(columns, k))))
}
unset multiplot
