#!/bin/sh
# figures-flagship.sh -- draws DIR/flagship.png, flagship-deflection.png and flagship-forces.png, the
# figures of README.md: the dam break on an elastic beam at six moments, how far the beam bends,
# and what the water presses with, as `stiffwater plot' draws them.
#
# Run by `make figures', or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-flagship.sh DIR [KEY=VALUE...]
#
# with keys for another run, as a test makes.  The run stays in DIR/flagship/.  Half a CPU minute.
set -e

top=${top_srcdir:-.}
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
to=$1
shift
"$stiffwater" run "$top/data/scenes/toth-beam.scene" -q -o "$to/flagship" "$@"
"$stiffwater" plot "$to/flagship" >"$to/flagship/plot.log" 2>&1 ||
    { cat "$to/flagship/plot.log" >&2; exit 1; }
cp "$to/flagship/figures/dye.png" "$to/flagship.png"
cp "$to/flagship/figures/deflection.png" "$to/flagship-deflection.png"
cp "$to/flagship/figures/forces.png" "$to/flagship-forces.png"
