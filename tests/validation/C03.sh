#!/bin/sh
# C03.sh -- a dam breaks on an elastic obstacle
#
# The main case: water and a beam that bends far, in one right-hand side
# (`data/scenes/elastic-obstacle.scene`, dx = 4.06 mm, obstacle 3 dx thick). Six codes computed it and
# it was never measured: `data/reference/C03_dambreak_elastic_obstacle_tip.csv`, digitised from Idelsohn
# (2008), Sun (2019), Ryzhakov (2010), Bogaers (2016), Liu (2013), Meduri (2018). They agree on the
# push, 41 to 49 mm at 0.217 to 0.260 s, and part ways later, when the
# sheet has closed over the air behind the obstacle.
#
# The default walls push 45 mm at any dx (C03fine has 2 mm). `adami` walls push less, because (W1)
# carries tension over as well as pressure, and a sheet of water is held back by floor and obstacle: 38.7 mm;
# 44.3 mm with `eos.tension = false`, and 41.7 mm (40.1 mm with a tank that slips, instead of 33) when, for
# a trial, p_w alone was kept from being negative. That (W1) leaves the acceleration of a skin out
# is worth 1.0 mm, 0.35 mm without tension (a trial with the acceleration of the step before).
# Tolerance: from 0.1 on the peak is within 1 % and the shape of the push does not change, later
# splashes differ from run to run as they do in any such flow. 0.01 is a sound choice; at 1e-4
# nearly three times the work moves the peak by less than 0.1 %, dx by ten times that.
. "$(dirname "$0")/lib.sh"
scene=$scenes/elastic-obstacle.scene

# tip RUN: t, displacement of the tip in mm
# As it was measured first: friction, tension, a hydrostatic start. C03walls has it as it is shipped.
old='effects.artificial-viscosity.stick=particles effects.density-diffusion.delta=0.1
    effects.density-healing.strength=0 fluid.water.initial=hydrostatic'
tip() { column "$1/beam" obstacle.tip_x | awk '{ print $1, 1000 * $2 }'; }
# judge RUN NAME [WHY]: the rows of a run
judge() {
    # shellcheck disable=SC2046 # two words
    set -- "$1" "$2" "${3-}" $(tip "$1" | awk '$1 < 0.35' | most)
    row "peak of the tip, $2" '41 to 49 mm' "$(calc "$4") mm" '40 to 50 mm' "$4 > 40 && $4 < 50" "$(cost "$1")" "$3"
    row "when, $2" '0.217 to 0.260 s' "$(calc "$5") s" '0.21 to 0.27 s' "$5 > 0.21 && $5 < 0.27" ''
    o=$(tip "$1" | first 2)
    row "onset (2 mm), $2" '0.138 to 0.161 s' "$(calc "$o") s" '0.14 to 0.165 s' "$o > 0.14 && $o < 0.165" ''
}
# shellcheck disable=SC2086 # keys
{
go run "$scene" $old walls=own-density eos.tension=true output.snapshots=15
judge run 'dx = 4.06 mm'
go finer "$scene" $old walls=own-density eos.tension=true spacing=2.9795918367346937e-3 beam.obstacle.layers=4
judge finer 'dx = 2.98 mm'
go adami "$scene" $old walls=adami eos.tension=true
judge adami 'dx = 4.06 mm, adami' 'these walls pull, too: see the next rows; 40.4 mm with 2 mm (C03fine)'
go push "$scene" $old walls=adami eos.tension=false
judge push 'dx = 4.06 mm, adami without tension'
}
leak=$(number run escaped)
row 'no particle leaves' '0' "$leak" '0' "$leak == 0" ''
e=$(calc "100 * $(number run energy_defect_max) / $(number run energy_initial)")
row 'energy defect over that at the start' '0' "$e %" '0.2 %' "$e < 0.2" ''

: >by-tolerance
for tol in 1 0.3 0.1 0.03 0.01 3e-3 1e-3 1e-4; do
    go tol "$scene" tol=$tol until=0.3
    # shellcheck disable=SC2046 # two words
    set -- $(tip tol | most)
    echo "$tol $1 $2 $(number tol rhs_explicit) $(number tol cpu_s) $(number tol energy_defect_max)" >>by-tolerance
done
worst=$(awk '{ p[NR] = $2; tol[NR] = $1 } END { for (i = 1; i <= NR; i++) if (tol[i] <= 0.1) {
    d = 100 * (p[i] / p[NR] - 1); if (d * d > m * m) m = d } printf "%.2f", m < 0 ? -m : m }' by-tolerance)
row 'peak with tol = 0.1 to 1e-3, from that of 1e-4' '0' "within $worst %" '2 %' "$worst < 2" "$(cost tol)"

for run in run finer adami; do tip $run >$run.t; done
grep -v '^#' "$reference/C03_dambreak_elastic_obstacle_tip.csv" >seen
draw <<'G'
set multiplot
set datafile separator ','
set size 0.68, 1
set xlabel 't [s]'
set ylabel 'tip [mm]'
set xrange [0.1:0.7]
set yrange [-25:52]
set key top right samplen 2
is(name) = strcol(1) eq name ? $2 : NaN
code = 'pfem_idelsohn2008 mps_dem_sun2019 fem_ryzhakov2010 qn_ls_bogaers2016 sph_liu2013 fem_meduri2018'
by = 'PFEM,_Idelsohn MPS,_Sun FEM,_Ryzhakov FV,_Bogaers SPH,_Liu FEM,_Meduri'
name(i) = word(by, i)[1:strstrt(word(by, i), '_') - 1].' '.word(by, i)[strstrt(word(by, i), '_') + 1:*]
plot for [i = 1:6] 'seen' using (is(word(code, i))):(1000 * $3) with linespoints lw 0.7 pt i ps 0.4 lc rgb grey title name(i), \
    'run.t' using (real(word(strcol(1), 1))):(real(word(strcol(1), 2))) with lines lw 2.5 lc rgb pick(1) title 'dx = 4.06 mm', \
    'finer.t' using (real(word(strcol(1), 1))):(real(word(strcol(1), 2))) with lines lw 2 lc rgb pick(2) title 'dx = 2.98 mm'
set datafile separator ' '
set origin 0.68, 0.5
set size 0.32, 0.5
set logscale x
set xrange [5e-5:2]
set xtics ('10^{-4}' 1e-4, '10^{-2}' 1e-2, '1' 1)
unset key
set xlabel 'tolerance'
set ylabel 'peak [mm]'
set yrange [40:50]
plot 'by-tolerance' using 1:2 with linespoints lw 2 pt 7 ps 0.7 lc rgb pick(1)
set origin 0.68, 0
set ylabel 'right-hand sides'
set logscale y
set yrange [*:*]
plot 'by-tolerance' using 1:4 with linespoints lw 2 pt 7 ps 0.7 lc rgb pick(1)
unset multiplot
G
for t in 0.15 0.2 0.25 0.35 0.5 0.65; do
    file=$(awk -F, -v t=$t '!/^[#t]/ && $1 >= t - 1e-9 { print $2; exit }' run/snapshots.csv)
    awk -F, '!/^[#x]/ { print $1, $2, sqrt($3 * $3 + $4 * $4), $8 }' "run/$file" >at.$t
done
draw -snapshots <<'G'
set datafile separator ' '
set multiplot layout 2, 3 margins 0.02, 0.9, 0.02, 0.93 spacing 0.02, 0.08
unset tics
unset key
set border 0
set size ratio -1
set xrange [0:0.584]
set yrange [0:0.5]
set cbrange [0:3]
set palette defined (0 '#08306b', 1 '#4292c6', 2 '#c6dbef', 3 '#ffffb2')
unset colorbox
time = '0.15 0.2 0.25 0.35 0.5 0.65'
do for [i = 1:6] {
    set title word(time, i).' s' offset 0, -0.7
    if (i == 3) { set colorbox user origin 0.92, 0.2 size 0.02, 0.6; set cbtics 1; set cblabel 'speed [m/s]' } else { unset colorbox }
    plot 'at.'.word(time, i) using 1:($4 == 0 ? $2 : NaN):3 with points pt 7 ps 0.28 lc palette, \
        '' using 1:($4 == 3 || $4 == 4 ? $2 : NaN) with points pt 7 ps 0.35 lc rgb pick(2)
}
unset multiplot
G
done_here
