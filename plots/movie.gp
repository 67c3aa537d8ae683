# movie.gp -- frames of a movie: every particle file of a run, the colour is the speed of the water;
# a 3D tank is cut in the middle; `stiffwater movie` alone draws it
# needs: frames.csv
load 'style.gp'
load 'joined.gp'   # joined = 1: a PNG a frame, for ffmpeg; 0: one GIF. shaped = 1: there are rigid bodies
low_up = dim == 2 ? low_y : low_z
high_up = dim == 2 ? high_y : high_z
rim = 3.5 * dx
left = low_x - rim
right = high_x + rim
bottom = low_up - rim
above = high_up + rim
drawn_x = 1000.0
drawn_y = drawn_x * (above - bottom) / (right - left)
if (drawn_y > 800) { drawn_x = drawn_x * 800 / drawn_y; drawn_y = 800.0 }
canvas_x = 2 * int((drawn_x + 270) / 2)   # even numbers: codecs want them
canvas_y = 2 * int((drawn_y + 140) / 2)

stats 'frames.csv' using 1 nooutput name 'shot'
frames = int(shot_records)
array time[frames]
array file[frames]
array particles[frames]
all_max = 0
stats 'frames.csv' using (n = int($0) + 1, time[n] = $1, file[n] = strcol(2), particles[n] = $3, \
    all_max = $4 > all_max ? $4 : all_max, 0) nooutput
fastest = a > 0 && g > 0 ? 2 * sqrt(g * n2 * a) : all_max > 0 ? all_max : 1
shown(y) = dim == 2 || abs(y - (low_y + high_y) / 2) < 1.01 * dx
up(y, z) = dim == 2 ? y : z
of(kind, low, high) = kind >= low && kind <= high ? 1 : NaN

if (joined) { set terminal pngcairo size canvas_x, canvas_y font 'Sans,17' } \
else { set terminal gif animate delay 8 loop 0 size canvas_x, canvas_y font 'Sans,14'; \
    set output 'movie.gif' }
set label 1 'x [m]' center at screen (110 + drawn_x / 2) / canvas_x, screen 18.0 / canvas_y
set label 2 (dim == 2 ? 'y [m]' : 'z [m], cut in the middle') center rotate \
    at screen 16.0 / canvas_x, screen (85 + drawn_y / 2) / canvas_y
unset grid
set xrange [left:right]
set yrange [bottom:above]
set lmargin at screen 110.0 / canvas_x
set rmargin at screen (110 + drawn_x) / canvas_x
set bmargin at screen 85.0 / canvas_y
set tmargin at screen (85 + drawn_y) / canvas_y
set palette defined (0 '#440154', 1 '#414487', 2 '#2a788e', 3 '#22a884', 4 '#7ad151', 5 '#fde725')
set cbrange [0:fastest]
set cblabel 'speed [m/s], end: and beyond'
set cbtics
set colorbox user origin screen (125 + drawn_x) / canvas_x, screen 85.0 / canvas_y \
    size screen 20.0 / canvas_x, screen drawn_y / canvas_y
if (particles[1] == 0) { unset colorbox }
r = 0.65 * dx
bodies_too = shaped == 0 ? '' : ", sprintf('bodies-%04d.csv', m - 1) using 1:".(dim == 2 ? 2 : 3)." skip 3 \
    with filledcurves closed fs solid 1 border lc rgb '#5a3210' lw 2 fc rgb '#d9a066' notitle"
r_skin = shaped == 0 ? r : 0.5 * dx
do for [m = 1:frames] {
    if (joined) { set output sprintf('frame-%04d.png', m - 1) }
    set title sprintf('%s, t = %.3f s', title, time[m]) noenhanced
    plot NaN notitle, file[m] using (shown($2) ? $1 * of($6, 1, 2) : NaN):(up($2, $3)):(r) \
            with circles fs solid noborder lc rgb '#a6a6a6' notitle, \
        '' using (shown($2) ? $1 * of($6, 0, 0) : NaN):(up($2, $3)):(r):4 \
            with circles fs solid noborder lc palette notitle, \
        '' using (shown($2) ? $1 * of($6, 3, 4) : NaN):(up($2, $3)):(r_skin) \
            with circles fs solid noborder lc rgb '#101010' notitle@bodies_too
}
set output
