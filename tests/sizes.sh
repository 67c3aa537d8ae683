#!/bin/sh
# sizes.sh -- a tolerance means the same at every size: one splash in tanks of 2,208 and
# 30,208 particles has the same error by the default norm, whatever the method, and another
# one by the norms that average.
#
# Marks: rms distance of the splash's particles from where a method of order 5 at 1e-6 has
# them in the same tank.  Measured: max 1.000 for all methods; p8 1.30, wrms 2.57.  With
# STIFFWATER_LONG the larger tank has 200,208 particles.  Each library is tried in one of 10,208
# only, which a mean would dilute by 1.5.
. "$top_srcdir/tests/lib.sh"
[ -n "${STIFFWATER_LONG-}" ] && long=20 || long=3

# run NAME LENGTH KEY=VALUE...: in a tank of that length [m]
run() {
    name=$1
    length=$2
    shift 2
    "$STIFFWATER" run "$top_srcdir/data/scenes/tank-sizes.scene" -q -o "$out/$name" \
        "domain.to=[$length,0.1]" "fluid.rest.to=[$length,0.04]" \
        output.interval=0.01 output.fields=1 output.snapshots=2 "$@"
}

# error REFERENCE: of the last splash [dx]
error() {
    paste -d, "$out/splash/snapshots/0001.csv" "$out/$1/snapshots/0001.csv" | awk -F, '
        $7 == 1 && $8 == 0 { sum += ($1 - $9) ^ 2 + ($2 - $10) ^ 2; n++ }
        END { if (n != 1008) exit 1; printf "%.6g", sqrt(sum / n) / 2e-3 }'
}

# grows KEY=VALUE...: the error in the large tank over that in the small one, in $ratio
grows() {
    run splash 0.2 tol=1e-4 "$@"
    small=$(error short)
    run splash $long tol=1e-4 "$@"
    large=$(error long)
    ratio=$(awk "BEGIN { print $large / $small }")
}

run short 0.2 method=bs54 tol=1e-6
run long $long method=bs54 tol=1e-6

grows
claim 'there is an error to be measured' "$small > 3e-7 && $small < 1e-5"
claim 'the default norm holds it within a factor 2' "$ratio > 0.5 && $ratio < 2"
grows norm=p8
claim 'the mean 8th power dilutes it a little' "$ratio > 1.15 && $ratio < 2"
grows norm=wrms
claim 'wrms by more than a factor 2' "$ratio > 2"

# every library has its own way to the norm
if [ $long = 3 ]; then
    long=1
    run long $long method=bs54 tol=1e-6
fi
for method in dv adams gsl-rkf45 ab3; do
    grows method=$method
    claim "the default norm holds $method" "$ratio > 0.9 && $ratio < 1.1"
done
finish
