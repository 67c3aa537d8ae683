#!/bin/sh
# probes.sh -- what probes and panels tell of still water is what a book says of it: levels,
# means over areas and over time, loads of sides with their moments; and figures are drawn.
#
# Marks: 3 % for loads and pressures with 30 spacings of water, a tenth of a spacing for the level.
. "$top_srcdir/tests/lib.sh"

cat >"$out/still.scene" <<'S'
title = "Still water, 0.15 m deep";
dimension = 2; gravity = [0.0, -9.81]; until = 0.2; spacing = 5e-3;
domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };
fluid = { water = { type = "box"; from = [0.0, 0.0]; to = [0.2, 0.15]; }; };
wall = { tank = { type = "frame"; }; };
effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.2; };
            density-diffusion = { }; };
probe = {
    bed = { at = [0.1, 0.02]; };
    slow = { at = [0.1, 0.02]; window = 0.03; };
    face = { at = [0.0, 0.0]; to = [0.0, 0.2]; profile = true; };
    level = { at = [0.1, 0.0]; what = "height"; };
};
panel = {
    left = { of = "tank"; side = "left"; };
    right = { of = "tank"; side = "right"; along = [2.0, 0.0]; };
    floor = { of = "tank"; side = "bottom"; about = [0.2, 0.0]; };
    lid = { of = "tank"; side = "top"; };
};
output = { interval = 1e-3; profiles = 0.1; };
S
well still "$out/still.scene"
at() { echo "($(last still "$1" "$2"))"; }
# near WORDS SEEN WANTED PART
near() { claim "$1" "sqrt(($2 / $3 - 1) ^ 2) < $4"; }

near 'the level is the depth, half a spacing above the highest particle' "$(at probes level)" 0.15 0.0034
near 'a side has rho g H^2/2' "-$(at panels left.fx)" 110.3625 0.03
near 'and turns about the corner with rho g H^3/6' "$(at panels left.mz)" 5.518125 0.03
near 'its impulse is force times time' "-$(at panels left.ix)" 22.0725 0.03
near 'the drag of the other side is its force' "$(at panels right.drag)" "$(at panels right.fx)" 1e-9
near 'the floor has rho g H L' "-$(at panels floor.fy)" 294.3 0.03
near 'and turns about its end with half its length' "$(at panels floor.mz)" 29.43 0.03
claim 'nothing touches the lid' "$(at panels lid.fx) == 0 && $(at panels lid.fy) == 0"
column still/forces tank.fx tank.fy >"$out/frame"
off=$(column still/panels left.fx right.fx floor.fx lid.fx left.fy right.fy floor.fy lid.fy |
    paste -d ' ' - "$out/frame" | awk '{ a = $2 + $3 + $4 + $5 - $11; b = $6 + $7 + $8 + $9 - $12
        a = a < 0 ? -a : a; b = b < 0 ? -b : b; m = a > m ? a : m; m = b > m ? b : m; n++ }
        END { print (n > 190 ? m + 0 : 99) }')
claim 'sides make up the frame in each row, to the digits of a table' "$off < 1e-6"
near 'the mean over a wall half dry is the load by its height' "$(at probes face)" 551.8125 0.03
near 'a bed 0.13 m below the level' "$(at probes bed)" 1275.3 0.03

# The mean over 30 ms of a probe that rings, from readings at all steps, beside that of rows
# (1 ms apart, by hand).
by_rows=$(column still/probes slow slow.mean | awk '{ t[NR] = $1; p[NR] = $2; m[NR] = $3 }
    END { for (k = 32; k <= NR; k++) { s = 0
            for (i = k - 29; i <= k; i++) s += (p[i] + p[i - 1]) / 2 * (t[i] - t[i - 1])
            d = s / 0.03 - m[k]; d = d < 0 ? -d : d; most = d > most ? d : most
            r = p[k] - m[k]; r = r < 0 ? -r : r; ring = r > ring ? r : ring }
        print most, ring }')
claim 'a running mean is that of the rows by hand' "${by_rows% *} < 0.02 * ${by_rows#* }"
claim 'of a signal that rings' "${by_rows#* } > 5"
well twice "$out/still.scene" output.interval=4e-3 output.profiles=0.05
[ "$(last twice probes slow.mean)" = "$(last still probes slow.mean)" ] &&
    good 'and the same with other intervals' || wrong 'and the same with other intervals'
claim 'nothing changes the run' "\"$(hash twice)\" == \"$(hash still)\""
for way in '2 -n 2' '2 -n 1' '8 -n 2'; do
    # shellcheck disable=SC2086 # words
    STIFFWATER_LANES=${way%% *} "$STIFFWATER" run "$out/still.scene" -q -o "$out/way" ${way#* } \
        output.fields=100 output.snapshots=0
    for table in panels probes profiles; do
        cmp -s "$out/way/$table.csv" "$out/still/$table.csv" || wrong "the same $table: lanes $way"
    done
done
good 'tables were compared on other lanes and threads'
points=$(grep -c '^0.1,face,' "$out/still/profiles.csv")
claim 'a profile has a point each half spacing' "$points == 80"

if command -v gnuplot >/dev/null; then
    "$STIFFWATER" plot "$out/still" >"$out/drawn" 2>&1 || { wrong 'figures are drawn'; cat "$out/drawn"; }
    for figure in forces parts probes profiles; do
        claim "$figure.png is drawn" "$(cat "$out/still/figures/$figure.png" 2>/dev/null | wc -c) > 5000"
    done
    well beam "$top_srcdir/data/scenes/beam-alone.scene" until=0.01
    "$STIFFWATER" plot "$out/beam" >"$out/drawn" 2>&1 || { wrong 'a beam is drawn'; cat "$out/drawn"; }
    claim 'root.png is drawn' "$(cat "$out/beam/figures/root.png" 2>/dev/null | wc -c) > 5000"
    [ -z "$(find "$out" -name '*.gp.log')" ] && good 'gnuplot says nothing' || wrong 'gnuplot says nothing'
fi
finish
