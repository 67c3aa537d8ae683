#!/bin/sh
# A08.sh -- beams that bend a little: frequencies and deflections
#
# Without water, 10 linear elements, `imex4` with tol = 1e-4. Frequencies are counted over ten
# swings after a uniform load was put on (the mean over them is the deflection at rest), so that
# the first mode is seen alone; modes 2 and 3 are held to 0.02 % by `tests/unit/beam-theory.c`.
# References: eigenvalues of Euler and Bernoulli, `data/reference/A08a_beam_eigenvalues.csv`; static
# deflections, `A08c`; the plate of Gray, Monaghan and Swift (2001), thin-plate theory, `A08b`.
. "$(dirname "$0")/lib.sh"

# beam NAME LENGTH THICKNESS E UNTIL KEYS: a scene
beam() {
    cat >"$1.scene" <<S
dimension = 2;
until = $5;
method = "imex4";
tol = 1e-4;
beam = { strip = { at = [0.0, 0.0]; angle = 0.0; length = $2; thickness = $3; E = $4; density = 1000.0;
                   elements = 10; $6 }; };
output = { interval = $(calc "$5 / 2000"); };
S
    go "$1" "$1.scene"
}
# swing RUN COLUMN: period over ten swings, and the mean over them
swing() {
    column "$1/beam" "strip.$2" >w
    middle=$(awk 'NR == 1 || $2 > b { b = $2 } NR == 1 || $2 < a { a = $2 } END { print (a + b) / 2 }' w)
    awk -v m="$middle" '{ print $1, $2 - m }' w >v
    first=$(cross 1 1 <v)
    last=$(cross 1 11 <v)
    echo "$(calc "($last - $first) / 10") $(awk -v a="$first" -v b="$last" '$1 >= a && $1 < b { s += $2; n++ } END { print s / n }' w)"
}
: >periods
# 1 m, 10 mm, 1 GPa: sqrt(EI/(rho A)) = 2.8868 m^2/s, EI = 83.33 N m
# END, where it is measured, beta L, EI w/(q L^4), load: each bends by 30 mm
for ends in 'free tip 1.875104069 8 20' 'clamped mid 4.730040745 384 1000' 'pinned mid 3.141592654 76.8 200'; do
    # shellcheck disable=SC2086 # five words
    set -- $ends
    t=$(calc "2 * 3.14159265 / ($3 ^ 2 * 2.8867513)")
    root=clamped
    [ "$1" = pinned ] && root=pinned
    beam "$1" 1.0 0.01 1e9 "$(calc "11.6 * $t")" "root = \"$root\"; tip = \"$1\"; load = $5.0;"
    # shellcheck disable=SC2046 # two words
    set -- "$@" $(swing "$1" "$2_y")
    f=$(awk "BEGIN { printf \"%.6g\", 1 / $6 }")
    row "first frequency, $root and $1" "$(calc "1 / $t") Hz" "$(calc "$f") Hz" '0.5 %' \
        "sqrt(($f * 2 * 3.14159265 / ($3 ^ 2 * 2.8867513) - 1) ^ 2) < 5e-3" "$(number "$1" cpu_s | cut -c1-5) s, $(number "$1" solves) solves"
    row "deflection under a load, $root and $1" "$(calc "1000 * $5 / ($4 * 83.33333)") mm" "$(calc "1000 * $7") mm" '1 %' \
        "sqrt(($7 * $4 * 83.33333 / $5 - 1) ^ 2) < 0.01" ''
done
beam gray 0.2 0.02 2e6 3.2 'nu = 0.3; plane = "strain"; load = 10.0; load_until = 0.13;'
# shellcheck disable=SC2046 # two words
set -- $(column gray/beam strip.tip_y | awk '$1 > 0.14' >w; echo "$(cross 1 1 <w)" "$(cross 1 11 <w)")
t=$(awk "BEGIN { printf \"%.6g\", ($2 - $1) / 10 }")
row "Gray's plate, nu = 0.3: period" '0.26409 s' "$t s" '0.5 %' "sqrt(($t / 0.26409211 - 1) ^ 2) < 5e-3" \
    "$(number gray cpu_s | cut -c1-5) s, $(number gray solves) solves"

for run in free clamped pinned; do
    place=mid
    [ $run = free ] && place=tip
    column $run/beam strip.${place}_y >$run.w
done
column gray/beam strip.tip_y >gray.w
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'deflection [mm]'
set multiplot layout 2, 1
set xrange [0:2]
plot 'free.w' using 1:(1000 * $2) with lines lw 1.5 lc rgb pick(1) title 'clamped, free: tip', \
    'clamped.w' using 1:(1e3 * $2) with lines lw 1.5 lc rgb pick(2) title 'clamped, clamped: middle', \
    'pinned.w' using 1:(1e3 * $2) with lines lw 1.5 lc rgb pick(3) title 'pinned, pinned: middle'
set xrange [0:3.2]
plot 'gray.w' using 1:(1000 * $2) with lines lw 1.5 lc rgb pick(1) title "Gray's plate: tip"
unset multiplot
G
done_here
