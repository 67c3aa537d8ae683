# dye.gp -- six moments of the flow, the water dyed in two colours (as figures 14 and 17 of
# Toth 2012 show theirs)
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
load 'panels.gp'

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'dye.png'
set multiplot title heading noenhanced
do for [m = 1:moments] {
    eval next_panel
    plot file using (is(1)):up:(r) skip 3 with circles fs solid noborder lc rgb wall notitle, \
        file using (is(0)):up:(r):(dye(column(dye_column))) skip 3 \
        with circles fs solid noborder lc rgb variable notitle, \
        file using (is(3)):up:(r) skip 3 with circles fs solid noborder lc rgb skin notitle
}
unset multiplot
