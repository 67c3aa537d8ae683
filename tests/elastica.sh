#!/bin/sh
# elastica.sh -- a beam that may bend far, in the water: where the linear beam is right it
# moves alike for as many right-hand sides; where it is not, it bends far and nothing breaks.
#
# Run by `make check`; a few seconds.
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
flagship=$top_srcdir/data/scenes/toth-beam.scene
gate=$top_srcdir/data/scenes/soft-gate.scene

# go NAME SCENE KEY=VALUE...
go() {
    name=$1
    file=$2
    shift 2
    "$STIFFWATER" run "$file" output.fields=1 output.snapshots=0 -q -o "$out/$name" "$@"
}

# number RUN KEY: a number of run.json
number() {
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$out/$1/run.json"
}

# most RUN COLUMN: its largest size in beam.csv
most() {
    awk -F, -v name="$2" '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
             { a = $c < 0 ? -$c : $c; if (a > m) m = a } END { print m }' "$out/$1/beam.csv"
}

# apart RUN OTHER: largest difference of their tips over the largest tip
apart() {
    paste -d, "$out/$1/beam.csv" "$out/$2/beam.csv" | awk -F, '/^#/ || /^t/ { next }
        { a = $2 < 0 ? -$2 : $2; d = $2 - $(NF / 2 + 2); d = d < 0 ? -d : d
          if (a > m) m = a; if (d > n) n = d } END { print n / m }'
}

# claim WORDS EXPRESSION: an awk expression that must be true
claim() {
    if awk "BEGIN { exit !($2) }"; then echo "ok      $1: $2"
    else echo "NOT SO  $1: $2"; bad=1; fi
}

# books RUN
books() {
    claim "$1: momentum closes" "$(number "$1" momentum_defect) < 1e-10"
    claim "$1: energy closes to 0.2 %" \
        "$(number "$1" energy_defect_max) < 2e-3 * $(number "$1" energy_initial)"
    claim "$1: nobody leaves" "$(number "$1" escaped) == 0"
}

bad=0
coarse='spacing=5e-3 until=0.25'
# shellcheck disable=SC2086 # two words
{
    go linear "$flagship" $coarse
    go far "$flagship" $coarse beam.theory=elastica
    go soft "$flagship" $coarse beam.theory=elastica beam.E=5e6
    go gate "$gate"
}
claim 'the tip moves alike' "$(apart linear far) < 0.02"
claim 'for as many right-hand sides' \
    "$(number far rhs_explicit) < 1.1 * $(number linear rhs_explicit)"
claim 'a hundred times softer it bends by more than half its length' \
    "$(most soft plate.tip_x) > 0.04 && $(most soft plate.tip_x) < 0.06"
claim 'and sinks' "$(most soft plate.tip_y) > 0.015"
claim 'for not many more' "$(number soft rhs_explicit) < 1.3 * $(number linear rhs_explicit)"
claim 'the gate opens by 47 mm' \
    "$(most gate gate.tip_x) > 0.043 && $(most gate gate.tip_x) < 0.05"
claim 'and rises by 17 mm' "$(most gate gate.tip_y) > 0.015 && $(most gate gate.tip_y) < 0.02"
claim 'the flap swings up as a whole' "$(most gate flap.tip_angle) > 0.6"
for run in far soft gate; do
    books $run
done
go swing "$top_srcdir/data/scenes/elastica.scene" until=0.3 method=dv # feels its first step
claim 'dv begins with a step that a bent strip allows' \
    "$(number swing energy_defect_max) < 1e-3 * $(number swing energy_initial)"
exit $bad
