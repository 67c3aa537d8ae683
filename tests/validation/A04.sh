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
    [ $n = 25 ] && why='the softening of (V1), 0.01 hs^2 in its denominator'
    row "rate of decay to 0.05 s, dx = L/$n" '1.579 1/s' "$(calc "$early") 1/s, $(calc "100 * ($early / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($early / 1.5791367 - 1) ^ 2) < 0.02" "$(cost run$n)" "$why"
    row "rate of decay to 0.5 s, dx = L/$n" '1.579 1/s' "$(calc "$late") 1/s, $(calc "100 * ($late / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($late / 1.5791367 - 1) ^ 2) < 0.02" '' 'particles leave their lattice; see below for the cure'
done
for n in 25 50 100; do
    dx=$(awk -v n=$n 'BEGIN { print 1 / n }')
    go held$n "$scenes/taylor-green.scene" spacing="$dx" until=2 kernel.support=4 'effects.particle-shifting={}' \
        output.snapshots=1
    column held$n/book kinetic | awk 'NR == 1 { e = $2 } { print $1, $2 / e }' >held$n.ke
    rate=$(awk '{ x = -log($2) / $1 } END { print x }' held$n.ke)
    why=
    [ $n = 25 ] && why='the softening of (V1), as above'
    row "with particle-shifting, H = 4 dx: rate of decay to 2 s, dx = L/$n" '1.579 1/s' \
        "$(calc "$rate") 1/s, $(calc "100 * ($rate / 1.5791367 - 1)") %" '2 %' \
        "sqrt(($rate / 1.5791367 - 1) ^ 2) < 0.02" "$(cost held$n)" "$why"
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
