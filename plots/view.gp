# view.gp -- six moments of a 3D flow seen from the front, the side and above, what is near drawn
# over what is far; the colour is the speed of the water
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
if (dim == 2) { exit }
legend = 165
load 'panels.gp'

# Without perspective: turned by `turn' about the vertical, then tilted by `tilt'.
turn = 25 * pi / 180
tilt = 20 * pi / 180
middle_x = (low_x + high_x) / 2
middle_y = (low_y + high_y) / 2
across_of(x, y) = (x - middle_x) * cos(turn) + (y - middle_y) * sin(turn)
away(x, y) = -(x - middle_x) * sin(turn) + (y - middle_y) * cos(turn)
up_of(x, y, z) = z * cos(tilt) + away(x, y) * sin(tilt)
far(x, y, z) = away(x, y) * cos(tilt) - z * sin(tilt)

# The picture has other sides than the tank.
half_x = (high_x - low_x) / 2
half_y = (high_y - low_y) / 2
side = half_x * cos(turn) + half_y * sin(turn)
back = half_x * sin(turn) + half_y * cos(turn)
left = -side - rim
right = side + rim
bottom = low_z * cos(tilt) - back * sin(tilt) - rim
above = high_z * cos(tilt) + back * sin(tilt) + rim
drawn_y = drawn_x * (above - bottom) / (right - left)
if (drawn_y > 900) { drawn_x = drawn_x * 900 / drawn_y; drawn_y = 900; panel_x = drawn_x + 24 }
panel_y = drawn_y + 52
canvas_x = int(across * panel_x + 24 + legend)
canvas_y = int(down * panel_y + 56 + strip)
bar = round_down((right - left) / 4)
bar_x = bar / (right - left) * drawn_x
strip_y = (strip / 2.0) / canvas_y
set xrange [left:right]
set yrange [bottom:above]

# To sort particles by their distance, each is one number: its place in the picture to a 4000th, and
# its speed to a 200th.  Solids have the speed 255; those of the tank itself are not shown.  Surfaces of
# rigid bodies are points among them, from 210, dark, to 250, bright: those that look this way; 205
# along their edges.
speed(a, b, c) = sqrt(a ** 2 + b ** 2 + c ** 2)
fastest = a > 0 && g > 0 ? 2 * sqrt(g * n2 * a) : 0
if (fastest == 0) {
    eval 'm = moments; '.next_panel
    set xrange [*:*]
    set yrange [*:*]
    stats file using (sort(column(kind_column)) == 0 ? speed($4, $5, $6) : NaN) skip 3 \
        nooutput name 'end'
    fastest = end_max > 0 ? end_max : 1
}
part(v, low, high) = v < low ? 0 : v > high ? 4000 : floor(4000 * (v - low) / (high - low))
shade(v) = v > fastest ? 200 : floor(200 * v / fastest)
inside(x, y, z) = x > low_x && x < high_x && y > low_y && y < high_y && z > low_z && z < high_z
kind_shown(k, x, y, z) = sort(k) == 0 || inside(x, y, z)
# Light falls from above and the left in front.
light(x, y, z) = (p = -0.45 * x - 0.5 * y + 0.74 * z, 210 + floor(40 * (0.35 + 0.65 * (p > 0 ? p : 0))))

packed(x, y, z, s) = (4096.0 * part(across_of(x, y), left, right) \
    + part(up_of(x, y, z), bottom, above)) * 256 + s
pick_x(v) = left + floor(v / 1048576) / 4000.0 * (right - left)
pick_y(v) = bottom + (floor(v / 256) - 4096.0 * floor(v / 1048576)) / 4000 * (above - bottom)
pick_s(v) = v - 256 * floor(v / 256)
tilted(x, y, z) = (y * cos(turn) - x * sin(turn)) * cos(tilt) - z * sin(tilt)
# Without bodies the rows are particles; with bodies those of one file that has both, column 7: on a
# face, 0, an edge, 1, or a particle of the fluid, 2, or of a wall, 3.  `smooth unique` sorts; a row that
# is left out would part the list into lists, so what is not shown is drawn behind all, without size.
hidden = 206
shaped = words(bodies) > 0
source(name) = shaped ? name[1:strlen(name) - 4].'-surface.csv' : name
is_shown(what) = !shaped ? kind_shown(column(kind_column), $1, $2, $3) \
    : what == 3 ? inside($1, $2, $3) : what == 2 || tilted($4, $5, $6) < 0
tone(what) = !shaped ? (sort(column(kind_column)) == 0 ? shade(speed($4, $5, $6)) : 255) \
    : what == 0 ? light($4, $5, $6) : what == 1 ? 205 : what == 2 ? shade(speed($4, $5, $6)) : 255
nearer(what) = shaped && what < 2 ? (0.3 + 0.3 * what) * dx : 0
sort_now = "set xrange [*:*]; set yrange [*:*]; set format xy '%.16g'; set table $sorted; \
    plot source(file) using ((is_shown($7) ? nearer($7) - far($1, $2, $3) : -1e6 * dx) + 1e-9 * dx * $0): \
        (packed($1, $2, $3, is_shown($7) ? tone($7) : hidden)) skip 3 smooth unique; \
    unset table; set xrange [left:right]; set yrange [bottom:above]"

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
# Colours by hand: the palette's, and grey for solids, in one sweep from back to front.
array red[6] = [0x44, 0x41, 0x2a, 0x22, 0x7a, 0xfd]
array green[6] = [0x01, 0x44, 0x78, 0xa8, 0xd1, 0xe7]
array blue[6] = [0x54, 0x87, 0x8e, 0x84, 0x51, 0x25]
lower(s) = s >= 200 ? 5 : 1 + floor(s / 40)
mix(c1, c2, s) = int(c1 + (c2 - c1) * (s / 40.0 - lower(s) + 1))
lit(s) = (p = (s - 210) / 40.0, 65536 * int(217 * p) + 256 * int(160 * p) + int(102 * p))
rgb(s) = s > 250 ? 0xa6a6a6 : s == 205 ? 0x2a1808 : s >= 210 ? lit(s) : 65536 * mix(red[lower(s)], red[lower(s) + 1], s) \
    + 256 * mix(green[lower(s)], green[lower(s) + 1], s) \
    + mix(blue[lower(s)], blue[lower(s) + 1], s)
radius(s) = s == hidden ? 0 : s == 205 ? 0.12 * dx : s >= 210 && s < 255 ? 0.3 * dx : r
do for [m = 1:moments] {
    eval next_panel
    eval sort_now
    set datafile separator whitespace
    plot $sorted using (pick_x($2)):(pick_y($2)):(radius(pick_s($2))):(rgb(pick_s($2))) \
        with circles fs solid noborder lc rgb variable notitle, \
        NaN with points lc palette notitle
    set datafile separator ','
    eval take_away
    unset colorbox
}
unset multiplot
