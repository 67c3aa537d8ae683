# steps.gp -- length of every step, and what kept it from being longer
# needs: steps.csv figures/constants.gp
load 'style.gp'
table = '../steps.csv'
limiters = 'error stability output'
is(name) = strstrt(strcol(3), name) == 1
stats table using 2 skip 2 nooutput name 'h'
array share[3]
do for [k = 1:3] {
    stats table using (is(word(limiters, k))) skip 2 nooutput name 'is'
    share[k] = is_sum
}

set terminal pngcairo size 1200, 750 font 'Sans,18'
set output 'steps.png'
set title sprintf('%s: %d steps, mean %.2g s', title, h_records, h_mean) noenhanced
set xrange [0:until]
set xlabel 'time [s]'
set ylabel 'step length [s]'
set logscale y
set format y '10^{%T}'
set mytics 10
set key below Left reverse samplen 1.5 title 'limited by:' left maxrows 1
faint(k) = '#90'.substr(pick(k), 2, 7)   # so that points under points are seen
plot for [k = 1:3] table using 1:(is(word(limiters, k)) ? $2 : NaN) skip 2 \
    with points pt 7 ps 0.5 lc rgb faint(k) notitle, \
    for [k = 1:3] NaN with points pt 7 ps 1.8 lc rgb pick(k) \
    title sprintf('%s (%.0f %%)', word(limiters, k), 100 * share[k] / h_records)
