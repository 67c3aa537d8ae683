#!/bin/sh
# uplift.sh -- a block on the floor, under water: it rises only where water gets beneath it.
#
# It is half as heavy as water.  With the pressure of the bed, 2943 Pa, under it, and 1962 Pa above, it
# feels the weight of what it displaces, 196 N/m, and 98 N/m of its own: g upward, less what the water that it
# takes along resists.
. "$top_srcdir/tests/lib.sh"

scene=$top_srcdir/tests/scenes/block-on-floor.scene

well lies "$scene" body.block.uplift=false
claim 'a block with no water beneath it stays' "($(last lies bodies block.y) - 0.05)^2 < 0.0005^2"

well rises "$scene"
claim 'with uplift it rises' "$(last rises bodies block.y) > 0.09"
claim 'energy closes' "$(number rises energy_defect_max) < 1e-3*530"
claim 'momentum closes' "$(number rises momentum_defect) < 1e-8"


# The pressure of the bed, less in the end, does its work over the spacings in which it is at work:
# 589 N/m over 1.1 in the mean at most.
claim 'uplift has done its work' "$(last rises book uplift) > 1 && $(last rises book uplift) < 589*0.011"
well rests "$scene" body.block.density=2000.0
claim 'a heavy block stays' "($(last rests bodies block.y) - 0.05)^2 < 0.0005^2"
finish
