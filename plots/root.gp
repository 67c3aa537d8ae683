# root.gp -- what the support of every beam feels at its root against time: force across, bending
# moment, and the stress that it makes in a rectangular section
# needs: beam.csv figures/constants.gp
load 'style.gp'
table = '../beam.csv'
load 'filtered.gp'
panels = 2 * words(beams)
each = 250.0
tall = 60 + each * panels + 110
set terminal pngcairo size 1200, tall font 'Sans,17'
set output 'root.png'
set multiplot title title noenhanced
set lmargin at screen 0.12
set rmargin at screen 0.88
set xrange [0:until]
unset key
eval foot
per = dim == 2 ? '/m' : ''
stress(b) = (h = word(sections, b) + 0.0, h > 0 ? 6 / h**2 * 1e-6 : 0) # [MPa] of a moment per width
factor = 1
do for [panel = 1:panels] {
    eval place
    if (panel == 2) { unset label 11; unset label 12 }
    b = (panel + 1) / 2
    moment = panel % 2 == 0
    c = column_of(word(beams, b).(moment ? '.root_moment' : '.root_force'))
    eval start_limits
    stats table using (widen(mean($0, $1, area($0, $1, column(c))))) skip 2 nooutput
    if (abs(low) < rounding && abs(high) < rounding) { low = -1; high = 1 }
    eval limits
    cut = ''
    called = 'it goes'
    eval beyond
    set label 1 strlen(cut) ? 'beyond the axis: '.cut : '' at graph 0.01, 0.06 left noenhanced \
        font ',12' tc rgb '#606060'
    set label 2 word(beams, b) at graph 0.99, 0.92 right noenhanced
    set label 3 moment && stress(b) == 0 ? 'no stress: the body has no section of one height' : '' \
        at graph 0.99, 0.80 right font ',12'
    set ylabel (moment ? 'root moment [N m' : 'root force [N').per.']'
    set ytics nomirror
    unset y2tics
    unset y2label
    set yrange [low:high]
    if (moment && stress(b) > 0) {
        set y2range [low * stress(b):high * stress(b)]
        set y2tics
        set y2label 'bending stress 6M/h² [MPa]'
    }
    plot 0 lc rgb grey lw 1 notitle, \
        table using 1:(column(c)) skip 2 with lines lw 1 lc rgb faint(moment + 1), \
        table using (v = mean($0, $1, area($0, $1, column(c))), middle):(v) skip 2 \
        with lines lw 3 lc rgb pick(moment + 1)
}
unset multiplot
