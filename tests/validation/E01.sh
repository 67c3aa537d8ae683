#!/bin/sh
# E01.sh -- a dam break on a box in 3D: MARIN
#
# 0.55 m of water, 1.23 m long and 1 m wide, fall and meet a box, 0.403 m wide and 0.161 m high (`tests/validation/marin.scene`,
# dx = 27.5 mm: 32,400 particles of water, and the box is six spacings high): pressures and levels of Kleefsman and
# others, J. Comput. Phys. 206 (2005) 363, `data/reference/E01_kleefsman_spheric2.csv`. Walls are `contact`, artificial
# viscosity does not act at them, the dam is `released`. "Healed": `eos.tension = false` and `density-healing`. Pressures and
# forces are means over 20 ms, of both.
#
# 317 N is the mean of P1 to P4 for 0.45 to 0.70 s times the face of 0.065 m^2. These sensors stand in one line near its
# middle, and water that leaves sideways and over the top presses less at the edges, so that the load of the whole face is less
# than that: here by 6 to 18 %, by a probe over the face beside P1 to P4. All are told: the force on the front half of the box,
# the load of a probe over its face, and P1 to P4 as the experiment has it.
#
# What is missing: the force stands 27 to 41 % below 317 N and rises as dx falls (tension: 189 N with 27.5 mm, 205 N with 18.3 mm;
# healed: 224, 231 and, with 12.2 mm, 237 N). P1 and P2 are 6.2 and 5.1 kPa (healed, 18.3 mm; experiment 5.5 and 5.1), P3 and P4 3.3
# and 0.9 kPa instead of 4.7 and 4.3: near the upper edge a kernel of 46 mm sees the jet that leaves. The first blow is that of a
# liquid in which sound runs at 33 m/s, rho c0 U = 0.1 MPa, and no air is caught: 20 ms of it are
# three times too high, and fall slowly with dx (tension: 37 and 32 kPa; healed: 49, 36 and 25 kPa). Finer: E01fine, E01finest.
. "$(dirname "$0")/lib.sh"
. "$cases/marin.sh"
scene=$cases/marin.scene
go tension "$scene"
go healed "$scene" until=0.75 eos.tension=false effects.density-healing={}
go adami "$scene" until=0.75 eos.tension=false walls=adami effects.density-healing={}
low='P3 and P4 are too low, near the edge over which the water leaves; rises with 1/dx, see E01fine'
blow='a blow of 0.1 MPa, rho c0 U: a liquid without air, met by all of a flat toe at once'
impact tension 'tension' "$low" "$blow" '' "$low" 'one behind the edge of the box in the blow, two in the floor at 0.77 s; none with 18.3 mm to 0.75 s'
impact healed 'healed' "$low" "$blow" 'the blow is not over at 0.45 s; 2 % with 18.3 mm' '' \
    'one in the far wall at 0.63 s; those lost were thrown over the top of the open tank'
impact adami 'adami, slip, healed' "$low" "$blow" '' '' 'these walls leak in violent flow'
f=$(load healed | mean 0.47 0.7)
m=$(load adami | mean 0.47 0.7)
row 'load on the face, adami beside contact, healed' "$(calc "$f") N" "$(calc "$m") N" '15 %' \
    "sqrt(($m / $f - 1) ^ 2) < 0.15" ''
# shellcheck disable=SC2046 # two words
set -- $(rms tension H2 11 2)
row 'level at H2 to 2 s, rms, tension' '0' "$1 m" '0.05 m' "$1 < 0.05" ''
# shellcheck disable=SC2046 # two words
set -- $(rms tension H4 13 2)
row 'level at H4 to 2 s, largest distance, tension' '0' "$2 m" '0.025 m' "$2 < 0.025" ''
m=$(column tension/probes P1 | mean 1 1.5)
within 'P1, mean for 1 to 1.5 s, tension' 2831 "$m" Pa 25 ''

for run in tension healed adami; do
    load "$run" >"$run.f"
    column "$run/probes" P1.mean P2.mean P3.mean P4.mean | four >"$run.q"
    column "$run/probes" P1.mean >"$run.p"
    column "$run/probes" H2 H4 >"$run.h"
done
awk '{ print $1, $2, $3, $4, $5 }' seen | four >four
awk '{ x[NR] = $2 } NR > 4 { print $1, (x[NR] + x[NR - 4]) / 8 + (x[NR - 1] + x[NR - 2] + x[NR - 3]) / 4 }' four >seen.q
over20 2 >seen.p
draw <<'G'
set datafile separator ' '
runs = 'tension healed adami'
set terminal pngcairo size 900, 640 font 'Sans,11'
set output 'E01.png'
set multiplot layout 3, 1
set lmargin 8
set rmargin 26
set key outside right
set xrange [0.3:0.75]
set ylabel 'load [N]'
set yrange [-100:800]
plot 'seen.q' with lines lw 2 lc rgb grey title 'P1 to P4: experiment', \
    for [i = 1:words(runs)] word(runs, i).'.q' with lines lw 1.2 dt '-' lc rgb pick(i) title word(runs, i), \
    for [i = 1:words(runs)] word(runs, i).'.f' with lines lw 2 lc rgb pick(i) title 'force, '.word(runs, i)
set ylabel 'P1 [kPa]'
set yrange [-5:50]
plot 'seen.p' using 1:($2 / 1000) with lines lw 2 lc rgb grey title 'experiment', \
    for [i = 1:words(runs)] word(runs, i).'.p' using 1:($2 / 1000) with lines lw 1.5 lc rgb pick(i) title word(runs, i)
set xrange [0:2]
set ylabel 'H2, H4 [m]'
set xlabel 't [s]'
set yrange [0:0.6]
set key outside right
plot 'seen' using 1:11 with lines lw 2 lc rgb grey title 'experiment', '' using 1:13 with lines lw 2 lc rgb grey notitle, \
    for [i = 1:words(runs)] word(runs, i).'.h' using 1:2 with lines lw 1.2 lc rgb pick(i) title word(runs, i), \
    for [i = 1:words(runs)] word(runs, i).'.h' using 1:3 with lines lw 1.2 lc rgb pick(i) notitle
unset multiplot
G
done_here
