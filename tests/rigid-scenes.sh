#!/bin/sh
# rigid-scenes.sh -- what the headers of shipped scenes with rigid bodies promise.
. "$top_srcdir/tests/lib.sh"

scenes=$top_srcdir/data/scenes

# field RUN COLUMN AWK: a program that sees t and x, a column of bodies.csv, row by row.
field()
{
    awk -F, -v name="$2" '
        /^#/ { next }
        /^t/ { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        { t = $1; x = $column }
        '"$3" "$out/$1/bodies.csv"
}

# Archimedes: 1.3197 radii deep in a level of (0.24 - 0.0104 + 0.0141)/0.8 m. The wedge below has the same.
if [ -n "${STIFFWATER_LONG-}" ]; then
    well disc "$scenes/floating-disc.scene"
    rise=$(field disc log.y 't > 5 { n++; sum += x } END { print sum / n - 0.2790 }')
    echo "disc: its centre is $rise m above the place by Archimedes"
    claim 'draft of a disc within a tenth of a spacing' "$rise^2 < 0.001^2"
    claim 'its energy closes' "$(number disc energy_defect_max) < 1e-3"
fi

# A triangle: sqrt(1/2) of its height deep in a level of (0.1890 + 0.01125)/0.8 m.
well wedge "$scenes/floating-wedge.scene"
rise=$(field wedge wedge.y 't > 6 { n++; sum += x } END { print sum / n - 0.25031 + 0.15 * (sqrt(0.5) - 2 / 3) }')
lift=$(field wedge wedge.fy 't > 6 { n++; sum += x } END { print sum / n / 110.3625 }')
echo "wedge: its centre is $rise m above the place by Archimedes, its lift $lift of its weight"
claim 'draft of a wedge within a tenth of a spacing' "$rise^2 < 0.001^2"
claim 'its lift is its weight within 1 %' "($lift - 1)^2 < 0.01^2"
claim 'it is upright within a degree' "$(field wedge wedge.angle 'END { print x }')^2 < 0.0175^2"
claim 'its energy closes, too' "$(number wedge energy_defect_max) < 1e-3"

# The experiment: 0.35 s.
well block "$scenes/sinking-block.scene"
# Water stays beneath it: its lower face comes to rest within half a spacing of the bed.
down=$(field block block.y 'x < 0.01125 && !found { print t; found = 1 }')
echo "block: on the bed after $down s, in the experiment 0.352 s"
claim 'a block sinks in the time of the experiment within 10 %' "($down / 0.352 - 1)^2 < 0.1^2"

# A thin plate with the water that it turns: 1.32 s.
well gate "$scenes/pendulum-gate.scene" until=4.2
period=$(field gate gate.angle '
    was * x < 0 { place = was_t + (t - was_t) * was / (was - x); if (!n++) first = place; last = place }
    { was = x; was_t = t }
    END { print 2 * (last - first) / (n - 1) }')
echo "gate: a period of $period s, of a thin plate 1.32 s, without water 1.04 s"
claim 'a plate swings under water as theory says within 5 %' "($period / 1.32 - 1)^2 < 0.05^2"
claim 'its momentum closes' "$(number gate momentum_defect) < 1e-5"

# Amplitude and mean with the waves' period over three periods.
amplitude='t > 4.49 && t < 7.49 { w = 2 * 3.14159265358979 / 1.5; c += x * cos(w * t); s += x * sin(w * t); n++ }
    END { print 2 * sqrt(c * c + s * s) / n }'
well waves "$scenes/box-in-waves.scene" spacing=0.025 until=7.5
heave=$(field waves box.y "$amplitude")
sway=$(field waves box.x "$amplitude")
roll=$(field waves box.angle "$amplitude")
echo "waves: heave $heave m for 0.0239 m, sway $sway m for 0.0358 m, roll $roll for 0.0641"
claim 'a box goes up and down with the wave within 10 %' "($heave / 0.0239 - 1)^2 < 0.1^2"
claim 'it goes to and fro with the water within 15 %' "($sway / 0.0358 - 1)^2 < 0.15^2"
claim 'it rolls with the slope within 15 %' "($roll / 0.0641 - 1)^2 < 0.15^2"
claim 'its drift is small' "($(field waves box.x 't > 6 { n++; sum += x } END { print sum / n - 2 }') / 0.3)^2 < 0.3^2"
claim 'its energy closes in waves' "$(number waves energy_defect_max) < 1e-3 * $(number waves energy_initial)"

finish
