#!/bin/sh
# still.sh -- water at rest for 60 sqrt(H/g), 40 spacings deep, with all walls: nothing creeps,
# boils or sticks.  With STIFFWATER_LONG also in three dimensions, 20 spacings deep.
#
# Marks, after 1 s: kinetic energy below 1e-5 m g H; centre of mass within 0.5 % of H of H/2; the
# level within 0.5 % of H of H; bed pressure within 2 %.  A density by sums with ghosts misses two
# of them, 1e-4 and 1.5 % are what it keeps: it rustles, and its surface, of half a surrounding,
# sinks by a third of a spacing.
. "$top_srcdir/tests/lib.sh"
H=0.2

# rests NAME MASS GAUGE KINETIC LEVEL: the marks, for a gauge so high above the bed
rests() {
    if words=$(awk -F, -v name="$1" -v m="$2" -v above="$3" -v most="$4" -v far="$5" -v H=$H -v g=9.81 '
        /^#/ || /^t/ || $1 < 1 { next }
        FILENAME ~ /book/ { if ($2 > kinetic) kinetic = $2
                            off = $3 / (m * g) - H / 2; off = off < 0 ? -off : off
                            if (off > centre) centre = off
                            next }
        { n++; p += $2; off = $3 - H; off = off < 0 ? -off : off
          if (off > level) level = off }
        END { kinetic /= m * g * H; centre /= H; level /= H; p = p / n / (1000 * g * (H - above)) - 1
              ok = kinetic < most && centre < 5e-3 && level < far && p < 0.02 && p > -0.02
              printf "%s: kinetic %.2g m g H, centre of mass %.2g H, level %.2g H, bed pressure %+.2f %%\n",
                  name, kinetic, centre, level, 100 * p
              exit !ok }' "$out/$1/book.csv" "$out/$1/probes.csv"); then good "$words"; else wrong "$words"; fi
    claim 'no particle leaves' "$(number "$1" escaped) == 0"
    claim 'energy closes' "$(number "$1" energy_defect_max) < 1e-3 * $(number "$1" energy_initial)"
}

scene=$top_srcdir/data/scenes/still-water.scene
for walls in contact own-density adami; do
    go $walls "$scene" until=8.57 walls=$walls
    claim "$walls comes to its end" "$code == 0"
    rests $walls 40 0.015 1e-5 5e-3
done
sed 's/continuity = { }/summation = { }/; /density-diffusion/d; s/rho0 = 1000.0;/& tension = false;/' \
    "$scene" >"$out/ghost.scene"
go ghost "$out/ghost.scene" until=8.57 walls=ghost
claim 'ghost comes to its end' "$code == 0"
rests ghost 40 0.015 1e-4 0.015

if [ -n "${STIFFWATER_LONG-}" ]; then
    for walls in contact own-density adami; do
        go three-$walls "$top_srcdir/tests/hard/still-water-3d.scene" walls=$walls
        claim "$walls in 3D comes to its end" "$code == 0"
        rests three-$walls 2 0.03 1e-5 5e-3
    done
fi
finish
