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

set terminal pngcairo size 1200, 400 * dim + 60 font 'Sans,18'
set output 'forces.png'
set multiplot layout dim, 1 title title noenhanced
set lmargin 11
set rmargin longest + 7
set xrange [0:until]
set key at graph 1.01, 1 left top Left reverse samplen 1.5
do for [d = 1:dim] {
    set ylabel 'force, '.word('x y z', d).(dim == 2 ? ' [N/m]' : ' [N]')
    set xlabel d == dim ? 'time [s]' : ''
    end = word('.fx .fy .fz', d)
    eval choose
    plot 0 lc rgb grey lw 1 notitle, for [k = 1:words(columns)] table \
        using 1:(column(int(word(columns, k)))) skip 2 with lines lw 2 lc rgb pick(k) \
        title stem(word(names, int(word(columns, k))))
}
unset multiplot
