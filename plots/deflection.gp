# deflection.gp -- how far tip and middle of every beam are bent, against time
# needs: beam.csv figures/constants.gp
load 'style.gp'
table = '../beam.csv'
eval read_names
end = '.tip_x'
eval choose
beams = ''
do for [k = 1:words(columns)] { beams = beams.' '.stem(word(names, int(word(columns, k)))) }

# Of the two directions the one in which the tip moves more.
across = ''
do for [k = 1:words(beams)] {
    stats table using (abs(column(column_of(word(beams, k).'.tip_x')))) skip 2 nooutput name 'x'
    stats table using (abs(column(column_of(word(beams, k).'.tip_y')))) skip 2 nooutput name 'y'
    across = across.(x_max >= y_max ? ' x' : ' y')
}
place(k, point) = column_of(word(beams, k).'.'.point.'_'.word(across, k))
label(k, point) = word(beams, k).', '.point.' ('.word(across, k).')'

set terminal pngcairo size 1200, 750 font 'Sans,18'
set output 'deflection.png'
set title title noenhanced
set xrange [0:until]
set xlabel 'time [s]'
set ylabel 'deflection [mm]'
set key top right samplen 2.5
plot 0 lc rgb grey lw 1 notitle, \
    for [k = 1:words(beams)] table using 1:(1e3 * column(place(k, 'tip'))) skip 2 \
        with lines lw 2.5 lc rgb pick(k) title label(k, 'tip'), \
    for [k = 1:words(beams)] table using 1:(1e3 * column(place(k, 'mid'))) skip 2 \
        with lines lw 2 dt '-' lc rgb pick(k) title label(k, 'mid')
