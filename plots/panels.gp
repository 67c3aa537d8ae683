# panels.gp -- for figures of particles at several moments: which moments, and where each stands.
# Loaded after style.gp; the loop over panels then does `eval next_panel`.  A 3D tank is shown cut
# in the middle, or, with picture = 'floor' set before, what runs along its floor.
#
# What is seen of the particles, moments and corners of the pictures are prepared by `stiffwater plot`:
# shots.gp, shots.csv, cut-1.csv and so on, beside this file.
load 'shots.gp'
picture = exists('picture') ? picture : 'cut'
wall = '#a6a6a6'
skin = '#101010'
covers = 0.75 * value(picture.'_pixel')
r = 0.65 * dx > covers ? 0.65 * dx : covers   # particles touch
dye(c) = c == 0 ? 0x1f6fb4 : c == 1 ? 0xf2c418 : 0x009e73
from_above = picture eq 'floor'
up = from_above ? 2 : dim   # the column that goes up in the picture; first is x
p_column = 2 * dim + 2
dye_column = 2 * dim + 3
kind_column = 2 * dim + 4
# x of a particle if it is fluid (0), wall (1, 2) or the skin of a beam or body (3, 4)
sort(kind) = kind == 0 ? 0 : kind < 3 ? 1 : 3
# Rigid bodies are drawn as shapes, each with its edge, over the particles that make it.
bodies = exists('bodies') ? bodies : ''
body_face = '#d9a066'
body_edge = '#5a3210'
beams = exists('beams') ? beams : ''
r_skin = words(bodies) == 0 ? r : 0.5 * dx
# From above they lie over each other: one face after the other, each with its edge.
shapes = words(bodies) == 0 ? '' : from_above ? "sprintf('floor-bodies-%d.csv', m) index i - 1" : \
    "shot.'".(dim == 2 ? '-bodies' : '-cut').".csv'"
bodies_too = shapes eq '' ? '' : ", ".(from_above ? "for [i = 1:faces] " : '').shapes \
    ." using 1:".(up == 2 ? 2 : 3)." skip 3 \
    with filledcurves closed fs solid 1 border lc rgb body_edge lw 2 fc rgb body_face notitle"
is(what) = sort(column(kind_column)) == what ? $1 : NaN
heading = title.(dim == 2 ? '' : from_above ? ', the floor from above' : ', cut in the middle')

# Panels of equal scale; the canvas takes the shape of the tank.
left = value(picture.'_left')
right = value(picture.'_right')
bottom = value(picture.'_bottom')
above = value(picture.'_above')
across = int(value(picture.'_across'))
down = (moments + across - 1) / across
panel_x = 1560 / across
drawn_x = panel_x - 24
drawn_y = drawn_x * (above - bottom) / (right - left)
if (drawn_y > 900) { drawn_x = drawn_x * 900 / drawn_y; drawn_y = 900.0; panel_x = drawn_x + 24 }
legend = exists('legend') ? legend : 0   # pixels at the right, for a colour box
panel_y = drawn_y + 52
canvas_x = int(across * panel_x + 24 + legend)
strip = 50                               # pixels below, for scale and legend
canvas_y = int(down * panel_y + 56 + strip)

set border 0
unset tics
unset grid
unset key
set size noratio
set xrange [left:right]
set yrange [bottom:above]
# A scale of a round length, and what the colours mean, below the panels.
# With `entries` such as "'#1f6fb4:water' '#a6a6a6:walls'", `eval put_scale` and `eval put_words`
# put them there before the first panel is drawn, `eval take_away` takes them off after it.
round_down(v) = (p = 10**floor(log10(v)), v >= 5 * p ? 5 * p : v >= 2 * p ? 2 * p : p)
bar = round_down((right - left) / 4)
bar_x = bar / (right - left) * drawn_x
bar_text = bar < 0.01 ? sprintf('%g mm', 1e3 * bar) : bar < 1 ? sprintf('%g cm', 1e2 * bar) : \
    sprintf('%g m', bar)
strip_y = (strip / 2.0) / canvas_y
put_scale = "set arrow 90 from screen 24.0 / canvas_x, screen strip_y \
    to screen (24 + bar_x) / canvas_x, screen strip_y heads size screen 0.004, 90 lw 2 front; \
    set label 90 bar_text at screen (34 + bar_x) / canvas_x, screen strip_y left noenhanced"
put_words = "next_x = 140 + bar_x; do for [i = 1:words(entries)] { \
    e = word(entries, i); k = strstrt(e, ':'); says = e[k + 1:*]; \
    set object 90 + i circle at screen next_x / canvas_x, screen strip_y \
        size screen 8.0 / canvas_x fc rgb e[1:k - 1] fs solid noborder front; \
    set label 90 + i says at screen (next_x + 16) / canvas_x, screen strip_y left noenhanced; \
    next_x = next_x + 60 + 12.0 * strlen(says) }"
take_away = "unset arrow 90; unset label 90; do for [i = 1:words(entries)] { \
    unset label 90 + i; unset object 90 + i }"
# Of all moments: pressures that 1 of 40 particles of the fluid is below and above
# [Pa], as means; the largest speed of the last [m/s]; the highest dye, -1 without water; in the first
# the number of particles of walls and of skins.
dyes = -1
has_walls = 0
has_skins = 0
p_low = 0
p_high = 0
stats 'shots.csv' using (p_low = p_low + $3 / moments, p_high = p_high + $4 / moments, end_max = $5, \
    dyes = $6 > dyes ? $6 : dyes, has_walls = $0 == 0 ? $7 : has_walls, \
    has_skins = $0 == 0 ? $8 : has_skins, 0) skip 2 nooutput
# A tank without walls is told by its outline.
if (has_walls == 0 && picture ne 'view') {
    set object 80 rectangle from low_x, (up == 2 ? low_y : low_z) to high_x, (up == 2 ? high_y : high_z) \
        behind fs empty border lc rgb '#808080' lw 1.2
}
solids = (has_walls > 0 ? " '".wall.":walls'" : '') \
    .(words(bodies) > 0 ? " '".body_face.":rigid bodies'" : '') \
    .(words(beams) > 0 && has_skins > 0 ? " '".skin.":beams'" : '')

# The particles of moment m are left in `file`, shapes of bodies stand in files that begin as `shot`
# says; its panel is set.
next_panel = "stats 'shots.csv' using (t = $1, shot = strcol(2), 0) skip 2 every ::m - 1::m - 1 nooutput; \
    file = sprintf('%s-%d.csv', picture, m); \
    if (from_above && words(bodies) > 0) { set xrange [*:*]; set yrange [*:*]; \
        stats sprintf('floor-bodies-%d.csv', m) using 1:2 skip 3 nooutput; faces = int(STATS_blocks); \
        set xrange [left:right]; set yrange [bottom:above] }; \
    set lmargin at screen (12 + panel_x * ((m - 1) % across) + 12.0) / canvas_x; \
    set rmargin at screen (12 + panel_x * ((m - 1) % across) + 12.0 + drawn_x) / canvas_x; \
    set tmargin at screen 1 - (48 + panel_y * ((m - 1) / across)) / canvas_y; \
    set bmargin at screen 1 - (48 + panel_y * ((m - 1) / across) + drawn_y) / canvas_y; \
    set label 1 sprintf('t = %.3g s', t) center at graph 0.5, graph 0 offset 0, -0.8"
