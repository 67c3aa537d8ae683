#!/bin/sh
# spread.sh -- `stiffwater spread' keeps its word: runs that differ by their seed alone, bands of
# exactly zero without a disturbance, numbers that are those of the runs' files, runs that failed
# left out, nothing run twice, a signal.  Run by `make check'.
scenes=${top_srcdir:-.}/data/scenes
ask=spread
. "${top_srcdir:-.}/tests/lib.sh"
asking

# value_of DIR COLUMN WHAT NUMBER: of spread.csv
value_of()
{
    awk -F, -v column="$2" -v what="$3" -v wanted="$4" '
        /^#/ { next }
        !c { for (i = 1; i <= NF; i++) if ($i == wanted) c = i; next }
        $2 == column && $3 == what { print $c }' "$1/spread.csv"
}

# holds CONDITION NUMBER...: awk's condition of a, b, c
holds()
{
    tried=$((tried + 1))
    awk -v a="$2" -v b="$3" -v c="$4" "BEGIN { exit !(a != \"\" && a == a + 0 && ($1)) }" ||
        complain "$1 does not hold for a = $2, b = $3, c = $4"
}

dam="$scenes/dam-break.scene spacing=0.0125 probe.low={at=[0.4,0.01];} --until 0.3"

# shellcheck disable=SC2086 # scene and keys are words
{
# --- mistakes -------------------------------------------------------------------------------
expect 2 $dam --runs 1 -o wrong
says --runs 2 999
expect 2 $dam --runs many -o wrong
expect 2 $dam --size 0.02 -o wrong
says --size 0.01
expect 2 $dam --size -1e-6 -o wrong
expect 2 $dam --share 0 -o wrong
expect 2 $dam --window 0.1 -o wrong
says FROM,TO
expect 2 $dam --window 0.2,0.1 -o wrong
says --window 0.3
expect 2 $dam --window 0.1,0.4 -o wrong
expect 2 "$scenes/beam-alone.scene" -o wrong
says "no fluid"
expect 2 no-such.scene -o wrong
says no-such.scene
[ ! -e wrong ] || complain "a mistake leaves a directory"
expect 2 $dam fluid.dey=1 --runs 5 -o refused
says dey dye
[ ! -e refused/runs/seed-2/run.json ] || complain "what the scene refuses is run again and again"
[ ! -e refused/spread.csv ] || complain "a table of nothing"

# --- without a disturbance there is no band -------------------------------------------------------
expect 0 $dam --until 0.1 --size 0 --runs 3 -q -o same
[ ! -s said ] || [ "$(grep -v png said)" = "" ] || complain "quiet, it talks"
for file in same/spread-front.csv same/spread-forces.csv same/spread-probes.csv; do
    tried=$((tried + 1))
    awk -F, '/^#/ { next } /^t/ { for (i = 2; i <= NF; i++) kind[i] = $i; next }
        { n++; for (i = 2; i < NF; i += 5) if ($(i + 1) != $i || $(i + 2) != $i || $(i + 3) != 0 ||
            $(i + 4) != 0) { print; exit 1 } }
        END { exit n < 20 }' $file || complain "$file: a band without a disturbance"
done
awk -F, '/^[#t]/ { next } $2 != 0 || $3 != 0 { exit 1 } { n++ } END { exit n != 51 }' \
    same/spread-positions.csv || complain "particles apart without a disturbance"
awk -F, '/^[#t]/ { next } $7 != $6 || $8 != $6 || $9 != 0 || $10 != 0 || $11 != "nan" { exit 1 }' \
    same/spread.csv || complain "single numbers differ without a disturbance"
grep -q 'chance decides nothing' same/spread.md || complain "no word that all runs are one"

# --- a dam break --------------------------------------------------------------------------------
expect 0 $dam --runs 3 --seed 7 --jobs 2 --window 0.1,0.2 --size 1e-3 --share 1e-4 -o dam
}
says "3 runs that differ by 0.001 spacings at the start" "| quantity | what | mean |" \
    "| forces tank.fx [N/m] | peak |" "| forces tank.fx [N/m] | time of the peak [s] |" \
    "are those from 0.1 to 0.2 s, ends those at 0.3 s" "| forces tank.ix [N s/m] | at the end |" \
    "3 of 3 runs came to their end." "50 % fall between them" "uncertain by 50 %" \
    "band wider than 0.01 % of its largest mean" "- particles: 0.0001 spacings apart" \
    "only statistics mean anything"
for file in spread.csv spread.json spread.md spread-front.csv spread-forces.csv \
    spread-probes.csv spread-positions.csv; do
    [ -s dam/$file ] || complain "there is no $file"
done
[ ! -e dam/spread-beam.csv ] || complain "bands of a beam that is not there"
for seed in 7 8 9; do
    grep -q -x "disturbance.seed=$seed" dam/runs/seed-$seed/order || complain "no seed $seed"
done
grep -h state_hash dam/runs/*/run.json | sort -u | wc -l | grep -q 3 || complain "seeds are alike"

# The numbers are those of the runs.
set -- $(for seed in 7 8 9; do
    awk -F, '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == "tank.ix") c = i; next }
        { x = $c } END { printf "%.9g ", x }' dam/runs/seed-$seed/forces.csv
done)
mean=$(awk -v a="$1" -v b="$2" -v c="$3" 'BEGIN { printf "%.9g", (a + b + c) / 3 }')
sd=$(awk -v a="$1" -v b="$2" -v c="$3" -v m="$mean" 'BEGIN {
    print sqrt(((a - m)^2 + (b - m)^2 + (c - m)^2) / 2) }')
holds "(a - b)^2 < 1e-12 * b^2" "$(value_of dam tank.ix end mean)" "$mean"
holds "a > 0 && (a - b)^2 < 1e-4 * b^2" "$(value_of dam tank.ix end sd)" "$sd"
holds "(a - b * 4.302653 / sqrt(3))^2 < 1e-4 * a^2" "$(value_of dam tank.ix end half)" "$sd"
holds "a < b && b < c" "$(value_of dam tank.ix end low)" "$(value_of dam tank.ix end mean)" \
    "$(value_of dam tank.ix end high)"
last=$(awk -F, '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == "tank.ix.sd") c = i; next }
    { x = $c } END { print x }' dam/spread-forces.csv)
holds "a == b" "$last" "$(value_of dam tank.ix end sd)"
# Apart at the start: even between -1e-3 and 1e-3 on two axes, sd 1e-3 sqrt(2/3).
holds "a > 0.7e-3 && a < 0.93e-3" "$(sed -n 3p dam/spread-positions.csv | cut -d, -f2)"
grep -q '"positions": 0,' dam/spread.json || complain "positions are not apart from the start"
grep -q '"seed-8": "done"' dam/spread.json || complain "spread.json lacks a run"

if command -v gnuplot >/dev/null; then
    for name in front forces probes positions; do
        [ -s dam/figures/spread-$name.png ] || complain "there is no spread-$name.png"
    done
    rm dam/figures/*.png
    "$STIFFWATER" plot dam >said 2>&1 || complain "the figures cannot be drawn again"
    says dam/figures/spread-forces.png
    [ ! -e dam/figures/front.png ] || complain "a figure of a single run"
fi

# --- again, with more runs; one that failed --------------------------------------------------------
stamp()
{
    find dam/runs -name run.json -exec ls --full-time {} + | awk '{ print $6, $7, $9 }' | sort
}
stamp >before
sed 's/^ended 0 0/ended 1 0/' dam/runs/seed-8/order >order && mv order dam/runs/seed-8/order
echo "stiffwater: the fluid has run away" >dam/runs/seed-8/said
# shellcheck disable=SC2086
expect 0 $dam --runs 4 --seed 7 --window 0.1,0.2 --size 1e-3 --share 1e-4 -o dam
says "3 of them from before" "seed-8 is left out: failed: the fluid has run away" \
    "3 of 4 runs came to their end; these are left out" "- seed-8: failed: the fluid has run away"
[ "$(stamp | comm -13 before - | wc -l)" = 1 ] || complain "what is there is run again"
[ "$(value_of dam tank.ix end runs)" = 3 ] || complain "a run that failed counts"
grep -q '"seed-8": "failed"' dam/spread.json || complain "spread.json does not know what failed"
# shellcheck disable=SC2086
expect 1 $dam --runs 2 --budget 0.001 -o late
says "0 of 2 runs came to their end, and a band needs two" "seed-1: stopped by the budget of 0.001 s"

# --- stopped, and on from there ----------------------------------------------------------------------
tried=$((tried + 1))
"$STIFFWATER" spread "$scenes/dam-break.scene" spacing=0.0125 --until 1 --runs 900 -o stopped \
    >said 2>&1 &
pid=$!
waited=0
until [ -s stopped/runs/seed-3/order ] || [ $waited = 300 ]; do
    sleep 0.1
    waited=$((waited + 1))
done
kill -s TERM $pid
wait $pid
found=$?
[ $found = 3 ] || complain "SIGTERM: exit status $found instead of 3"
says "stopped by signal 15" "of 900 runs came to their end" "- seed-900: not run"
[ -s stopped/spread.csv ] || complain "no table of what was there"

finish
