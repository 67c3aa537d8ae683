# floor.gp -- six moments of the water that runs along the floor of a 3D tank, from above; the
# colour is the speed
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
if (dim == 2) { exit }
picture = 'floor'
legend = 165
load 'panels.gp'
speed(a, b, c) = sqrt(a ** 2 + b ** 2 + c ** 2)

# One scale for all moments: the front of a shallow dam break, or what runs fastest in the end.
fastest = a > 0 && g > 0 ? 2 * sqrt(g * n2 * a) : end_max > 0 ? end_max : 1

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'floor.png'
entries = solids
eval put_scale
eval put_words
set multiplot title heading noenhanced
set palette defined (0 '#440154', 1 '#414487', 2 '#2a788e', 3 '#22a884', 4 '#7ad151', 5 '#fde725')
set cbrange [0:fastest]
set cblabel "speed [m/s]\nend: and beyond"
set cbtics
set colorbox user origin screen 1 - (legend - 14.0) / canvas_x, screen 0.15 \
    size screen 24.0 / canvas_x, screen 0.7
if (dyes < 0) { unset colorbox }
do for [m = 1:moments] {
    eval next_panel
    plot file using (is(1)):up:(r) skip 3 with circles fs solid noborder lc rgb wall notitle, \
        file using (is(0)):up:(r):(speed($4, $5, $6)) skip 3 \
        with circles fs solid noborder lc palette notitle@bodies_too
    unset colorbox
    eval take_away
}
unset multiplot
