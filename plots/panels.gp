# panels.gp -- for figures of particles at several moments: which moments, and where each stands.
# Loaded after style.gp; the loop over panels then does `eval next_panel`.  A 3D tank is shown cut
# in the middle, or, with from_above = 1 set before, what runs along its floor.
wall = '#a6a6a6'
skin = '#101010'
r = 0.65 * dx   # particles touch
dye(c) = c == 0 ? 0x1f6fb4 : c == 1 ? 0xf2c418 : 0x009e73
from_above = exists('from_above') ? from_above : 0
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
looks = words(bodies) == 0 || from_above ? '' : dim == 2 ? '-bodies' : '-cut'
bodies_too = looks eq '' ? '' : ", file[1:strlen(file) - 4].looks.'.csv' using 1:".(up == 2 ? 2 : 3)." skip 3 \
    with filledcurves closed fs solid 1 border lc rgb body_edge lw 2 fc rgb body_face notitle"
is(what) = sort(column(kind_column)) == what && in_plane($2, $3) ? $1 : NaN
in_plane(y, z) = dim == 2 || (from_above ? z > low_z && z < low_z + 3 * dx : \
    abs(y - (low_y + high_y) / 2) < 1.01 * dx)
heading = title.(dim == 2 ? '' : from_above ? ', the floor from above' : ', cut in the middle')

stats '../snapshots.csv' using 1 skip 2 nooutput name 'shot'
moments = shot_records < 6 ? int(shot_records) : 6
which(m) = moments > 1 ? int((m - 1) * (shot_records - 1) / (moments - 1) + 0.5) : 0

# Panels of equal scale in two rows of three, those of long tanks in three of two; the canvas
# takes the shape of the tank.
rim = 3.5 * dx
left = low_x - rim
right = high_x + rim
bottom = (up == 2 ? low_y : low_z) - rim
above = (up == 2 ? high_y : high_z) + rim
# Where the tank itself moves there is to be room for it: all outermost walls have gone one way then.
together(least, most) = abs(least - most) < dx ? least : 0
if (!exists('walls_move')) { walls_move = 1 }   # an older version did not say
do for [m = 1:(walls_move ? moments : 0)] {
    stats '../snapshots.csv' using (shot_file = '../'.strcol(2), 0) skip 2 every ::which(m)::which(m) nooutput
    undefine wall_*
    stats shot_file using (sort(column(kind_column)) == 1 ? $1 : NaN):(column(up)) skip 3 nooutput \
        name 'wall'
    if (exists('wall_max_x')) {
        if (m == 1) { x1 = wall_min_x; x2 = wall_max_x; y1 = wall_min_y; y2 = wall_max_y }
        along = together(wall_min_x - x1, wall_max_x - x2)
        upward = together(wall_min_y - y1, wall_max_y - y2)
        left = along < 0 && low_x - rim + along < left ? low_x - rim + along : left
        right = along > 0 && high_x + rim + along > right ? high_x + rim + along : right
        low_up = up == 2 ? low_y : low_z
        high_up = up == 2 ? high_y : high_z
        bottom = upward < 0 && low_up - rim + upward < bottom ? low_up - rim + upward : bottom
        above = upward > 0 && high_up + rim + upward > above ? high_up + rim + upward : above
    }
}

# Panels of equal scale in two rows of three, those of long tanks in three of two; the canvas
# takes the shape of the tank.
rim = 3.5 * dx
left = low_x - rim
right = high_x + rim
bottom = (up == 2 ? low_y : low_z) - rim
above = (up == 2 ? high_y : high_z) + rim
# Where a tank itself moves there is to be room for it: by as much as its outermost walls do.
file_at(m) = sprintf('%s', at_file)
do for [m = 1:moments] {
    stats '../snapshots.csv' using (at_file = '../'.strcol(2), 0) skip 2 every ::which(m)::which(m) nooutput
    undefine wall_x* wall_up*
    stats at_file using (sort(column(kind_column)) == 1 ? $1 : NaN) skip 3 nooutput name 'wall_x'
    stats at_file using (sort(column(kind_column)) == 1 ? column(up) : NaN) skip 3 nooutput name 'wall_up'
    if (exists('wall_x_min') && exists('wall_up_min')) {
        if (m == 1) { first_left = wall_x_min; first_right = wall_x_max; \
            first_bottom = wall_up_min; first_above = wall_up_max }
        left = left < low_x - rim + wall_x_min - first_left ? left : low_x - rim + wall_x_min - first_left
        right = right > high_x + rim + wall_x_max - first_right ? right \
            : high_x + rim + wall_x_max - first_right
    }
}
is_long = above - bottom < 0.45 * (right - left)
across = moments < 3 ? moments : moments == 4 || (is_long && moments > 4) ? 2 : 3
down = (moments + across - 1) / across
panel_x = 1560 / across
drawn_x = panel_x - 24
drawn_y = drawn_x * (above - bottom) / (right - left)
if (drawn_y > 900) { drawn_x = drawn_x * 900 / drawn_y; drawn_y = 900; panel_x = drawn_x + 24 }
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
# Are there particles of this sort in the first picture?
first_file = ''
stats '../snapshots.csv' using (first_file = '../'.strcol(2), 0) skip 2 every ::0::0 nooutput
set xrange [*:*]
set yrange [*:*]
stats first_file using (sort(column(kind_column)) == 1 ? 1 : NaN) skip 3 nooutput name 'has_wall'
stats first_file using (sort(column(kind_column)) == 3 ? 1 : NaN) skip 3 nooutput name 'has_skin'
set xrange [left:right]
set yrange [bottom:above]
has_wall_records = exists('has_wall_records') ? has_wall_records : 0
has_skin_records = exists('has_skin_records') ? has_skin_records : 0
solids = (has_wall_records > 0 ? " '".wall.":walls'" : '') \
    .(words(bodies) > 0 ? " '".body_face.":rigid bodies'" : '') \
    .(words(beams) > 0 && has_skin_records > 0 ? " '".skin.":beams'" : '')

# The file of moment m is left in `file`, its panel is set.
next_panel = "stats '../snapshots.csv' using (t = $1, file = '../'.strcol(2), 0) \
    skip 2 every ::which(m)::which(m) nooutput; \
    set lmargin at screen (12 + panel_x * ((m - 1) % across) + 12.0) / canvas_x; \
    set rmargin at screen (12 + panel_x * ((m - 1) % across) + 12.0 + drawn_x) / canvas_x; \
    set tmargin at screen 1 - (48 + panel_y * ((m - 1) / across)) / canvas_y; \
    set bmargin at screen 1 - (48 + panel_y * ((m - 1) / across) + drawn_y) / canvas_y; \
    set label 1 sprintf('t = %.3g s', t) center at graph 0.5, graph 0 offset 0, -0.8"
