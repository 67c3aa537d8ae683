# sweep.gp -- what comes out against a swept key, a line for each combination of the other keys:
# sweep-KEY.png.  Keys whose values are words have them below the axis in the order of the table.
# needs: sweep.csv figures/constants.gp
load 'style.gp'
table = '../sweep.csv'
set datafile missing NaN
eval read_names
c_status = column_of('status')
sweeps = c_status - 1
c_run = column_of('run')
is_one_of(w, list) = strstrt(' '.list.' ', ' '.w.' ') > 0
add(list, w) = is_one_of(w, list) ? list : list.(strlen(list) ? ' ' : '').w
but(k, j) = j > sweeps || j == k ? '' : ','.word(names, j).'='.strcol(j)
elsewhere(k) = 'at'.but(k, 1).but(k, 2).but(k, 3).but(k, 4)
is_number(w) = strstrt('+-.0123456789', w[1:1]) > 0
done(i) = strcol(c_status) eq 'done'

eval read_units

# Panels: cost, and the outputs that stand first, as long as they differ.
most_panels = 8
panels = sprintf('%d', column_of('pair_passes'))
do for [c = c_status + 9:c_run - 1] {
    last = word(names, c)[strlen(word(names, c)) - 3:*]
    if (words(panels) < most_panels && (last eq 'peak' || last eq '.end' || last eq 'mean')) {
        undefine seen*
        stats table using (done(0) ? column(c) : NaN) skip 2 nooutput name 'seen'
        if (exists('seen_max') && seen_max > seen_min) { panels = panels.' '.c }
    }
}

do for [k = 1:sweeps] {
    reset
    load 'style.gp'
    set datafile missing NaN
    spots = ''
    others = ''
    numbers = 0
    stats table using (spots = add(spots, strcol(k)), others = add(others, elsewhere(k)), \
        numbers = numbers + is_number(strcol(k)), 0) skip 2 nooutput name 'all'
    if (words(spots) > 1 && strstrt(word(names, k), '/') == 0) {
        by_words = numbers < all_records
        place(w) = sum [i = 1:words(spots)] (word(spots, i) eq w ? i : 0)
        x(i) = by_words ? place(strcol(k)) : column(k)
        few = words(others) > 7 ? 7 : words(others)
        slots = words(panels) + (few > 1)
        wide = slots > 4 ? 3 : 2
        rows = (slots + wide - 1) / wide
        set terminal pngcairo size 620 * wide, 420 * rows + 50 font 'Sans,16'
        set output 'sweep-'.word(names, k).'.png'
        set multiplot layout rows, wide title title noenhanced
        if (by_words) {
            set xrange [0.5:words(spots) + 0.5]
            set xtics ()
            do for [i = 1:words(spots)] { set xtics add (word(spots, i) i) }
        } else {
            stats table using (column(k)) skip 2 nooutput name 'x'
            if (x_min > 0 && x_max > 4 * x_min) { set logscale x }
            eval few_tics
            set offsets graph 0.05, graph 0.05, 0, 0
        }
        set xlabel say(k) noenhanced
        unset key
        do for [panel in panels] {
            c = panel + 0
            set ylabel say(c) noenhanced offset 1, 0
            plot for [i = 1:few] table using (elsewhere(k) eq word(others, i) ? x(0) : NaN):\
                (done(0) ? column(c) : NaN) skip 2 \
                with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(i)
        }
        if (few > 1) {
            unset logscale
            unset border
            unset tics
            unset xlabel
            unset ylabel
            set xrange [0:1]
            set yrange [0:1]
            set key center center vertical maxcols 1 Left reverse samplen 3 spacing 1.4
            plot for [i = 1:few] NaN with linespoints lw 2 pt 7 ps 1.3 lc rgb pick(i) \
                title word(others, i)[4:*]
        }
        unset multiplot
    }
}
