#!/bin/sh
# beam-contact.sh -- beams that touch rigid bodies and walls: a disc lies on a board, a board bends
# down to the floor, a board lies on another; without contacts the run ends there.
. "$top_srcdir/tests/lib.sh"

scene=$top_srcdir/tests/scenes/disc-on-beam.scene

# last RUN FILE COLUMN: its value in the last row.
last()
{
    awk -F, -v name="$3" '
        /^#/ { next }
        /^t/ { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        { value = $column }
        END { print value }' "$out/$1/$2"
}

# Small deflections: P a^2 (3 L - a)/(6 E I) + w L^4/(8 E I) = 7.425 mm.  The disc rubs, too, and touches
# a little nearer to the root, as the board slopes: 2 % less.
well disc "$scene"
claim 'the board bends as beams do, within 4 %' "($(last disc beam.csv board.tip_y) / -7.425e-3 - 1)^2 < 0.04^2"
claim 'and carries the disc' "($(last disc bodies.csv disc.contact_y) / 9.81 - 1)^2 < 1e-3^2"
claim 'its root carries both' "($(last disc beam.csv board.root_force) / -29.43 - 1)^2 < 1e-2^2"
claim 'momentum closes' "$(number disc momentum_defect) < 1e-9"
claim 'energy closes' "$(number disc energy_defect_max) < 0.01 * 6"

# A soft board that reaches the floor: its lowest point is a spacing below its axis.
soft='body=off beam.board.E=2e5 beam.board.length=0.25 beam.board.at=[0.0,0.1] fluid.water.to=[0.3,0.01]'
well floor "$scene" $soft
claim 'the floor stops the tip' "$(last floor beam.csv board.tip_y) > -0.094"
claim 'as it reaches it' "$(last floor beam.csv board.tip_y) < -0.085"
claim 'at the floor, momentum closes' "$(number floor momentum_defect) < 1e-9"
claim 'at the floor, energy closes' "$(number floor energy_defect_max) < 0.01 * 1.8"
go hits "$scene" $soft beam.board.contact=false
claim 'without a contact the run ends' "$code == 1"
prints hits 'beam.board has met wall.tank' 'contact = true'

# Two boards of one stiffness, 1 mm apart: whatever they press with, the sum of their deflections is that by the
# sum of their weights, 39.24 and 7.85 N, w L^4/(8 E I) = 35.3 mm at the tips.
boards=$top_srcdir/tests/scenes/two-boards.scene
well boards "$boards"
upper=$(last boards beam.csv upper.tip_y)
lower=$(last boards beam.csv lower.tip_y)
on_upper=$(last boards beam.csv upper.root_force)
on_lower=$(last boards beam.csv lower.root_force)
claim 'two boards bend by both weights, within 3 %' "(($upper + $lower) / -35.3e-3 - 1)^2 < 0.03^2"
claim 'one lies on the other, within a tenth of the gap' "(($upper - $lower) / -1e-3 - 1)^2 < 0.1^2"
claim 'the roots carry both' "(($on_upper + $on_lower) / -47.09 - 1)^2 < 1e-3^2"
claim 'the lower one the more' "$on_lower / -7.85 > 1.5"
claim 'of two boards, momentum closes' "$(number boards momentum_defect) < 1e-9"
claim 'of two boards, energy closes' "$(number boards energy_defect_max) < 1e-3"
well rough "$boards" beam.friction=0.5 until=0.4
claim 'with friction, momentum closes' "$(number rough momentum_defect) < 1e-9"
claim 'with friction, energy closes' "$(number rough energy_defect_max) < 1e-3"
go meet "$boards" beam.lower.contact=false
claim 'two beams of which one touches nothing end the run' "$code == 1"
prints meet 'beam.upper has met beam.lower'

for threads in 1 2; do
    OMP_NUM_THREADS=$threads "$STIFFWATER" run "$scene" -q until=0.1 -o "$out/bits-$threads" 2>"$out/said" ||
        wrong "bits: $(cat "$out/said")"
    grep state_hash "$out/bits-$threads/run.json" >>"$out/hashes"
done
claim 'one hash of two runs' "$(sort -u "$out/hashes" | wc -l) == 1"

finish
