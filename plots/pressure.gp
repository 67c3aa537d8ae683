# pressure.gp -- six moments of the pressure in the water
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
legend = 150
load 'panels.gp'

# One scale for all moments: the weight of the column, or what pressure there is at the start.
eval 'm = 1; '.next_panel
set yrange [*:*]
stats file using (sort(column(kind_column)) == 0 ? column(p_column) / 1e3 : NaN) skip 3 \
    nooutput name 'start'
set yrange [bottom:above]
highest = a > 0 && g > 0 ? rho0 * g * n2 * a / 1e3 : start_max > 0 ? start_max : 1

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'pressure.png'
set multiplot title heading noenhanced
# Tension has colours of its own; particles beyond an end of the scale have the colour of the end.
set palette defined (-2.5 '#d73027', -0.01 '#fdbfae', 0 '#440154', 1 '#414487', 2 '#2a788e', \
    3 '#22a884', 4 '#7ad151', 5 '#fde725')
set cbrange [-highest / 2:highest]
set cblabel 'pressure [kPa], red: tension, ends: and beyond'
set cbtics
set colorbox user origin screen 1 - (legend - 14.0) / canvas_x, screen 0.15 \
    size screen 24.0 / canvas_x, screen 0.7
do for [m = 1:moments] {
    eval next_panel
    plot file using (is(1)):up:(r) skip 3 with circles fs solid noborder lc rgb wall notitle, \
        file using (is(0)):up:(r):(column(p_column) / 1e3) skip 3 \
        with circles fs solid noborder lc palette notitle, \
        file using (is(3)):up:(r) skip 3 with circles fs solid noborder lc rgb skin notitle
    unset colorbox
}
unset multiplot
