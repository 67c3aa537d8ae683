#!/bin/sh
# still-water.sh -- what should not move does not: 2 s, or with STIFFWATER_LONG the
# scene's 10 s; between walls with a density of their own, and, coarser, between those that stop
# water at their faces.
. "$top_srcdir/tests/lib.sh"
[ -n "${STIFFWATER_LONG-}" ] && until=10 || until=2

# still KEY=VALUE...
still() {
    "$STIFFWATER" run "$top_srcdir/data/scenes/still-water.scene" "until=$until" \
        output.interval=0.02 output.fields=100 output.snapshots=0 "$@" -q -o "$out"

    # Marks after 1 s: kinetic energy under 1e-5 m g H; centre of mass, from the
    # potential energy m g y, within 0.1 % H of where it settled; bed pressure, at the
    # gauge 0.015 m above the bed, within 2 % of rho g (0.2 - 0.015).
    awk -F, -v m=40 -v g=9.81 -v H=0.2 '
        /^#/ || /^t/ { next }
        FNR == NR { if ($1 < 1) next
                    if ($2 > kinetic) kinetic = $2
                    y = $3 / (m * g)
                    if (!seen++) low = high = y
                    if (y < low) low = y
                    if (y > high) high = y
                    next }
        $1 >= 1 { n++; p += $2 }
        END {
            p /= n; bed = 1000 * g * (H - 0.015)
            printf "kinetic %.2g m g H, centre of mass moves %.2g H, bed pressure %+.2f %%\n", \
                kinetic / (m * g * H), (high - low) / H, 100 * (p / bed - 1)
            exit !(kinetic < 1e-5 * m * g * H && high - low < 1e-3 * H \
                   && p / bed > 0.98 && p / bed < 1.02)
        }' "$out/book.csv" "$out/probes.csv"
}

still walls=own-density
still walls=contact spacing=0.01
