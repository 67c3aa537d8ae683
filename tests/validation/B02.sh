#!/bin/sh
# B02.sh -- a column that collapses: Koshizuka and Oka 1996
#
# L = 0.146 m wide, 2 L high, tank 4 L long (`tests/validation/koshizuka.scene`, dx = L/40).
# The experiment is slower than every code, its digitisations disagree by 0.18 L; the mark is that
# a code be near the other codes, a pressure that looks ahead nearer than 0.08 L at L/100, and that
# `method = "mps"` (scene `mps-dam-break`) be near the curve that its authors had:
# `data/reference/B02*.csv`, Koshizuka and Oka, Nucl. Sci. Eng. 123 (1996) 421.
# T = t sqrt(2 g/L), Z = front/L.
. "$(dirname "$0")/lib.sh"
go run "$cases/koshizuka.scene" walls=own-density effects.artificial-viscosity.stick=particles
# the default walls, and what the shipped scenes of open water have
go contact "$cases/koshizuka.scene" eos.tension=false effects.density-healing={} effects.density-diffusion.delta=0.03
go slip "$cases/koshizuka.scene" walls=adami wall.tank.slip=true
go semi "$top_srcdir/data/scenes/mps-dam-break.scene"
# a pressure that looks ahead, as fine as L/100
sed 's/type = "tait"; rho0 = 1000.0; gamma = 7.0;/type = "look-ahead"; rho0 = 1000.0;/' "$cases/koshizuka.scene" >ahead.scene
go ahead ahead.scene walls=own-density spacing=1.46e-3 until=0.3
for run in contact run slip semi ahead; do
    dx=3.65e-3 near=0.15
    [ $run != ahead ] || dx=1.46e-3 near=0.08
    column $run/front x | awk -v dx=$dx '{ print $1 * sqrt(2 * 9.81 / 0.146), ($2 + dx / 2) / 0.146 }' >$run.t
    case $run in
    contact) name='contact, healed' ;;
    run) name=own-density ;;
    slip) name='adami, slip' ;;
    semi) name='method mps' ;;
    ahead) name='look-ahead, L/100' ;;
    esac
    t=$(first 3 <$run.t)
    row "T at Z = 3, $name" '2.27 MPS, 2.25 VOF, 2.47 to 2.70 measured' "$(calc "$t")" '2.2 to 2.75' "$t > 2.2 && $t < 2.75" "$(cost $run)"
    for series in mps_pysph mps_openmps; do
        grep $series "$reference/B02b_koshizuka_oka_1996_front_numerical.csv" | cut -d, -f2,3 | tr , ' ' >there
        d=$(awk 'FILENAME == ARGV[1] { t[n] = $1; z[n++] = $2; next } $1 > t[n - 1] || $2 > 3.95 { next }
            { while (i < n - 2 && t[i + 1] < $1) i++
              d = z[i] + ($1 - t[i]) / (t[i + 1] - t[i]) * (z[i + 1] - z[i]) - $2; s += d * d; k++ }
            BEGIN { n = i = 0 } END { printf "%.3f", sqrt(s / k) }' $run.t there)
        row "front, rms from ${series#*_} digitisation of MPS, $name" '0' "$d L" "$near L" "$d < $near" ''
    done
    t=$(awk '{ print $1 / sqrt(2 * 9.81 / 0.146), $2 }' $run.t | first 3.95)
    row "at the far wall, $name" '0.27 to 0.28 s' "$(calc "$t") s" '0.25 to 0.30 s' "$t > 0.25 && $t < 0.30" ''
done
for t in 0.1 0.2 0.3; do
    file=$(awk -F, -v t=$t '!/^[#t]/ && $1 >= t - 1e-9 { print $2; exit }' contact/snapshots.csv)
    awk -F, '!/^[#x]/ && $8 == 0 { print $1, $2 }' "contact/$file" >shape.$t
    awk -F, -v t=$t '$1 == t { print $2, $3 }' "$reference/B02c_koshizuka_oka_1996_free_surface.csv" >surface.$t
done
grep exp_pysph "$reference/B02a_koshizuka_oka_1996_front_exp.csv" | tr , ' ' >seen
grep mps_pysph "$reference/B02b_koshizuka_oka_1996_front_numerical.csv" | tr , ' ' >mps
draw <<'G'
set datafile separator ' '
set multiplot
set origin 0, 0
set size 0.5, 1
set xlabel 'T = t √(2g/L)'
set ylabel 'Z = front / L'
set xrange [0:3.2]
set yrange [0.9:4.2]
set key top left Left reverse
plot 'seen' using 2:3 with points pt 6 lc rgb grey title 'measured', \
    'mps' using 2:3 with points pt 4 lc rgb pick(3) title 'MPS 1996', \
    'run.t' with lines lw 2 lc rgb pick(1) title 'own-density', \
    'slip.t' with lines lw 2 lc rgb pick(2) title 'adami, slip', \
    'semi.t' with lines lw 2 dt 2 lc rgb pick(4) title 'method mps', \
    'ahead.t' with lines lw 2 dt 3 lc rgb pick(5) title 'look-ahead, L/100', \
    'contact.t' with lines lw 2 dt '-' lc rgb 'black' title 'contact, healed'
set xrange [0:0.584]
set yrange [0:0.3]
set ytics 0.1
set size 0.5, 0.33
set xlabel
set ylabel 'z [m]'
unset key
array time[3] = ['0.1', '0.2', '0.3']
do for [i = 1:3] {
    set origin 0.5, 1 - i / 3.0
    set title time[i].' s' offset 0, -1
    plot 'shape.'.time[i] with points pt 7 ps 0.15 lc rgb pick(6), 'surface.'.time[i] with points pt 6 ps 0.6 lc rgb pick(7)
}
unset multiplot
G
done_here
