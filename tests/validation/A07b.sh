#!/bin/sh
# A07b.sh -- a drop that flies apart into an ellipse; error against spacing and tolerance
#
# A round drop, R = 1 m, with u = (100 x, -100 y) 1/s and nothing that acts on it
# (`data/scenes/elliptic-drop.scene`, dx = R/20). The reference is the exact solution, with the
# set-up of Monaghan (J. Comput. Phys. 110 (1994) 399), `data/reference/A07b_elliptic_drop_free.csv`.
#
# The error of the figure is that of a(0.0076 s), on the left against dx at the default tolerance
# (0.01), on the right against the tolerance for three spacings, each relative to its own run at
# 1e-5, which is the error of time alone; the dotted levels are the error of the spacing. Below
# the crossing of the two a tighter tolerance is wasted.
. "$(dirname "$0")/lib.sh"
scene=$scenes/elliptic-drop.scene
exact=1.9445

# axes RUN DX: t, a, b of each snapshot
axes() {
    snapshots "$1" '{ a += x * x; b += y * y; n++ } END { printf "%s %.8f %.8f\n", t,
        2 * sqrt(a / n + '"$2"' ^ 2 / 12), 2 * sqrt(b / n + '"$2"' ^ 2 / 12) }'
}
# value FILE: a at the end
value() { tail -n 1 "$1" | awk '{ print $2 }'; }

sed '/^[#t]/d; s/,/ /g' "$reference/A07b_elliptic_drop_free.csv" >exact
exact=$(awk '$1 == 0.0076 { print $3 }' exact)
go run "$scene" output.snapshots=20
axes run 0.05 >shape
# largest COLUMN: error of a semi-axis over all snapshots, in per cent
error=$(awk 'BEGIN { n = 0 } FILENAME == "exact" { a[n] = $3; b[n++] = $4; next }
    { i = int($1 / 1e-4); s = $1 / 1e-4 - i
      d = $2 / (a[i] + s * (a[i + 1] - a[i])) - 1; if (d * d > m * m) m = d
      d = $3 / (b[i] + s * (b[i + 1] - b[i])) - 1; if (d * d > m * m) m = d }
    END { printf "%.2f", m < 0 ? -100 * m : 100 * m }' exact shape)
area=$(awk '{ d = $2 * $3 - 1; if (d * d > m * m) m = d } END { printf "%.2f", 100 * m }' shape)
row 'semi-axes to 0.0076 s' 'a(t), b(t)' "off by $error % at most" '2 %' "$error < 2" "$(cost run)"
row 'area, a b' '1' "off by $area %" '1 %' "$area < 1 && $area > -1" ''

# --- spacing ---------------------------------------------------------------------------------
: >spacing
runs=
for dx in 0.1 0.05 0.025 0.0125; do
    go "dx$dx" "$scene" spacing=$dx output.snapshots=2 tol=1e-3
    axes "dx$dx" $dx >last
    echo "$dx $(value last) $exact" >>spacing
    runs="$runs dx$dx"
done
awk '{ e = $2 / $3 - 1; print $1, e < 0 ? -e : e }' spacing >by-spacing
order=$(awk '{ x = log($1); y = log($2); n++; a += x; b += y; c += x * x; d += x * y }
    END { printf "%.2f", (n * d - a * b) / (n * c - a * a) }' by-spacing)
# shellcheck disable=SC2086 # names of runs
row 'order in dx, R/10 to R/80' '1 or more' "$order" '1' "$order > 1" "$(cost $runs)"

# --- tolerance ---------------------------------------------------------------------------------
: >by-tolerance
for dx in 0.1 0.05 0.025; do
    go best "$scene" spacing=$dx output.snapshots=2 tol=1e-5
    axes best $dx >last
    best=$(value last)
    for tol in 1 0.3 0.1 0.03 0.01 3e-3 1e-3 1e-4; do
        go tol "$scene" spacing=$dx output.snapshots=2 tol=$tol
        axes tol $dx >last
        echo "$tol $dx $(value last) $best $(number tol rhs_explicit)" >>by-tolerance
    done
done
share=$(awk 'FILENAME == "by-spacing" { e[$1] = $2; next } $1 == 0.01 && $2 == 0.05 {
    d = $3 / $4 - 1; printf "%.3g", (d < 0 ? -d : d) / e[0.05] }' by-spacing by-tolerance)
row 'error of time over that of dx = R/20, tol = 0.01' '-' "$share" '0.1' "$share < 0.1" "$(cost tol)"

draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set logscale xy
set format y '10^{%L}'
set xlabel 'dx [m]'
set ylabel 'error of a'
set xrange [0.009:0.14]
set xtics (0.1, 0.05, 0.025, 0.0125)
set yrange [1e-7:0.1]
set key bottom right
plot 'by-spacing' using 1:2 with linespoints lw 2 pt 7 lc rgb pick(1) title 'tol = 0.001', \
    0.06 * x lw 1 dt '-' lc rgb grey title 'first order'
set xlabel 'tolerance'
set xrange [5e-5:2]
set xtics auto
set format x '10^{%L}'
set key top left Left reverse
at(d) = real(system(sprintf("awk '$1 == %g { print $2 }' by-spacing", d)))
plot for [i = 1:3] d = 0.1 / 2 ** (i - 1) 'by-tolerance' using (abs($2 - d) < 1e-9 ? $1 : NaN):(abs($3 / $4 - 1)) \
    with linespoints lw 2 pt 6 lc rgb pick(i) title sprintf('of time, dx = R/%g', 1 / d), \
    for [i = 1:3] at(0.1 / 2 ** (i - 1)) lw 1.5 dt '.' lc rgb pick(i) title sprintf('of dx = R/%g', 10 * 2 ** (i - 1))
unset multiplot
G
done_here
