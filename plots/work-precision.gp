# work-precision.gp -- what accuracy costs: error against CPU time and against pair passes, a line
# a method; runs that failed or were stopped stand at the top edge
# needs: compare.csv figures/constants.gp
load 'style.gp'
table = '../compare.csv'
set datafile missing NaN
eval read_names
sweeps = words(names) - 18
head(word) = strstrt(word, '@') ? word[1:strstrt(word, '@') - 1] : word
swept(i) = i > sweeps ? '' : (i > 1 ? '/' : '').strcol(17 + i)
place(i) = sweeps < 1 ? 'all' : swept(1).swept(2).swept(3).swept(4)

# Methods and combinations of swept values, in the order of the table.
methods = ''
places = ''
add(list, word) = strstrt(' '.list.' ', ' '.word.' ') ? list : list.(strlen(list) ? ' ' : '').word
stats table using (methods = add(methods, head(strcol(1))), places = add(places, place(0)), 0) \
    skip 2 nooutput
key_of(p) = (sweeps == 1 ? word(names, 18).' = ' : '').word(places, p)
mine(m, p) = head(strcol(1)) eq word(methods, m) && place(0) eq word(places, p)
done(c) = strcol(3) eq 'done' && abs(column(c)) > 0 ? abs(column(c)) : NaN
missed(word) = strcol(3) eq word ? 0.965 : NaN

# Quantities of which there is an error, with the runs' columns.
shown = ''
do for [c = 13:17] {
    stats table using (strcol(3) eq 'done' && strcol(c) ne 'nan' && strcol(c) ne '0') skip 2 \
        nooutput name 'has'
    if (has_sum > 0) { shown = shown.' '.c }
}
title_of(c) = c == 13 ? 'positions [spacings]' : c == 14 ? 'front [its way]' : \
    c == 15 ? 'tip [its largest]' : c == 16 ? 'impulse [its largest]' : 'energy defect [J]'
rows = words(shown)
if (rows == 0) { exit }

# Where the columns of cost reach; 1, 2, 5 are labelled where there is less than a decade or two.
do for [w in '4 11'] {
    stats table using (column(w + 0) > 0 ? column(w + 0) : NaN) skip 2 nooutput name 'cost'.w
}
low_cost(w) = (w == 4 ? cost4_min : cost11_min) / 1.3
high_cost(w) = (w == 4 ? cost4_max : cost11_max) * 1.3

high = 380
set terminal pngcairo size 1500, 130 + high * rows font 'Sans,18'
set output 'work-precision.png'
set multiplot title title noenhanced
set logscale xy
set format xy '10^{%T}'
set y2range [0:1]
unset y2tics
unset key
set lmargin 11
set rmargin 2
dash(p) = p == 1 ? 1 : p + 1
mark(p) = word('7 5 9 13 11 6 4 8', 1 + (p - 1) % 8) + 0

body = real(high * rows) / (130 + high * rows)
do for [k = 1:rows] {
    c = word(shown, k) + 0
    do for [side = 0:1] {
        w = side ? 11 : 4
        set origin 0.5 * side, body * (rows - k) / rows + 70.0 / (130 + high * rows)
        set size 0.5, body / rows
        set ylabel side ? '' : title_of(c)
        set xlabel k < rows ? '' : side ? 'pair passes' : 'CPU time [s]'
        set xrange [low_cost(w):high_cost(w)]
        set xtics format (high_cost(w) / low_cost(w) < 50 ? '%g' : '10^{%T}')
        set xtics autofreq
        if (high_cost(w) / low_cost(w) < 50) {
            set xtics ()
            do for [e = -6:12] { do for [d in '1 2 5'] { set xtics add (d * 10.0**e) } }
        }
        plot for [m = 1:words(methods)] for [p = 1:words(places)] table \
            using (mine(m, p) ? column(w) : NaN):(done(c)) skip 2 \
            with linespoints lw 2.5 ps 1.4 pt mark(p) dt dash(p) lc rgb pick(m), \
            for [m = 1:words(methods)] for [p = 1:words(places)] table \
            using (mine(m, p) ? column(w) : NaN):(missed('failed')) skip 2 axes x1y2 \
            with points pt 2 ps 1.8 lw 3 lc rgb pick(m), \
            for [m = 1:words(methods)] for [p = 1:words(places)] table \
            using (mine(m, p) ? column(w) : NaN):(missed('stopped')) skip 2 axes x1y2 \
            with points pt 12 ps 1.8 lw 3 lc rgb pick(m)
    }
}

# The key, below everything.
set origin 0, 0
set size 1, 80.0 / (130 + high * rows)
set lmargin 2
unset logscale
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set format xy ''
set xrange [0:1]
set yrange [0:1]
set key center center horizontal maxrows 2 samplen 2 width 1
plot for [m = 1:words(methods)] NaN with lines lw 4 lc rgb pick(m) title word(methods, m), \
    for [p = 1:(words(places) > 1 ? words(places) : 0)] NaN with linespoints lw 2 ps 1.4 \
    pt mark(p) dt dash(p) lc rgb grey title key_of(p), \
    NaN with points pt 2 ps 1.8 lw 3 lc rgb grey title 'failed', \
    NaN with points pt 12 ps 1.8 lw 3 lc rgb grey title 'stopped'
unset multiplot
