# blocks-snapshots.gp -- figures 3 and 6 of seed 003: a flood and blocks from the side
# needs: the tables of plots/figures-blocks.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 1500, 1250 font 'Sans,16'
set output 'blocks-snapshots.png'
runs = 'paper paper three three six six six'
times = '0.98 1.28 0.98 1.28 0.82 1.16 1.46'
array name[7] = ['paper', 'paper', 'defaults', 'defaults', 'six', 'six', 'six']
set multiplot layout 4, 2 margins 0.06, 0.9, 0.05, 0.97 spacing 0.05, 0.06
set size ratio -1
set xrange [1.2:2.8]
set yrange [0:0.55]
set ytics 0.2
set cbrange [0:3]
set palette defined (0 '#08306b', 1 '#2171b5', 2 '#6baed6', 3 '#c6dbef')
unset key
do for [i = 1:7] {
    set title name[i].', '.word(times, i).' s' offset 0, -0.7
    if (i == 2) {
        set colorbox user origin 0.92, 0.3 size 0.015, 0.4
        set cblabel 'speed [m/s]'
    } else {
        unset colorbox
    }
    plot word(runs, i).'-water-'.word(times, i) using 1:2:3 with points pt 7 ps (i < 3 ? 0.9 : 0.5) lc palette, \
        word(runs, i).'-cubes-'.word(times, i) using 1:2 with lines lw 2 lc rgb pick(2)
}
unset multiplot
