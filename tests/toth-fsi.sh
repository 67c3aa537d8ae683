#!/bin/sh
# toth-fsi.sh -- the coupled case of Toth (2012) with PCISPH: water and beam in turn keep momentum
# to rounding and energy to first order in the step, whatever the mesh of the beam; the tip bends
# about as far as in one right-hand side with WCSPH.
#
# Found: tip 2.30 mm (WCSPH, imex3: 2.53 mm); energy missed 0.639 J of 19.7, half of it with
# half of the step; supports booked where a step begins missed 0.031 N s/m.
. "$top_srcdir/tests/lib.sh"
scene=$top_srcdir/data/scenes/toth-fsi.scene

# peak RUN: largest tip displacement [mm]
peak() {
    awk -F, '/^[0-9]/ { a = $2 < 0 ? -$2 : $2; if (a > m) m = a } END { print 1000 * m }' \
        "$out/$1/beam.csv"
}

well whole "$scene" until=0.3
well half "$scene" until=0.3 method=pcisph@0.1
well coarse "$scene" until=0.3 beam.elements=20
runs='whole half coarse'
[ -z "${STIFFWATER_LONG-}" ] || { runs="$runs substeps"; well substeps "$scene" until=0.3 substep=1e-4; }
well one "$scene" until=0.3 method=imex3
for run in $runs; do
    claim "$run: momentum closes" "$(number $run momentum_defect) < 1e-8"
    claim "$run: no particle leaves" "$(number $run escaped) == 0 && $(number $run in_solids) == 0"
    claim "$run: compression" "$(number $run pressure_compression) <= 0.01"
done
claim 'energy closes to 4 %' "$(number whole energy_defect_max) < 0.04 * $(number whole energy_initial)"
claim 'half of the step, less than two thirds of the defect' \
    "$(number half energy_defect_max) < 0.67 * $(number whole energy_defect_max)"
claim 'the tip bends by 2.3 mm +- 8 %' "$(peak whole) > 2.3 * 0.92 && $(peak whole) < 2.3 * 1.08"
claim 'no less than 0.8 of what WCSPH has, no more than it' \
    "$(peak whole) > 0.8 * $(peak one) && $(peak whole) < 1.05 * $(peak one)"
claim 'with 20 elements the same within 8 %' \
    "$(peak coarse) > 0.92 * $(peak whole) && $(peak coarse) < 1.08 * $(peak whole)"
finish
