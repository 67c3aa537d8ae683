#!/bin/sh
# B03.sh -- a dam break against a wall: pressure and heights
#
# 0.6 m of water, 1.2 m long, in a tank of 3.22 m (`tests/validation/buchner.scene`, dx = H/60):
# the experiment of Zhou, De Kat and Buchner (1999), `data/reference/B03*.csv`, whose zero of time
# is approximate, and for the lowest sensors the incompressible SPH of De Courcy et al., Comput.
# Meth. Appl. Mech. Eng. 420 (2024) 116700, with 400 particles in H, `B04c_decourcy_2024_numerical_pressure.csv`.
# T = t sqrt(g/H), pressures over rho g H. The disc at 0.16 m is the mean of five probes.
#
# Walls `adami` that slip. The layer that really sticks to a wall is far thinner than dx; walls
# that do not slip brake the sheet and give 40 % less pressure at the lowest sensors. Peaks of the
# first touch depend on the moment that a particle hits a probe, and are not judged.
. "$(dirname "$0")/lib.sh"
go run "$cases/buchner.scene" walls=adami wall.tank.slip=true
go own "$cases/buchner.scene" spacing=0.02 until=1.3
go stick "$cases/buchner.scene" walls=adami spacing=0.02 until=1.3
go coarse "$cases/buchner.scene" walls=adami wall.tank.slip=true spacing=0.02 until=1.3
# scaled RUN: T, disc, p1, p2, p3 in rho g H; h1, h2 in H
scaled() {
    column "$1/probes" d1 d2 d3 d4 d5 p1 p2 p3 h1 h2 | awk '{ print $1 * sqrt(9.81 / 0.6),
        ($2 + $3 + $4 + $5 + $6) / 5 / 5886, $7 / 5886, $8 / 5886, $9 / 5886, $10 / 0.6, $11 / 0.6 }'
}
# late COLUMN <FILE: mean for 3.5 < T < 5
late() { awk -v c="$1" '{ print $1, $c }' "$2" | mean 3.5 5; }
for run in run own stick coarse; do scaled $run >$run.t; done

arrival=$(awk '{ print $1, $3 }' run.t | first 0.05)
row 'arrival at the wall, T' '2.5' "$(calc "$arrival")" '0.1' "sqrt(($arrival - 2.5) ^ 2) < 0.1" "$(cost run)" \
    'no gate, no friction: De Courcy, with neither, has 2.36'
m=$(late 2 run.t)
row 'disc at 0.16 m, mean for 3.5 < T < 5' '0.54 measured, 0.37 De Courcy' "$(calc "$m")" '0.33 to 0.65' "$m > 0.33 && $m < 0.65" ''
for k in '1 3 0.98' '2 4 0.92' '3 5 0.82'; do
    # shellcheck disable=SC2086 # three words
    set -- $k
    m=$(late "$2" run.t)
    row "P$1, mean for 3.5 < T < 5" "$3 (De Courcy)" "$(calc "$m")" '20 %' "sqrt(($m / $3 - 1) ^ 2) < 0.2" ''
done
for k in 'coarse slip,_adami' 'stick stick,_adami' 'own stick,_own-density'; do
    # shellcheck disable=SC2086 # two words
    set -- $k
    m=$(late 3 "$1.t")
    why=
    [ "$1" = coarse ] || why='the sheet is braked by walls that do not slip'
    row "P1 with dx = H/30, $(echo "$2" | tr _ ' ')" '0.98 (De Courcy)' "$(calc "$m")" '20 %' \
        "sqrt(($m / 0.98 - 1) ^ 2) < 0.2" "$(cost "$1")" "$why"
done
# height COLUMN FILE FROM TO: rms distance from the experiment, of H
height() {
    awk -F'[, ]' -v c="$1" -v from="$3" -v to="$4" '
        FILENAME == "run.t" { t[n] = $1; h[n++] = $c; next }
        $1 != "experiment_zhou1999" || $2 < from || $2 > to { next }
        { while (i < n - 2 && t[i + 1] < $2) i++; d = h[i] - $3; s += d * d; k++ }
        BEGIN { n = i = 0 } END { printf "%.4f", sqrt(s / k) }' run.t "$2"
}
d=$(height 7 "$reference/B03_zhou_1999_h2.csv" 2 6)
row 'height 0.992 m before the wall, rms for 2 < T < 6' 'experiment' "$d H" '0.05 H' "$d < 0.05" ''
d=$(height 6 "$reference/B03_zhou_1999_h1.csv" 2 5.5)
row 'height 0.495 m before the wall, rms for 2 < T < 5.5' 'experiment' "$d H" '0.05 H' "$d < 0.05" ''

grep experiment "$reference/B03_zhou_1999_p2.csv" >seen.p
grep experiment "$reference/B03_zhou_1999_h1.csv" >seen.h1
grep experiment "$reference/B03_zhou_1999_h2.csv" >seen.h2
grep '^P1' "$reference/B04c_decourcy_2024_numerical_pressure.csv" >computed.p1
grep '^P4' "$reference/B04c_decourcy_2024_numerical_pressure.csv" >computed.p4
tr ' ' , <run.t >run.csv
draw <<'G'
set multiplot layout 3, 1
set xrange [1.4:7]
set lmargin 8
set key top left Left reverse
set ytics 1
set ylabel 'P1 / ρgH'
set yrange [0:3]
plot 'computed.p1' using 2:3 with lines lw 1 lc rgb pick(2) title 'De Courcy 2024', \
    'run.csv' using 1:3 with lines lw 1.5 lc rgb pick(1) title 'here'
set ytics 0.5
set ylabel 'disc / ρgH'
set yrange [0:1.6]
plot 'seen.p' using 2:3 with lines lw 1 lc rgb grey title 'Zhou 1999', \
    'computed.p4' using 2:3 with lines lw 1 lc rgb pick(2) title 'De Courcy 2024', \
    'run.csv' using 1:2 with lines lw 1.5 lc rgb pick(1) title 'here'
set ytics 0.3
set ylabel 'heights / H'
set xlabel 'T = t √(g/H)'
set yrange [0:0.9]
plot 'seen.h1' using 2:3 with lines lw 1.5 lc rgb grey title '0.495 m before the wall, Zhou 1999', \
    'seen.h2' using 2:3 with lines lw 1.5 dt '-' lc rgb grey title '0.992 m', \
    'run.csv' using 1:6 with lines lw 1.5 lc rgb pick(1) title 'here', \
    '' using 1:7 with lines lw 1.5 dt '-' lc rgb pick(1) notitle
unset multiplot
G
done_here
