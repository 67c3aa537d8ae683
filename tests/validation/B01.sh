#!/bin/sh
# B01.sh -- columns that collapse: Martin and Moyce 1952
#
# Columns a = 57.15 mm wide, 2 a and a high, on a dry floor (`tests/validation/martin-moyce.scene`,
# dx = a/40), against the front and height seen by Martin and Moyce (Phil. Trans. R. Soc. A 244
# (1952) 312), `data/reference/B01*.csv`, digitised by others. Z = front/a, T = n t sqrt(g/a), with
# n^2 the height over the width. The experiment began when a membrane tore, so its zero of time
# is uncertain by 0.1 to 0.2: the shift in time that fits best, at most 0.2, is given, and
# deviations are those after it. The walls are the default ones, `contact`, along which water slips, without tension and
# healed; `own-density` walls to which it sticks; and `adami` walls that slip. The front is that of the foremost particle in the water, plus dx/2.
#
# Against spacing: T at which Z = 3 with dx = a/20 to a/160. The front is one particle, and by chance T is a few thousandths off,
# so the order is that of the whole ladder: of T(a/20) - T(a/40) over T(a/80) - T(a/160).
. "$(dirname "$0")/lib.sh"
scene=$cases/martin-moyce.scene
# the default walls, and what the shipped scenes of open water have
open='eos.tension=false effects.density-healing={} effects.density-diffusion.delta=0.03'
square='fluid.water.to=[0.05715,0.05715]'

# scaled RUN N2 DX: T, Z, height over initial height
scaled() {
    column "$1/front" x height | awk -v n="$2" -v dx="$3" '
        { print $1 * sqrt(n * 9.81 / 0.05715), ($2 + dx / 2) / 0.05715, $3 / (n * 0.05715) }'
}
# apart REFERENCE RUN COLUMN LARGEST-SHIFT: shift, largest and root-mean-square relative deviation
apart() {
    awk -v c="$3" -v most="$4" '
        FILENAME == ARGV[1] { T[n] = $1; Z[n++] = $2; next }
        { t[m] = $1; z[m++] = $c }
        function at(x,    i) {
            for (i = 1; i < m - 1 && t[i] < x; i++);
            return z[i - 1] + (x - t[i - 1]) / (t[i] - t[i - 1]) * (z[i] - z[i - 1])
        }
        BEGIN { n = m = 0 }
        END { for (s = -most; s <= most + 1e-9; s += 0.01) {
                  sum = worst = count = 0
                  for (k = 0; k < n; k++) {
                      if (T[k] + s < 0 || T[k] + s > t[m - 1]) continue
                      d = at(T[k] + s) / Z[k] - 1; sum += d * d; count++
                      if (d * d > worst * worst) worst = d
                  }
                  if (s == -most || sum / count < best) { best = sum / count; shift = s; w = worst }
              }
              printf "%.2f %.1f %.1f\n", shift, 100 * w, 100 * sqrt(best) }' "$1" "$2"
}
# slope FILE: of Z between 1.8 and 4
slope() { awk '$2 > 1.8 && !a { a = $1; p = $2 } $2 < 4 { b = $1; q = $2 } END { printf "%.3f", (q - p) / (b - a) }' "$1"; }

sed -n 's/^a2.25in_pysph,//p; ' "$reference/B01a_martin_moyce_1952_front_n2_2.csv" | tr , ' ' >front2
sed '/^[#T]/d' "$reference/B01b_martin_moyce_1952_front_square.csv" | tr , ' ' >front1
sed '/^[#T]/d' "$reference/B01c_martin_moyce_1952_height_square.csv" | tr , ' ' >height1
runs=
for walls in contact own-density adami; do
    slip=
    case $walls in
    contact) stick="$open" ;;
    own-density) stick=effects.artificial-viscosity.stick=particles ;;
    adami) stick=effects.artificial-viscosity.stick=particles slip=wall.tank.slip=true ;;
    esac
    # shellcheck disable=SC2086
    go two-$walls "$scene" walls=$walls $stick $slip
    # shellcheck disable=SC2086
    go one-$walls "$scene" walls=$walls $stick $slip "$square" until=0.25
    scaled two-$walls 2 1.42875e-3 >two-$walls.t
    scaled one-$walls 1 1.42875e-3 >one-$walls.t
    # shellcheck disable=SC2046 # three words
    {
        set -- $(apart front2 two-$walls.t 2 0.2)
        row "front, n^2 = 2, $walls${slip:+, slip}" 'experiment' "within $2 % (rms $3 %), shift $1" '10 %' "sqrt(($2) ^ 2) < 10" "$(cost two-$walls)"
        s=$(slope two-$walls.t)
        row "dZ/dT for 1.8 < Z < 4, n^2 = 2, $walls${slip:+, slip}" '1.28 to 1.37' "$s" '7 %' "$s > 1.19 && $s < 1.466" ''
        set -- $(apart front1 one-$walls.t 2 0.2)
        row "front, n^2 = 1, $walls${slip:+, slip}" 'experiment' "within $2 % (rms $3 %), shift $1" '10 %' "sqrt(($2) ^ 2) < 10" "$(cost one-$walls)"
        set -- $(apart height1 one-$walls.t 3 0.2)
        row "height, n^2 = 1, $walls${slip:+, slip}" 'experiment' "within $2 % (rms $3 %), shift $1" '5 %' "sqrt(($2) ^ 2) < 5" '' \
            'readings in steps of a/9; late the row at the wall is thin'
    }
done

: >by-spacing
for n in 20 40 80 160; do
    dx=$(awk -v n=$n 'BEGIN { printf "%.17g", 0.05715 / n }')
    # shellcheck disable=SC2086 # keys without blanks
    go dx$n "$scene" spacing="$dx" until=0.15 $open
    echo "$n $dx $(scaled dx$n 2 "$dx" | first 3)" >>by-spacing
    runs="$runs dx$n"
done
set -- $(awk '{ t[NR] = $3 } END { a = t[1] - t[2]; b = t[3] - t[4]
    printf "%.3f %.3f %.3f %.3f %.2f", t[1], t[2], t[3], t[4], log(sqrt((a / b) ^ 2)) / log(4) }' by-spacing)
# shellcheck disable=SC2086 # names of runs
row 'T at Z = 3, dx = a/20, a/40, a/80, a/160, contact: order' '1' "$1, $2, $3, $4: $5" '0.8' "$5 > 0.8" "$(cost $runs)"

draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set xlabel 'T = n t √(g/a)'
set ylabel 'Z = front / a'
set key top left Left reverse
set xrange [0:4]
set yrange [0.8:5.2]
set title 'column 2 a high'
plot 'front2' with points pt 6 lc rgb grey title 'Martin, Moyce', \
    'two-own-density.t' using 1:2 with lines lw 2 lc rgb pick(1) title 'own-density', \
    'two-adami.t' using 1:2 with lines lw 2 lc rgb pick(2) title 'adami, slip', \
    'two-contact.t' using 1:2 with lines lw 2 dt '-' lc rgb 'black' title 'contact, healed'
set title 'column a high: front, and height / a'
set yrange [0:5.2]
plot 'front1' with points pt 6 lc rgb grey title 'Martin, Moyce', 'height1' with points pt 4 lc rgb grey notitle, \
    'one-own-density.t' using 1:2 with lines lw 2 lc rgb pick(1) title 'own-density', \
    '' using 1:3 with lines lw 2 lc rgb pick(1) notitle, \
    'one-adami.t' using 1:2 with lines lw 2 lc rgb pick(2) title 'adami, slip', \
    '' using 1:3 with lines lw 2 lc rgb pick(2) notitle, \
    'one-contact.t' using 1:2 with lines lw 2 dt '-' lc rgb 'black' title 'contact, healed', \
    '' using 1:3 with lines lw 2 dt '-' lc rgb 'black' notitle
unset multiplot
G
done_here
