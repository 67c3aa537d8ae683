#!/bin/sh
# C03walls.sh -- the elastic obstacle with contact walls, at three spacings
#
# C03 with `walls = "contact"` and artificial viscosity that does not act at solids, dx = 4.06, 2.98 and 2 mm (the
# obstacle 3, 4 and 6 dx thick), to 0.35 s: with pressures that may be negative (tension), and with `eos.tension =
# false` and `density-healing` (healed). Tension between water and obstacle pulls the tip back; without it the peak is the same
# at all three spacings. What stick and other walls make of it: [walls.md](walls.md).
. "$(dirname "$0")/lib.sh"
scene=$scenes/elastic-obstacle.scene
tip() { column "$1/beam" obstacle.tip_x | awk '{ print $1, 1000 * $2 }'; }
# judge RUN NAME WHY
judge() {
    name=$2
    # shellcheck disable=SC2046 # two words
    set -- "$1" "$3" $(tip "$1" | most)
    row "peak of the tip, $name" '41 to 49 mm' "$(calc "$3") mm" '40 to 50 mm' "$3 > 40 && $3 < 50" "$(cost "$1")" "$2"
    row "when, $name" '0.217 to 0.260 s' "$(calc "$4") s" '0.21 to 0.27 s' "$4 > 0.21 && $4 < 0.27" ''
}
for k in '4.06 4.0555555555555553e-3 3' '2.98 2.9795918367346937e-3 4' '2 2e-3 6'; do
    # shellcheck disable=SC2086 # three words
    set -- $k
    keys="spacing=$2 beam.obstacle.layers=$3 until=0.35 output.snapshots=1 walls=contact effects.artificial-viscosity.stick=none"
    # shellcheck disable=SC2086 # keys
    {
        go "healed-$1" "$scene" $keys eos.tension=false effects.density-healing={}
        go "tension-$1" "$scene" $keys
    }
    judge "healed-$1" "dx = $1 mm, healed" ''
    why='tension pulls the tip back; it rises with 1/dx, as the next rows show'
    [ "$1" != 2 ] || why=
    judge "tension-$1" "dx = $1 mm, tension" "$why"
    tip "healed-$1" >"healed-$1.t"
    tip "tension-$1" >"tension-$1.t"
done
grep -v '^#' "$reference/C03_dambreak_elastic_obstacle_tip.csv" | tr , ' ' >seen
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'tip [mm]'
set xrange [0.1:0.35]
set yrange [-5:52]
set key bottom right
dx = '4.06 2.98 2'
plot 'seen' using 2:(1000 * $3) with points pt 6 ps 0.4 lc rgb grey title 'six codes', \
    for [i = 1:3] 'healed-'.word(dx, i).'.t' with lines lw 2 lc rgb pick(i) title 'healed, '.word(dx, i).' mm', \
    for [i = 1:3] 'tension-'.word(dx, i).'.t' with lines lw 1.5 dt '-' lc rgb pick(i) title 'tension, '.word(dx, i).' mm'
G
done_here
