#!/bin/sh
# archimedes.sh -- a box that left the bed, and one that was driven down to it, have the lift of
# the water they displace within 3 %, between walls that stop water at their faces; none gets below
# one that stands on the bed and slides along it.
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

# Where a solid slides along another one, water finds no way between them: each knows how much
# room the other fills.
"$STIFFWATER" run "$top_srcdir/tests/scenes/sliding-box.scene" -q -o "$out/sliding"
awk -F, '
    FNR < 4 || $8 != 0 { next }
    { floor = $2 / 0.01; side = $1 < 0.35 ? (0.25 - $1) / 0.01 : ($1 - 0.45) / 0.01 }
    floor < least || !n++ { least = floor }
    $2 < 0.07 && (side < foot || !m++) { foot = side }
    END {
        printf "sliding box: the water stays %.2f dx from it and %.2f dx from the bed\n", foot, least
        exit !(foot > 0.2 && least > 0.2)
    }' "$out"/sliding/snapshots/0001.csv
