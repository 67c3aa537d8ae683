# bodies.gp -- where the centre of every rigid body goes and how far it turns, against time
# needs: bodies.csv figures/constants.gp
load 'style.gp'
table = '../bodies.csv'
eval read_names
end = dim == 2 ? '.angle' : '.qw'
eval choose
bodies = ''
do for [k = 1:words(columns)] { bodies = bodies.' '.stem(word(names, int(word(columns, k)))) }
axes = dim == 2 ? 'x y' : 'x y z'
at(k, axis) = column_of(word(bodies, k).'.'.axis)
turn(k) = column_of(word(bodies, k).end)
# In space: the angle of the turn from where it stood not turned at all.
degrees(v) = 180 / pi * (dim == 2 ? v : 2 * acos(abs(v) < 1 ? abs(v) : 1))

set terminal pngcairo size 1200, 1000 font 'Sans,18'
set output 'bodies.png'
set multiplot layout 2, 1 title title noenhanced
set xrange [0:until]
set rmargin 18
set key outside right top Left reverse samplen 2
# What a legend has no room for is told by the colours alone.
if (words(bodies) > 6) { unset key; set rmargin 3 }
set ylabel 'centre [m]'
plot for [k = 1:words(bodies)] for [d = 1:words(axes)] table using 1:(column(at(k, word(axes, d)))) skip 2 \
    with lines lw 2.5 dt d lc rgb pick(k) title word(bodies, k).', '.word(axes, d)
set xlabel 'time [s]'
set ylabel 'turned by [deg]'
plot 0 lc rgb grey lw 1 notitle, \
    for [k = 1:words(bodies)] table using 1:(degrees(column(turn(k)))) skip 2 \
        with lines lw 2.5 lc rgb pick(k) title word(bodies, k)
unset multiplot
