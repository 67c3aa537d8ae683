# spread-front.gp -- how far and how high the water stands, over runs that began alike
# needs: spread-front.csv spread.csv figures/constants.gp figures/runs.gp
load 'style.gp'
load 'spread-bands.gp'
table = '../spread-front.csv'
eval read_names
set terminal pngcairo size 1200, 1000 font 'Sans,18'
set output 'spread-front.png'
set multiplot layout 2, 1 title title."\n".few."\n".legend noenhanced
set lmargin 10
set rmargin 3
set xrange [0:until]
scale = 1
what = 'x'
tone = pick(1)
set ylabel 'front x [m]'
eval draw_band
what = 'height'
tone = pick(2)
set xlabel 'time [s]'
set ylabel 'height [m]'
eval draw_band
unset multiplot
