# spread-probes.gp -- what the gauges read, over runs that began alike
# needs: spread-probes.csv spread.csv figures/constants.gp figures/runs.gp
load 'style.gp'
load 'spread-bands.gp'
table = '../spread-probes.csv'
eval read_names
eval names_of_means
panels = words(means) < 12 ? words(means) : 12

set terminal pngcairo size 1200, 300 * panels + 120 font 'Sans,18'
set output 'spread-probes.png'
set multiplot layout panels, 1 title title."\n".few."\n".legend noenhanced
set lmargin 12
set rmargin 3
set xrange [0:until]
do for [k = 1:panels] {
    what = word(means, k)
    tone = pick(k)
    eval read_told
    scale = unit eq 'Pa' ? 1e-3 : 1
    set xlabel k == panels ? 'time [s]' : ''
    set ylabel what.(unit eq 'Pa' ? ' [kPa]' : ' ['.unit.']') noenhanced
    eval draw_band
}
unset multiplot
