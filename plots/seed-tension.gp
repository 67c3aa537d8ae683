# seed-tension.gp -- a summed density with and without tension, and the density that evolves
# needs: the runs of plots/figures-seed.sh, which draws this
load 'style.gp'
dx = 3.3333333333333333e-3
r = 0.65 * dx
dye(c) = c == 0 ? 0x1f6fb4 : 0xf2c418
runs = 'tension tension-one no-tension continuity'
array what[4] = ["two kernels, tension: as printed", 'one kernel (wendland-c2), tension', \
    'two kernels, no tension', 'density that evolves, adami walls']
set datafile columnheaders

set terminal pngcairo size 1640, 660 font 'Sans,16'
set output '../seed-tension.png'
set multiplot layout 1, 4 title "dam break of Toth (2012) at 0.1 s, 1,800 particles"
set border 0
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.01:0.27]
set yrange [-0.01:0.33]
set lmargin 1
set rmargin 1
set tmargin 3
set bmargin 5
set object 1 polygon from -0.003, 0.33 to -0.003, -0.003 to 0.27, -0.003 to 0.27, -0.009 \
    to -0.009, -0.009 to -0.009, 0.33 to -0.003, 0.33 fs solid noborder fc rgb '#a6a6a6'
do for [i = 1:4] {
    run = word(runs, i)
    stats 'tension.csv' using (start = column('energy_initial'), kinetic = column('kinetic'), \
        pairing = column('pairing'), 0) every ::i-1::i-1 nooutput
    stats run.'/snapshots.csv' using (file = run.'/'.strcol(2), 0) skip 1 nooutput
    set title what[i]
    set label 1 sprintf("energy at t = 0: %.0f J/m\nkinetic now: %.3g J/m\nin pairs: %.2g %%", \
        start, kinetic, 100 * pairing) at graph 0.05, graph 0 offset 0, -1.2
    plot file using (column('kind') == 0 ? $1 : NaN):2:(r):(dye(column('dye'))) skip 2 \
        with circles fs solid noborder lc rgb variable
}
unset multiplot
