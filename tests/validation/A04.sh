#!/bin/sh
# A04.sh -- Taylor-Green vortices
#
# Vortices in a domain that repeats (`data/scenes/taylor-green.scene`, Re = 100), against the exact decay of
# their energy, exp(-16 pi^2 nu t/L^2), `data/reference/A04_taylor_green_decay.csv`. Known to be beyond a
# plain scheme: particles leave the lattice along the lines on which the flow parts, and the noise
# of that takes the energy. `particle-shifting` holds it: drawn with H = 4 dx, which it wants.
. "$(dirname "$0")/lib.sh"
: >by-spacing
for n in 25 50 100; do
    dx=$(awk -v n=$n 'BEGIN { print 1 / n }')
    go run$n "$scenes/taylor-green.scene" spacing="$dx" until=0.5 output.snapshots=1
    column run$n/book kinetic | awk 'NR == 1 { e = $2 } { print $1, $2 / e }' >run$n.ke
    early=$(awk '$1 > 0.0499 { print -log($2) / $1; exit }' run$n.ke)
    late=$(awk '{ x = -log($2) / $1 } END { print x }' run$n.ke)
    echo "$n $early $late" >>by-spacing
    why=
    [ $n = 25 ] && why='1.5 % are of (V1) at any dx, see below; the rest falls with dx^2'
    row "rate of decay to 0.05 s, dx = L/$n" '1.579 1/s' "$(calc "$early") 1/s, $(calc "100 * ($early / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($early / 1.5791367 - 1) ^ 2) < 0.02" "$(cost run$n)" "$why"
    row "rate of decay to 0.5 s, dx = L/$n" '1.579 1/s' "$(calc "$late") 1/s, $(calc "100 * ($late / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($late / 1.5791367 - 1) ^ 2) < 0.02" '' 'particles leave their lattice; see below for the cure'
done
# What (V1) leaves of viscosity on a square lattice without end, H = 3 dx, Wendland C2: per cent
limit=$(awk 'BEGIN { H = 3; hs = H / 2
    for (i = -3; i <= 3; i++) for (j = -3; j <= 3; j++) {
        r = sqrt(i * i + j * j); q = r / H
        if (r > 0 && q < 1) s += 7 / (3.14159265 * H ^ 3) * 20 * q * (1 - q) ^ 3 * i * i * r / (r * r + 0.01 * hs * hs)
    }
    printf "%.3f", 100 * (s - 1) }')
# slope OFFSET: of the logarithms of error and spacing, errors counted from OFFSET per cent
slope() {
    awk -v off="$1" '{ x = -log($1); e = 100 * ($2 / 1.5791367 - 1) - off; y = log(sqrt(e * e)); n++
        a += x; b += y; c += x * x; d += x * y } END { printf "%.2f", (n * d - a * b) / (n * c - a * a) }' by-spacing
}
o=$(slope 0)
row 'the same: order in dx, L/25 to L/100' '2' "$o" '0.8' "$o > 0.8" '' \
    'levels off at what (V1) is short by at any dx, see the next row'
o=$(slope "$limit")
row "the same, counted from what (V1) is short by on any lattice, $limit %" '2' "$o" '1.5' "$o > 1.5" ''
for n in 25 50 100; do
    dx=$(awk -v n=$n 'BEGIN { print 1 / n }')
    go held$n "$scenes/taylor-green.scene" spacing="$dx" until=2 kernel.support=4 'effects.particle-shifting={}' \
        output.snapshots=1
    column held$n/book kinetic | awk 'NR == 1 { e = $2 } { print $1, $2 / e }' >held$n.ke
    rate=$(awk '{ x = -log($2) / $1 } END { print x }' held$n.ke)
    why=
    [ $n = 25 ] && why='most of it (V1), as above'
    row "with particle-shifting, H = 4 dx: rate of decay to 2 s, dx = L/$n" '1.579 1/s' \
        "$(calc "$rate") 1/s, $(calc "100 * ($rate / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($rate / 1.5791367 - 1) ^ 2) < 0.02" "$(cost held$n)" "$why"
done
# Re = 1000: slower decay, so noise counts ten times as much
for n in 50 100; do
    dx=$(awk -v n=$n 'BEGIN { print 1 / n }')
    go fast$n "$scenes/taylor-green.scene" spacing="$dx" until=2 kernel.support=4 'effects.particle-shifting={}' \
        effects.laminar-viscosity.mu=0.001 output.snapshots=1
    column fast$n/book kinetic | awk 'NR == 1 { e = $2 } { print $1, $2 / e }' >fast$n.ke
    rate=$(awk '{ x = -log($2) / $1 } END { print x }' fast$n.ke)
    row "Re 1000, with particle-shifting, H = 4 dx: rate of decay to 2 s, dx = L/$n" '0.1579 1/s' \
        "$(calc "$rate") 1/s, $(calc "100 * ($rate / 0.15791367 - 1)") %" '2 %' \
        "sqrt(($rate / 0.15791367 - 1) ^ 2) < 0.02" "$(cost fast$n)" \
        'noise of particles that leave their lattice, most of it before 0.5 s; falls as dx^2'
done
draw <<'G'
set datafile separator ' '
set xlabel 't [L/U]'
set ylabel 'kinetic energy, of that at the start'
set logscale y
set xrange [0:1]
set yrange [0.01:1]
plot exp(-1.5791367 * x) lw 2 lc rgb grey title 'exact', \
    for [i = 1:3] 'run'.word('25 50 100', i).'.ke' with lines lw 1.5 lc rgb pick(i) title 'dx = L/'.word('25 50 100', i), \
    for [i = 1:3] 'held'.word('25 50 100', i).'.ke' with lines lw 1.5 dt 2 lc rgb pick(i) title 'shifted'
G
done_here
