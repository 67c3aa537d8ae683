# work-precision.gp -- what accuracy costs: error against CPU time and against pair passes, a line
# a method.  work-precision.png has every quantity, work-precision-NAME.png one of them; swept
# values have panels of their own there.  Runs that failed or were stopped stand at the top edge.
# needs: compare.csv figures/constants.gp
load 'style.gp'
load 'comparison.gp'

# An error above this is none: it stands at the top edge.
array most[quantities] = [10, 1, 1, 1, 1, 1, 1, E0 > 0 ? E0 : 1e300]
good(q) = strcol(3) eq 'done' && error(q) > 0 && error(q) <= most[q] ? error(q) : NaN
at_edge(q) = strcol(3) eq 'failed' || strcol(3) eq 'stopped' || error(q) > most[q] ? 0.965 : NaN
sign(i) = strcol(3) eq 'failed' ? 2 : strcol(3) eq 'stopped' ? 12 : 8

if (words(shown) == 0) { exit }
# What a point of a line is told from the others by: its tolerance, what stands behind its @, or its spacing.
c_spacing = 0
do for [k = 1:sweeps] { if (space && word(names, first_swept - 1 + k) eq 'spacing') { c_spacing = first_swept - 1 + k } }
told(i) = c_spacing > 0 ? strcol(c_spacing) : strstrt(strcol(1), '@') ? \
    strcol(1)[strstrt(strcol(1), '@'):*] : strcol(2) eq 'nan' ? '' : strcol(2)
says_points = c_spacing > 0 ? 'points: '.say(c_spacing) : 'points: tol'
cost(w) = w == 1 ? column(4) : passes(0)
array name_of[2] = ['CPU time [s]', say_passes]
array least[2]
array largest[2]
do for [w = 1:2] {
    stats table using (cost(w) > 0 ? cost(w) : NaN) skip 2 nooutput name 'cost'
    least[w] = cost_min / 1.2
    largest[w] = cost_max * 1.2
}

# Where the label of each point stands: beside it, above or below, where no coloured point and no other
# label is; where all four are taken it has none.  All in pixels of the panel.
runs = int(row_records)
array point_x[runs]
array point_y[runs]
array said[runs]
array corner[runs]                     # 1 to 4, 0: none
array label_x[runs]
array label_y[runs]
side_of(c, at, long) = at + (c <= 2 ? 9 : -9 - long)
height_of(c, at) = at + (c % 2 == 1 ? 2 : -16)
long(i) = 7.5 * strlen(said[i])
see(i, v, e, s, told) = (said[i] = s, corner[i] = told ? -1 : 0, point_x[i] = v > 0 && e > 0 ? v : 0, \
    point_y[i] = e, low = point_x[i] > 0 && e < low ? e : low, top = point_x[i] > 0 && e > top ? e : top, 0)
far = 1e9
find_point(i) = point_x[i] > 0 && corner[i] < 0 \
    ? (point_x[i] = log(point_x[i] / least[w]) / log(largest[w] / least[w]) * panel_wide, \
       point_y[i] = (log10(point_y[i]) - floor(log10(low))) / (ceil(log10(top)) - floor(log10(low)) + 1e-9) \
       * (high - foot)) : (corner[i] = 0, point_x[i] = far, point_y[i] = far)
taken(x, y, long) = (x < 0 || x + long > panel_wide) + sum [j = 1:runs] (point_x[j] > x - 5 && point_x[j] < x + long + 5 && point_y[j] > y - 5 \
    && point_y[j] < y + 19 || corner[j] > 0 && label_x[j] < x + long && label_x[j] + long(j) > x \
    && abs(label_y[j] - y) < 14)
take(i, c, x, y) = corner[i] == -1 && taken(x, y, long(i)) == 0 \
    ? (corner[i] = c, label_x[i] = x, label_y[i] = y, c) : 0
place_labels = "low = 1e300; top = 0; stats table using (see(int($0) + 1, cost(w), \
    p eq '' || place(0) eq p ? good(q) : NaN, told(0), \
    told_here && mine_of_hull(0))) skip 2 nooutput; \
    do for [i = 1:runs] { last = find_point(i) }; \
    do for [i = 1:runs] { do for [c = 1:4] { \
        last = take(i, c, side_of(c, point_x[i], long(i)), height_of(c, point_y[i])) } }"
mine_of_hull(i) = words(lines) <= 8 || is_one_of(line_of(case(0)), hull)

# A panel of quantity q, cost in column w, at place p ('' for all), with the n-th of `rows' rows.
wide = 1700.0
key_wide = 330
gap = 118
panel_wide = (wide - key_wide - 2 * gap) / 2
panel = "set lmargin at screen (gap + side * (panel_wide + gap)) / wide; \
    set rmargin at screen (gap + side * (panel_wide + gap) + panel_wide) / wide; \
    set tmargin at screen 1 - (head + (n - 1) * high) / tall; \
    set bmargin at screen 1 - (head + n * high - foot) / tall; \
    set xrange [least[w]:largest[w]]; eval place_labels; \
    plot for [at in stand] for [i = 1:words(lines)] table using (mine(i, at) ? cost(w) : NaN):(good(q)) skip 2 \
        with linespoints lw 2.2 ps 1.4 pt mark(member(i)) dt dash(member(i)) lc rgb look(i) \
        notitle, \
    for [i = 1:words(lines)] table using (corner[int($0) + 1] == 1 && mine(i, p) ? cost(w) : NaN):(good(q)):(told(0)) \
        skip 2 with labels left offset 0.7, 0.45 font ',11' tc rgb look(i) noenhanced notitle, \
    for [i = 1:words(lines)] table using (corner[int($0) + 1] == 2 && mine(i, p) ? cost(w) : NaN):(good(q)):(told(0)) \
        skip 2 with labels left offset 0.7, -0.45 font ',11' tc rgb look(i) noenhanced notitle, \
    for [i = 1:words(lines)] table using (corner[int($0) + 1] == 3 && mine(i, p) ? cost(w) : NaN):(good(q)):(told(0)) \
        skip 2 with labels right offset -0.7, 0.45 font ',11' tc rgb look(i) noenhanced notitle, \
    for [i = 1:words(lines)] table using (corner[int($0) + 1] == 4 && mine(i, p) ? cost(w) : NaN):(good(q)):(told(0)) \
        skip 2 with labels right offset -0.7, -0.45 font ',11' tc rgb look(i) noenhanced notitle, \
    for [i = 1:words(lines)] table using (mine(i, p) ? cost(w) : NaN):(at_edge(q)):(sign(0)) \
        skip 2 axes x1y2 with points pt variable ps 1.6 lw 2.5 lc rgb look(i) notitle; \
    unset label 9"
# A line joins points of one place; where there are many points they are told in figures of one quantity.
axes = "stand = p eq '' ? places : p; told_here = p ne '' || row_records <= 16; set logscale xy; set format y '10^{%T}'; set ytics autofreq; set y2range [0:1]; \
    unset y2tics; unset key; \
    set yrange [*:*]; set xtics autofreq format (largest[w] / least[w] < 50 ? '%g' : '10^{%T}'); \
    if (largest[w] / least[w] < 50) { set xtics (); \
        do for [e = -6:12] { do for [d in (largest[w] / least[w] < 5 ? '1 1.5 2 3 4 5 6 7 8 9' : '1 2 5')] { \
            set xtics add (d * 10.0**e) } } }"
both_panels = "do for [side = 0:1] { w = side + 1; eval axes; \
    set ylabel side ? '' : axis[q] offset 1, 0; \
    set xlabel n < rows ? '' : name_of[w]; eval panel }"

# Where there are more than eight lines those on the lower hull have colours: a run of theirs in any
# panel that is drawn, against any cost, has none beside it that is cheaper and more exact.
array run_cost[runs]
array run_error[runs]
array run_line[runs]
keep(i, v, e) = (run_cost[i] = v, run_error[i] = e, run_line[i] = line_of(case(0)), 0)
add_hull = "stats table using (keep(int($0) + 1, cost(w), good(q))) skip 2 nooutput; \
    do for [i = 1:runs] { beaten = run_cost[i] > 0 && run_error[i] > 0 ? 0 : 1; \
        do for [j = 1:runs] { if (beaten == 0 && run_cost[j] > 0 && run_error[j] > 0 \
            && run_cost[j] < run_cost[i] && run_error[j] < run_error[i]) { beaten = 1 } }; \
        if (beaten == 0) { hull = add(hull, run_line[i]) } }"
find_hull = "hull = ''; do for [k_hull in drawn] { q = k_hull + 0; do for [w = 1:2] { eval add_hull } }"

# What stands beside and below the panels: the key, and why runs are missing.
has_places = 0
legend = "set lmargin at screen (wide - key_wide + 5) / wide; set rmargin at screen 0.999; \
    set tmargin at screen 1 - head / tall; set bmargin at screen 0.01; eval empty; \
    set key inside left top vertical maxcols 1 Left reverse samplen 3 spacing 1.15 width -2 \
        noenhanced; \
    set label 1 reasons at screen 20 / wide, (22 * reason_lines - 5) / tall left noenhanced \
        font ',13' tc rgb '#404040'; \
    plot for [i = 1:words(lines)] NaN with linespoints lw 2.2 ps 1.4 pt mark(member(i)) \
        dt dash(member(i)) lc rgb look(i) title say_line(word(lines, i)), \
        NaN with points pt -1 title (told_here ? says_points : ''), \
        NaN with points pt 2 ps 1.6 lw 3 lc rgb grey title 'failed', \
        NaN with points pt 12 ps 1.6 lw 3 lc rgb grey title 'stopped', \
        NaN with points pt 8 ps 1.6 lw 2 lc rgb grey title 'off the scale'; unset label 1"

below = 22 * reason_lines + (reason_lines > 0 ? 15 : 0)
start = "reset; load 'style.gp'; set datafile missing NaN; eval dashes; \
    set terminal pngcairo size wide, tall font 'Sans,17'; set output file; \
    set multiplot; set label 9 title noenhanced at screen 0.42, 1 - 24.0 / tall center font ',20'"
head = 55
foot = 64

# Every quantity, all places in one.
key_high = 31 * (words(lines) + 4)     # what the key needs
larger(i, j) = i > j ? i : j
rows = words(shown)
high = larger(330, key_high / rows)
tall = 1.0 * head + rows * high + 25 + below
file = 'work-precision.png'
drawn = shown
if (words(lines) > 8) { eval find_hull }
eval start
do for [n = 1:rows] {
    q = word(shown, n) + 0
    p = ''
    eval both_panels
}
eval legend
unset multiplot

# Each quantity, a row for each place; where lines are swept over a hundred values, the first six.
most_rows = 6
places_shown = words(places) > most_rows ? most_rows : words(places)
do for [k in shown] {
    drawn = k
    if (words(lines) > 8) { eval find_hull }
    q = k + 0
    rows = places_shown
    high = larger(rows > 1 ? 400 : 620, key_high / rows)
    tall = 1.0 * head + rows * high + 25 + below
    file = 'work-precision-'.quantity[q].'.png'
    eval start
    do for [n = 1:rows] {
        p = word(places, n)
        if (p ne 'all') { set label 7 p noenhanced at graph 0.02, 0.07 left }
        eval both_panels
    }
    unset label 7
    eval legend
    unset multiplot
}
