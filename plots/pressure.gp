# pressure.gp -- six moments of the pressure in the water
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
legend = 165
load 'panels.gp'
if (dyes < 0) { exit }   # no water

# One scale for all moments, that no single particle and no single impact sets: the mean over the
# moments of the pressures below and above which 1 of 40 particles of the fluid is.  Above, no less
# than the weight of the column.
highest = p_high / 1e3
lowest = p_low / 1e3
heavy = a > 0 && g > 0 ? rho0 * g * n2 * a / 1e3 : 0
highest = highest > heavy ? highest : heavy > 0 ? heavy : 1
lowest = lowest < -highest / 50 ? lowest : 0

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'pressure.png'
entries = solids
eval put_scale
eval put_words
set multiplot title heading noenhanced
# Tension has colours of its own; particles beyond an end of the scale have the colour of the end.
low = 5 * lowest / highest
set palette defined (0 '#440154', 1 '#414487', 2 '#2a788e', 3 '#22a884', 4 '#7ad151', 5 '#fde725')
if (lowest < 0) { set palette defined (low '#d73027', low / 500 '#fdbfae', 0 '#440154', \
    1 '#414487', 2 '#2a788e', 3 '#22a884', 4 '#7ad151', 5 '#fde725') }
set cbrange [lowest:highest]
set cblabel 'pressure [kPa]'.(lowest < 0 ? ', red: tension' : '')."\nends: and beyond"
set cbtics
set colorbox user origin screen 1 - (legend - 14.0) / canvas_x, screen 0.15 \
    size screen 24.0 / canvas_x, screen 0.7
do for [m = 1:moments] {
    eval next_panel
    plot file using (is(1)):up:(r) skip 3 with circles fs solid noborder lc rgb wall notitle, \
        file using (is(0)):up:(r):(column(p_column) / 1e3) skip 3 \
        with circles fs solid noborder lc palette notitle, \
        file using (beams eq '' && shapes ne '' ? NaN : is(3)):up:(r_skin) skip 3 with circles fs solid noborder lc rgb skin notitle@bodies_too
    unset colorbox
    eval take_away
}
unset multiplot
