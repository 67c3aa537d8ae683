# spread-forces.gp -- forces on walls and bodies and their impulses, over runs that began alike
# needs: spread-forces.csv spread.csv figures/constants.gp figures/runs.gp
load 'style.gp'
load 'spread-bands.gp'
table = '../spread-forces.csv'
eval read_names
eval names_of_means

# Components of forces that are more than what chance makes of a symmetric flow, six at most.
is_force(name) = strlen(name) > 3 && name[strlen(name) - 2:strlen(name) - 1] eq '.f' \
    && strstrt('xyz', name[strlen(name):*]) > 0
most = 0
do for [k = 1:words(means)] {
    what = word(means, k)
    if (is_force(what)) { eval size_of; most = largest > most ? largest : most }
}
shown = ''
do for [k = 1:words(means)] {
    what = word(means, k)
    if (is_force(what) && words(shown) < 6) {
        eval size_of
        if (largest > 0 && largest >= 1e-2 * most) { shown = shown.' '.what }
    }
}
if (words(shown) == 0) { exit }
impulse(name) = name[1:strlen(name) - 2].'i'.name[strlen(name):*]

set terminal pngcairo size 1800, 420 * words(shown) + 120 font 'Sans,18'
set output 'spread-forces.png'
set multiplot layout words(shown), 2 title title."\n".few."\n".legend noenhanced
set lmargin 12
set rmargin 3
set xrange [0:until]
scale = 1
do for [k = 1:words(shown)] {
    tone = pick(k)
    set xlabel k == words(shown) ? 'time [s]' : ''
    what = word(shown, k)
    set ylabel 'force '.what.(dim == 2 ? ' [N/m]' : ' [N]') noenhanced
    eval draw_band
    what = impulse(word(shown, k))
    set ylabel 'impulse '.what.(dim == 2 ? ' [N s/m]' : ' [N s]') noenhanced
    eval draw_band
}
unset multiplot
