#!/bin/sh
# impacts.sh -- drops, a jet, a film, a plunging wave, one particle at half the sound speed:
# no particle passes through anything, nothing is not finite.  The marks stand in the scenes.
#
# Twice: at five times the speed, where artificial viscosity has to brake the water before walls,
# and with walls along which it slips, without tension, at ten times, as the program asks for.
# Each scene is there with one kind of wall at least, with STIFFWATER_LONG with all.
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/tests/hard
sticky='walls=own-density effects.artificial-viscosity.stick=particles
    effects.density-diffusion.delta=0.1'
keys=$sticky

# through NAME CONDITION: how often a fluid particle was where awk's condition on x, y holds,
# in all snapshots
through() {
    awk -F, '$8 == 0 { x = $1; y = $2; if ('"$2"') n++ } END { print n + 0 }' \
        "$out/$1"/snapshots/*.csv
}

# hit NAME SCENE KEY=VALUE...: what is claimed of all
hit() {
    name=$1
    scene=$2
    shift 2
    # shellcheck disable=SC2086 # keys without blanks
    go "$name" "$scene" output.snapshots=41 $keys "$@"
    claim "$name comes to its end" "$code == 0"
    claim 'no particle leaves' "$(number "$name" escaped) == 0"
    claim "at most ${sunk:=0} in solids, in any row, and none at the end" \
        "$(number "$name" in_solids_max) <= $sunk && $(number "$name" in_solids) == 0"
    ! grep -q -i -E '(nan|inf),' "$out/$name/book.csv" "$out/$name"/snapshots/*.csv ||
        wrong "$name is finite"
}

# closes NAME: the book, to 1e-3 of the most energy it held
closes() {
    claim 'energy closes to 1e-3' \
        "$(number "$1" energy_defect_max) < 1e-3 * ($(most "$1" book kinetic) + $(most "$1" book internal))"
}

hit drops "$scenes/drops.scene"
closes drops
claim 'momentum stays 0' "$(most drops book momentum_x) < 1e-9"
claim 'left mirrors right' "$(awk -F, '$8 == 0 { x += $1 - 0.1; n++ } END { x /= n; print x < 0 ? -x : x }' \
    "$out/drops/snapshots/0040.csv") < 1e-3"

hit corner "$scenes/corner.scene"
closes corner
claim 'no particle is inside the post' \
    "$(through corner '(x > 0.1 ? x - 0.1 : 0.1 - x) + (y > 0.06 ? y - 0.06 : 0.06 - y) < 0.029') == 0"
claim 'density' "$(number corner density_max) < 1300"

hit jet "$scenes/jet.scene"
closes jet
claim 'no particle is behind the plate, nor half a spacing deep in it' "$(through jet 'y < 0.099') == 0"
claim 'the plate has the momentum of the jet' "$(number jet momentum_defect) < 1e-9"

# Distance to the walls of the V: (y - 0.02) sin 30 - |x - 0.15| cos 30.
deep='(y - 0.02) * 0.5 - (x > 0.15 ? x - 0.15 : 0.15 - x) * 0.8660254 < -0.001'
[ -n "${STIFFWATER_LONG-}" ] && kinds='own-density adami' || kinds=adami
for walls in $kinds; do
    hit funnel-$walls "$scenes/funnel.scene" walls=$walls
    closes funnel-$walls
    claim 'no particle is in the walls of the V' "$(through funnel-$walls "$deep") == 0"
    claim 'density' "$(number funnel-$walls density_max) < 1400"
done
sunk=2 # for a moment: sound is five times as fast as the jet only
hit slow "$scenes/funnel.scene" walls=adami eos.c0=20
sunk=0
claim 'nor with slow sound, if walls = "adami"' "$(through slow "$deep") == 0"
# shellcheck disable=SC2086
go slow "$scenes/funnel.scene" $keys eos.c0=20
prints slow 'take a higher eos.c0' 'particles are in solids at t = ' '(v at ('
claim 'else four pass, and are counted' "$(number slow in_solids) >= 3 && $(number slow in_solids_max) >= \
    $(number slow in_solids) && $(number slow escaped) == 0"

hit film "$scenes/film.scene"
closes film
claim 'no particle sinks' "$(through film 'y < 0') == 0"

hit plunge "$scenes/plunge.scene"
closes plunge
claim 'no particle sinks' "$(through plunge 'y < 0') == 0"
claim 'density' "$(number plunge density_max) < 1150"

# --- one particle, with both walls that a continuity density has -----------------------------
for walls in own-density adami; do
    for direction in 10,0 10,10 7.1,-7.1; do
        hit "shot-$walls" "$scenes/shot.scene" walls=$walls "fluid.shot.velocity=[$direction]"
        claim "no particle is in a wall (velocity $direction)" \
            "$(through "shot-$walls" 'x < 0 || x > 0.1 || y < 0 || y > 0.1') == 0"
    done
    { cat "$scenes/shot.scene"
      echo 'beam = { plate = { at = [0.07, 0.0]; length = 0.1; thickness = 0.015; E = 1e9;
          density = 2000; }; };'; } >"$out/beam.scene"
    hit "beam-$walls" "$out/beam.scene" walls=$walls
    claim 'nor behind the beam' "$(through "beam-$walls" 'x > 0.065 || x < 0 || y < 0 || y > 0.1') == 0"
done

# --- walls as they are unless a scene says otherwise ---------------------------------------
keys='eos.tension=false effects.density-healing={} eos.c0=40'
falls=film
[ -z "${STIFFWATER_LONG-}" ] || falls='film plunge'
for name in drops corner jet funnel $falls; do
    hit $name "$scenes/$name.scene"
    closes $name
    claim "$name: density" "$(number $name density_max) < 1400"
done
claim 'no particle is inside the post' \
    "$(through corner '(x > 0.1 ? x - 0.1 : 0.1 - x) + (y > 0.06 ? y - 0.06 : 0.06 - y) < 0.029') == 0"
claim 'no particle is behind the plate, nor half a spacing deep in it' "$(through jet 'y < 0.099') == 0"
claim 'no particle is in the walls of the V' "$(through funnel "$deep") == 0"
for name in $falls; do
    claim "$name: no particle sinks by half a spacing" "$(through $name 'y < -0.001') == 0"
done
for direction in 10,0 10,10 7.1,-7.1; do
    hit shot "$scenes/shot.scene" "fluid.shot.velocity=[$direction]" eos.c0=100
    claim "no particle is in a wall (velocity $direction)" \
        "$(through shot 'x < -0.001 || x > 0.101 || y < -0.001 || y > 0.101') == 0"
done
hit beam "$out/beam.scene" eos.c0=100
claim 'nor behind the beam' "$(through beam 'x > 0.065 || x < -0.001 || y < -0.001 || y > 0.101') == 0"
finish
