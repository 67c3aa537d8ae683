#!/bin/sh
# mri-rigid.sh -- a heavy block of real stiffness falls through shallow water onto the floor: its contacts
# bound its own steps, not those of the water.
. "$top_srcdir/tests/lib.sh"

scene=$top_srcdir/tests/scenes/block-falls.scene
stiff=body.block.softness=0.003
all=202 # J/m, that there were

# Its first steps, and those in which it lies on the floor, are all there is for a sanitizer.
if brief; then
    well short "$scene" method=mri-rigid $stiff until=0.02
    well lying "$scene" method=mri-rigid $stiff until=0.02 'body.block.at=[0.4,0.0505]' body.block.angle=0
    claim 'momentum closes' "$(number short momentum_defect) < 1e-8 && $(number lying momentum_defect) < 1e-8"
    finish
fi

well apart "$scene" method=mri-rigid $stiff
well alike "$scene" method=cks43 $stiff
well soft "$scene" method=mri-rigid

claim 'it hits the floor' "$(last apart book contact) < -5"
claim 'energy closes' "($(last apart book defect))^2 < (1e-3*$all)^2"
claim 'energy of soft contacts closes' "($(last soft book defect))^2 < (1e-3*$all)^2"
claim 'momentum closes' "$(number apart momentum_defect) < 1e-8"
claim 'the water takes less than half of the right-hand sides' \
    "$(number apart rhs_explicit) < 0.5*$(number alike rhs_explicit)"
claim 'however stiff it is, the water takes as many' \
    "$(number apart rhs_explicit) < 1.1*$(number soft rhs_explicit)"
claim 'stiffer contacts take more, by themselves' \
    "$(number apart rhs_implicit) > 1.3*$(number soft rhs_implicit)"

# --- order 3, without a contact ---------------------------------------------------------------
float=$top_srcdir/tests/scenes/floating-box.scene
go_on='until=0.04 output.interval=0.04 body.it.velocity=[0.2,-0.3]'
well exact "$float" method=cks43@2.5e-5s $go_on
for h in 4e-4 2e-4 1e-4; do
    well by-$h "$float" method=mri-rigid@${h}s $go_on
done
# error H: of the upward velocity
error() {
    awk -v a="$(last "by-$1" bodies it.vy)" -v b="$(last exact bodies it.vy)" \
        'BEGIN { print (a > b ? a - b : b - a) }'
}
claim 'half the step has an eighth of the error' "$(error 4e-4) > 6.5*$(error 2e-4)"
claim 'and again' "$(error 2e-4) > 6.5*$(error 1e-4)"

# --- what it cannot serve ---------------------------------------------------------------------
go lifted "$scene" method=mri-rigid body.block.uplift=true
prints lifted 'uplift'
go bent "$top_srcdir/tests/scenes/small-2d.scene" method=mri-rigid
prints bent 'has a beam'
go dry "$top_srcdir/data/scenes/block-stack.scene" method=mri-rigid
prints dry 'has no water'

for threads in 1 2; do
    OMP_NUM_THREADS=$threads "$STIFFWATER" run "$scene" -q method=mri-rigid $stiff until=0.25 \
        -o "$out/bits-$threads" 2>"$out/said" || wrong "it runs on $threads threads"
done
claim 'two threads have the bits of one' "\"$(hash bits-1)\" == \"$(hash bits-2)\""
finish
