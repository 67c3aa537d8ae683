#!/bin/sh
# A02.sh -- Poiseuille and Couette: water between plates starts to flow
#
# Plates 1 mm apart in a domain that repeats along x (`data/scenes/poiseuille.scene`, `couette.scene`), Re = 0.0125:
# Morris, Fox and Zhu (1997). References: their series at 0.0225, 0.045, 0.1125 and 0.225 s, as in
# `data/reference/A02_poiseuille_startup.csv` and `A03_couette_startup.csv`. The error is the largest of u over all
# particles, over the largest speed of the flow, 1.25e-5 m/s. 20 spacings from plate to plate, and 40.
#
# The fluid sticks at the faces of the plates, (W2). With `stick = "particles"`, where the velocity of a wall is that of
# its particles, errors beside the plates are those of plates 0.6 spacings further apart on each side. What is left
# late and in the middle of the Poiseuille flow is (V1) on a lattice, 1 to 2 % low.
. "$(dirname "$0")/lib.sh"

# errors RUN FLOW: t and largest error, in per cent
errors() {
    for t in 0.0225 0.045 0.1125 0.225; do
        file=$(awk -F, -v t=$t '!/^[#t]/ && $1 > t - 1e-6 { print $2; exit }' "$1/snapshots.csv")
        awk -F, -v flow="$2" -v t=$t -v to="$1.$t" -v L=1e-3 -v nu=1e-6 '
            /^#/ || /^x/ || $8 != 0 { next }
            { pi = 3.14159265358979
              y = $2
              u = flow == "poiseuille" ? 1e-4 * y * (L - y) / 2 / nu : 1.25e-5 * y / L
              for (n = 1; n < 200; n++) {
                  e = sin(n * pi * y / L) * exp(-(n * pi / L) ^ 2 * nu * t)
                  if (flow == "couette") u += 2.5e-5 / (n * pi) * (n % 2 ? -1 : 1) * e
                  else if (n % 2) u -= 4e-4 * L * L / nu / (pi * n) ^ 3 * e
              }
              print $2, $3 >to
              d = ($3 - u) / 1.25e-5
              if (d * d > m * m) m = d }
            END { printf "%s %.3f\n", t, m < 0 ? -100 * m : 100 * m }' "$1/$file"
    done
}
for flow in 'poiseuille 2' 'couette 1'; do
    # shellcheck disable=SC2086 # two words
    set -- $flow
    for n in 20 40; do
        run=$1
        keys='until=0.225'
        if [ $n = 40 ]; then
            run=${1}40
            keys="$keys spacing=2.5e-5"
            [ "$1" = poiseuille ] || keys="$keys wall.lower.from=[0,-0.75e-4] wall.upper.to=[5e-4,10.75e-4]"
        fi
        # shellcheck disable=SC2086 # several keys
        go "$run" "$scenes/$1.scene" output.snapshots=11 $keys
        errors "$run" "$1" >"$run.errors"
        e=$(most <"$run.errors" | cut -d' ' -f1)
        row "$1: u, dx = L/$n" 'series' "off by $(calc "$e") %" "$2 %" "$e < $2" "$(cost "$run")"
    done
done
early=$(sed -n '1s/.* //p' poiseuille.errors)
half=$(sed -n '1s/.* //p' poiseuille40.errors)
order=$(calc "log($early / $half) / log(2)")
row 'poiseuille at 0.0225 s, beside the plates: order in dx' 'of the first at least' "$early %, then $half %: $order" '1' \
    "$order > 1" ''
go own "$scenes/poiseuille.scene" until=0.225 output.snapshots=11 'effects.laminar-viscosity.stick="particles"'
errors own poiseuille >own.errors
e=$(most <own.errors | cut -d' ' -f1)
row 'poiseuille: u, dx = L/20, stick = "particles"' 'series' "off by $(calc "$e") %" '2 %' "$e < 2" "$(cost own)" \
    'plates drag from where their particles are, behind their faces'
sed '/^[#y]/d; s/,/ /g' "$reference/A02_poiseuille_startup.csv" >exact.poiseuille
sed '/^[#y]/d; s/,/ /g' "$reference/A03_couette_startup.csv" >exact.couette
draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set xlabel 'u [mm/s]'
set ylabel 'y [mm]'
set xtics 0.004
set xrange [0:0.0135]
set yrange [0:1]
unset key
moment = '0.0225 0.045 0.1125 0.225'
do for [k = 1:2] {
    flow = word('poiseuille couette', k)
    set title flow
    plot for [i = 1:4] 'exact.'.flow using (1000 * column(1 + i)):(1000 * $1) with lines lw 1.5 lc rgb grey, \
        for [i = 1:4] ''.flow.'.'.word(moment, i) using (1000 * $2):(1000 * $1) with points pt 7 ps 0.3 lc rgb pick(i)
}
unset multiplot
G
done_here
