# view.gp -- six moments of a 3D flow seen from the front, the side and above, what is near drawn
# over what is far; the colour is the speed of the water
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
if (dim == 2) { exit }
legend = 165
picture = 'view'
load 'panels.gp'

# Without perspective: turned by `turn' about the vertical, then tilted by `tilt', as the particles are.
middle_x = (low_x + high_x) / 2
middle_y = (low_y + high_y) / 2
across_of(x, y) = (x - middle_x) * cos(turn) + (y - middle_y) * sin(turn)
away(x, y) = -(x - middle_x) * sin(turn) + (y - middle_y) * cos(turn)
up_of(x, y, z) = z * cos(tilt) + away(x, y) * sin(tilt)
fastest = a > 0 && g > 0 ? 2 * sqrt(g * n2 * a) : end_max > 0 ? end_max : 1

# The edges of the tank, those behind the water first.
edge(n, x1, y1, z1, x2, y2, z2, where) = sprintf( \
    "set arrow %d from %.9g, %.9g to %.9g, %.9g nohead \
    lw 1.2 lc rgb '#808080' %s", n, across_of(x1, y1), up_of(x1, y1, z1), across_of(x2, y2), \
    up_of(x2, y2, z2), where)
do for [i = 0:3] {
    y = i % 2 ? high_y : low_y
    z = i / 2 ? high_z : low_z
    x = i % 2 ? high_x : low_x
    eval edge(1 + i, low_x, y, z, high_x, y, z, i % 2 ? 'back' : 'front')
    eval edge(5 + i, x, low_y, z, x, high_y, z, z == low_z ? 'back' : 'front')
    eval edge(9 + i, x, i / 2 ? high_y : low_y, low_z, x, i / 2 ? high_y : low_y, high_z, \
        i / 2 ? 'back' : 'front')
}

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'view.png'
entries = words(bodies) > 0 ? "'".body_face.":rigid bodies'" : "'".wall.":solids in the tank'"
eval put_scale
eval put_words
set multiplot title title noenhanced
set palette defined (0 '#440154', 1 '#414487', 2 '#2a788e', 3 '#22a884', 4 '#7ad151', 5 '#fde725')
set cbrange [0:fastest]
set cblabel "speed [m/s]\nend: and beyond"
set cbtics
set colorbox user origin screen 1 - (legend - 14.0) / canvas_x, screen 0.15 \
    size screen 24.0 / canvas_x, screen 0.7
# Rows from back to front: on a face of a body (what 0) with the light on it, on an edge (1), water (2)
# with its speed, a wall (3).  Colours by hand: the palette's, and others for solids, in one sweep.
array red[6] = [0x44, 0x41, 0x2a, 0x22, 0x7a, 0xfd]
array green[6] = [0x01, 0x44, 0x78, 0xa8, 0xd1, 0xe7]
array blue[6] = [0x54, 0x87, 0x8e, 0x84, 0x51, 0x25]
lower(s) = s >= 5 ? 5 : 1 + floor(s)
mix(c1, c2, s) = int(c1 + (c2 - c1) * (s - lower(s) + 1))
water(s) = 65536 * mix(red[lower(s)], red[lower(s) + 1], s) \
    + 256 * mix(green[lower(s)], green[lower(s) + 1], s) + mix(blue[lower(s)], blue[lower(s) + 1], s)
lit(p) = 65536 * int(217 * p) + 256 * int(160 * p) + int(102 * p)
rgb(what, v) = what == 0 ? lit(v) : what == 1 ? 0x2a1808 : what == 3 ? 0xa6a6a6 : \
    water(v > fastest ? 5.0 : 5 * v / fastest)
if (dyes < 0) { unset colorbox }
do for [m = 1:moments] {
    eval next_panel
    plot file using 1:2:3:(rgb($4, $5)) skip 3 with circles fs solid noborder lc rgb variable notitle, \
        NaN with points lc palette notitle
    eval take_away
    unset colorbox
}
unset multiplot
