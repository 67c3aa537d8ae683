# obstacle-history.gp -- tip, force and impulse of the obstacle against time, at three spacings,
# and the tip of six other codes
# needs: the runs of plots/figures-obstacle.sh, which draws this
load 'style.gp'
runs = '36 49 73'
array size[3] = ['4.06 mm', '2.98 mm', '2.00 mm']
codes = 'pfem_idelsohn2008 mps_dem_sun2019 fem_ryzhakov2010 '.\
    'qn_ls_bogaers2016 sph_liu2013 fem_meduri2018'
array by[6] = ['PFEM, Idelsohn 2008', 'MPS-DEM, Sun 2019', 'FEM, Ryzhakov 2010', \
    'FV, Bogaers 2016', 'SPH, Liu 2013', 'FEM, Meduri 2018']
array shade[6] = ['#b0b0b0', '#8c8c8c', '#b8a080', '#80a0b8', '#a8c0a0', '#c0a0b8']
is(i) = strcol(1) eq word(codes, i) ? $2 : NaN
rows = 25      # of 0.2 ms: the force is a mean over 5 ms, from the impulse
array past[25]
at = 0
mean(ix) = (at = at % rows + 1, before = past[at], past[at] = ix, \
    before == before ? (ix - before) / (rows * 2e-4) : NaN)
start(i) = sum [k = 1:25] (past[k] = NaN, 0)

set terminal pngcairo size 1300, 1250 font 'Sans,17'
set output 'obstacle-history.png'
set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.74
set xrange [0.1:0.7]
set key at screen 0.76, graph 1 left top Left reverse samplen 1.8 spacing 1.15

set tmargin at screen 0.985
set bmargin at screen 0.52
set xtics format ''
set ylabel 'tip moves by [mm]'
set yrange [-25:52]
plot for [i = 1:6] 'C03_dambreak_elastic_obstacle_tip.csv' using (is(i)):(1000 * $3) skip 4 \
        with lines lw 1.8 lc rgb shade[i] title by[i], \
    for [i = 1:3] 'story-'.word(runs, i).'/beam.csv' using 1:(1000 * $2) skip 2 \
        with lines lw 2.5 lc rgb pick(i) title 'here, dx = '.size[i]

set tmargin at screen 0.49
set bmargin at screen 0.29
set ylabel 'force along x [N/m]'
set yrange [*:*]
plot for [i = 1:3] 'story-'.word(runs, i).'/forces.csv' \
    using ($0 == 0 ? (start(0), NaN) : $1 - 2.5e-3):(mean(column('obstacle.ix'))) skip 1 \
    with lines lw 2 lc rgb pick(i) title 'dx = '.size[i]

set tmargin at screen 0.26
set bmargin at screen 0.075
set xtics format '%g'
set xlabel 't [s]'
set ylabel 'impulse along x [N s/m]'
plot for [i = 1:3] 'story-'.word(runs, i).'/forces.csv' using 1:(column('obstacle.ix')) skip 1 \
    with lines lw 2 lc rgb pick(i) title 'dx = '.size[i]
unset multiplot
