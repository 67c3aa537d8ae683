#!/bin/sh
# wave-maker.sh -- a piston makes the waves that linear theory says, and the books of a
# tank that swings and of a gate that lifts close.
#
# Marks: height of the first harmonic, mean of two places (the beach throws a little back),
# within 10 % of the theory (-7 % at 10 spacings of depth, -5 % at 15); energy to 3e-4 of
# what there was, momentum to 1e-8 of weight x time.
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes

# books MASS: of the run that has ended, MASS kg
books() {
    awk -v e="$(number run energy_defect_max)" -v e0="$(number run energy_initial)" -v mass="$1" \
        -v p="$(number run momentum_defect)" -v t="$(number run t_end)" 'BEGIN {
            printf "energy %.2g of %.4g J, momentum %.2g N s\n", e, e0, p
            exit !(e < 3e-4 * e0 && p < 1e-8 * mass * 9.81 * t)
        }'
}

"$STIFFWATER" run "$scenes/wave-maker.scene" spacing=0.03 output.fields=9 output.snapshots=0 -q \
    -o "$out/run"
books 1200
awk -F, -v theory=0.0479 '
    /^[0-9]/ && $1 > 5.999 && $1 < 8.999 {
        w = 2 * 3.14159265358979 / 1.5
        for (k = 2; k <= 3; k++) {
            c[k] += $k * cos(w * $1)
            s[k] += $k * sin(w * $1)
        }
        n++
    }
    END {
        for (k = 2; k <= 3; k++) {
            printf "probe %d: %.4f m\n", k - 1, 4 * sqrt(c[k] ^ 2 + s[k] ^ 2) / n
            height += 2 * sqrt(c[k] ^ 2 + s[k] ^ 2) / n
        }
        printf "height %.4f m, theory %.4f m\n", height, theory
        exit !(height > 0.9 * theory && height < 1.1 * theory && n > 140)
    }' "$out/run/probes.csv"

"$STIFFWATER" run "$scenes/sloshing-tank.scene" spacing=0.05 until=1.5 output.snapshots=0 -q -o "$out/run"
books 200
"$STIFFWATER" run "$scenes/gate.scene" spacing=0.02 until=0.5 output.snapshots=0 -q -o "$out/run"
books 60
