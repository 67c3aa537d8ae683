#!/bin/sh
# A02.sh -- Poiseuille and Couette: water between plates starts to flow
#
# Plates 1 mm apart in a domain that repeats along x (`data/scenes/poiseuille.scene`, `couette.scene`, 20
# spacings), Re = 0.0125: Morris, Fox and Zhu (1997). References: the series,
# `data/reference/A02_poiseuille_startup.csv` and `A03_couette_startup.csv`, at 0.0225, 0.045, 0.1125 and 0.225 s.
# The error is the largest of u over all particles, over the largest speed of the flow, 1.25e-5 m/s.
. "$(dirname "$0")/lib.sh"

# errors RUN TABLE: t and largest error at each time of the table, from straight lines in it
errors() {
    k=2
    for t in 0.0225 0.045 0.1125 0.225; do
        file=$(awk -F, -v t=$t '!/^[#t]/ && $1 > t - 1e-6 { print $2; exit }' "$1/snapshots.csv")
        awk -F, -v k=$k -v t=$t -v to="$1.$t" '/^#/ || /^[xy]/ { next }
            FILENAME == ARGV[1] { y[n] = $1; u[n++] = $k; next }
            $8 == 0 { i = int($2 / 5e-5)
                d = ($3 - u[i] - ($2 - y[i]) / 5e-5 * (u[i + 1] - u[i])) / 1.25e-5
                print $2, $3 >to
                if (d * d > m * m) m = d }
            BEGIN { n = 0 } END { printf "%s %.2f\n", t, m < 0 ? -100 * m : 100 * m }' "$reference/$2" "$1/$file"
        k=$((k + 1))
    done
}
for flow in 'poiseuille A02_poiseuille_startup.csv 2' 'couette A03_couette_startup.csv 1'; do
    # shellcheck disable=SC2086 # three words
    set -- $flow
    go "$1" "$scenes/$1.scene" until=0.225 output.snapshots=11
    errors "$1" "$2" >"$1.errors"
    e=$(most <"$1.errors" | cut -d' ' -f1)
    row "$1: u" 'series' "off by $e %" "$3 %" "$e < $3" "$(cost "$1")" \
        'plates drag from where their particles are, dx/2 behind their faces'
done
tr ' ' , <"$reference/A02_poiseuille_startup.csv" | sed '/^[#y]/d' >exact.poiseuille
tr ' ' , <"$reference/A03_couette_startup.csv" | sed '/^[#y]/d' >exact.couette
draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set xlabel 'u [mm/s]'
set ylabel 'y [mm]'
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
