# blocks-paths.gp -- figures 4 and 5 of seed 003: paths of blocks in a flood
# needs: the tables of plots/figures-blocks.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 1500, 1000 font 'Sans,17'
set output 'blocks-paths.png'
set multiplot layout 2, 2 margins 0.085, 0.98, 0.095, 0.945 spacing 0.095, 0.13
set xrange [0.4:1.6]
set key Left reverse
array title_of[4] = ['4 a: the lowest of three, along the flume (nothing measured is at hand)', \
    '4 b: the top one of three, along the flume', '4 c: the top one of three, height', \
    '5: the top one of six (nothing measured is at hand)']
array body[4] = ['lower', 'top', 'top', 'top']
do for [i = 1:4] {
    if (i == 3) { set key bottom left } else { set key top left }
    set title title_of[i]
    set xlabel i > 2 ? 't [s]' : ''
    set ylabel i == 3 ? 'z [m]' : i == 4 ? 'x - 1.5 m, z [m]' : 'x [m]'
    set yrange [i < 3 ? 1.7 : 0 : i < 3 ? 2.6 : i == 3 ? 0.45 : 1.2]
    if (i < 4) {
        plot for [run = 1:2] word('paper three', run).'-'.body[i] using 1:(i == 3 ? $3 : $2) with lines lw 2.5 \
                lc rgb pick(3 - run) title (run == 1 ? 'model of the paper, 50 mm' : 'defaults, 25 mm'), \
            i == 3 ? 'seen-z' : 'seen-x' using 1:(i == 1 ? NaN : $2) with points pt 6 lc rgb grey \
                title (i == 1 ? '' : 'measured')
    } else {
        set xrange [0.4:2]
        plot 'six-top' using 1:($2 - 1.5) with lines lw 2.5 lc rgb pick(1) title 'x - 1.5 m, defaults, 25 mm', \
            '' using 1:3 with lines lw 2.5 lc rgb pick(2) title 'z'
    }
}
unset multiplot
