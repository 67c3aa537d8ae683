#!/bin/sh
# A06.sh -- a square that turns: pressure at the start, then tension
#
# A square of fluid, side 1 m, begins as a stiff body, omega = 1 1/s, in free space
# (`data/scenes/rotating-square.scene`, dx = L/50). Its pressure is negative throughout; the
# reference for the start is the series of Colagrossi (2005), `data/reference/A06_rotating_square_patch_p0.csv`.
# The run starts without pressure, so sound rings around the true one; c0 is raised to 50 m/s, and
# three probes are averaged over five periods of the slowest sound, 5 sqrt(2) L/c0 = 0.141 s, in
# which the square turns by 8 degrees.
#
# Later tension shows what a plain scheme does: drawn together by negative pressure, particles
# line up along the flow and leave a void in the middle. Neither a larger support nor another
# kernel nor more viscosity keeps them apart (pairs at omega t = 2: 59 % at 3 dx, 29 % at 4 dx, 25 %
# with wendland-c4, 5 % with ten times the viscosity). `artificial-stress` (P3) does, and keeps
# momentum and its moment: 0 to 3 % in pairs until omega t = 4, and the square becomes four arms around
# a whole middle. The tension that it takes back is missing, so that p itself falls 15 % lower until both
# together hold the square; the pressures at the start are compared without it. `particle-shifting`
# instead of it helps, and no more: near the surface none drift.
. "$(dirname "$0")/lib.sh"
scene=$scenes/rotating-square.scene
cat >probes.part <<'P'
probe = { p0 = { at = [0.0, 0.0]; }; p2 = { at = [0.2, 0.0]; }; p4 = { at = [0.4, 0.0]; }; };
P
cat "$scene" probes.part >start.scene
go start start.scene effects.artificial-stress.strength=0 eos.c0=50 until=0.1414 output.interval=2e-4 output.snapshots=1
: >measured
for place in 0:-147.34 2:-126.76 4:-58.08; do
    p=$(column start/probes "p${place%:*}" | mean 0 1)
    r=${place#*:}
    echo "0.${place%:*} $p" >>measured
    row "pressure 0.${place%:*} L from the middle" "$r Pa" "$p Pa" '5 %' "sqrt(($p / $r - 1) ^ 2) < 0.05" "$(cost start)"
done
go stressed start.scene eos.c0=50 until=0.1414 output.interval=2e-4 output.snapshots=1
p=$(column stressed/probes p0 | mean 0 1)
row 'with artificial-stress: pressure in the middle' '-147.34 Pa' "$p Pa" '5 %' "sqrt(($p / -147.34 - 1) ^ 2) < 0.05" "$(cost stressed)" \
    'p and the stress together hold the square, so that p falls lower'
go later "$scene" output.snapshots=21
snapshots later '{ l += x * v - y * u } END { print t, l }' >momentum
turn=$(awk 'NR == 1 { l = $2 } END { printf "%.2g", 100 * ($2 / l - 1) }' momentum)
row 'with artificial-stress: angular momentum at omega t = 2' 'kept' "off by $turn %" '0.1 %' "sqrt(($turn) ^ 2) < 0.1" "$(cost later)"
pairs=$(column later/pairing pairing | awk '{ x = $2 } END { printf "%.0f", 100 * x }')
row 'with artificial-stress: particles in pairs at omega t = 2' 'none' "$pairs %" '2 %' "$pairs < 2" ''
go finer "$scene" spacing=0.01 output.snapshots=1
pairs=$(column finer/pairing pairing | awk '{ x = $2 } END { printf "%.0f", 100 * x }')
row 'the same, dx = L/100' 'none' "$pairs %" '2 %' "$pairs < 2" "$(cost finer)"
go plain "$scene" output.snapshots=21 effects.artificial-stress.strength=0
pairs=$(column plain/pairing pairing | awk '{ x = $2 } END { printf "%.0f", 100 * x }')
row 'the same without artificial-stress' 'none' "$pairs %" '2 %' "$pairs < 2" "$(cost plain)" \
    'negative pressure draws particles together'
go shifted "$scene" output.snapshots=1 effects.artificial-stress.strength=0 'effects.particle-shifting={}'
pairs=$(column shifted/pairing pairing | awk '{ x = $2 } END { printf "%.0f", 100 * x }')
row 'with particle-shifting instead' 'none' "$pairs %" '2 %' "$pairs < 2" "$(cost shifted)" \
    'particles near the surface do not drift, and tension stays tension'

sed '/^[#x]/d; s/,/ /g' "$reference/A06_rotating_square_patch_p0.csv" >exact
last=$(tail -n 1 later/snapshots.csv | cut -d, -f2)
plain=$(tail -n 1 plain/snapshots.csv | cut -d, -f2)
grep -v '^[#x]' "later/$last" >last.csv
grep -v '^[#x]' "plain/$plain" >plain.csv
draw <<'G'
set multiplot layout 1, 3
set datafile separator ' '
set xlabel 'distance from the middle [m]'
set ylabel 'p [Pa]'
set key top left
plot 'exact' using (0.5 - $1):(1000 * $2) with lines lw 2 lc rgb grey title 'series', \
    'measured' using 1:2 with points pt 6 ps 1.5 lc rgb pick(1) title 'mean to 0.14 s'
set datafile separator ','
set size ratio -1
unset xlabel
unset ylabel
unset key
set xtics 1
set ytics 1
set xrange [-1.6:1.6]
set yrange [-1.6:1.6]
set title 'ω t = 2, without artificial-stress'
plot 'plain.csv' using 1:2 with points pt 7 ps 0.2 lc rgb pick(1)
set title 'ω t = 2, with it'
plot 'last.csv' using 1:2 with points pt 7 ps 0.2 lc rgb pick(1)
unset multiplot
G
done_here
