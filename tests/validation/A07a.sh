#!/bin/sh
# A07a.sh -- a drop that swings in a central force
#
# A round drop, R = 1 m, begins as a pure strain of 0.5 1/s in a force -x (omega = 1 1/s) and
# swings between two ellipses (`data/scenes/oscillating-drop.scene`, dx = R/20). The reference is
# the solution of the three ordinary equations of Monaghan and Rafiee (Int. J. Numer. Meth. Fluids
# 71 (2013) 537), `data/reference/A07a_oscillating_drop.csv`. Semi-axes are those of the ellipse
# with the same second moments as the particles, a = 2 sqrt(mean x^2), over the radius of the disc
# with as many particles (0.3 % more than R).
. "$(dirname "$0")/lib.sh"

go run "$scenes/oscillating-drop.scene" until=5 output.snapshots=126
snapshots run '{ a += x * x; b += y * y; n++ }
    END { r = sqrt(n / 3.14159265) * 0.05
           printf "%s %.6f %.6f\n", t, 2 * sqrt(a / n) / r, 2 * sqrt(b / n) / r }' >axes
period=$(awk '{ print $1, $2 - $3 }' axes | cross 1 1)
sed '/^[#t]/d; s/,/ /g' "$reference/A07a_oscillating_drop.csv" >exact
# Largest error over one period, each snapshot against the reference at its time.
error=$(awk 'BEGIN { n = 0 } FILENAME == "exact" { t[n] = $1; a[n] = $3; b[n++] = $4; next }
    $1 <= 4.567 { i = int($1 / 0.05); s = ($1 - t[i]) / (t[i + 1] - t[i])
        d = $2 / (a[i] + s * (a[i + 1] - a[i])) - 1; if (d * d > m * m) m = d
        d = $3 / (b[i] + s * (b[i + 1] - b[i])) - 1; if (d * d > m * m) m = d }
    END { printf "%.2f", m < 0 ? -100 * m : 100 * m }' exact axes)
loss=$(column run/book kinetic potential internal | awk '{ e = $2 + $3 + $4 }
    NR == 1 { e0 = e } $1 < 4.57 { l = e } END { printf "%.2f", 100 * (1 - l / e0) }')

row 'period' '4.5674 s' "$(calc $period) s" '1.5 %' "sqrt(($period / 4.567374 - 1) ^ 2) < 0.015" "$(cost run)"
row 'semi-axes over a period' 'a(t), b(t)' "off by $error % at most" '2 %' "$error < 2" ''
row 'energy lost in a period' '0' "$loss %" '5 %' "$loss < 5 && $loss > -0.1" ''

draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'semi-axis [m]'
set xrange [0:5]
set key top center horizontal
plot 'exact' using 1:3 with lines lw 2 lc rgb pick(1) title 'a, exact', \
    '' using 1:4 with lines lw 2 lc rgb pick(2) title 'b, exact', \
    'axes' every 4 using 1:2 with points pt 6 lc rgb pick(1) title 'a, dx = R/20', \
    '' every 4 using 1:3 with points pt 4 lc rgb pick(2) title 'b, dx = R/20'
G
done_here
