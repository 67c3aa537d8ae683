# seed-fsi.gp -- how far the beam of toth-fsi bends, by PCISPH in turn with the beam and by WCSPH in
# turn and in one right-hand side
# needs: fsi-METHOD/beam.csv; drawn by plots/figures-pcisph.sh, not with a run
load 'style.gp'
set terminal pngcairo size 1000, 620 font 'Sans,17'
set output '../seed-fsi.png'
set datafile separator ','
set xlabel 't [s]'
set ylabel 'tip, along the flow [mm]'
set xrange [0.1:0.4]
set yrange [0:3]
set rmargin 4
set key top right
tip(m) = "'fsi-".m."/beam.csv' using 1:(1000 * column('plate.tip_x')) skip 1 with lines lw 3"
array names[4] = ['pcisph@0.2', 'pcisph@0.05', 'staggered', 'imex3']
array about[4] = ['PCISPH, in turn', 'PCISPH, a quarter of the step', 'WCSPH, in turn (Toth 2012)', \
    'WCSPH, one right-hand side']
eval 'plot '.tip(names[1])." dt 1 lc rgb pick(1) title about[1], " \
    .tip(names[2])." dt 4 lc rgb pick(1) title about[2], " \
    .tip(names[3])." dt 2 lc rgb pick(2) title about[3], " \
    .tip(names[4])." dt 1 lc rgb pick(3) title about[4]"
