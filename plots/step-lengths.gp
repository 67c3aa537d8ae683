# step-lengths.gp -- steps of each method of a comparison over time, and what kept them from being
# longer; those of all the others behind them in grey.  Of each method one run: the middle one of
# those that came to their end, or the last one if none did, at the first of swept values.
# needs: compare.csv figures/constants.gp
load 'style.gp'
load 'comparison.gp'

here(i) = line_of(strcol(1)) eq l && place(0) eq word(places, 1) && column(7) > 0
ended(i) = here(0) && strcol(3) eq 'done'
take(i) = (run = strcol(c_run), name = strcol(1).(strcol(2) eq 'nan' ? '' : '~'.strcol(2)), 0)
runs = ''
labels = ''
do for [l in lines] {
    all = 0
    seen = 0
    run = ''
    stats table using (ended(0) ? (all = all + 1) : 0) skip 2 nooutput
    stats table using (all > 0 ? (ended(0) ? (seen = seen + 1, \
        seen == (all + 1) / 2 ? take(0) : 0) : 0) : here(0) ? take(0) : 0) skip 2 nooutput
    if (strlen(run)) {
        runs = runs.' '.run
        labels = labels.' '.name
    }
}
if (words(runs) == 0) { exit }
steps_of(i) = '../runs/'.word(runs, i).'/steps.csv'

limiters = 'error stability output'
limited(k) = strstrt(strcol(3), word(limiters, k)) == 1
array share[3 * words(runs)]
array steps[words(runs)]
shortest = 1e300
longest = 0
do for [i = 1:words(runs)] {
    stats steps_of(i) using 2 skip 2 nooutput name 'h'
    steps[i] = h_records
    shortest = h_lo_quartile < shortest ? h_lo_quartile : shortest
    longest = h_max > longest ? h_max : longest
    do for [k = 1:3] {
        stats steps_of(i) using (limited(k)) skip 2 nooutput name 'is'
        share[3 * (i - 1) + k] = 100 * is_sum / h_records
    }
}

across = words(runs) < 3 ? words(runs) : words(runs) < 10 ? 3 : 4
down = (words(runs) + across - 1) / across
set terminal pngcairo size 130 + 430 * across, 130 + 300 * down font 'Sans,15'
set output 'step-lengths.png'
set multiplot title title.': length of steps [s] over time [s], all the others in grey' noenhanced
set xrange [0:until]
set yrange [shortest / 3:longest * 1.5]
set logscale y
set format y '10^{%T}'
set xtics until / 5.0
unset key
faint(k) = '#90'.substr(pick(k), 2, 7)   # so that points under points are seen
set lmargin 8
set rmargin 3
below = 60.0 / (130 + 300 * down)
body = 1 - below - 50.0 / (130 + 300 * down)
do for [i = 1:words(runs)] {
    at = word(labels, i)
    cut = strstrt(at, '~')
    set title sprintf('%s: %d steps', cut ? at[1:cut - 1].' '.at[cut + 1:*] : at, steps[i]) \
        noenhanced offset 0, -0.5
    set size 1.0 / across, body / down
    set origin ((i - 1) % across) / real(across), \
        below + body * (down - 1 - (i - 1) / across) / down
    set label 1 sprintf('%.0f / %.0f / %.0f %%', share[3 * i - 2], share[3 * i - 1], share[3 * i]) \
        at graph 0.97, 0.08 right tc rgb '#404040' noenhanced
    plot for [j = 1:words(runs)] steps_of(j) using 1:2 skip 2 \
        with points pt 7 ps 0.15 lc rgb '#d4d4d4', \
        for [k = 1:3] steps_of(i) using 1:(limited(k) ? $2 : NaN) skip 2 \
        with points pt 7 ps 0.4 lc rgb faint(k)
}
unset label 1
set origin 0, 0
set size 1, below
set lmargin 2
eval empty
set key center center horizontal samplen 1.5 \
    title 'limited by (shares at the right of each panel in this order):'
plot for [k = 1:3] NaN with points pt 7 ps 1.6 lc rgb pick(k) title word(limiters, k)
unset multiplot
