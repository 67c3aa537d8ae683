#!/bin/sh
# lacking.sh -- check warns of effects that the objects of a scene call for and that it lacks, and of
# no scene that has them.
#
# What they do, measured: without viscosity the force on the walls of dam-break.scene jumps by 27 N/m
# from row to row (rms, 0.3 to 0.6 s), with it by 17; its largest density is 28 and 22 % above rho0.
# Without density diffusion and healing the force on the plate of toth-beam.scene jumps by 12.8 N/m
# (0.17 to 0.25 s), with them by 4.1, about a mean of 100.
scenes=${top_srcdir:-.}/data/scenes
ask=check
. "${top_srcdir:-.}/tests/lib.sh"
asking

# silent: none of these warnings
silent() {
    ! grep -q 'no effect\|nothing moves\|may bend' said || complain "$what: a warning too many"
}

expect 0 "$scenes/dam-break.scene"
silent
expect 0 "$scenes/dam-break.scene" effects.artificial-viscosity=off
says 'this water falls, and no effect is a viscosity' effects.laminar-viscosity
expect 0 "$scenes/dam-break.scene" effects.artificial-viscosity=off effects.laminar-viscosity=on
silent
expect 0 "$scenes/still-water.scene" effects.artificial-viscosity=off # which does not fall
silent
expect 0 "$scenes/mps-dam-break.scene" # a method that smooths by itself
silent

expect 0 "$scenes/dam-break.scene" effects.pressure=off
says 'no effect is a pressure: nothing keeps the fluid apart' 'effects.pressure = { }'
cat >none.scene <<'S'
dimension = 2; gravity = [0.0, -9.81]; until = 0.1; spacing = 0.01;
domain = { from = [0.0, 0.0]; to = [0.4, 0.4]; };
fluid = { water = { type = "box"; from = [0.0, 0.0]; to = [0.1, 0.2]; }; };
wall = { tank = { type = "frame"; }; };
S
expect 0 none.scene
says 'no effect is a pressure'

expect 0 "$scenes/toth-beam.scene"
silent
expect 0 "$scenes/toth-beam.scene" effects.density-diffusion=off effects.density-healing=off
says 'this water falls on plate, and no effect evens out its density'
expect 0 "$scenes/toth-beam.scene" beam.plate.E=1e7
says 'beam.plate may bend too far' 'theory = "elastica"'
expect 0 "$scenes/toth-beam.scene" beam.plate.E=1e7 beam.plate.theory=elastica
silent
expect 0 "$scenes/dam-break.scene" effects.density-diffusion=off effects.density-healing=off
silent # there is nothing that a load would bend

expect 0 "$scenes/block-stack.scene" body.top.uplift=true body.left.film=0.1
says 'body.top.uplift does nothing, as the scene has no fluid' 'body.left.film does nothing'

expect 0 "$scenes/closed-tank.scene"
silent
sed '/^gravity/d' "$scenes/still-water.scene" >weightless.scene
expect 0 weightless.scene eos.c0=20
says 'nothing moves this fluid' 'gravity = [0, -9.81]'
expect 0 "$scenes/still-water.scene" 'gravity=[0,0]' eos.c0=20 # as its author wants it
silent
expect 0 "$scenes/still-water.scene" 'gravity=[0,0]' eos.c0=20 'fluid.water.velocity=[0.1,0]'
silent
expect 0 "$scenes/still-water.scene" 'gravity=[0,0]' eos.c0=20 effects.central-force.omega=1
silent
expect 0 "$scenes/driven-cavity.scene" # by a lid
silent
finish
