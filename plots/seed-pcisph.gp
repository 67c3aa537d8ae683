# seed-pcisph.gp -- where the iteration of PCISPH converges: gain against support, for one
# kernel and for the two of Toth 2012
# needs: lattice-*.csv, scan-*.csv; drawn by plots/figures-pcisph.sh, not with a run
load 'style.gp'
set terminal pngcairo size 1700, 760 font 'Sans,18'
set output '../seed-pcisph.png'
set datafile separator ','
set xlabel 'support H / spacing'
set ylabel 'gain: what an iteration corrects, of what it should'
set xrange [2.2:4.4]
set yrange [0:3.2]
set key top left
set multiplot layout 1, 2
array density[2] = ['poly6', 'wendland-c2']
array about[2] = ['poly6 for densities, spiky for pressure: Toth 2012', \
    'wendland-c2 for both']
do for [k = 1:2] {
    set title about[k]
    lattice = 'lattice-'.density[k].'.csv'
    scan = 'scan-'.density[k].'.csv'
    plot lattice using 3:7 every ::1 with filledcurves y1=0 fc rgb '#d9ead3' \
            title 'converges on the lattice (shortest waves)', \
        lattice using 3:4 every ::1 with lines lw 3 lc rgb '#1f4e9e' \
            title 'delta of the density kernel', \
        scan using 1:($3 == 1 ? $2 : NaN) every ::1 with points pt 6 ps 2 lw 2 lc rgb '#2e7d32' \
            title 'run: converges', \
        scan using 1:($3 == 0 ? $2 : NaN) every ::1 with points pt 2 ps 2 lw 2 lc rgb '#c0392b' \
            title 'run: diverges'
}
unset multiplot
