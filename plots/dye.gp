# dye.gp -- six moments of the flow, in the colours of the water's dye
# needs: snapshots.csv figures/constants.gp
load 'style.gp'
load 'panels.gp'

set terminal pngcairo size canvas_x, canvas_y font 'Sans,18'
set output 'dye.png'
entries = (dyes < 0 ? '' : dyes > 0 ? "'#1f6fb4:water' '#f2c418:water with dye 1'" : "'#1f6fb4:water'") \
    .(dyes > 1 ? " '#009e73:dye 2 and more'" : '').solids
eval put_scale
eval put_words
set multiplot title heading noenhanced
do for [m = 1:moments] {
    eval next_panel
    plot file using (is(1)):up:(r) skip 3 with circles fs solid noborder lc rgb wall notitle, \
        file using (is(0)):up:(r):(dye(column(dye_column))) skip 3 \
        with circles fs solid noborder lc rgb variable notitle, \
        file using (beams eq '' && shapes ne '' ? NaN : is(3)):up:(r_skin) skip 3 with circles fs solid noborder lc rgb skin notitle@bodies_too
    eval take_away
}
unset multiplot
