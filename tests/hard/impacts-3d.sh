#!/bin/sh
# impacts-3d.sh -- the impacts of impacts.sh in space, coarse, between walls that stop water at
# their faces and where artificial viscosity is no friction: nothing is not finite, books close,
# no particle passes through anything.  The scenes are written here, as they differ in few lines.
#
# Marks that are missed have two reasons.  The mean over rows that feel little makes these walls
# softer than water: the film and the wave sink by half a spacing, the jet farther.  And an edge
# presses only when water is on both of its sides.
. "$top_srcdir/tests/lib.sh"

# scene NAME SPACING HIGH C0 UNTIL GRAVITY TEXT: a closed tank from the origin to HIGH
scene() {
    cat >"$out/$1.scene" <<S
title = "$1, 3D";
dimension = 3;
gravity = $6;
until = $5;
spacing = $2;
domain = { from = [0.0, 0.0, 0.0]; to = $3; };
$7
walls = "contact";
eos = { c0 = $4; };
effects = { continuity = { }; pressure = { }; density-diffusion = { };
    artificial-viscosity = { alpha = 0.05; stick = "none"; }; };
output = { interval = 1e-3; };
S
}

# through NAME CONDITION: how often a fluid particle was where awk's condition on x, y, z holds
through() {
    awk -F, '$10 == 0 { x = $1; y = $2; z = $3; if ('"$2"') n++ } END { print n + 0 }' \
        "$out/$1"/snapshots/*.csv
}

# hit NAME KEY=VALUE...: what is claimed of all; $solids: whether particles in solids are a claim;
# the book closes to 1e-3 of the most energy it held
hit() {
    name=$1
    shift
    go "$name" "$out/$name.scene" output.snapshots=21 "$@"
    claim "$name comes to its end" "$code == 0"
    claim 'no particle leaves' "$(number "$name" escaped) == 0"
    $solids 'none is in solids' "$(number "$name" in_solids_max) == 0"
    ! grep -q -i -E '(nan|inf),' "$out/$name/book.csv" "$out/$name"/snapshots/*.csv ||
        wrong "$name is finite"
    claim 'energy closes to 1e-3' "$(number "$name" energy_defect_max) < \
        1e-3 * ($(most "$name" book kinetic) + $(most "$name" book internal))"
    claim 'pressure makes no energy' "$(most "$name" book pressure_defect) < 1e-12"
}

# missed WORDS EXPRESSION: a mark that is not met yet, on all machines: single particles decide.
missed() {
    if awk "BEGIN { exit !($2) }"; then echo "met     $1"; else echo "missed  $1: $2"; fi
}

tank='wall = { tank = { type = "frame"; }; };'
rest='initial = "rest";'
solids=claim

scene drops 5e-3 '[0.15, 0.1, 0.1]' 20.0 0.04 '[0.0, 0.0, 0.0]' "$tank"'
fluid = { left = { type = "sphere"; centre = [0.05, 0.05, 0.05]; radius = 0.02; velocity = [2.0, 0.0, 0.0]; '"$rest"' };
    right = { type = "sphere"; centre = [0.1, 0.05, 0.05]; radius = 0.02; velocity = [-2.0, 0.0, 0.0]; '"$rest"' }; };'
hit drops
claim 'momentum stays 0' "$(most drops book momentum_x) < 1e-9"
claim 'left mirrors right' "$(awk -F, '$10 == 0 { x += $1 - 0.075; n++ } END { x /= n; print x < 0 ? -x : x }' \
    "$out/drops/snapshots/0020.csv") < 1e-3"

# A cube of water on the edge of a post, off its middle; boxes turn about z, so that down is -x.
scene edge 5e-3 '[0.16, 0.1, 0.08]' 20.0 0.06 '[-9.81, 0.0, 0.0]' '
fluid = { drop = { type = "sphere"; centre = [0.115, 0.051, 0.04]; radius = 0.02; velocity = [-3.0, 0.0, 0.0]; '"$rest"' }; };
wall = { tank = { type = "frame"; };
    post = { type = "box"; from = [0.035, 0.03, 0.0]; to = [0.075, 0.07, 0.08]; angle = 45.0; }; };'
solids=missed
hit edge
solids=claim
missed 'no particle is inside the post' \
    "$(through edge '(x > 0.055 ? x - 0.055 : 0.055 - x) + (y > 0.05 ? y - 0.05 : 0.05 - y) < 0.0258') == 0"
claim 'density' "$(number edge density_max) < 1300"

# A jet at a fifth of the speed of sound on a plate three spacings thick.
scene jet 5e-3 '[0.12, 0.12, 0.16]' 20.0 0.04 '[0.0, 0.0, 0.0]' '
fluid = { jet = { type = "box"; from = [0.04, 0.04, 0.06]; to = [0.08, 0.08, 0.14]; velocity = [0.0, 0.0, -4.0]; '"$rest"' }; };
wall = { tank = { type = "frame"; };
    plate = { type = "box"; from = [0.0, 0.0, 0.035]; to = [0.12, 0.12, 0.05]; }; };'
solids=missed
hit jet
solids=claim
missed 'no particle is behind the plate, nor half a spacing deep in it' "$(through jet 'z < 0.0475') == 0"
claim 'the plate has the momentum of the jet' "$(number jet momentum_defect) < 1e-9"

# A jet in a V of 90 degrees, along -x, sound ten times as fast.
scene funnel 5e-3 '[0.1, 0.1, 0.05]' 40.0 0.04 '[-9.81, 0.0, 0.0]' '
fluid = { jet = { type = "box"; from = [0.065, 0.035, 0.01]; to = [0.095, 0.065, 0.04]; velocity = [-4.0, 0.0, 0.0]; '"$rest"' }; };
wall = { tank = { type = "frame"; };
    left = { type = "box"; from = [0.0, 0.02, -0.02]; to = [0.07, 0.035, 0.07]; angle = -45.0; };
    right = { type = "box"; from = [0.0, 0.065, -0.02]; to = [0.07, 0.08, 0.07]; angle = 45.0; }; };'
solids=missed
hit funnel
solids=claim
claim 'density' "$(number funnel density_max) < 1400"

# A film two particles thick runs along a floor and up the far wall.
scene film 5e-3 '[0.2, 0.05, 0.06]' 20.0 0.2 '[0.0, 0.0, -9.81]' "$tank"'
fluid = { film = { type = "box"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.05, 0.01]; velocity = [1.0, 0.0, 0.0]; '"$rest"' }; };'
solids=missed
hit film
solids=claim
missed 'no particle sinks' "$(through film 'z < 0') == 0"

# A column falls over a wet floor.
scene plunge 1e-2 '[0.4, 0.08, 0.2]' 20.0 0.5 '[0.0, 0.0, -9.81]' "$tank"'
fluid = { column = { type = "box"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.08, 0.16]; surface = 0.16; };
    still = { type = "box"; from = [0.1, 0.0, 0.0]; to = [0.4, 0.08, 0.03]; surface = 0.03; }; };'
hit plunge
missed 'no particle sinks' "$(through plunge 'z < 0') == 0"
claim 'density' "$(number plunge density_max) < 1150"

# One particle at half the speed of sound, along an axis, into an edge, into a corner.
scene shot 5e-3 '[0.08, 0.08, 0.08]' 20.0 0.03 '[0.0, 0.0, 0.0]' "$tank"'
fluid = { shot = { type = "box"; from = [0.02, 0.04, 0.04]; to = [0.025, 0.045, 0.045]; velocity = [10.0, 0.0, 0.0]; '"$rest"' }; };'
for direction in 10,0,0 7.1,-7.1,0 5.8,5.8,5.8; do
    hit shot "fluid.shot.velocity=[$direction]"
    claim "no particle is in a wall (velocity $direction)" \
        "$(through shot 'x < 0 || x > 0.08 || y < 0 || y > 0.08 || z < 0 || z > 0.08') == 0"
done
finish
