#!/bin/sh
# flagship-figures.sh -- the figures of README.md can be drawn from a run: the flagship, coarse
# and short, through the script that `make figures' runs.
. "$top_srcdir/tests/lib.sh"
command -v gnuplot >/dev/null || skip 'there is no gnuplot'
export top_srcdir STIFFWATER

sh "$top_srcdir/plots/figures-flagship.sh" "$out" spacing=0.01 beam.plate.elements=5 until=0.16 \
    >"$out/drawn.said" 2>&1 || { wrong 'all are drawn'; cat "$out/drawn.said"; }
for figure in flagship flagship-deflection flagship-forces; do
    picture=$out/$figure.png
    if [ "$(head -c 4 "$picture" 2>/dev/null | tail -c 3)" = PNG ]; then
        claim "$figure is more than a frame" "$(wc -c <"$picture") > 8000"
    else
        wrong "$figure is drawn"
    fi
    if grep -q "img/$figure.png" "$top_srcdir/README.md"; then good "README.md shows $figure"
    else wrong "README.md shows $figure"; fi
done
claim 'the beam has moved by then' "$(most flagship beam plate.tip_x) > 1e-5"
claim 'and the water presses on it' "$(most flagship forces plate.fx) > 1"
if grep -q -i -e warning -e error "$out/flagship/plot.log"; then
    wrong 'gnuplot has nothing to say'
    cat "$out/flagship/plot.log"
else
    good 'gnuplot has nothing to say'
fi
finish
