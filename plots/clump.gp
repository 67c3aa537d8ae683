# clump.gp -- figure 2 of seed 003: a cube as a clump of balls, and how two of them interlock
# needs: the tables of plots/figures-clump.sh, which draws this
load 'style.gp'
set datafile separator ' '
set terminal pngcairo size 1500, 520 font 'Sans,15'
set output 'clump.png'
set multiplot
unset key
unset border
unset tics
unset grid
set size ratio -1
set size 0.3, 0.92
set origin 0.0, 0.02
set title '98 balls: radius 33 mm, pitch 21 mm'
plot 'whole' using 1:2:3:4:5 with rgbimage
set origin 0.28, 0.02
set title 'the same, cut in half'
plot 'cut' using 1:2:3:4:5 with rgbimage
set border 3
set size noratio
set size 0.42, 0.98
set origin 0.57, 0.01
set tics
set xtics nomirror
set ytics nomirror
set title 'a square on a slope, no friction (2D, pitch s = 15 mm)'
set xlabel 'time [s]'
set ylabel 'gone [mm]'
set xrange [0:0.25]
set yrange [0:55]
set key left top reverse Left
slope(t, a) = 500 * 9.81 * sin(a * pi / 180) * t * t
plot slope(x, 10) with lines lw 2 dt 2 lc rgb '#888888' title 'smooth faces', \
    slope(x, 5) with lines lw 2 dt 2 lc rgb '#888888' notitle, \
    'large-10' using 1:2 with lines lw 3 lc rgb '#08519c' title 'radius 1.1 s, 10 degrees', \
    'large-5' using 1:2 with lines lw 3 lc rgb '#6baed6' title '1.1 s, 5 degrees', \
    'half-10' using 1:2 with lines lw 3 lc rgb '#31a354' title 's/2, 10 degrees', \
    'small-10' using 1:2 with lines lw 3 lc rgb '#de2d26' title '0.32 s, 10 degrees', \
    'small-5' using 1:2 with lines lw 3 lc rgb '#fc9272' title '0.32 s, 5 degrees'
unset multiplot
