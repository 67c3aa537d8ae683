#!/bin/sh
# A10.sh -- a column of water on a clamped plate
#
# 1 m wide, 2 m high, on 50 mm of aluminium clamped at both ends, plane strain, nu = 0.34; the
# weight of water and plate acts from t = 0 (`tests/validation/water-on-plate.scene`, dx = 25 mm, a linear
# beam). Reference: thin-plate theory, `data/reference/A10_hydrostatic_plate_analytic.csv`. Others, `A10b`:
# TrixiParticles -15 to +4 %, SPH-VCPM of Ng +7 %. Without damping the first swing is twice the
# deflection at rest; sound leaves with part of it.
. "$(dirname "$0")/lib.sh"
exact=-6.8604382e-05
for walls in contact own-density adami; do
    go $walls "$cases/water-on-plate.scene" walls=$walls
    column $walls/beam plate.mid_y >$walls.w
    late=$(mean 0.5 1 <$walls.w)
    row "late mean of the deflection, $walls" '-0.0686 mm' "$(calc "1000 * $late") mm, $(calc "100 * ($late / $exact - 1)") %" '5 %' \
        "sqrt(($late / $exact - 1) ^ 2) < 0.05" "$(cost $walls)"
    # shellcheck disable=SC2046 # two words
    set -- $(awk '{ print $1, -$2 }' $walls.w | most)
    row "first swing over that, $walls" 'about 2' "$(calc "-$1 / $late") at $2 s" '1.5 to 2.1' "-$1 / $late > 1.5 && -$1 / $late < 2.1" ''
done
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'middle of the plate [mm]'
set xrange [0:1]
plot -0.068604 lw 2 lc rgb grey title 'exact', \
    'contact.w' using 1:(1000 * $2) with lines lw 1 lc rgb pick(4) title 'contact', \
    'own-density.w' using 1:(1000 * $2) with lines lw 1 lc rgb pick(1) title 'own-density', \
    'adami.w' using 1:(1000 * $2) with lines lw 1 lc rgb pick(2) title 'adami'
G
done_here
