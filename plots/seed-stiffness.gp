# seed-stiffness.gp -- standard SPH against WCSPH: the front, and the energy that the pressure
# makes with the two kernels of Toth (2012)
# needs: the runs of plots/figures-seed.sh, which draws this
load 'style.gp'
width = 0.1      # of the column [m], twice as high
dx = 2e-3
gravity = 9.81
T(t) = t * sqrt(2 * gravity / width)
Z(x) = (x + dx / 2) / width
is(name) = strcol(1) eq name ? $2 : NaN
runs = 'standard-printed standard-matched wcsph wcsph-printed'
array label[4] = ['linear, k = 10000 as printed: c = 100 m/s', 'linear, k = 392.4: c = 19.8 m/s', \
    'Tait, c = 19.8 m/s', 'Tait, c = 4 m/s as printed']
array dash[4] = ['1', '1', '(8,6)', '1']

set terminal pngcairo size 1700, 800 font 'Sans,18'
set output '../seed-stiffness.png'
set multiplot layout 1, 2 \
    title "dam break of Toth (2012), 5,000 particles: standard SPH (linear) and WCSPH (Tait)"
set lmargin 10
set rmargin 3

set xlabel 'time  T = t √(2g/a)'
set ylabel 'front  Z = x / a'
set xrange [0:3.6]
set yrange [0.8:5]
set key top left Left reverse samplen 3 spacing 1.2
as = 'with lines lw %g dt %s lc rgb pick(%d) title label[%d]'
line(i) = sprintf("'%s/front.csv' using (T($1)):(Z($2)) skip 2 ".as, \
    word(runs, i), i == 3 ? 4 : 3, dash[i], i, i)
above(e) = e > 0 ? e : NaN
made(i) = sprintf("'%s/book.csv' using 1:(above(column('pressure_defect'))) skip 1 ".as, \
    word(runs, i), i == 3 ? 4 : 3, dash[i], i, i)
lines = ''
works = ''
do for [i = 1:4] {
    lines = lines.', '.line(i)
    works = works.', '.made(i)
}
eval "plot 'B01a_martin_moyce_1952_front_n2_2.csv' using (is('a2.25in_pysph')):3 skip 4 " \
    ."with points ps 1.6 lw 2 pt 4 lc rgb grey title 'Martin, Moyce 1952, a = 57.2 mm'".lines

set xlabel 't [s]'
set ylabel 'energy out of nothing [J/m]'
set xrange [0:0.6]
set yrange [0.01:1000]
set logscale y
set datafile columnheaders
unset key
set label 1 'energy at the start' at 0.01, 19.62 offset 0, 0.7 tc rgb '#606060'
eval "plot 19.62 lw 1.5 dt '-' lc rgb '#606060' notitle".works
unset multiplot
