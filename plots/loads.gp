# loads.gp -- forces of a table, a panel for each wall, beam or part; `table' and `picture' are
# given by the script that loads this
load 'filtered.gp'
end = '.fx'
eval choose
rigid = exists('bodies') ? bodies : ''
masses = exists('masses') ? masses : ''   # an older version did not say
bodies = ''
do for [k = 1:words(columns)] { bodies = bodies.' '.stem(word(names, int(word(columns, k)))) }
panels = words(bodies)
# Its own weight is what a force on a rigid body is held against; 0 for what is none.
weight_of(name) = words(masses) < words(rigid) ? 0 : \
    sum [i = 1:words(rigid)] (word(rigid, i) eq name ? g * word(masses, i) : 0)
force_of(b, d) = column_of(word(bodies, b).word('.fx .fy .fz', d))
impulse_of(b, d) = column_of(word(bodies, b).word('.ix .iy .iz', d))

each = 300.0
tall = 60 + each * panels + 110
set terminal pngcairo size 1200, tall font 'Sans,17'
set output picture
set multiplot title title noenhanced
set lmargin at screen 0.13
set rmargin at screen 0.9
set xrange [0:until]
set key at graph 1.01, 1 left top Left reverse samplen 1.2
eval foot
do for [panel = 1:panels] {
    eval place
    if (panel == 2) { unset label 11; unset label 12 }
    eval start_limits
    # directions in which there is more than what chance makes of a symmetric flow
    array most[3]
    largest = 0
    do for [d = 1:dim] {
        c = force_of(panel, d)
        stats table using (abs(column(c))) skip 2 nooutput name 'f'
        most[d] = f_max
        largest = f_max > largest ? f_max : largest
    }
    shown = ''
    do for [d = 1:dim] { if (most[d] >= 1e-3 * largest && largest > rounding) { shown = shown.' '.d } }
    none = shown eq ''
    if (none) { shown = '1' }
    factor = largest >= 1e5 ? 1e-3 : 1
    do for [d in shown] {
        c = impulse_of(panel, d + 0)
        stats table using (widen(factor * mean($0, $1, column(c)))) skip 2 nooutput
    }
    weight = factor * weight_of(word(bodies, panel))
    weight = none || weight > 4 * factor * largest ? 0 : weight
    if (weight > 0) { weight = widen(weight) }
    if (none) { low = 0; high = 0 }
    eval limits
    cut = ''
    do for [d in shown] {
        c = force_of(panel, d + 0)
        called = word('x y z', d + 0)
        eval beyond
    }
    set label 1 strlen(cut) ? 'beyond the axis: '.cut : '' at graph 0.01, 0.06 left noenhanced \
        font ',12' tc rgb '#606060'
    set key title word(bodies, panel) noenhanced
    set ylabel 'force ['.(factor < 1 ? 'k' : '').(dim == 2 ? 'N/m]' : 'N]')
    set yrange [low:high]
    plot 0 lc rgb grey lw 1 notitle, \
        (weight > 0 ? weight : NaN) with lines dt '-' lw 1.5 lc rgb '#404040' \
            title (weight > 0 ? 'm g' : ''), \
        for [d in shown] table using 1:(factor * column(force_of(panel, d + 0))) skip 2 \
        with lines lw 1 lc rgb faint(d + 0) notitle, \
        for [d in shown] table \
        using (v = mean($0, $1, column(impulse_of(panel, d + 0))), middle):(factor * v) skip 2 \
        with lines lw 3 lc rgb pick(d + 0) title word('x y z', d + 0)
}
unset multiplot
