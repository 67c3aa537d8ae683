# seed-clustering.gp -- figure 5 of Toth 2012, and the share of particles in pairs by kernel and
# support
# needs: the runs of plots/figures-seed.sh, which draws this
load 'style.gp'
r = 0.6e-3
dye(c) = c == 0 ? 0x1f6fb4 : 0xf2c418
set datafile columnheaders

set terminal pngcairo size 1700, 620 font 'Sans,16'
set output '../seed-clustering.png'
set multiplot

set tmargin at screen 0.9
set bmargin at screen 0.1
set border 15
unset tics
unset grid
unset key
set size ratio -1
set xrange [0.02:0.06]
set yrange [0.02:0.06]
array left[2] = [0.01, 0.325]
array kernel[2] = ['gauss', 'wendland-c2']
do for [i = 1:2] {
    set lmargin at screen left[i]
    set rmargin at screen left[i] + 0.8 * 620 / 1700
    set title kernel[i].', H = 4 dx'
    plot sprintf('cluster-%s-4/snapshots/0005.csv', kernel[i]) \
        using (column('kind') == 0 ? $1 : NaN):2:(r):(dye(column('dye'))) skip 2 \
        with circles fs transparent solid 0.6 noborder lc rgb variable
}

set lmargin at screen 0.69
set rmargin at screen 0.985
set bmargin at screen 0.36
set border 3
set xtics nomirror out (2.52, 3, 4, 5)
set ytics nomirror out
set grid
set size noratio
set title 'in pairs after 0.1 s under 50 kPa'
set xlabel 'support H / dx' offset 0, 0.5
set ylabel '% of the particles' offset 1.5
set xrange [2.4:5.1]
set yrange [-3:104]
set key at screen 0.985, 0.2 right maxrows 3 samplen 2 spacing 1.1
kernels = 'poly6 gauss cubic-spline quintic-spline wendland-c2 wendland-c4 wendland-c6 spiky seed'
of(i) = strcol(1) eq word(kernels, i) ? $2 : NaN
plot for [i = 1:4] 'clustering.csv' using (of(i)):(100 * $3) with linespoints lw 3 pt 7 ps 1.4 \
        lc rgb pick(i) title word(kernels, i), \
    for [i = 5:9] '' using (of(i)):(100 * $3) with linespoints lw 3 pt 6 ps 1.4 lc rgb pick(5) \
        title i == 5 ? 'wendland-c2, c4, c6' : i == 6 ? "spiky; Toth's two" : ''
unset multiplot
