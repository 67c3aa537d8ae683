#!/bin/sh
# toth-beam.sh -- the flagship: what a dam break does to an elastic beam, and what
# the stiffness and the mesh of the beam cost (nothing).
. "$top_srcdir/tests/lib.sh"
scene=$top_srcdir/data/scenes/toth-beam.scene

# peak RUN: largest tip displacement [mm] and its time
peak() {
    awk -F, '/^#/ || /^t/ { next } { a = $2 < 0 ? -$2 : $2; if (a > m) { m = a; t = $1 } }
             END { print 1000 * m, t }' "$out/$1/beam.csv"
}

awk '/^beam = /{ skip = 1 } !skip { print } skip && /^};/ { skip = 0 }' "$scene" >"$out/alone.scene"
well alone "$out/alone.scene"
well beam "$scene"
well coarse "$scene" beam.elements=10
meshes=coarse
[ -z "${STIFFWATER_LONG-}" ] || { meshes='coarse fine'; well fine "$scene" beam.elements=100; }
well steel "$scene" beam.E=210e9

contact=$(awk -F, '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == "plate.fx") c = i; next }
                   $c > 1 || $c < -1 { print $1; exit }' "$out/beam/forces.csv")
set -- $(peak beam)
claim 'first contact at about 0.130 s' "$contact > 0.126 && $contact < 0.134"
claim 'tip bends by 1.95 mm +-8 %' "$1 > 1.95 * 0.92 && $1 < 1.95 * 1.08"
claim 'between 0.165 and 0.205 s' "$2 >= 0.165 && $2 <= 0.205"
tip=$1
for run in $meshes; do
    set -- $(peak $run)
    claim "the same with $run elements, 5 %" "$1 > 0.95 * $tip && $1 < 1.05 * $tip"
done
claim 'momentum closes' "$(number beam momentum_defect) < 1e-10"
claim 'energy closes to 0.1 %' "$(number beam energy_defect_max) < 1e-3 * $(number beam energy_initial)"
claim 'no particle leaves' "$(number beam escaped) == 0"
rhs=$(number beam rhs_explicit)
claim 'at most 1.3 times the right-hand sides of the water alone' "$rhs <= 1.3 * $(number alone rhs_explicit)"
for run in $meshes steel; do
    claim "right-hand sides within 30 % ($run)" "$(number $run rhs_explicit) > 0.7 * $rhs && $(number $run rhs_explicit) < 1.3 * $rhs"
done
# Right-hand sides of an explicit method are as many in each millisecond of a run: its
# step is that of the beam. 166 of them follow the contact, at 0.134 s, until 0.3 s.
explicit() {
    well "$1" "$scene" until=0.001 method=cks43 beam.elements=10 $2
}
explicit soft ''
explicit stiff beam.E=5e9
explicit finer beam.elements=20
well before "$scene" until=0.134 method=imex4 beam.elements=10
well after "$scene" until=0.3 method=imex4 beam.elements=10
implicit=$(($(number after rhs_explicit) - $(number before rhs_explicit)))
soft=$(number soft rhs_explicit)
claim 'after the contact explicit needs 50 times the right-hand sides' "166 * $soft > 50 * $implicit"
claim 'and 3.16 times those with 10 times E' \
    "$(number stiff rhs_explicit) > 2.8 * $soft && $(number stiff rhs_explicit) < 3.5 * $soft"
claim 'and 4 times those with twice the elements' \
    "$(number finer rhs_explicit) > 3.6 * $soft && $(number finer rhs_explicit) < 4.4 * $soft"
well exact "$scene" until=0.3 method=imex4 tol=5e-4
claim 'imex4 closes energy to 5e-4 J' "$(number exact energy_defect_max) < 5e-4"
finish
