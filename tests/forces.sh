#!/bin/sh
# forces.sh -- forces of the tables can be trusted: what the water loses in momentum, tank and
# beam get, also of a beam that bends far; what is under water is lifted by what it displaces.
#
# Marks: 1e-9 of m g t for the balance of the water alone, from its particles' eight digits and the
# impulses of forces.csv; 3 % for the lift, 20 spacings deep.  tests/validation/F01.sh has more.
. "$top_srcdir/tests/lib.sh"

# water RUN: t and momentum of the water in each snapshot
water() {
    m=$(column "$1/book" mass | awk 'NR == 1 { print $2 }')
    for file in "$out/$1"/snapshots/*.csv; do
        awk -F, -v m="$m" '/^# t/ { split($0, word, " "); t = word[4] }
            /^[-0-9]/ && $8 == 0 { x += $3; y += $4; n++ }
            END { printf "%s %.12g %.12g\n", t, m * x / n, m * y / n }' "$file"
    done
}

# balances RUN BEAM: sum of P(t) - P(0) - m g t and the impulses on tank and beam
balances() {
    m=$(column "$1/book" mass | awk 'NR == 1 { print $2 }')
    water "$1" >"$out/w"
    off=$(column "$1/forces" tank.ix tank.iy "$2.ix" "$2.iy" | awk -v m="$m" -v g=9.81 '
        NR == FNR { x[sprintf("%.9g", $1)] = $2; y[sprintf("%.9g", $1)] = $3; next }
        { t = sprintf("%.9g", $1) }
        t in x { if (!n++) { px = x[t]; py = y[t] }
            a = x[t] - px + $2 + $4; b = y[t] - py + m * g * $1 + $3 + $5
            e = sqrt(a * a + b * b); if (e > most) most = e; last = $1
            push = sqrt($4 * $4 + $5 * $5) / (m * g * $1 + 1e-9) }
        END { printf "%.3g, %.3g, %d", most / (m * g * last), push, n }' "$out/w" -)
    claim "$1: the water's momentum comes from weight, tank and beam" "${off%%,*} < 1e-9"
    off=${off#*, }
    claim "$1: and the beam has its part of it" "${off%%,*} > 0.02"
    claim "$1: at many moments" "${off#*, } >= 9"
}

cadence='output.interval=0.025 output.snapshots=11 until=0.25'
# shellcheck disable=SC2086 # words
well held "$top_srcdir/tests/validation/sunk-beam.scene" $cadence \
    'fluid.above.velocity=[0.3,0.0]' spacing=0.01 beam.body.layers=5
balances held body
# shellcheck disable=SC2086
well bends "$top_srcdir/data/scenes/elastic-obstacle.scene" $cadence \
    spacing=6.0833333333333333e-3 beam.obstacle.layers=3
balances bends obstacle
well rests "$top_srcdir/tests/validation/sunk-beam.scene" until=3 output.interval=0.01 \
    spacing=0.01 beam.body.layers=5
lift=$(column rests/forces body.fy | awk '$1 >= 2 { s += $2; n++ } END { print s / n }')
claim 'a beam under water is lifted by 24.525 N/m' "$lift / 24.525 > 0.97 && $lift / 24.525 < 1.03"
finish
