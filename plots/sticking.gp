# sticking.gp -- three results against spacing, for water that slips along solids or sticks to them
# needs: the tables of plots/figures-sticking.sh, which draws this
load 'style.gp'
set datafile separator ' '
cases = 'obstacle farwall flagship'
array say[3] = ['Elastic obstacle: peak of the tip', 'Dam break on a far wall: mean force', \
    'Flagship: peak of the tip']
array unit[3] = ['mm', 'force / ρgH²', 'mm']
array top[3] = [60, 0.25, 3]
families = 'slip stick slip-healed stick-healed'
array name[4] = ['slip', 'stick', 'slip, no tension, healed', 'stick, no tension, healed']
array wide[4] = [2, 2, 3.5, 3.5]
array dash[4] = [2, 2, 1, 1]
array mark[4] = [6, 6, 7, 7]
array hue[4] = [1, 2, 1, 2]
only(family) = sprintf("< awk '$1 == \"%s\"' %s", family, file)

set terminal pngcairo size 1700, 560 font 'Sans,17'
set output '../sticking.png'
set multiplot layout 1, 3 margins 0.05, 0.985, 0.13, 0.92 spacing 0.065, 0.1
set xlabel 'spacing / mm' offset 0, 0.5
set xrange [0:*]
do for [k = 1:3] {
    file = word(cases, k).'.csv'
    set title say[k] offset 0, -0.6
    set ylabel unit[k] offset 1.5, 0
    set yrange [0:top[k]]
    if (k == 1) { set key bottom left Left reverse samplen 2 spacing 1.2 } else { unset key }
    plot for [i = 1:4] only(word(families, i)) using (1000 * $2):3 with linespoints \
        lw wide[i] dt dash[i] pt mark[i] ps 1.4 lc rgb pick(hue[i]) title name[i]
}
unset multiplot
