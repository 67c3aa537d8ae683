#!/bin/sh
# W01.sh -- contact walls: rest, waves, gaps and water that lets go
#
# What `walls = "contact"` promises, with artificial viscosity that does not act at solids (`stick = "none"`), with
# tension and without it (healed: `eos.tension = false` and `density-healing`). Water at rest is that of A01, 40 spacings
# deep, in 3D 20. The standing wave is that of A05. *Gap*: distance from the floor of the lowest particle of
# every 2 dx of it, median, while the water runs over the dry floor (`data/scenes/dam-break.scene`, dx = 2.5 mm, 0.2 s); half
# a spacing is none. *Hanging*: particles of the row beside the left wall above 0.12 m at 0.4 s, when the water has left it.
#
# Level: height of the centre of mass, mean from 4 to 5 s of sloshing (dx = 5 mm), over that at rest, 25 mm. Water
# that slips goes on to slosh, and a wave lifts the centre of mass: by as much potential energy as it has kinetic, in linear
# theory. So what volume the walls add or take is judged by potential energy less kinetic; the row above it has both.
. "$(dirname "$0")/lib.sh"
contact='walls=contact effects.artificial-viscosity.stick=none'
healed='eos.tension=false effects.density-healing={}'

# profile RUN DX D: L2 error of p over rho g H, and the lowest row
profile() {
    awk -F, -v dx="$2" -v d="$3" '/^#/ || /^x/ { next } $NF != 0 { next }
        { e = $(2 * d + 2) - 9810 * (0.2 - $d); s += e * e; n++; if (n == 1 || $d < low) low = $d }
        END { printf "%.3f %.2f", 100 * sqrt(s / n) / 1962, low / dx }' \
        "$1/$(tail -n 1 "$1/snapshots.csv" | cut -d, -f2)"
}
# rest RUN NAME DX D WEIGHT-TIMES-DEPTH FROM
rest() {
    from=$6
    # shellcheck disable=SC2046 # two words
    set -- "$1" "$2" "$5" $(profile "$1" "$3" "$4")
    row "at rest, $2: pressure, L2 error over rho g H" '0' "$4 %" '2 %' "$4 < 2" "$(cost "$1")"
    p=$(column "$1/probes" bed | mean "$from" 99)
    row "at rest, $2: pressure at z = 15 mm" '1815 Pa' "$(calc "$p") Pa" '2 %' "sqrt(($p / 1814.9 - 1) ^ 2) < 0.02" ''
    k=$(column "$1/book" kinetic | awk -v w="$3" '{ k = $2 } END { printf "%.2g", k / w }')
    row "at rest, $2: kinetic energy over m g H at the end" '0' "$k" '1e-5' "$k < 1e-5" ''
    row "at rest, $2: lowest row" '0.5 dx' "$5 dx" '0.35 to 0.65 dx' "$5 > 0.35 && $5 < 0.65" ''
}
# shellcheck disable=SC2086 # keys
{
    go flat "$scenes/still-water.scene" $contact until=4 output.snapshots=2
    go deep "$cases/still-water-3d.scene" $contact spacing=0.01
}
rest flat '2D, 40 dx' 5e-3 2 78.48 2
rest deep '3D, 20 dx' 0.01 3 15.696 1

# period RUN COUNT: twice the distance of the minima of the kinetic energy, mean over so many
period() {
    column "$1/book" kinetic | awk '
        { if (NR > 2 && a > b && $2 >= b) print s + (a - $2) / (2 * (a - 2 * b + $2)) * ($1 - s)
          a = b; b = $2; s = $1 }' |
        awk -v n="$2" 'NR == 1 { t = $1 } NR == 2 * n + 1 { printf "%.4f", ($1 - t) / n }'
}
# wave RUN NAME COUNT
wave() {
    p=$(period "$1" "$3")
    row "standing wave, $2: period" '1.1339 s' "$p s" '1 %' "sqrt(($p / 1.133917 - 1) ^ 2) < 0.01" "$(cost "$1")"
}
wavy='effects.laminar-viscosity.mu=0 effects.stress-viscosity.mu=12.53'
# shellcheck disable=SC2086 # keys
{
    go wave "$scenes/standing-wave.scene" walls=contact $wavy
    go wave-healed "$scenes/standing-wave.scene" walls=contact $wavy $healed
    go long "$scenes/standing-wave.scene" walls=contact spacing=0.05 until=23.5 effects.laminar-viscosity.mu=0 \
        effects.density-diffusion.delta=0.03
}
wave wave 'Re 250, dx = H/40' 5
wave wave-healed 'Re 250, dx = H/40, healed' 5
wave long 'no viscosity, dx = H/20, 20 periods' 20
r=$(column long/book total | awk 'NR == 1 || $2 < low { low = $2 } $2 - low > m { m = $2 - low }
    END { printf "%.2g", 100 * m / 12.26 }')
row 'in this run energy never grows: largest rise, delta = 0.03' '0' "$r % of the wave" '0.1 %' "$r < 0.1" ''

# gap FILE: of the lowest particle of every 2 dx of wet floor, median, dx
gap() {
    awk -F, '/^#/ || /^x/ || $8 != 0 { next }
        { k = int($1 / 5e-3); if (!(k in low) || $2 < low[k]) low[k] = $2 }
        END { for (k in low) if (low[k] < 0.0125) print low[k] / 2.5e-3 }' "$1" | sort -n |
        awk '{ x[NR] = $1 } END { printf "%.2f", (x[int((NR + 1) / 2)] + x[int((NR + 2) / 2)]) / 2 }'
}
# hanging FILE: particles beside the left wall, above 0.12 m
hanging() {
    awk -F, '/^#/ || /^x/ || $8 != 0 { next } $1 < 3.75e-3 && $2 > 0.12 { n++ } END { print n + 0 }' "$1"
}
# level RUN: potential energy of its centre of mass over that at rest, and less its kinetic energy; %
level() {
    column "$1/book" potential kinetic | awk '$1 >= 4 { p += $2; k += $3; n++ }
        END { rest = 20 * 9.81 * 0.025; printf "%.2f %.2f", 100 * (p / n / rest - 1), 100 * ((p - k) / n / rest - 1) }'
}
# books RUN: largest pressure_defect over the energy there was
books() {
    column "$1/book" pressure_defect |
        awk -v e="$(number "$1" energy_initial)" '{ d = $2 < 0 ? -$2 : $2 } d > m { m = d } END { printf "%.1g", m / e }'
}
for k in tension healed; do
    keys=$contact
    [ $k = tension ] || keys="$contact $healed"
    # shellcheck disable=SC2086 # keys
    {
        go "run-$k" "$scenes/dam-break.scene" spacing=2.5e-3 until=0.4 output.snapshots=3 $keys
        go "slosh-$k" "$scenes/dam-break.scene" spacing=5e-3 until=5 output.snapshots=1 $keys
    }
    g=$(gap "run-$k/snapshots/0001.csv")
    row "running water, $k: gap" '0.5 dx' "$g dx" '0.6 dx' "$g <= 0.6" "$(cost "run-$k")"
    h=$(hanging "run-$k/snapshots/0002.csv")
    row "particles that hang on a dry wall, $k" '0' "$h" '0' "$h == 0" ''
    # shellcheck disable=SC2046 # two words
    set -- $(level "slosh-$k")
    row "centre of mass after sloshing, $k" '0 % above rest' "$1 %" 'not judged: waves lift it' 1 "$(cost "slosh-$k")"
    why=
    [ $k = tension ] || why='healing makes room: density comes back where spray lands'
    row "the same less kinetic energy, $k" '0 %' "$2 %" '1.5 %' "sqrt(($2) ^ 2) < 1.5" '' "$why"
    b=$(books "slosh-$k")
    row "pressure_defect over the energy of the start, $k" '0' "$b" '1e-12' "$b < 1e-12" ''
    n=$(number "slosh-$k" in_solids_max)
    row "particles in solids at any time, lost, $k" '0, 0' "$n, $(number "slosh-$k" escaped)" '0, 0' \
        "$n + $(number "slosh-$k" escaped) == 0" ''
done
for k in tension healed; do
    awk -F, '!/^#/ && !/^x/ && $8 == 0 { print $1, $2 }' "run-$k/snapshots/0001.csv" >"$k.0.2"
    awk -F, '!/^#/ && !/^x/ && $8 == 0 { print $1, $2 }' "run-$k/snapshots/0002.csv" >"$k.0.4"
done
draw <<'G'
set datafile separator ' '
set multiplot layout 2, 2 margins 0.02, 0.98, 0.03, 0.93 spacing 0.02, 0.08
unset tics
unset key
set size ratio -1
set xrange [0:0.4]
set yrange [0:0.2]
do for [k in 'tension healed'] {
    do for [t in '0.2 0.4'] {
        set title k.', '.t.' s' offset 0, -0.7
        plot k.'.'.t using 1:2 with points pt 7 ps 0.25 lc rgb pick(1)
    }
}
unset multiplot
G
done_here
