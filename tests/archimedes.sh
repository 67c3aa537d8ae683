#!/bin/sh
# archimedes.sh -- a box that left the bed, and one that was driven down to it, have the lift of
# the water they displace within 3 %, between walls that stop water at their faces.
. "$top_srcdir/tests/lib.sh"

for box in lifted lowered; do
    "$STIFFWATER" run "$top_srcdir/tests/scenes/$box-box.scene" -q -o "$out/$box"
    awk -F, -v box="$box" -v lift=156.96 '
        /^#/ { next }
        /^t/ { for (i = 1; i <= NF; i++) if ($i == "box.fy") column = i; next }
        $1 >= 1.8 { n++; sum += $column }
        END {
            printf "%s box: %.4f of its lift\n", box, sum / n / lift
            exit !(sum / n > 0.97 * lift && sum / n < 1.03 * lift)
        }' "$out/$box/forces.csv"
done
