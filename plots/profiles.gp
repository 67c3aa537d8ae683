# profiles.gp -- what the points of a probe read, along it, at six times of the run
# needs: profiles.csv figures/constants.gp
load 'style.gp'
table = '../profiles.csv'
eval read_names
probes = ''
stats table using (strstrt(probes.' ', ' '.strcol(2).' ') ? 0 : (probes = probes.' '.strcol(2), 1)) \
    skip 2 nooutput
stats table using 1 skip 2 nooutput name 't'
c_value = column_of('value')
times = 6
each = t_max > t_min ? (t_max - t_min) / (times - 1) : 1

# The written time next to the k-th of six, from 0
array near[times]
array off[times]
do for [k = 1:times] { off[k] = 1e300 }
nearer(k, t) = abs(t - t_min - (k - 1) * each) < off[k] ? \
    (off[k] = abs(t - t_min - (k - 1) * each), near[k] = t) : 0
do for [k = 1:times] { stats table using (nearer(k, $1)) skip 2 nooutput }

# Distance from the first point, which each probe begins with at each time
at(d) = column(2 + d)
from(d) = d == 1 ? x1 : d == 2 ? x2 : x3
begin(t) = t != last ? (last = t, x1 = at(1), x2 = at(2), x3 = dim == 3 ? at(3) : 0) : 0
distance(t) = (begin(t), sqrt((at(1) - x1)**2 + (at(2) - x2)**2 \
    + (dim == 3 ? (at(3) - x3)**2 : 0)))
mine(p, k) = strcol(2) eq word(probes, p) && $1 == near[k]

set terminal pngcairo size 1200, 420 * words(probes) + 60 font 'Sans,17'
set output 'profiles.png'
set multiplot layout words(probes), 1 title title noenhanced
set rmargin 16
set key at graph 1.01, 1 left top Left reverse samplen 1.2
set xlabel 'distance along the probe [m]'
do for [p = 1:words(probes)] {
    set ylabel word(probes, p).' [Pa or m/s]' noenhanced
    last = -1
    plot 0 lc rgb grey lw 1 notitle, \
        for [k = 1:times] table using (mine(p, k) ? distance($1) : NaN):(column(c_value)) skip 2 \
        with linespoints pt 7 ps 0.5 lw 2 lc rgb pick(k) title sprintf('%.4g s', near[k])
}
unset multiplot
