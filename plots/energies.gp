# energies.gp -- where the energy is, what each part of the physics took or gave, and what the
# integration in time lost
# needs: book.csv figures/constants.gp
load 'style.gp'
table = '../book.csv'
eval read_names
# What never was more than rounding is left out; parts stand between `elastic` and `total`.
stats table using (abs(column(column_of('total')))) skip 2 nooutput name 'all'
stored = ''
parts = ''
do for [i = 2:column_of('total') - 1] {
    stats table using (abs(column(i))) skip 2 nooutput name 'part'
    if (part_max > 1e-9 * all_max) {
        if (i > column_of('elastic')) { parts = parts.' '.word(names, i) } else { stored = stored.' '.word(names, i) }
    }
}
say_part(w) = w eq 'pressure_defect' ? "pressure forces that\nno energy stands for" : w
unit = dim == 2 ? ' [J/m]' : ' [J]'

set terminal pngcairo size 1200, 1250 font 'Sans,18'
set output 'energies.png'
set multiplot title title noenhanced
set lmargin 15
set rmargin 22
set key at graph 1.01, 1 left top Left reverse samplen 1.5
set xrange [0:until]
set origin 0, 0.54
set size 1, 0.42
set ylabel 'stored energy'.unit
plot for [k = 1:words(stored)] table using 1:(column(column_of(word(stored, k)))) skip 2 \
    with lines lw 2.5 lc rgb pick(k) title word(stored, k), \
    table using 1:(column(column_of('total'))) skip 2 with lines lw 2 dt '-' lc rgb colour[7] \
    title 'total'

set origin 0, 0.27
set size 1, 0.28
set ylabel 'taken or given'.unit
if (words(parts) > 0) {
    plot 0 lc rgb grey lw 1 notitle, for [k = 1:words(parts)] table \
        using 1:(column(column_of(word(parts, k)))) skip 2 \
        with lines lw 2.5 lc rgb pick(k) title say_part(word(parts, k))
}

set origin 0, 0
set size 1, 0.28
set xlabel 'time [s]'
set ylabel 'defect'.unit
set format y '%g'
stats table using (column(column_of('defect'))) skip 2 nooutput name 'y'
step = (y_max - y_min) / 4
if (step > 0) { set ytics decade(step) * round_up(step / decade(step)) }
plot 0 lc rgb grey lw 1 notitle, \
    table using 1:(column(column_of('defect'))) skip 2 with lines lw 2.5 lc rgb pick(2) \
    title E0 > 0 ? sprintf("defect\n(of %.3g\nat t = 0)", E0) : 'defect'
unset multiplot
