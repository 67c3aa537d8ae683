#!/bin/sh
# F01.sh -- forces: momentum, and Archimedes
#
# The force on a wall is the sum over its particles, so that impulse and momentum of the water must
# balance to rounding: the dam break of `data/scenes/dam-break.scene` (dx = 5 mm, 1 s) from its own
# tables, P(t) - P(0) = m g t - impulses of all walls. At rest a box of 50 mm, held 0.1 m below
# the surface in water 40 spacings deep (`tests/validation/sunk-box.scene`), is lifted by
# rho g V = 24.53 N/m. The tables have ten digits.
#
# The skin of a beam is such a sum, too. Momentum is that of the water alone here, from its
# particles (`snapshots/`, eight digits), so that the beam may move: one of steel that is held at
# both ends (`tests/validation/sunk-beam.scene`, the box again), and the obstacle of
# `data/scenes/elastic-obstacle.scene` that bends by half its height. What its ends carry at
# rest is its weight less the lift. `tests/unit/skin-loads.c` has the same for the nodes, point by
# point: they get the skin's force and moment, to rounding.
. "$(dirname "$0")/lib.sh"
go dam "$scenes/dam-break.scene" spacing=5e-3 output.snapshots=1
go stiff "$cases/sunk-beam.scene" until=0.5 'fluid.above.velocity=[0.3,0.0]' \
    output.interval=0.025 output.snapshots=21
go bends "$scenes/elastic-obstacle.scene" until=0.4 output.interval=0.02 output.snapshots=21
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
# water RUN: t and momentum of the water at each snapshot
water() {
    m=$(column "$1/book" mass | awk 'NR == 1 { print $2 }')
    snapshots "$1" '{ px += u; py += v; n++ }
        END { printf "%s %.12g %.12g\n", t, '"$m"' * px / n, '"$m"' * py / n }'
}
# skin_balance RUN BEAM: the same of the water alone, between tank and beam
skin_balance() {
    m=$(column "$1/book" mass | awk 'NR == 1 { print $2 }')
    water "$1" >w
    column "$1/forces" tank.ix tank.iy "$2.ix" "$2.iy" | awk -v m="$m" '
        FILENAME == "w" { x[sprintf("%.9g", $1)] = $2; y[sprintf("%.9g", $1)] = $3; next }
        { t = sprintf("%.9g", $1) }
        t in x { if (!n++) { px = x[t]; py = y[t] }
            a = x[t] - px + $2 + $4; b = y[t] - py + m * 9.81 * $1 + $3 + $5
            e = sqrt(a * a + b * b); if (e > most) most = e; last = $1 }
        END { printf "%.2g", (n > 20 ? most / (m * 9.81 * last) : "nan") }' w -
}
run=dam
e=$(balance dam tank)
row 'dam break: momentum - weight + impulse on the tank' '0' "$e of m g t" '1e-9' "$e < 1e-9" "$(cost dam)"
run=held
e=$(balance held tank body)
row 'a held box in moving water: the same, tank and box' '0' "$e of m g t" '1e-9' "$e < 1e-9" "$(cost held)"
e=$(skin_balance stiff body)
row "a held beam's skin in moving water: the water alone, tank and skin" '0' "$e of m g t" '1e-9' \
    "$e < 1e-9" "$(cost stiff)"
e=$(skin_balance bends obstacle)
b=$(column bends/beam obstacle.tip_x | most | awk '{ print 1000 * $1 }')
row "a dam breaks on an obstacle that bends by $b mm: the same" '0' "$e of m g t" '1e-9' \
    "$e < 1e-9" "$(cost bends)"
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
        go $walls-beam$n "$cases/sunk-beam.scene" walls=$walls spacing="$dx" beam.body.layers=$((n / 4))
        f=$(column $walls-beam$n/forces body.fy | mean "5" 9)
        echo "$n $walls-beam $f" >>lift
        off=$(calc "100 * ($f / 24.525 - 1)")
        row "lift of a beam's skin, $walls, $n spacings" '24.53 N/m' "$(calc "$f") N/m, $off %" '3 %' \
            "sqrt(($off) ^ 2) < 3" "$(cost $walls-beam$n)"
    done
done
r=$(column own-density-beam40/beam body.root_force | mean 5 9)
r=$(calc "-2 * $r")
f=$(column own-density-beam40/forces body.fy | mean 5 9)
row 'what both ends of the beam carry, own-density, 40 spacings' 'weight - lift' \
    "$r N/m of $(calc "66.2175 - $f") N/m" '1 %' "sqrt(($r / (66.2175 - $f) - 1) ^ 2) < 0.01" ''
draw <<'G'
set datafile separator ' '
set xlabel 'depth / dx'
set ylabel 'lift / ρgV'
set xrange [0:60]
set yrange [0.95:1.05]
is(name) = strcol(2) eq name ? $3 / 24.525 : NaN
plot 1 lw 2 lc rgb grey title 'Archimedes', 'lift' using 1:(is('adami')) with points pt 7 ps 1.3 lc rgb pick(2) title 'adami', \
    '' using 1:(is('own-density')) with points pt 7 ps 1.3 lc rgb pick(1) title 'own-density', \
    '' using 1:(is('adami-beam')) with points pt 6 ps 2 lc rgb pick(2) title "adami, beam's skin", \
    '' using 1:(is('own-density-beam')) with points pt 6 ps 2 lc rgb pick(1) title "own-density, beam's skin"
G
done_here
