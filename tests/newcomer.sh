#!/bin/sh
# newcomer.sh -- four scenes as doc/scene.md alone lets one write them: two beams, a wave on a beam,
# a dam break in 3D on a box that is tilted, and a drop, that page's own.  Each is checked and run
# at the first try, keeps its water, and closes its books.
. "${top_srcdir:-.}/tests/lib.sh"
cd "$out" || exit 99

awk '/^    \/\/ A drop of/ { on = 1 } on && /^Save it/ { exit } on { sub(/^    /, ""); print }' \
    "$top_srcdir/doc/scene.md" >drop.scene

flat='dimension = 2; gravity = [0, -9.81];'
effects='effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; density-diffusion = { }; };'
tank='tank = { type = "frame"; };'
cat >two-beams.scene <<S
$flat until = 0.3; spacing = 5e-3;
domain = { from = [0, 0]; to = [0.6, 0.6]; lid = false; };
fluid = { water = { type = "box"; from = [0, 0]; to = [0.15, 0.2]; initial = "released"; }; };
wall = { $tank };
beam = {
    first = { theory = "elastica"; at = [0.3, 0]; length = 0.1; thickness = 6e-3; E = 5e6; density = 1100; };
    second = { theory = "elastica"; at = [0.45, 0]; length = 0.1; thickness = 6e-3; E = 5e6; density = 1100; };
};
$effects
S
cat >wave-on-beam.scene <<S
$flat until = 0.6; spacing = 0.01;
domain = { from = [0, 0]; to = [1.5, 0.4]; lid = false; };
fluid = { water = { type = "box"; from = [0, 0]; to = [1.5, 0.2]; }; };
wall = {
    $tank
    piston = { type = "box"; from = [-0.1, 0]; to = [0.05, 0.4];
        amplitude = [0.03, 0]; frequency = 1; phase = -90; };
};
beam = { flag = { theory = "elastica"; at = [0.8, 0]; length = 0.3; thickness = 0.01; E = 5e6; density = 1200; }; };
$effects
probe = { level = { at = [0.7, 0]; what = "height"; }; };
S
cat >tilted-box.scene <<S
dimension = 3; gravity = [0, 0, -9.81]; until = 0.2; spacing = 0.025;
domain = { from = [0, 0, 0]; to = [1, 0.3, 0.5]; lid = false; };
fluid = { water = { type = "box"; from = [0, 0, 0]; to = [0.3, 0.3, 0.3]; initial = "released"; }; };
wall = {
    $tank
    block = { type = "box"; from = [0.6, 0.1, 0.0]; to = [0.75, 0.2, 0.15]; angle = 30; axis = [0, 1, 0]; };
};
$effects
S

# first NAME: checked and run; its water stays, and its energy closes within 1 %
first() {
    code=0
    "$STIFFWATER" check "$1.scene" >"$1.checked" 2>&1 || code=$?
    claim "$1: checked" "$code == 0"
    well "$1" "$1.scene"
    claim "$1: nothing lost" "$(number "$1" escaped) == 0"
    claim "$1: the book closes" "$(number "$1" energy_defect_max) < 0.01 * $(number "$1" energy_most)"
}

for scene in drop two-beams wave-on-beam tilted-box; do first $scene; done
for beam in first second; do
    claim "$beam bends" "$(most two-beams beam $beam.tip_x) > 1e-3"
done
claim 'the beam feels the wave' "$(most wave-on-beam beam flag.tip_x) > 1e-3"
claim 'the box feels the dam' "$(most tilted-box forces block.fx) > 1"
finish
