# probes.gp -- what the gauges read against time: pressures, heights of the water, speeds
# needs: probes.csv figures/constants.gp
load 'style.gp'
table = '../probes.csv'
eval read_names
units = system("sed -n 's/^# units: //p;q' ".table)
unit(i) = word(units_apart, i)
units_apart = ''
do for [i = 1:strlen(units)] { units_apart = units_apart.(units[i:i] eq ',' ? ' ' : units[i:i]) }

# `eval choose_unit` leaves in `columns` the gauges that read in `wanted`.
choose_unit = "columns = ''; do for [i = 2:words(names)] { \
    if (unit(i) eq wanted) { columns = columns.' '.i } }"
kinds = 'Pa m m/s'
array label[3] = ['pressure [kPa]', 'height of the water [m]', 'speed [m/s]']
array scale[3] = [1e-3, 1, 1]
shown = ''
do for [k = 1:3] {
    wanted = word(kinds, k)
    eval choose_unit
    if (words(columns) > 0) { shown = shown.' '.k }
}
longest = 0
do for [i = 2:words(names)] {
    longest = strlen(word(names, i)) > longest ? strlen(word(names, i)) : longest
}

set terminal pngcairo size 1200, 440 * words(shown) + 60 font 'Sans,18'
set output 'probes.png'
set multiplot layout words(shown), 1 title title noenhanced
set lmargin 11
set rmargin longest + 7
set xrange [0:until]
set key at graph 1.01, 1 left top Left reverse samplen 1.5
do for [panel = 1:words(shown)] {
    k = int(word(shown, panel))
    wanted = word(kinds, k)
    eval choose_unit
    set ylabel label[k]
    set xlabel panel == words(shown) ? 'time [s]' : ''
    n(j) = int(word(columns, j))
    plot 0 lc rgb grey lw 1 notitle, \
        for [j = 1:words(columns)] table using 1:(scale[k] * column(n(j))) skip 2 \
        with lines lw 2 dt 1 + (j > 7) lc rgb pick(j) title word(names, n(j))
}
unset multiplot
