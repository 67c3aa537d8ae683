# spread-beam.gp -- tips of beams, forces and moments at their roots, over runs that began alike
# needs: spread-beam.csv spread.csv figures/constants.gp figures/runs.gp
load 'style.gp'
load 'spread-bands.gp'
table = '../spread-beam.csv'
eval read_names
eval names_of_means

# Of each tip the direction in which it moves more; six panels at most.
largest_of = "stats table using (abs(column(column_of(other.'.mean')))) skip 2 nooutput name 'own'"
shown = ''
do for [k = 1:words(means)] {
    what = word(means, k)
    if (ends_in(what, '.tip_x') && words(shown) < 5) {
        other = what
        eval largest_of
        x_most = own_max
        other = stem(what).'.tip_y'
        eval largest_of
        shown = shown.' '.(x_most >= own_max ? what : other).' '.stem(what).'.root_moment'
    }
}
if (words(shown) == 0) { exit }

set terminal pngcairo size 1200, 420 * words(shown) + 120 font 'Sans,18'
set output 'spread-beam.png'
set multiplot layout words(shown), 1 title title."\n".few."\n".legend noenhanced
set lmargin 12
set rmargin 3
set xrange [0:until]
do for [k = 1:words(shown)] {
    what = word(shown, k)
    tone = pick(k)
    scale = ends_in(what, '.root_moment') ? 1 : 1e3
    set xlabel k == words(shown) ? 'time [s]' : ''
    set ylabel what.(scale == 1 ? dim == 2 ? ' [N m/m]' : ' [N m]' : ' [mm]') noenhanced
    eval draw_band
}
unset multiplot
