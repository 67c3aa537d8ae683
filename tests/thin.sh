#!/bin/sh
# thin.sh -- solids that are one layer of particles thick, walls = "contact": they hold water that
# stands on one side, the book closes, and where water stands on both sides the program says what to do.
. "$top_srcdir/tests/lib.sh"
scene=$top_srcdir/tests/scenes/thin-skin.scene

# holds NAME: no particle beyond the middle of the layer, and none nearer to it than 0.4 spacings
holds() {
    claim "$1: no particle is beyond the layer or in it" "$(awk -F, '$8 == 0 && $1 > 0.1005 { n++ }
        END { print n + 0 }' "$out/$1"/snapshots/*.csv) == 0 && $(number "$1" escaped) == 0"
    claim "$1: pressure makes no energy" \
        "$(most "$1" book pressure_defect) < 1e-12 * $(number "$1" energy_initial)"
    claim "$1: energy closes" "$(number "$1" energy_defect_max) < 1e-3 * $(number "$1" energy_initial)"
    claim "$1: the water is at rest" "$(last "$1" book kinetic) < 1e-4"
}

well skin "$scene" output.snapshots=5
holds skin
sed '/^beam/d; s/^wall = .*/wall = { tank = { type = "frame"; };\
    plate = { type = "box"; from = [0.1, 0.0]; to = [0.105, 0.13]; }; };/' "$scene" >"$out/wall.scene"
well wall "$out/wall.scene" output.snapshots=5
holds wall

# Wet on both sides from the start: it says so.
sed 's/^fluid = {/& right = { type = "box"; from = [0.105, 0.0]; to = [0.205, 0.05]; };/' "$scene" \
    >"$out/both.scene"
well both "$out/both.scene" until=1e-3
prints both 'beam.plate is one layer of particles with water on both sides' 'set layers = 2 or more'
well layers "$out/both.scene" until=1e-3 beam.plate.layers=2 spacing=2.5e-3
! grep -q 'both sides at t = 0' "$out/layers.said" || wrong 'two layers are fine'
finish
