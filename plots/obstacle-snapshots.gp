# obstacle-snapshots.gp -- water and obstacle at six moments, coloured by speed and by pressure
# needs: at-TIME (x, y, speed, pressure, kind) of plots/figures-obstacle.sh, which draws this
load 'style.gp'
set datafile separator ' '
times = '0.1 0.16 0.2 0.24 0.3 0.5'
array name[2] = ['speed', 'pressure']
array most[2] = [3.0, 4.0]
array unit[2] = ['speed [m/s]', 'pressure [kPa]']
array factor[2] = [1.0, 1e-3]
water(k, w) = k == 0 ? w : NaN
skin(k, w) = k == 3 || k == 4 ? w : NaN

do for [w = 1:2] {
    set terminal pngcairo size 1500, 850 font 'Sans,17'
    set output 'obstacle-'.name[w].'.png'
    set multiplot layout 2, 3 margins 0.065, 0.9, 0.105, 0.96 spacing 0.015, 0.075
    unset key
    unset grid
    set size ratio -1
    set border 11 lw 2 lc rgb '#404040'
    set xrange [0:0.584]
    set yrange [0:0.45]
    set cbrange [0:most[w]]
    set palette defined (0 '#08306b', 1 '#2171b5', 2 '#6baed6', 3 '#c6dbef', 4 '#ffffb2', \
        5 '#fd8d3c')
    do for [i = 1:6] {
        if (i == 3) {
            set colorbox user origin 0.91, 0.2 size 0.015, 0.6
            set cblabel unit[w]
        } else {
            unset colorbox
        }
        set xlabel (i > 3 ? 'x [m]' : '') offset 0, 0.3
        set ylabel ((i - 1) % 3 ? '' : 'y [m]') offset 0.5, 0
        set xtics 0.2 format (i > 3 ? '%g' : '')
        set ytics 0.2 format ((i - 1) % 3 ? '' : '%g')
        set title word(times, i).' s' offset 0, -0.7
        plot 'at-'.word(times, i) using 1:(water($5, $2)):(factor[w] * column(2 + w)) \
                with points pt 7 ps 0.42 lc palette, \
            '' using 1:(skin($5, $2)) with points pt 7 ps 0.5 lc rgb pick(7)
    }
    unset multiplot
}
