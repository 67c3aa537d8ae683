#!/bin/sh
# A12.sh -- a disc and a box that float
#
# `floating-disc.scene`, 0.7 of the density of water, and `floating-box.scene`, half of it and twice as wide as high, in 2D, 8 spacings to the
# radius and 10 to the height; the draft by Archimedes, `data/reference/A12_floating_drafts.csv`, from the level that the scene's water has with the
# body in it. Means from 5 s to the end. Spheres: no run of seconds gets there; 2D shapes and a sphere's lift are tested by `tests/archimedes.sh`.
#
# Nothing rights a disc that drifts or turns, so it goes where it was pushed while it fell in. Rings of its skin that began at the side, 47 particles in the
# outermost, had no mirror image: 1.73 % and 0.023 rad/s, with twice the viscosity 3.1 mm for 3.8 after 8 s. They begin at the bottom and are
# mirrored to the last bit now. What is left is rounding that a splash makes large; to 10 s the mean drift is 0.01 %.
. "$(dirname "$0")/lib.sh"
# drift RUN COLUMN SIZE AT: of the mean, by the size [%]
drift() { column "$1/bodies" "$2" | mean 5 10 | awk -v size="$3" -v at="$4" '{ d = ($1 - at) / size; printf "%.3g", 100 * (d < 0 ? -d : d) }'; }

go disc "$scenes/floating-disc.scene"
exact=$(awk -F, '$1 == 0.7 { print $2 }' "$reference/A12_floating_drafts.csv")
# Water that is left, 0.24 m^2 less what was carved, stands at 0.3046 m.
draft=$(column disc/bodies log.y | mean 5 10 | awk '{ printf "%.5g", (0.3046 - $1 + 0.08) / 0.08 }')
row 'disc, 0.7: draft over R' "$exact" "$draft" '1 spacing, 0.125' "sqrt(($draft - $exact) ^ 2) < 0.125" "$(cost disc)"
got=$(drift disc log.x 0.16 0.4)
row 'disc: drift by its diameter' 0 "$got %" '1 % in 10 s' "$got < 1" ''
got=$(column disc/bodies log.spin | mean 5 10)
row 'disc: spin' 0 "$got rad/s" '0.01 rad/s' "sqrt(($got) ^ 2) < 0.01" ''

go box "$scenes/floating-box.scene"
draft=$(column box/bodies box.y | mean 5 10 | awk '{ printf "%.5g", (0.2475 - $1 + 0.05) / 0.1 }')
row 'box, 0.5: draft over its height' 0.5 "$draft" '1 spacing, 0.1' "sqrt(($draft - 0.5) ^ 2) < 0.1" "$(cost box)"
got=$(drift box box.x 0.2 0.4)
row 'box: drift by its width' 0 "$got %" '1 % in 10 s' "$got < 1" ''
got=$(column box/bodies box.angle | mean 5 10)
row 'box: turn' 0 "$got rad" '0.5 degrees' "sqrt(($got) ^ 2) < 0.0087" ''
row 'box: energy it cannot explain, of all' 0 "$(calc "100 * $(number box energy_defect_max) / $(number box energy_initial)") %" '0.5 %' "$(number box energy_defect_max) < 5e-3 * $(number box energy_initial)" ''
done_here
