#!/bin/sh
# A07b.sh -- a drop that flies apart into an ellipse; error against spacing and tolerance
#
# A round drop, R = 1 m, with u = (100 x, -100 y) 1/s and nothing that acts on it
# (`data/scenes/elliptic-drop.scene`, dx = R/20). The reference is the exact solution, with the
# set-up of Monaghan (J. Comput. Phys. 110 (1994) 399), `data/reference/A07b_elliptic_drop_free.csv`.
#
# With the default support of 3 dx the drop grows by 5 %, at any dx: drawn out 4 to 1 its lattice
# has too few neighbours along x for (D1) to keep its area, and pressure follows density. Steps do
# not cure that, nor does diffusion; a support of 5 dx does. Where things are drawn out, look at it.
#
# The figure has the larger error of a and b at 0.0076 s: on the left against dx, on the right
# that of time alone (the distance from a run with tol = 1e-5) against the tolerance, beside the
# levels of the left side (dotted). This flow is smooth, its steps are bounded by stability: from
# tol = 1 on time errs by a thousandth of what space does, and a tighter tolerance is wasted.
. "$(dirname "$0")/lib.sh"
scene=$scenes/elliptic-drop.scene

# axes RUN DX: t, a, b of each snapshot over the radius of as many particles (R is 0.3 % less)
axes() {
    snapshots "$1" '{ a += x * x; b += y * y; n++ } END { r = sqrt(n / 3.14159265) * '"$2"'
        printf "%s %.8f %.8f\n", t, 2 * sqrt(a / n) / r, 2 * sqrt(b / n) / r }'
}

# ends RUN DX: a and b at the end
ends() { axes "$1" "$2" | tail -n 1 | cut -d' ' -f2-; }
# shape_error FILE: largest error of a semi-axis over all snapshots, in per cent
shape_error() {
    awk 'BEGIN { n = 0 } FILENAME == "exact" { a[n] = $3; b[n++] = $4; next }
        { i = int($1 / 1e-4); s = $1 / 1e-4 - i
          d = $2 / (a[i] + s * (a[i + 1] - a[i])) - 1; if (d * d > m * m) m = d
          d = $3 / (b[i] + s * (b[i + 1] - b[i])) - 1; if (d * d > m * m) m = d }
        END { printf "%.2f", m < 0 ? -100 * m : 100 * m }' exact "$1"
}
# area_error FILE: of a b, from 1
area_error() { awk '{ d = $2 * $3 - 1; if (d * d > m * m) m = d } END { printf "%.2f", 100 * m }' "$1"; }

sed '/^[#t]/d; s/,/ /g' "$reference/A07b_elliptic_drop_free.csv" >exact
why='support too short for a lattice drawn out 4 to 1, see below'
for support in 3 5; do
    go "run$support" "$scene" output.snapshots=20 kernel.support=$support
    axes "run$support" 0.05 >shape$support
    error=$(shape_error shape$support)
    area=$(area_error shape$support)
    row "semi-axes to 0.0076 s, dx = R/20, support $support dx" 'a(t), b(t)' \
        "off by $error % at most" '2 %' "$error < 2" "$(cost run$support)" "$why"
    row "area a b, support $support dx" '1' "off by $area %" '1 %' "sqrt(($area) ^ 2) < 1" '' "$why"
    why=
done

# --- spacing ---------------------------------------------------------------------------------
: >by-spacing
runs=
for support in 3 5; do
    for dx in 0.1 0.05 0.025; do
        go "dx$dx-$support" "$scene" spacing=$dx output.snapshots=2 kernel.support=$support
        ends "dx$dx-$support" $dx | awk -v dx=$dx -v s=$support '{ a = $1 / 1.9445172 - 1
            b = $2 * 1.9445172 - 1; if (a < 0) a = -a; if (b < 0) b = -b
            print dx, s, (a > b ? a : b) }' >>by-spacing
        [ $support = 3 ] || runs="$runs dx$dx-5"
    done
done
order=$(awk '$2 == 5 { x = log($1); y = log($3); n++; a += x; b += y; c += x * x; d += x * y }
    END { printf "%.2f", (n * d - a * b) / (n * c - a * a) }' by-spacing)
# shellcheck disable=SC2086 # names of runs
row 'order in dx, R/10 to R/40, support 5 dx' '1 or more' "$order" '1' "$order > 1" "$(cost $runs)" \
    'levels off at 0.5 %, as H/dx stays: the error of a sum over so many neighbours'

# --- tolerance ---------------------------------------------------------------------------------
: >by-tolerance
for dx in 0.1 0.05 0.025; do
    go best "$scene" spacing=$dx output.snapshots=2 tol=1e-5
    for tol in 1 0.1 0.01 1e-3 1e-4; do
        go tol "$scene" spacing=$dx output.snapshots=2 tol=$tol
        echo "$tol $dx $(ends tol $dx) $(ends best $dx) $(number tol rhs_explicit)" >>by-tolerance
    done
done
share=$(awk 'FILENAME == "by-spacing" { if ($2 == 3) e[$1] = $3; next } $1 == 0.01 && $2 == 0.05 {
    d = $3 / $5 - 1; printf "%.3g", (d < 0 ? -d : d) / e[0.05] }' by-spacing by-tolerance)
row 'error of time (tol = 0.01) over that of dx = R/20' '-' "$share" '0.1' "$share < 0.1" "$(cost best)"

draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set logscale xy
set format y '10^{%L}'
set xlabel 'dx [m]'
set ylabel 'larger error of a, b at 0.0076 s'
set xrange [0.009:0.14]
set xtics (0.1, 0.05, 0.025, 0.0125)
set yrange [1e-7:0.1]
set key bottom right
plot for [i = 1:2] 'by-spacing' using ($2 == 1 + 2 * i ? $1 : NaN):3 with linespoints lw 2 pt 7 \
    lc rgb pick(i) title sprintf('support %d dx', 1 + 2 * i), 0.3 * x lw 1 dt '-' lc rgb grey title 'first order'
set xlabel 'tolerance'
set ylabel 'error at 0.0076 s'
set xrange [5e-5:2]
set xtics autofreq
set format x '10^{%L}'
set key center left Left reverse
at(d) = real(system(sprintf("awk '$1 == %g && $2 == 3 { print $3 }' by-spacing", d)))
max(a, b) = a > b ? a : b
plot for [i = 1:3] d = 0.1 / 2 ** (i - 1) 'by-tolerance' \
    using (abs($2 - d) < 1e-9 ? $1 : NaN):(max(abs($3 / $5 - 1), abs($4 / $6 - 1))) \
    with linespoints lw 2 pt 6 lc rgb pick(i) title sprintf('of time, dx = R/%g', 1 / d), \
    for [i = 1:3] at(0.1 / 2 ** (i - 1)) lw 1.5 dt '.' lc rgb pick(i) notitle
unset multiplot
G
done_here
