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
says_points = c_spacing > 0 ? 'at points: '.say(c_spacing) : 'at points: tol'
cost(w) = w == 1 ? column(4) : passes(0)
array name_of[2] = ['CPU time [s]', say_passes]
array least[2]
array largest[2]
do for [w = 1:2] {
    stats table using (cost(w) > 0 ? cost(w) : NaN) skip 2 nooutput name 'cost'
    least[w] = cost_min / 1.2
    largest[w] = cost_max * 1.2
}

# A panel of quantity q, cost in column w, at place p ('' for all), with the n-th of `rows' rows.
wide = 1700.0
key_wide = 330
gap = 118
panel_wide = (wide - key_wide - 2 * gap) / 2
panel = "set lmargin at screen (gap + side * (panel_wide + gap)) / wide; \
    set rmargin at screen (gap + side * (panel_wide + gap) + panel_wide) / wide; \
    set tmargin at screen 1 - (head + (n - 1) * high) / tall; \
    set bmargin at screen 1 - (head + n * high - foot) / tall; \
    set xrange [least[w]:largest[w]]; \
    plot for [at in stand] for [i = 1:words(lines)] table using (mine(i, at) ? cost(w) : NaN):(good(q)) skip 2 \
        with linespoints lw 2.2 ps 1.4 pt mark(member(i)) dt dash(member(i)) lc rgb look(i) \
        notitle, \
    for [i = 1:words(lines)] table using (told_here && mine(i, p) && is_hull(i) ? cost(w) : NaN):(good(q)):(told(0)) \
        skip 2 with labels left offset 0.7, 0.45 font ',11' tc rgb look(i) noenhanced notitle, \
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
runs = int(row_records)
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
legend = "set lmargin at screen (wide - key_wide - 10) / wide; set rmargin at screen 0.999; \
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
