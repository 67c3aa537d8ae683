#!/bin/sh
# B03.sh -- a dam break against a wall: pressure and heights
#
# 0.6 m of water, 1.2 m long, in a tank of 3.22 m (`tests/validation/buchner.scene`, dx = H/60):
# the experiment of Zhou, De Kat and Buchner (1999), `data/reference/B03*.csv`, whose zero of time
# is approximate, and for the lowest sensors the incompressible SPH of De Courcy et al., Comput.
# Meth. Appl. Mech. Eng. 420 (2024) 116700, with 400 particles in H, `B04c_decourcy_2024_numerical_pressure.csv`.
# T = t sqrt(g/H), pressures over rho g H. The disc at 0.16 m is the mean of five probes.
#
# Walls `adami` that slip. The layer that really sticks to a wall is far thinner than dx; walls
# that do not slip brake the sheet and give 40 % less pressure at the lowest sensors. Peaks of the
# first touch depend on the moment that a particle hits a probe, and are not judged.
#
# `contact` walls with artificial viscosity that does not act at them (`stick = "none"`) give the same
# means. Force and probes of one face are to be one thing: the mean force on the far wall, over rho g
# H^2, for 2.3 < T < 3.5 beside the load of a probe over that whole face. With tension the splash above
# 0.3 m spoils it: probes read its stretched water as -0.06, the wall feels 1e-5 of it; on the lowest 0.3 m they agree. Peaks at P1
# are told raw and as means over 5 ms: rows at 2 ms see the raw ones by chance.
. "$(dirname "$0")/lib.sh"
go run "$cases/buchner.scene" walls=adami wall.tank.slip=true
contact='walls=contact effects.artificial-viscosity.stick=none'
# shellcheck disable=SC2086 # two keys
{
    go contact "$cases/buchner.scene" $contact
    go healed "$cases/buchner.scene" $contact eos.tension=false effects.density-healing={} until=1.3
}
go own "$cases/buchner.scene" walls=own-density effects.artificial-viscosity.stick=particles spacing=0.02 until=1.3
go stick "$cases/buchner.scene" walls=adami effects.artificial-viscosity.stick=particles spacing=0.02 until=1.3
go coarse "$cases/buchner.scene" walls=adami wall.tank.slip=true spacing=0.02 until=1.3
# scaled RUN: T, disc, p1, p2, p3 in rho g H; h1, h2 in H
scaled() {
    column "$1/probes" d1 d2 d3 d4 d5 p1 p2 p3 h1 h2 | awk '{ print $1 * sqrt(9.81 / 0.6),
        ($2 + $3 + $4 + $5 + $6) / 5 / 5886, $7 / 5886, $8 / 5886, $9 / 5886, $10 / 0.6, $11 / 0.6 }'
}
# late COLUMN <FILE: mean for 3.5 < T < 5
late() { awk -v c="$1" '{ print $1, $c }' "$2" | mean 3.5 5; }
for run in run contact healed own stick coarse; do scaled $run >$run.t; done

# judge RUN NAME [WHY]: what the sensors say
judge() {
    arrival=$(awk '{ print $1, $3 }' "$1.t" | first 0.05)
    row "arrival at the wall, T, $2" '2.5' "$(calc "$arrival")" '0.1' "sqrt(($arrival - 2.5) ^ 2) < 0.1" "$(cost "$1")" "${3-}"
    m=$(late 2 "$1.t")
    row "disc at 0.16 m, mean for 3.5 < T < 5, $2" '0.54 measured, 0.37 De Courcy' "$(calc "$m")" '0.33 to 0.65' \
        "$m > 0.33 && $m < 0.65" ''
    for k in '1 3 0.98' '2 4 0.92' '3 5 0.82'; do
        # shellcheck disable=SC2086 # three words
        set -- "$1" "$2" $k
        m=$(late "$4" "$1.t")
        row "P$3, mean for 3.5 < T < 5, $2" "$5 (De Courcy)" "$(calc "$m")" '20 %' "sqrt(($m / $5 - 1) ^ 2) < 0.2" ''
    done
}
# face RUN NAME PART LENGTH WORDS [WHY]: force on a part of the far wall and the load of the probe over it, over rho g H^2
face() {
    probe=face
    [ "$3" = far ] || probe=$3
    force=$(column "$1/panels" "$3.fx" | awk '{ print $1 * sqrt(9.81 / 0.6), $2 / 3531.6 }' | mean 2.3 3.5)
    load=$(column "$1/probes" $probe | awk -v l="$4" '{ print $1 * sqrt(9.81 / 0.6), l * $2 / 3531.6 }' | mean 2.3 3.5)
    row "$5, mean for 2.3 < T < 3.5, $2: load of a probe over it" "its force $(calc "$force")" "$(calc "$load")" \
        '5 %' "sqrt(($load / $force - 1) ^ 2) < 0.05" '' "${6-}"
}
# peaks RUN: at P1, raw and over 5 ms
peaks() {
    echo "$(column "$1/probes" p1 | most | awk '{ printf "%.3g", $1 / 5886 }') raw,
        $(column "$1/probes" p1.mean | most | awk '{ printf "%.3g", $1 / 5886 }') over 5 ms" | tr -s '\n ' ' '
}
none='no gate, no friction: De Courcy, with neither, has 2.36'
judge run 'adami, slip' "$none"
judge contact 'contact, slip' "$none"
judge healed 'contact, slip, healed' "$none"
for k in 'run adami,_slip' 'contact contact,_slip' 'healed contact,_slip,_healed'; do
    # shellcheck disable=SC2086 # two words
    set -- $k
    name=$(echo "$2" | tr _ ' ')
    why=
    [ "$1" != contact ] || why='drops stretched in the splash above read as suction, which no wall feels'
    face "$1" "$name" far 2 'far wall' "$why"
    face "$1" "$name" low 0.3 'lowest 0.3 m of it'
    arrival=$(awk '{ print $1, $3 }' "$1.t" | first 0.05)
    row "arrival, $name" '2.36 (De Courcy) to 2.57' "$(calc "$arrival")" '2.36 to 2.57' "$arrival > 2.36 && $arrival < 2.57" ''
    row "peak at P1, $name" '2.59 (De Courcy)' "$(peaks "$1")" 'not judged' 1 ''
done
for k in 'coarse slip,_adami' 'stick stick,_adami' 'own stick,_own-density'; do
    # shellcheck disable=SC2086 # two words
    set -- $k
    m=$(late 3 "$1.t")
    why=
    [ "$1" = coarse ] || why='the sheet is braked by walls that do not slip'
    row "P1 with dx = H/30, $(echo "$2" | tr _ ' ')" '0.98 (De Courcy)' "$(calc "$m")" '20 %' \
        "sqrt(($m / 0.98 - 1) ^ 2) < 0.2" "$(cost "$1")" "$why"
done
# height RUN COLUMN FILE FROM TO: rms distance from the experiment, of H
height() {
    awk -F'[, ]' -v run="$1.t" -v c="$2" -v from="$4" -v to="$5" '
        FILENAME == run { t[n] = $1; h[n++] = $c; next }
        $1 != "experiment_zhou1999" || $2 < from || $2 > to { next }
        { while (i < n - 2 && t[i + 1] < $2) i++; d = h[i] - $3; s += d * d; k++ }
        BEGIN { n = i = 0 } END { printf "%.4f", sqrt(s / k) }' "$1.t" "$3"
}
for k in 'run adami' 'contact contact'; do
    # shellcheck disable=SC2086 # two words
    set -- $k
    d=$(height "$1" 7 "$reference/B03_zhou_1999_h2.csv" 2 6)
    row "height 0.992 m before the wall, rms for 2 < T < 6, $2" 'experiment' "$d H" '0.05 H' "$d < 0.05" ''
    d=$(height "$1" 6 "$reference/B03_zhou_1999_h1.csv" 2 5.5)
    row "height 0.495 m before the wall, rms for 2 < T < 5.5, $2" 'experiment' "$d H" '0.05 H' "$d < 0.05" ''
done

grep experiment "$reference/B03_zhou_1999_p2.csv" >seen.p
grep experiment "$reference/B03_zhou_1999_h1.csv" >seen.h1
grep experiment "$reference/B03_zhou_1999_h2.csv" >seen.h2
grep '^P1' "$reference/B04c_decourcy_2024_numerical_pressure.csv" >computed.p1
grep '^P4' "$reference/B04c_decourcy_2024_numerical_pressure.csv" >computed.p4
for run in run contact; do tr ' ' , <$run.t >$run.csv; done
draw <<'G'
set multiplot layout 3, 1
set xrange [1.4:7]
set lmargin 8
set key top left Left reverse
set ytics 1
set ylabel 'P1 / ρgH'
set yrange [0:3]
plot 'computed.p1' using 2:3 with lines lw 1 lc rgb pick(2) title 'De Courcy 2024', \
    'run.csv' using 1:3 with lines lw 1.5 lc rgb pick(1) title 'here, adami', \
    'contact.csv' using 1:3 with lines lw 1.5 lc rgb pick(3) title 'contact'
set ytics 0.5
set ylabel 'disc / ρgH'
set yrange [0:1.6]
plot 'seen.p' using 2:3 with lines lw 1 lc rgb grey title 'Zhou 1999', \
    'computed.p4' using 2:3 with lines lw 1 lc rgb pick(2) title 'De Courcy 2024', \
    'run.csv' using 1:2 with lines lw 1.5 lc rgb pick(1) title 'here, adami', \
    'contact.csv' using 1:2 with lines lw 1.5 lc rgb pick(3) title 'contact'
set ytics 0.3
set ylabel 'heights / H'
set xlabel 'T = t √(g/H)'
set yrange [0:0.9]
plot 'seen.h1' using 2:3 with lines lw 1.5 lc rgb grey title '0.495 m before the wall, Zhou 1999', \
    'seen.h2' using 2:3 with lines lw 1.5 dt '-' lc rgb grey title '0.992 m', \
    'run.csv' using 1:6 with lines lw 1.5 lc rgb pick(1) title 'here', \
    '' using 1:7 with lines lw 1.5 dt '-' lc rgb pick(1) notitle
unset multiplot
G
done_here
