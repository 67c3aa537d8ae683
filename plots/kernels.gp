# kernels.gp -- smoothing kernels in 2D with support H = 1 m: four of Toth 2012 (figures 4, 6,
# 7, 8) with their derivatives, and all of them side by side
# needs: kernel.csv of plots/kernel-table; drawn by plots/figures-kernels.sh, not with a run
load 'style.gp'
set xlabel 'r / H'
set xrange [0:1.05]
set xtics 0.2
inside(r, y) = r <= 1 ? y : NaN

# One kernel: W, W' and its Laplacian, each with its own scale; `printed` is the Laplacian of
# the paper where that differs.
set terminal pngcairo size 1700, 640 font 'Sans,18'
array what[3] = ['W  [1/m^2]', "W'  [1/m^3]", 'Laplacian of W  [1/m^4]']
names = 'gauss poly6 spiky viscosity-log'
files = 'gauss poly6 spiky viscosity'
array about[4] = ['gauss, cut at H = 3 ħ and lowered to 0 there: (13)', \
    'poly6: (15), (16), (17)', 'spiky: (25), (26), (27)', \
    'viscosity-log, the W whose Laplacian is linear: (31)']
array low[12] = [0, -3, -30, 0, -2.5, -50, 0, -10, -60, 0, -40, -20]
array high[12] = [1.6, 0, 10, 1.4, 0, 10, 3.5, 0, 10, 6, 0, 15]
array printed[4] = ['', '-48 / pi * (1 - x**2) * (3 - 7 * x**2)', \
    '-60 / pi * (1 - x) * (1 - 2 * x)', '-40 / pi * (1 - x)']
array number[4] = ['', '(17)', '(27)', '(31)']

do for [k = 1:4] {
    set output '../kernel-'.word(files, k).'.png'
    set multiplot layout 1, 3 title about[k].' of Toth 2012;  2D, H = 1 m'
    set lmargin 10.5
    set rmargin 1.5
    do for [d = 1:3] {
        set yrange [low[3 * (k - 1) + d]:high[3 * (k - 1) + d]]
        set ylabel what[d]
        set key bottom right samplen 2
        curve = "plot 0 lc rgb '#404040' lw 1 notitle, '".word(names, k).".csv' " \
            ."using 1:(column(d + 1)) skip 2 with lines lw 3.5 lc rgb pick(d) "
        if (d < 3 || k == 1) { eval curve.'notitle'; continue }
        eval curve."title 'this program', inside(x, ".printed[k].") with lines lw 2.5 dt '-' " \
            ."lc rgb grey title '".number[k]." as printed'"
    }
    unset multiplot
}

# All of them.
set terminal pngcairo size 1700, 900 font 'Sans,18'
set output '../kernels-all.png'
all = 'wendland-c2 wendland-c4 wendland-c6 cubic-spline quintic-spline gauss poly6 spiky '. \
    'viscosity-log'
dashes(i) = i < 4 || i == 7 ? 1 : i == 6 ? 4 : i == 9 ? 3 : 2
hue(i) = pick(i < 7 ? i : 7)
set multiplot layout 1, 2 title 'kernels of equal support, each with integral 1,  2D, H = 1 m'
set lmargin 9.5
set rmargin 2
set key top right spacing 1.15 samplen 3
set ylabel 'W  [1/m^2]'
set yrange [0:4]
plot for [i = 1:9] word(all, i).'.csv' using 1:2 skip 2 with lines lw 3 dt dashes(i) \
    lc rgb hue(i) title word(all, i)
set ylabel "-W'  [1/m^3]"
set yrange [0:12]
plot for [i = 1:9] word(all, i).'.csv' using 1:(-$3) skip 2 with lines lw 3 dt dashes(i) \
    lc rgb hue(i) title word(all, i)
unset multiplot
