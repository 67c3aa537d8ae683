#!/bin/sh
# A09.sh -- beams that bend far: elastica, and the bar of Turek and Hron
#
# Cantilevers of `theory = "elastica"`, 20 elements, brought to rest by damping (damping_ratio = 1,
# default method and tolerance): under a
# force at the tip, alpha = P L^2/EI, against Bisshopp and Drucker (`data/reference/A09a_elastica_tip_load.csv`),
# under their own weight, K = q L^3/EI, against `A09b_elastica_uniform_load.csv`, and CSM1 and CSM2 of Turek
# and Hron (2006), a bar of 0.35 m by 20 mm under a gravity of 2 m/s^2 (`A11a_turek_hron_reference.csv`:
# 66.1 and 16.97 mm for a solid in two dimensions; a thin beam is itself 0.7 to 1.1 % below).
# `tests/unit/elastica-theory.c` holds every row of these tables to 1e-4.
. "$(dirname "$0")/lib.sh"

# beam NAME E KEYS GRAVITY UNTIL: a scene, and its run
beam() {
    cat >"$1.scene" <<S
dimension = 2;
gravity = [0.0, -$4];
until = $5;
beam = { strip = { theory = "elastica"; at = [0.0, 0.0]; angle = 0.0; E = $2; density = 1000.0;
                   elements = 20; damping_ratio = 1.0; $3 }; };
output = { interval = $(calc "$5 / 100"); };
S
    go "$1" "$1.scene"
}
# rest RUN: tip_x and tip_y at the end
rest() { column "$1/beam" strip.tip_x strip.tip_y | awk 'END { print $2, $3 }'; }
# table FILE LOAD: deflection, shortening
table() { awk -F, -v load="$2" '$1 == load { print $2, $3 }' "$reference/$1"; }

: >tip
: >weight
thin='length = 1.0; thickness = 1e-3;'
# E = 12e9: EI = 1 N m, rho A = 1 kg/m, a period of 1.8 s
for alpha in 1 2 5 10; do
    beam tip$alpha 1.2e10 "$thin tip_force = -$alpha.0;" 0.0 12.0
    # shellcheck disable=SC2046 # four words
    set -- $(rest tip$alpha) $(table A09a_elastica_tip_load.csv $alpha)
    echo "$alpha $1 $2 $3 $4" >>tip
    row "tip force, alpha = $alpha: deflection over L" "$3" "$(calc "-($2)")" '0.5 %' "sqrt((-($2) / $3 - 1) ^ 2) < 5e-3" \
        "$(number tip$alpha cpu_s | cut -c1-5) s, $(number tip$alpha solves) solves"
done
for k in 1 5 10 20; do
    beam weight$k 1.2e10 "$thin" $k.0 12.0
    # shellcheck disable=SC2046 # four words
    set -- $(rest weight$k) $(table A09b_elastica_uniform_load.csv $k)
    echo "$k $1 $2 $3 $4" >>weight
    row "own weight, K = $k: deflection over L" "$3" "$(calc "-($2)")" '0.5 %' "sqrt((-($2) / $3 - 1) ^ 2) < 5e-3" \
        "$(number weight$k cpu_s | cut -c1-5) s, $(number weight$k solves) solves"
done
bar='length = 0.35; thickness = 0.02; nu = 0.4; plane = "strain";'
beam csm1 1.4e6 "$bar" 2.0 12.0
beam csm2 5.6e6 "$bar" 2.0 12.0
for c in 'csm1 66.1' 'csm2 16.974'; do
    # shellcheck disable=SC2086,SC2046 # two words each
    set -- $c $(rest "${c% *}")
    row "$1 of Turek and Hron: tip" "$2 mm" "$(calc "-1000 * ($4)") mm" '1.5 %' "sqrt((-1000 * ($4) / $2 - 1) ^ 2) < 0.015" \
        "$(number "$1" cpu_s | cut -c1-5) s, $(number "$1" solves) solves"
done
sed '/^[#aK]/d' "$reference/A09a_elastica_tip_load.csv" | tr , ' ' >exact.tip
sed '/^[#aK]/d' "$reference/A09b_elastica_uniform_load.csv" | tr , ' ' >exact.weight
draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set key bottom right
set ylabel 'deflection / L, shortening / L'
set yrange [0:1]
set xlabel 'P L^2 / EI'
set xrange [0:10]
plot 'exact.tip' using 1:2 with lines lw 1.5 lc rgb grey title 'exact', '' using 1:3 with lines lw 1.5 lc rgb grey notitle, \
    'tip' using 1:(-$3) with points pt 6 ps 1.3 lc rgb pick(1) title 'deflection', \
    '' using 1:(-$2) with points pt 4 ps 1.3 lc rgb pick(2) title 'shortening'
set xlabel 'q L^3 / EI'
set xrange [0:20]
plot 'exact.weight' using 1:2 with lines lw 1.5 lc rgb grey title 'exact', '' using 1:3 with lines lw 1.5 lc rgb grey notitle, \
    'weight' using 1:(-$3) with points pt 6 ps 1.3 lc rgb pick(1) title 'deflection', \
    '' using 1:(-$2) with points pt 4 ps 1.3 lc rgb pick(2) title 'shortening'
unset multiplot
G
done_here
