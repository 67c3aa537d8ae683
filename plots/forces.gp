# forces.gp -- forces of the fluid on every wall, beam and body against time
# needs: forces.csv figures/constants.gp
load 'style.gp'
table = '../forces.csv'
eval read_names
end = '.fx'
eval choose
longest = 0
do for [k = 1:words(columns)] {
    width = strlen(stem(word(names, int(word(columns, k)))))
    longest = width > longest ? width : longest
}


# Directions in which there is more than what chance makes of a symmetric flow.
array most[3]
do for [d = 1:dim] {
    end = word('.fx .fy .fz', d)
    eval choose
    most[d] = 0
    do for [k = 1:words(columns)] {
        stats table using (abs(column(int(word(columns, k))))) skip 2 nooutput name 'f'
        most[d] = f_max > most[d] ? f_max : most[d]
    }
}
largest = most[1] > most[2] ? most[1] : most[2]
if (dim == 3) { largest = most[3] > largest ? most[3] : largest }
shown = ''
do for [d = 1:dim] { if (most[d] >= 1e-3 * largest) { shown = shown.' '.d } }

set terminal pngcairo size 1200, 400 * words(shown) + 60 font 'Sans,18'
set output 'forces.png'
set multiplot layout words(shown), 1 title title noenhanced
set lmargin 11
set rmargin longest + 7
set xrange [0:until]
set key at graph 1.01, 1 left top Left reverse samplen 1.5
do for [panel = 1:words(shown)] {
    d = int(word(shown, panel))
    set ylabel 'force, '.word('x y z', d).(dim == 2 ? ' [N/m]' : ' [N]')
    set xlabel panel == words(shown) ? 'time [s]' : ''
    end = word('.fx .fy .fz', d)
    eval choose
    plot 0 lc rgb grey lw 1 notitle, for [k = 1:words(columns)] table \
        using 1:(column(int(word(columns, k)))) skip 2 with lines lw 2 lc rgb pick(k) \
        title stem(word(names, int(word(columns, k))))
}
unset multiplot
