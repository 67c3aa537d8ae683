#!/bin/sh
# elastica.sh -- a beam that may bend far, in the water: where the linear beam is right it
# moves alike for as many right-hand sides; where it is not, it bends far and nothing breaks.
#
# Run by `make check`; a few seconds.
. "$top_srcdir/tests/lib.sh"
flagship=$top_srcdir/data/scenes/toth-beam.scene
gate=$top_srcdir/data/scenes/soft-gate.scene

# apart RUN OTHER: largest difference of their tips over the largest tip
apart() {
    paste -d, "$out/$1/beam.csv" "$out/$2/beam.csv" | awk -F, '/^#/ || /^t/ { next }
        { a = $2 < 0 ? -$2 : $2; d = $2 - $(NF / 2 + 2); d = d < 0 ? -d : d
          if (a > m) m = a; if (d > n) n = d } END { print n / m }'
}

# books RUN
books() {
    claim "$1: momentum closes, to 1e-11 of weight times time" "$(number "$1" momentum_defect) < 5e-10"
    claim "$1: energy closes to 0.2 %" \
        "$(number "$1" energy_defect_max) < 2e-3 * $(number "$1" energy_initial)"
    claim "$1: no particle leaves" "$(number "$1" escaped) == 0"
}

# Walls with a cushion, friction and tension: else two runs that differ by a millionth of a spacing
# are 8 % of the tip apart, by chance.
coarse='spacing=5e-3 until=0.25 walls=own-density effects.artificial-viscosity.stick=particles
    eos.tension=true effects.density-healing.strength=0 effects.density-diffusion.delta=0.1'
# shellcheck disable=SC2086 # two words
{
    well linear "$flagship" $coarse
    well far "$flagship" $coarse beam.theory=elastica
    well soft "$flagship" $coarse beam.theory=elastica beam.E=5e6
    well gate "$gate"
}
claim 'the tip moves alike' "$(apart linear far) < 0.02"
claim 'for as many right-hand sides' \
    "$(number far rhs_explicit) < 1.1 * $(number linear rhs_explicit)"
claim 'a hundred times softer it bends by more than half its length' \
    "$(most soft beam plate.tip_x) > 0.04 && $(most soft beam plate.tip_x) < 0.06"
claim 'and sinks' "$(most soft beam plate.tip_y) > 0.015"
claim 'for not many more' "$(number soft rhs_explicit) < 1.3 * $(number linear rhs_explicit)"
claim 'the gate opens by 39 mm' \
    "$(most gate beam gate.tip_x) > 0.037 && $(most gate beam gate.tip_x) < 0.041"
claim 'and rises by 12 mm' \
    "$(most gate beam gate.tip_y) > 0.011 && $(most gate beam gate.tip_y) < 0.013"
claim 'the flap swings up as a whole' "$(most gate beam flap.tip_angle) > 0.6"
for run in far soft gate; do
    books $run
done
# Begins with no energy at all: what it has later comes from its weight.
cat >"$out/weight.scene" <<'S'
dimension = 2; gravity = [0.0, -1.0]; until = 1.2; tol = 0.1;
beam = { strip = { theory = "elastica"; at = [0.0, 0.0]; angle = 0.0; E = 1.2e10; density = 1000.0;
                   elements = 20; damping_ratio = 1.0; length = 1.0; thickness = 1e-3; }; };
S
well weight "$out/weight.scene"
claim 'a strip sinks under its weight' "$(most weight beam strip.tip_y) > 0.05"
well swing "$top_srcdir/data/scenes/elastica.scene" until=0.3 method=dv # feels its first step
claim 'dv begins with a step that a bent strip allows' \
    "$(number swing energy_defect_max) < 1e-3 * $(number swing energy_initial)"
finish
