# cost-against.gp -- what runs cost against a swept key of numbers, a line a method and tolerance:
# cost-against-KEY.png.  Other swept keys have panels of their own.  A run that the budget stopped
# stands at what it had spent; its arrow goes to what all would take at that pace.
# needs: compare.csv figures/constants.gp
load 'style.gp'
load 'comparison.gp'
if (sweeps < 1) { exit }

# A line is a method with all that stands behind it.
listed = ''
stats table using (listed = add(listed, case(0)), 0) skip 2 nooutput
cases = ''          # by families
do for [l in lines] {
    do for [c in listed] {
        if (line_of(c) eq l) { cases = add(cases, c) }
    }
}
number_of(l) = sum [i = 1:words(lines)] (word(lines, i) eq l ? i : 0)
of(i) = number_of(line_of(word(cases, i)))
turn(i) = sum [j = 1:i] (of(j) == of(i))

# All swept keys but the k-th.
but(k, j) = j > sweeps || j == k ? '' : \
    ','.word(names, first_swept - 1 + j).'='.strcol(first_swept - 1 + j)
elsewhere(k) = 'at'.but(k, 1).but(k, 2).but(k, 3).but(k, 4)

# Panels: pair passes, CPU time, and an error, so that what is cheap and wrong is seen to be so.
wanted = '3 4 2 1 5 8'
q = 0
do for [c in wanted] { if (q == 0 && is_one_of(c, shown)) { q = c + 0 } }
panels = q > 0 ? 3 : 2
cost(w) = w == 1 ? passes(0) : w == 2 ? column(4) : error(q)
array name_of[3] = [say_passes, 'CPU time [s]', q > 0 ? 'error, '.axis[q] : '']
whole(w) = strcol(3) ne 'stopped' || w == 3 ? 1 : until / column(c_end)
ours(i) = case(0) eq word(cases, i) && elsewhere(k) eq p
counts(w) = strcol(3) eq 'done' || (strcol(3) eq 'stopped' && w < 3)
line(w) = counts(w) && cost(w) > 0 ? cost(w) * whole(w) : NaN
as(how, w) = strcol(3) eq how && cost(w) > 0 && (w < 3 || how eq 'done') ? cost(w) : NaN
x(i) = ours(i) ? column(c) : NaN

wide = 1900.0
key_wide = 300
gap = 118
panel_wide = (wide - key_wide - panels * gap) / panels
head = 60
foot = 98
high = 600
panel = "set lmargin at screen (gap + (w - 1) * (panel_wide + gap)) / wide; \
    set rmargin at screen (gap + (w - 1) * (panel_wide + gap) + panel_wide) / wide; \
    set tmargin at screen 1 - (head + (n - 1) * high) / tall; \
    set bmargin at screen 1 - (head + n * high - foot) / tall; \
    plot for [i = 1:words(cases)] table using (x(i)):(line(w)) skip 2 \
        with lines lw 2 dt dash(turn(i)) lc rgb look(of(i)) notitle, \
    for [i = 1:words(cases)] table using (x(i)):(as('done', w)) skip 2 \
        with points pt mark(member(of(i))) ps 1.4 lc rgb look(of(i)) notitle, \
    for [i = 1:words(cases)] table using (x(i)):(as('failed', w)) skip 2 \
        with points pt 2 ps 1.6 lw 3 lc rgb look(of(i)) notitle, \
    for [i = 1:words(cases)] table using (x(i)):(as('stopped', w)) skip 2 \
        with points pt 12 ps 1.6 lw 3 lc rgb look(of(i)) notitle, \
    for [i = 1:words(cases)] table using (x(i)):(as('stopped', w)):(0):(line(w) - cost(w)) skip 2 \
        with vectors head size screen 0.006, 20 filled lw 1.5 lc rgb look(of(i)) notitle"
legend = "set lmargin at screen (wide - key_wide - 10) / wide; set rmargin at screen 0.999; \
    set tmargin at screen 1 - head / tall; set bmargin at screen 0.01; eval empty; \
    set key inside left top vertical maxcols 1 Left reverse samplen 3 spacing 1.15 width -2 \
        noenhanced; \
    set label 1 reasons at screen 20 / wide, (22 * reason_lines - 5) / tall left noenhanced \
        font ',13' tc rgb '#404040'; \
    plot for [i = 1:words(cases)] NaN with linespoints lw 2 ps 1.4 pt mark(member(of(i))) \
        dt dash(turn(i)) lc rgb look(of(i)) title say_case(word(cases, i)), \
        NaN with points pt 2 ps 1.6 lw 3 lc rgb grey title 'failed', \
        NaN with points pt 12 ps 1.6 lw 3 lc rgb grey title 'stopped; arrow:', \
        NaN with points pt -1 title 'all at that pace'; unset label 1"
start = "reset; load 'style.gp'; set datafile missing NaN; eval dashes; \
    set terminal pngcairo size wide, tall font 'Sans,17'; set output file; set multiplot; \
    set label 9 title noenhanced at screen 0.42, 1 - 24.0 / tall center font ',20'; \
    set logscale y; set format y '10^{%T}'; unset key; \
    set xrange [*:*]; \
    if (x_min > 0 && x_max > 4 * x_min) { set logscale x; set xrange [x_min / 1.3:x_max * 1.3] }; \
    set xtics autofreq format (x_max > 50 * x_min ? '10^{%T}' : '%g'); eval few_tics"
most_rows = 6

do for [k = 1:sweeps] {
    c = first_swept - 1 + k
    spots = ''
    numbers = 0
    others_at = ''
    stats table using (spots = add(spots, strcol(c)), others_at = add(others_at, elsewhere(k)), \
        numbers = numbers + valid(c), 0) skip 2 nooutput name 'all'
    if (words(spots) > 1 && numbers == all_records && strstrt(word(names, c), '/') == 0) {
        set xrange [*:*]    # stats leaves out what the last legend did
        set yrange [*:*]
        stats table using (column(c)) skip 2 nooutput name 'x'
        rows = words(others_at) > most_rows ? most_rows : words(others_at)
        key_high = 31 * (words(cases) + 5)
        high = rows > 1 ? 430 : 600
        high = rows * high > key_high ? high : key_high / rows
        below = 22 * reason_lines + (reason_lines > 0 ? 15 : 0)
        tall = 1.0 * head + rows * high + below
        file = 'cost-against-'.word(names, c).'.png'
        eval start
        do for [n = 1:rows] {
            p = word(others_at, n)
            set xlabel (n < rows ? '' : say(c)) noenhanced
            if (sweeps > 1) { set label 7 p[4:*] noenhanced at graph 0.03, 0.95 left }
            do for [w = 1:panels] {
                set ylabel name_of[w] offset 1, 0
                eval panel
                unset label 9
            }
        }
        unset label 7
        eval legend
        unset multiplot
    }
}
