#!/bin/sh
# C03fine.sh -- the elastic obstacle with 2 mm
#
# C03 with dx = 2 mm, obstacle 6 dx thick, and both wall models. Run once, kept; again by
# `make validation CASES=C03fine`.
# Long: a minute and a half.
. "$(dirname "$0")/lib.sh"
scene=$scenes/elastic-obstacle.scene
# As it was measured first: friction, tension, a hydrostatic start. C03walls has it as it is shipped.
old='effects.artificial-viscosity.stick=particles effects.density-diffusion.delta=0.1
    effects.density-healing.strength=0 fluid.water.initial=hydrostatic'
tip() { column "$1/beam" obstacle.tip_x | awk '{ print $1, 1000 * $2 }'; }
for walls in own-density adami; do
    # shellcheck disable=SC2086 # keys
    go $walls "$scene" $old eos.tension=true spacing=2e-3 beam.obstacle.layers=6 walls=$walls output.snapshots=1
    tip $walls >$walls.t
    # shellcheck disable=SC2046 # two words
    set -- $(awk '$1 < 0.35' $walls.t | most)
    row "peak of the tip, $walls" '41 to 49 mm' "$(calc "$1") mm" '40 to 50 mm' "$1 > 40 && $1 < 50" "$(cost $walls)"
    row "when, $walls" '0.217 to 0.260 s' "$(calc "$2") s" '0.21 to 0.27 s' "$2 > 0.21 && $2 < 0.27" ''
    o=$(first 2 <$walls.t)
    row "onset (2 mm), $walls" '0.138 to 0.161 s' "$(calc "$o") s" '0.14 to 0.165 s' "$o > 0.14 && $o < 0.165" ''
done
grep -v '^#' "$reference/C03_dambreak_elastic_obstacle_tip.csv" | tr , ' ' >seen
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'tip [mm]'
set xrange [0.1:0.7]
set yrange [-25:52]
plot 'seen' using 2:(1000 * $3) with points pt 6 ps 0.4 lc rgb grey title 'six codes', \
    'own-density.t' with lines lw 2.5 lc rgb pick(1) title 'own-density', \
    'adami.t' with lines lw 2 lc rgb pick(2) title 'adami'
G
done_here
