# obstacle-tolerance.gp -- error of the tip until 0.3 s against tolerance, beside what the spacing
# and what chance do; the energy defect against work
# needs: tolerances.csv spacings.csv of plots/figures-obstacle.sh, which draws this
load 'style.gp'
methods = 'imex3 imex4 imex5 dv'
is(i) = strcol(1) eq word(methods, i)
# What imex3 with these spacings is off from the finest.
off(d) = real(system(sprintf("awk -F, '$1 == \"imex3\" && int(100 * $2) == %d { print $9 }' \
    spacings.csv", int(100 * d + 0.001))))
# Between these lie runs that differ from the reference by a shift of particles alone.
stats 'tolerances.csv' using (strcol(1) eq 'chance' ? $9 : NaN) skip 1 name 'chance' nooutput
array level[3] = [off(6.08), off(4.05), off(2.97)]
array size[3] = ['6.08', '4.06', '2.98']

set terminal pngcairo size 1500, 700 font 'Sans,17'
set output 'obstacle-tolerance.png'
set multiplot layout 1, 2 margins 0.085, 0.985, 0.14, 0.97 spacing 0.11, 0
set logscale xy
set yrange [3e-4:0.1]
set format xy '10^{%T}'
set ylabel 'error of the tip until 0.3 s, rms over the peak'
set xlabel 'tolerance'
set xrange [4e-6:0.3]
unset key
do for [k = 1:3] {
    set label k ''.(k == 2 ? '↑ ' : '').'dx = '.size[k].' mm against 2 mm' \
        at graph (k == 2 ? 0.5 : 0.02), first level[k] \
        left offset 0, (k == 2 ? -0.6 : 0.6) tc rgb '#606060' font ',14'
}
set object 1 rectangle from graph 0, first chance_min to graph 1, first chance_max behind \
    fs solid noborder fc rgb '#e4e4e4'
set label 4 'grey: chance, a shift of particles by 1e-6 spacings' at graph 0.02, first 7e-4 \
    left tc rgb '#606060' font ',14'
plot for [k = 1:3] level[k] lw 2 dt '-' lc rgb grey notitle, \
    for [i = 1:4] 'tolerances.csv' using (is(i) ? $2 : NaN):9 skip 1 \
    with linespoints lw 2.5 pt 7 ps 1.4 lc rgb pick(i) notitle
unset label
unset object 1
set ylabel 'largest energy defect over the energy at the start'
set yrange [1e-7:1e-3]
set xlabel 'explicit right-hand sides'
set xrange [800:40000]
set xtics (1000, 2000, 5000, 10000, 20000)
set format x '%.0f'
set key top right samplen 2
plot for [i = 1:4] 'tolerances.csv' using (is(i) ? $7 : NaN):6 skip 1 \
    with linespoints lw 2.5 pt 7 ps 1.4 lc rgb pick(i) title word(methods, i)
unset multiplot
