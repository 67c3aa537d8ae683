# deflection.gp -- how far tip and middle of every beam are bent, against time
# needs: beam.csv figures/constants.gp
load 'style.gp'
table = '../beam.csv'
eval read_names
end = '.tip_x'
eval choose
beams = ''
do for [k = 1:words(columns)] { beams = beams.' '.stem(word(names, int(word(columns, k)))) }

# Of the two directions the one in which the tip moves more; a beam that hardly moves beside the
# others is seen in that of the one that moves most.
tip(k, axis) = column_of(word(beams, k).'.tip_'.axis)
array moved_x[words(beams)]
array moved_y[words(beams)]
furthest = 0
main_axis = 'x'
do for [k = 1:words(beams)] {
    stats table using (abs(column(tip(k, 'x')))) skip 2 nooutput name 'x'
    stats table using (abs(column(tip(k, 'y')))) skip 2 nooutput name 'y'
    moved_x[k] = x_max
    moved_y[k] = y_max
    own = x_max >= y_max ? x_max : y_max
    if (own > furthest) { furthest = own; main_axis = x_max >= y_max ? 'x' : 'y' }
}
small(k) = moved_x[k] < furthest / 10 && moved_y[k] < furthest / 10
axis_of(k) = small(k) ? main_axis : moved_x[k] >= moved_y[k] ? 'x' : 'y'
place(k, point) = column_of(word(beams, k).'.'.point.'_'.axis_of(k))
label(k, point) = word(beams, k).', '.point.' ('.axis_of(k).')'

set terminal pngcairo size 1200, 750 font 'Sans,18'
set output 'deflection.png'
set title title noenhanced
set xrange [0:until]
set xlabel 'time [s]'
set ylabel 'deflection [mm]'
set key below height 1 samplen 2.5
plot 0 lc rgb grey lw 1 notitle, \
    for [k = 1:words(beams)] table using 1:(1e3 * column(place(k, 'tip'))) skip 2 \
        with lines lw 2.5 lc rgb pick(k) title label(k, 'tip'), \
    for [k = 1:words(beams)] table using 1:(1e3 * column(place(k, 'mid'))) skip 2 \
        with lines lw 2 dt '-' lc rgb pick(k) title label(k, 'mid')
