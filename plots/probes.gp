# probes.gp -- what the gauges read against time: pressures, heights of the water, speeds; at most
# four in a panel
# needs: probes.csv figures/constants.gp
load 'style.gp'
table = '../probes.csv'
load 'filtered.gp'
units = system("sed -n 's/^# units: //p;q' ".table)
units_apart = ''
do for [i = 1:strlen(units)] { units_apart = units_apart.(units[i:i] eq ',' ? ' ' : units[i:i]) }
unit(i) = word(units_apart, i)

# Columns of the panels: of one unit each, without the means that are columns themselves.
kinds = 'Pa m m/s'
array label[3] = ['pressure [kPa]', 'level of the water [m]', 'speed [m/s]']
array scale[3] = [1e-3, 1, 1]
array members[300]
array kind_of[300]
panels = 0
longest = 0
do for [k = 1:3] {
    in_it = 4
    do for [i = 2:words(names)] {
        if (unit(i) eq word(kinds, k) && !ends_in(word(names, i), '.mean') && panels < 300) {
            if (in_it == 4) { panels = panels + 1; members[panels] = ''; kind_of[panels] = k; in_it = 0 }
            members[panels] = members[panels].' '.i
            in_it = in_it + 1
            width = strlen(word(names, i))
            longest = width > longest ? width : longest
        }
    }
}
# A running mean of the run's own, over the window of its probe, is shown as it is.
own(i) = column_of(word(names, i).'.mean')
called_of(i) = word(names, i).(own(i) ? ' (.mean)' : '')
thick(i) = own(i) ? (middle = $1, column(own(i))) : mean($0, $1, area($0, $1, column(i)))

each = panels > 1 ? 330.0 : 500.0
tall = 60 + each * panels + 110
set terminal pngcairo size 1250, tall font 'Sans,17'
set output 'probes.png'
set multiplot title title noenhanced
set lmargin at screen 0.105
set rmargin at screen 0.86 - 0.008 * longest
set xrange [0:until]
set key at graph 1.01, 1 left top Left reverse samplen 1.2
eval foot
do for [panel = 1:panels] {
    eval place
    if (panel == 2) { unset label 11; unset label 12 }
    gauges = members[panel]
    factor = scale[kind_of[panel]]
    eval start_limits
    do for [g in gauges] {
        stats table using (widen(factor * thick(g + 0))) skip 2 nooutput
    }
    eval limits
    cut = ''
    do for [g in gauges] {
        c = g + 0
        called = word(names, c)
        eval beyond
    }
    set label 1 strlen(cut) ? 'beyond the axis: '.cut : '' at graph 0.01, 0.04 left noenhanced \
        font ',12' tc rgb '#606060'
    set ylabel label[kind_of[panel]] offset 1, 0
    set yrange [low:high]
    plot 0 lc rgb grey lw 1 notitle, \
        for [j = 1:words(gauges)] table using 1:(factor * column(word(gauges, j) + 0)) skip 2 \
        with lines lw 1 lc rgb faint(j) notitle, \
        for [j = 1:words(gauges)] table \
        using (v = factor * thick(word(gauges, j) + 0), middle):(v) skip 2 \
        with lines lw 3 lc rgb pick(j) title called_of(word(gauges, j) + 0)
}
unset multiplot
