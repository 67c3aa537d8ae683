# bodies.gp -- how far the centre of every rigid body has gone and how far it has turned, against time
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
# How far from where it stood, row i from 0; and where that was, for the legend.
way(i, v) = (i == 0 ? (from = v) : 0, v - from)
many = words(bodies) > 6
array first[words(bodies) * words(axes)]
place(k, d) = (k - 1) * words(axes) + d
if (!many) {
    do for [k = 1:words(bodies)] {
        do for [d = 1:words(axes)] {
            stats table using (start = column(at(k, word(axes, d))), 0) skip 2 every ::0::0 nooutput
            first[place(k, d)] = start
        }
    }
}
say(k, d) = many ? '' : sprintf('%s, %s from %.4g', word(bodies, k), word(axes, d), first[place(k, d)])
# In space: the angle of the turn from where it stood not turned at all.
degrees(v) = 180 / pi * (dim == 2 ? v : 2 * acos(abs(v) < 1 ? abs(v) : 1))

set terminal pngcairo size 1200, 1000 font 'Sans,18'
set output 'bodies.png'
set multiplot layout 2, 1 title title noenhanced
set xrange [0:until]
set lmargin 14
set rmargin 25
set key outside right top Left reverse samplen 2 maxcols 1
# A long legend is small; what it has no room for is told by the colours alone.
lines = words(bodies) * words(axes)
if (lines > 12) { set key font ',12' spacing 0.8 }
if (many) { unset key; set rmargin 3 }
# Less than that is rounding.
set yrange [*<-1e-6:1e-6<*]
set ylabel 'way of the centre [m]'
plot 0 lc rgb grey lw 1 notitle, \
    for [k = 1:words(bodies)] for [d = 1:words(axes)] \
        table using 1:(way($0, column(at(k, word(axes, d))))) skip 2 \
        with lines lw 2.5 dt d lc rgb pick(k) title say(k, d)
set xlabel 'time [s]'
set yrange [*<-1e-3:1e-3<*]
set ylabel 'turned by [deg]'
plot 0 lc rgb grey lw 1 notitle, \
    for [k = 1:words(bodies)] table using 1:(degrees(column(turn(k)))) skip 2 \
        with lines lw 2.5 lc rgb pick(k) title word(bodies, k)
unset multiplot
