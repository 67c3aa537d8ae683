#!/bin/sh
# rigid-hard.sh -- rigid bodies where water is hard on them: what comes down on it at 5 m/s, what is
# much lighter than it in a flood, and bumps; and contacts that are hard on methods.
. "$top_srcdir/tests/lib.sh"

scenes=$top_srcdir/tests/scenes

# sound RUN ENERGY: nothing leaves or stands in a solid, momentum closes, energy within ENERGY [J/m]
sound()
{
    claim "$1: no particle leaves" "$(number "$1" escaped) == 0"
    claim "$1: none is in a solid" "$(number "$1" in_solids_max) == 0"
    claim "$1: momentum closes" "$(number "$1" momentum_defect) < 1e-8"
    claim "$1: energy closes" "$(number "$1" energy_defect_max) < $2"
}

# The box brings 125 J/m.
well slam "$scenes/slamming-box.scene"
sound slam 0.01*125
sed 's/box = { at = .* size = [^;]*;/disc = { shape = "disc"; at = [0.5, 0.42]; radius = 0.1;/' \
    "$scenes/slamming-box.scene" >"$out/disc.scene"
well disc "$out/disc.scene"
sound disc 0.01*196

# 490 J/m of water before it falls.
well light "$scenes/light-bodies.scene"
sound light 0.01*490

# Methods without a bound of stability and with a loose tol, a contact harder than their steps would be: the
# cube lies on the floor in the end, and not somewhere above or below it.
for method in adams bdf gsl-rkf45 gsl-msadams; do
    well "$method" "$scenes/falling-cube.scene" method="$method" tol=0.1 body.it.softness=0.01
    claim "$method: the cube is on the floor" "($(last "$method" bodies it.z) - 0.09)^2 < 0.02^2"
    claim "$method: it went no further than it slides" "($(last "$method" bodies it.x) - 0.225)^2 < 0.03^2"
done

finish
