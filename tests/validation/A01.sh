#!/bin/sh
# A01.sh -- water at rest
#
# A column of water, 0.2 m wide and deep, 40 spacings each (`data/scenes/still-water.scene`), and
# one of 0.2 m x 0.2 m x 0.2 m with 12 (`tests/validation/still-water-3d.scene`), left alone for ten
# seconds (3D: two), with three wall models, of which `contact` is the default. The reference is rho g z below a surface that keeps its
# place, and the equilibrium of Tait, which is at most 0.5 % above it
# (`data/reference/A01_hydrostatic_column.csv`). Pressures are those of all particles at the end.
#
# Ghosts, the layer of particles that Toth saw at the floor under walls of fixed particles, are
# looked for as the share of particles nearer than half a spacing to their neighbour (pairing.csv)
# and as the gap below the lowest row (half a spacing is none).
. "$(dirname "$0")/lib.sh"

# profile RUN DX D: L2 error of p over rho g H, lowest row, centre of mass, L2 error from the
# equilibrium of Tait with its c0 = 10 sqrt(2 g H), B = rho0 c0^2/7 = 56057 Pa
profile() {
    file=$(tail -n 1 "$1/snapshots.csv" | cut -d, -f2)
    awk -F, -v dx="$2" -v d="$3" '/^#/ || /^x/ { next } $NF != 0 { next }
        { z = $d; p = $(2 * d + 2); e = p - 9810 * (0.2 - z); s += e * e; n++; c += z
          e = p - 56057.14 * ((1 + 6 * 9.81 * (0.2 - z) / 392.4) ^ (7 / 6) - 1); q += e * e
          if (n == 1 || z < low) low = z
          print z / 0.2, p / 1962 >"profile" }
        END { printf "%.3f %.2f %.3f %.3f", 100 * sqrt(s / n) / 1962, low / dx, 100 * (c / n / 0.2 - 0.5),
              100 * sqrt(q / n) / 1962 }' "$1/$file"
    mv profile "$1.p"
}
# report RUN NAME DX D WEIGHT-TIMES-DEPTH: the rows of a run
report() {
    # shellcheck disable=SC2046 # four words
    set -- "$@" $(profile "$1" "$3" "$4")
    row "$2: pressure, L2 error over rho g H" '0' "$6 %" '2 %' "$6 < 2" "$(cost "$1")"
    p=$(column "$1/probes" bed | mean "$(calc "0.5 * $(number "$1" t_end)")" 99)
    row "$2: pressure at z = 15 mm" '1815 Pa' "$(calc "$p") Pa" '2 %' "sqrt(($p / 1814.9 - 1) ^ 2) < 0.02" ''
    k=$(column "$1/book" kinetic | awk -v w="$5" '{ k = $2 } END { printf "%.2g", k / w }')
    row "$2: kinetic energy over m g H at the end" '0' "$k" '1e-5' "$k < 1e-5" ''
    row "$2: centre of mass, from that of the start" '0' "$8 % of H" '0.5 %' "sqrt(($8) ^ 2) < 0.5" ''
    g=$(column "$1/pairing" pairing | awk '{ x = $2 } END { printf "%.2g", 100 * x }')
    row "$2: ghosts: in pairs; lowest row" '0; 0.5 dx' "$g %; $7 dx" '0 %; 0.35 to 0.65 dx' \
        "$g == 0 && $7 > 0.35 && $7 < 0.65" ''
}
for walls in contact own-density adami; do
    go flat-$walls "$scenes/still-water.scene" walls=$walls output.snapshots=2
    go deep-$walls "$cases/still-water-3d.scene" walls=$walls
    report flat-$walls "2D, $walls" 5e-3 2 78.48
    report deep-$walls "3D, $walls" 0.016666666666666666 3 15.696
done
: >by-spacing
for n in 10 20 40; do
    dx=$(awk -v n=$n 'BEGIN { printf "%.17g", 0.2 / n }')
    for walls in contact own-density adami; do
        go "dx$n" "$scenes/still-water.scene" walls=$walls spacing="$dx" until=4 output.snapshots=2
        # shellcheck disable=SC2046 # three words
        set -- $(profile "dx$n" "$dx" 2)
        echo "$n $walls $4" >>by-spacing
    done
done
for walls in contact own-density adami; do
    o=$(awk -v w=$walls '$2 == w { x = -log($1); y = log($3); n++; a += x; b += y; c += x * x; d += x * y }
        END { printf "%.2f", (n * d - a * b) / (n * c - a * a) }' by-spacing)
    e=$(awk -v w=$walls '$2 == w { printf "%s%s", n++ ? ", " : "", $3 }' by-spacing)
    row "2D, $walls: L2 error from Tait with 10, 20, 40 spacings (4 s): order" '1' "$e %: $o" '0.8' "$o > 0.8" "$(cost dx40)" \
        'a floor of compressibility: with three times c0 the error of 20 spacings falls from 0.7 to 0.3 %'
done
draw <<'G'
set datafile separator ' '
set xlabel 'z / H'
set ylabel 'p / ρgH'
set xrange [0:1.05]
set yrange [-0.05:1.1]
plot 1 - x lw 2 lc rgb grey title 'ρgz', \
    'flat-contact.p' with points pt 7 ps 0.3 lc rgb pick(4) title '2D, contact', \
    'flat-own-density.p' with points pt 7 ps 0.3 lc rgb pick(1) title '2D, own-density', \
    'flat-adami.p' with points pt 7 ps 0.3 lc rgb pick(2) title '2D, adami', \
    'deep-adami.p' with points pt 6 ps 0.6 lc rgb pick(3) title '3D, adami'
G
done_here
