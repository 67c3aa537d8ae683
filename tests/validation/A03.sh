#!/bin/sh
# A03.sh -- water is dragged along by a plate (Couette)
#
# Of two plates 1 mm apart the upper one moves from t = 0 on, Re 0.0125 (`data/scenes/couette.scene`,
# 20 spacings from plate to plate, periodic along them). The reference is the exact series for the
# set-up of Morris, Fox and Zhu (J. Comput. Phys. 136 (1997) 214),
# `data/reference/A03_couette_startup.csv`; errors are the largest of all rows of particles, in
# units of the plate's speed.
. "$(dirname "$0")/lib.sh"
scene=$scenes/couette.scene
sed '/^[#y]/d; s/,/ /g' "$reference/A03_couette_startup.csv" >exact

# profile RUN COLUMN TIME: y, u, and u of the reference, a row of particles each
profile() {
    snapshots "$1" '{ k = int(y / 5e-5 + 0.5); s[k] += u; n[k]++ }
        END { for (k in n) print t, k, s[k] / n[k] }' |
        awk -v c="$2" -v t="$3" 'FILENAME == "exact" { e[int($1 / 5e-5 + 0.5)] = $c; next }
            $1 > t - 1e-6 && $1 < t + 1e-6 { print $2 * 5e-5, $3, e[$2] }' exact - | sort -g
}
# claim RUN COLUMN TIME COST [REASON]
claim() {
    profile "$1" "$2" "$3" >"at-$3"
    off=$(awk '{ e = ($2 - $3) / 1.25e-5; if (e * e > m * m) m = e } END { printf "%.2f", 100 * m }' \
        "at-$3")
    row "u(y) at $3 s" 'exact series' "off by $off %" '1 %' "$off < 1 && $off > -1" "$4" ${5+"$5"}
}

why='beside the plate the speed falls by half in four spacings; walls have their own velocity, not one that is extrapolated'
go run "$scene"
go long "$scene" until=1 output.snapshots=2
claim run 2 0.0225 "$(cost run)" "$why"
claim run 3 0.045 '' "$why"
claim run 4 0.1125 ''
claim run 5 0.225 ''
claim long 6 1 "$(cost long)"

draw <<'G'
set datafile separator ' '
set xlabel 'y [mm]'
set ylabel 'u [10^{-5} m/s]'
set key top left
plot for [i = 2:6] 'exact' using ($1 * 1e3):(column(i) * 1e5) with lines lw 2 lc rgb pick(1) \
         title i == 2 ? 'exact: 0.0225, 0.045, 0.1125, 0.225 and 1 s' : '', \
    for [t in '0.0225 0.045 0.1125 0.225 1'] 'at-'.t using ($1 * 1e3):($2 * 1e5) \
         with points pt 6 lc rgb pick(2) title t eq '1' ? '20 spacings' : ''
G
done_here
