#!/bin/sh
# figures-flagship.sh -- draws DIR/flagship.png, the first figure of README.md: the dam break on an
# elastic beam at six moments, as `stiffwater plot' draws them.
#
# Run by `make figures', or by hand in a build tree:  top_srcdir=PATH sh .../figures-flagship.sh DIR
# The run stays in DIR/flagship/.  Half a CPU minute.
set -e

top=${top_srcdir:-.}
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
"$stiffwater" run "$top/data/scenes/toth-beam.scene" -q -o "$1/flagship"
"$stiffwater" plot "$1/flagship" >"$1/flagship/plot.log" 2>&1 ||
    { cat "$1/flagship/plot.log" >&2; exit 1; }
cp "$1/flagship/figures/dye.png" "$1/flagship.png"
