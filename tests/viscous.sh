#!/bin/sh
# viscous.sh -- what the implicit side of a thick fluid saves: 1,800 particles of 500
# Pa s, and the same bits on one thread and on two.
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
sed 's/artificial-viscosity = .*/laminar-viscosity = { mu = 500.0; };/' \
    "$top_srcdir/data/scenes/dam-break.scene" >"$out/thick.scene"

# run NAME METHOD SIDE THREADS
run()
{
    "$STIFFWATER" run "$out/thick.scene" spacing=3.3333333333333333e-3 until=0.02 \
        output.interval=0.01 output.fields=100 output.snapshots=0 -m "$2" -n "$4" \
        "effects.laminar-viscosity.side=$3" -q -o "$out/$1" 2>>"$out/said"
}
number()
{
    sed -n "s/^ *\"$2\": *\"\{0,1\}\([^\",]*\).*/\1/p" "$out/$1/run.json"
}

run explicit cks43 explicit 1
run implicit imex3 implicit 1
run threads imex3 implicit 2
grep -q 'side = "implicit" is cheaper' "$out/said" || { echo 'no advice'; exit 1; }
[ "$(number implicit state_hash)" = "$(number threads state_hash)" ] ||
    { echo 'two threads give other bits than one'; exit 1; }

# At least 5 times fewer passes over pairs, products counted as such; energy closes to
# 1e-4 of what there is, momentum to rounding.
echo "$(number explicit pair_passes) $(number implicit pair_passes)" \
    "$(number implicit operator_products) $(number explicit energy_defect)" \
    "$(number implicit energy_defect) $(number implicit energy_initial)" \
    "$(number implicit momentum_defect)" | awk '{
        printf "explicit %d passes; implicit %d and %d products, %.1f times fewer; energy " \
               "defect %.2g and %.2g of %.3g J/m, momentum %.1g\n", $1, $2, $3, $1 / ($2 + $3),
               $4, $5, $6, $7
        if ($5 < 0) $5 = -$5
        exit !($1 > 5 * ($2 + $3) && $3 > 0 && $5 < 1e-4 * $6 && $7 < 1e-10)
    }'
