#!/bin/sh
# F01.sh -- forces: momentum, and Archimedes
#
# The force on a wall is the sum over its particles, so that impulse and momentum of the water must
# balance to rounding: the dam break of `data/scenes/dam-break.scene` (dx = 5 mm, 1 s) from its own
# tables, P(t) - P(0) = m g t - impulses of all walls. At rest a box of 50 mm, held 0.1 m below
# the surface in water 40 spacings deep (`tests/validation/sunk-box.scene`), is lifted by
# rho g V = 24.53 N/m. The tables have ten digits.
. "$(dirname "$0")/lib.sh"
go dam "$scenes/dam-break.scene" spacing=5e-3 output.snapshots=1
go held "$cases/sunk-box.scene" walls=adami until=0.5 'fluid.above.velocity=[0.3,0.0]'
# balance RUN WALLS: largest |P(t) - P(0) - m g t + impulses|, over m g t of the end
balance() {
    column "$1/book" mass momentum_x momentum_y >p
    shift
    names=
    for wall; do names="$names $wall.ix $wall.iy"; done
    # shellcheck disable=SC2086 # names of columns
    column "$run/forces" $names | paste -d' ' p - | awk '
        NR == 1 { px = $3; py = $4 }
        { x = $3 - px; y = $4 - py + $2 * 9.81 * $1
          for (i = 6; i <= NF; i += 2) { x += $i; y += $(i + 1) }
          e = sqrt(x * x + y * y); if (e > m) m = e; w = $2 * 9.81 * $1 }
        END { printf "%.2g", m / w }'
}
run=dam
e=$(balance dam tank)
row 'dam break: momentum - weight + impulse on the tank' '0' "$e of m g t" '1e-9' "$e < 1e-9" "$(cost dam)"
run=held
e=$(balance held tank body)
row 'a held box in moving water: the same, tank and box' '0' "$e of m g t" '1e-9' "$e < 1e-9" "$(cost held)"
: >lift
for walls in adami own-density; do
    for n in 20 40; do
        dx=$(awk -v n=$n 'BEGIN { print 0.2 / n }')
        go $walls$n "$cases/sunk-box.scene" walls=$walls spacing="$dx"
        f=$(column $walls$n/forces body.fy | mean "5" 9)
        echo "$n $walls $f" >>lift
        off=$(calc "100 * ($f / 24.525 - 1)")
        row "lift at rest, $walls, $n spacings" '24.53 N/m' "$(calc "$f") N/m, $off %" '3 %' \
            "sqrt(($off) ^ 2) < 3" "$(cost $walls$n)"
    done
done
draw <<'G'
set datafile separator ' '
set xlabel 'depth / dx'
set ylabel 'lift / ρgV'
set xrange [0:60]
set yrange [0.95:1.05]
is(name) = strcol(2) eq name ? $3 / 24.525 : NaN
plot 1 lw 2 lc rgb grey title 'Archimedes', 'lift' using 1:(is('adami')) with points pt 7 ps 1.3 lc rgb pick(2) title 'adami', \
    '' using 1:(is('own-density')) with points pt 7 ps 1.3 lc rgb pick(1) title 'own-density'
G
done_here
