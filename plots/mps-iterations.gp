# mps-iterations.gp -- products of a solve against particles, in the method mps
# needs: ic0-1.csv, ic0-0.85.csv and, where there are any, multigrid-1.csv, multigrid-0.85.csv of
# plots/figures-mps.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 900, 560 font 'Sans,17'
set output '../mps-iterations.png'
set logscale x
set xrange [500:200000]
set yrange [0:100]
set rmargin 5
set xlabel 'particles of the fluid'
set ylabel 'products a solve'
set key top left Left reverse
grow(n) = 18.9 * sqrt(n / 800.0)
array which[4] = ['ic0-0.85', 'ic0-1', 'multigrid-0.85', 'multigrid-1']
array says[4] = ['IC(0), γ = 0.85', 'IC(0), γ = 1', 'multigrid, γ = 0.85', 'multigrid, γ = 1']
there(i) = system('test -s '.which[i].'.csv && echo 1 || echo 0') + 0
table(i) = there(i) ? which[i].'.csv' : 'ic0-1.csv'
key_of(i) = there(i) ? says[i] : ''
shown(i) = there(i) ? 1 : NaN
dash(i) = i % 2 ? 2 : 1
plot for [i = 1:4] table(i) using 1:($2 * shown(i)) with linespoints lw 2 ps 1.4 \
        pt (i > 2 ? 5 : 7) dt dash(i) lc rgb pick(i > 2 ? 2 : 1) title key_of(i), \
    grow(x) with lines lw 1.5 dt 3 lc rgb grey title 'as √N'
