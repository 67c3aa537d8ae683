# energies.gp -- where the energy is, what each part of the physics took or gave, and what the
# integration in time lost
# needs: book.csv figures/constants.gp
load 'style.gp'
table = '../book.csv'
eval read_names
stored = 'kinetic potential internal elastic'
# Parts stand between `elastic` and `total`; those that never did anything are left out.
parts = ''
do for [i = column_of('elastic') + 1:column_of('total') - 1] {
    stats table using (abs(column(i))) skip 2 nooutput name 'part'
    if (part_max > 0) { parts = parts.' '.word(names, i) }
}
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
        with lines lw 2.5 lc rgb pick(k) title word(parts, k)
}

set origin 0, 0
set size 1, 0.28
set xlabel 'time [s]'
set ylabel 'defect'.unit
set format y '%g'
plot 0 lc rgb grey lw 1 notitle, \
    table using 1:(column(column_of('defect'))) skip 2 with lines lw 2.5 lc rgb pick(2) \
    title E0 > 0 ? sprintf("defect\n(of %.3g\nat t = 0)", E0) : 'defect'
unset multiplot
