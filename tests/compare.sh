#!/bin/sh
# compare.sh -- `stiffwater compare' keeps its word: a row for each run, those that failed, were
# refused or stopped included; errors that shrink with the tolerance; what is there is not run
# again; a signal leaves a table.  Run by `make check'.
scenes=${top_srcdir:-.}/data/scenes
ask=compare
. "${top_srcdir:-.}/tests/lib.sh"
asking

# field DIR METHOD TOL COLUMN [MORE]: of the row, whose end holds MORE
field()
{
    awk -F, -v method="$2" -v tol="$3" -v wanted="$4" -v more="$5" '
        /^#/ { next }
        !column { for (i = 1; i <= NF; i++) if ($i == wanted) column = i; next }
        $1 == method && $2 == tol && index($0, more) { print $column }' "$1/compare.csv"
}

# row DIR METHOD TOL COLUMN WORD [MORE]
row()
{
    seen=$(field "$1" "$2" "$3" "$4" "$6")
    [ "$seen" = "$5" ] || complain "$1: $4 of $2 $3 is \"$seen\" instead of \"$5\""
}

# holds CONDITION NUMBER...: awk's condition of a, b, c
holds()
{
    awk -v a="$2" -v b="$3" -v c="$4" "BEGIN { exit !(a != \"\" && a == a + 0 && ($1)) }" ||
        complain "$what: $1 does not hold for a = $2, b = $3, c = $4"
}

# drawn DIR NAME...: these figures are there, and no others.
drawn()
{
    command -v gnuplot >/dev/null || return 0
    ls "$1"/figures/*.png >there
    from=$1
    shift
    for name in "$@"; do echo "$from/figures/$name.png"; done | sort | cmp -s - there ||
        complain "other figures than $*: $(cat there)"
}

dam="$scenes/dam-break.scene spacing=0.0125 --until 0.1"

# --- mistakes -------------------------------------------------------------------------------
# shellcheck disable=SC2086 # scene and keys are words
{
expect 2 $dam
says --methods
expect 2 $dam --methods cks44 -o wrong
says cks44 cks43
expect 2 $dam --methods cks43@0.1 -o wrong
expect 2 $dam --methods cks43,,dv -o wrong
says --methods
expect 2 $dam --methods cks43 --tols 1e-2,none -o wrong
says none
expect 2 $dam --methods cks43 --sweep spacing -o wrong
says spacing KEY=VALUE
expect 2 $dam --methods cks43 --reference bs54 -o wrong
says METHOD:TOL
expect 2 $dam --methods cks43 --repeat 0 -o wrong
expect 2 $dam --methods cks43 --budget none -o wrong
expect 2 $dam --methods cks43 --sweep tol=1,2 -o wrong
says tol=1,2 --tols
expect 2 $dam --methods cks43 method=dv -o wrong
says method=dv --methods
expect 2 $dam --methods cks43 output.fields=0.1 -o wrong
says output.fields
expect 2 $dam --methods cks43 --early 100 -o wrong
says "--early 100" "end at 0.1 s"
expect 2 no-such.scene --methods cks43 -o wrong
says no-such.scene
[ ! -e wrong ] || complain "a mistake leaves a directory"
expect 2 $dam --methods cks43 --tols 1e-2 fluid.dey=1 -o refused
says dey dye
expect 2 $dam --methods cks43 --tols 1e-2 --sweep spacing=0.0125,0.024 -o refused
says spacing=0.024
[ -z "$(find refused -name run.json)" ] || complain "a scene is run before all are checked"

# --- a dam break ------------------------------------------------------------------------------
expect 0 $dam --methods cks43,leapfrog@0.25,leapfrog@0.025,leapfrog@4 --tols 1e-1,1e-5,20 --jobs 2 \
    --reference bs54:1e-07 --repeat 3 --growth -o dam
}
says "CPU time; error at most | position | front | impulse | force | energy [J/m] |" \
    "pair passes; error at most |" "cks43 1e-5" "4 of 6 runs came to their end" \
    "| leapfrog@4 | failed | the fluid has run away" "| cks43 20 | refused | "
head -n 1 dam/compare.csv | grep -q '^# units: ' || complain "compare.csv has no line of units"
columns=method,tol,status,cpu_s,cpu_spread,wall_s,steps,rejected,rhs_explicit,rhs_implicit
columns=$columns,pair_passes,h_mean,error_position,error_front,error_tip,error_body,error_impulse,error_force,error_probe,energy_defect
sed -n 2p dam/compare.csv | grep -q -x "$columns,t_end,run,reference,message" || complain "compare.csv has other columns"
[ "$(wc -l <dam/compare.csv)" = 8 ] || complain "compare.csv has not a row for each run"
row dam cks43 1e-1 status "done"
row dam cks43 1e-5 status "done"
row dam leapfrog@0.25 nan status "done"
row dam leapfrog@4 nan status failed
row dam leapfrog@4 nan error_front nan
row dam cks43 20 status refused
row dam cks43 1e-1 error_tip nan
row dam cks43 1e-1 t_end 0.1
row dam leapfrog@0.025 nan run leapfrog@0.025
[ -d "dam/runs/$(field dam cks43 1e-1 run)" ] || complain "the column run names no directory"
holds "a > 0 && a < 0.1" "$(field dam leapfrog@4 nan t_end)"
grep '^leapfrog@4,' dam/compare.csv | grep -q 'particle' || complain "no reason why it failed"
grep '^cks43,20,' dam/compare.csv | grep -q 'tol' || complain "no reason why it was refused"
for quantity in position front impulse; do
    holds "a > 0 && a < 1e-2 && b < a / 10 && b > 0" "$(field dam cks43 1e-1 error_$quantity)" \
        "$(field dam cks43 1e-5 error_$quantity)"
    holds "a > 0 && a < 1e-2 && b < a / 10 && b > 0" \
        "$(field dam leapfrog@0.25 nan error_$quantity)" \
        "$(field dam leapfrog@0.025 nan error_$quantity)"
done
holds "a > 0 && b > 0 && c >= a / 2" "$(field dam cks43 1e-1 cpu_s)" \
    "$(field dam cks43 1e-1 cpu_spread)" "$(field dam cks43 1e-1 wall_s)"
holds "a > 0 && b >= 4 * a && b < 4 * a + 4 && c == b" "$(field dam cks43 1e-1 steps)" \
    "$(field dam cks43 1e-1 rhs_explicit)" "$(field dam cks43 1e-1 pair_passes)"
[ -d dam/runs/cks43-1e-1-3 ] || complain "there are no three runs"
[ ! -e dam/runs/leapfrog@4-2 ] || [ ! -e dam/runs/leapfrog@4-2/run.json ] ||
    complain "what failed is repeated"
for word in '"reference_method": "bs54"' '"reference_tol": "1e-07"' '"reference_status": "done"' \
    '"early": ' '"growth_rate": ' '"positions_until": 0'; do
    grep -q -F -e "$word" dam/compare.json || complain "compare.json lacks $word"
done
grep -q -x 'gravity=\[9.8.*e-06,-9.8.*\]' dam/runs/disturbed-*/order || complain "gravity is not tilted"
cmp -s dam/compare.md /dev/null && complain "compare.md is empty"
if command -v gnuplot >/dev/null; then
    drawn dam work-precision work-precision-position work-precision-front \
        work-precision-impulse work-precision-force work-precision-energy step-lengths
    rm -f dam/figures/*.png
    echo old >dam/figures/work-precision-tip.png
    figure=dam/figures/work-precision-position.png
    "$STIFFWATER" plot dam >said 2>&1 || complain "the figures cannot be drawn again"
    says dam/figures/work-precision-energy.png
    [ -s $figure ] || complain "a figure is not drawn again"
    [ -s dam/figures/work-precision-tip.png ] || complain "plot takes away what it did not draw"
    rm dam/figures/work-precision-tip.png
    drawn dam work-precision work-precision-position work-precision-front \
        work-precision-impulse work-precision-force work-precision-energy step-lengths
fi

# The error is that of the files: front of a run and of the reference, by awk.
front=$(paste -d, dam/runs/cks43-1e-1/front.csv dam/runs/reference-bs54-1e-07/front.csv | awk -F, '
    /^[#t]/ { next }
    !n { first = $5 }
    { n++; sum += ($2 - $5) ^ 2; far = $5 - first; if (far ^ 2 > most) most = far ^ 2 }
    END { print sqrt(sum / n / most) }')
holds "(a / b - 1) ^ 2 < 1e-8" "$(field dam cks43 1e-1 error_front)" "$front"

# --- again: nothing is run twice ----------------------------------------------------------------
stamp()
{
    find dam/runs -name run.json -exec ls --full-time {} + | awk '{ print $6, $7, $9 }' | sort
}
stamp >before
cp dam/compare.csv before.csv
# shellcheck disable=SC2086
expect 0 $dam --methods cks43,leapfrog@0.25,leapfrog@0.025,leapfrog@4 --tols 1e-1,1e-5,20 --jobs 2 \
    --reference bs54:1e-07 --repeat 3 --growth -o dam
says "from before"
stamp | cmp -s before - || complain "what is there is run again"
cmp -s before.csv dam/compare.csv || complain "the same runs give another table"
rm dam/runs/cks43-1e-1/order
# shellcheck disable=SC2086
expect 0 $dam --methods cks43,dv --tols 1e-1 --reference bs54:1e-07 -o dam
[ "$(stamp | comm -13 before - | wc -l)" = 2 ] || complain "what is missing is not run, or more"
row dam dv 1e-1 status "done"

# One letter in a setting, or in a file that the scene includes, makes another run.
# defect_of WORD ...: the energy defect of cks43 at 1e-1, into the file `differ'
defect_of()
{
    expect 0 "$@" --methods cks43 --tols 1e-1 -q -o other
    field other cks43 1e-1 energy_defect >>differ
}
# shellcheck disable=SC2086
{
defect_of $dam "fluid.velocity=[0.1,0]"
defect_of $dam "fluid.velocity=[0.2,0]"
}
sed 's/^spacing.*/@include "part.scene"/' "$scenes/dam-break.scene" >local.scene
for spacing in 0.0125 0.0250; do
    echo "spacing = $spacing;" >part.scene
    defect_of local.scene --until 0.1
done
[ "$(sort -u differ | wc -l)" = 4 ] || complain "another scene takes what was there: $(cat differ)"

# --- steps of one length: no tolerance, whether the method has an estimate or not ----------------
# shellcheck disable=SC2086
expect 0 $dam --methods cks43@2e-4s,leapfrog@5e-5s --tols 1e-1,1e-2 --reference bs54:1e-07 -o dam
[ "$(wc -l <dam/compare.csv)" = 4 ] || complain "fixed steps: not a row each"
row dam cks43@2e-4s nan status "done"
row dam leapfrog@5e-5s nan status "done"
holds "a == 500 && b == 2000" "$(field dam cks43@2e-4s nan steps)" \
    "$(field dam leapfrog@5e-5s nan steps)"

# --- each method against its own run with the least spacing ------------------------------------
# shellcheck disable=SC2086
{
expect 2 $dam --methods cks43 --reference finest -o wrong
says "--reference finest" "--sweep spacing"
expect 2 $dam --methods cks43 --reference finest --sweep spacing=0.02,0.01 --growth -o wrong
says --growth
expect 2 $dam --methods cks43 --reference finest --sweep spacing=0.02,0.01 fluid.dey=1 -o other
says dey dye
expect 0 $dam --methods cks43,leapfrog@0.25 --tols 1e-2 --reference finest \
    --sweep spacing=0.05,0.025,0.0125 --sweep eos.c0=20,30 --jobs 2 -o space
}
says "eos.c0=30" "CPU time; error at most | front | impulse | force |" "0.025 m" \
    "Each run stands against that of its method with the least spacing."
[ "$(wc -l <space/compare.csv)" = 14 ] || complain "not a row for each run of each spacing"
row space leapfrog@0.25 nan reference leapfrog@0.25-spacing=0.0125_eos.c0=30 ",0.05,30,"
grep -q '"reference_method": "finest"' space/compare.json || complain "compare.json has another reference"
drawn space work-precision work-precision-front work-precision-impulse work-precision-force \
    work-precision-energy step-lengths cost-against-spacing cost-against-eos.c0

# --- a budget, and a row for what it stops --------------------------------------------------------
expect 0 "$scenes/dam-break.scene" spacing=0.025 --until 0.02 --methods leapfrog@0.000001,cks43 \
    --tols 1e-1 --budget 2 -q -o budget
row budget leapfrog@0.000001 nan status stopped
row budget cks43 1e-1 status "done"
grep -q '^leapfrog.*"stopped by the budget of 2 s at t = .* s of 0.02 s"$' budget/compare.csv ||
    complain "no word of the budget"
grep -q "running\|error at most" said && complain "quiet, it talks"
expect 0 "$scenes/dam-break.scene" spacing=0.025 --until 0.02 --methods leapfrog@0.000001 \
    --budget 0.001 -o budget
row budget leapfrog@0.000001 nan status stopped

# --- swept keys, a beam -------------------------------------------------
expect 0 "$scenes/beam-alone.scene" --until 5e-3 output.interval=5e-4 --methods imex3 \
    --tols 1e-2,1e-5 --sweep beam.E=5e8,1e9 --sweep beam.elements=10,12 --jobs 2 -o beam
[ "$(wc -l <beam/compare.csv)" = 10 ] || complain "two swept keys: not 2 x 4 rows"
sed -n 2p beam/compare.csv | grep -q ',beam.E,beam.elements,t_end,run,reference,message$' || complain "no swept columns"
row beam imex3 1e-5 status "done" ,1e9,12,
row beam imex3 1e-5 error_position nan ,1e9,12,
holds "a > 0 && a < 1 && b < a / 10" "$(field beam imex3 1e-2 error_tip ,5e8,10,)" \
    "$(field beam imex3 1e-5 error_tip ,5e8,10,)"
grep -q "could not draw" said && complain "a figure of the beam's runs is not drawn"
drawn beam cost-against-beam.E cost-against-beam.elements step-lengths work-precision \
    work-precision-energy work-precision-tip
grep -q '"reference_method": "imex4"' beam/compare.json || complain "another reference with a beam"

# --- rigid bodies -----------------------------------------------------------------------------------
expect 0 "$scenes/../../tests/scenes/falling-cube.scene" --until 0.2 output.interval=5e-3 --methods erk4 --tols 1e-2,1e-4 \
    --reference erk4:1e-6 -o cube
holds "a > 0 && a < 1e-1 && b < a / 10" "$(field cube erk4 1e-2 error_body)" "$(field cube erk4 1e-4 error_body)"
drawn cube step-lengths work-precision work-precision-body work-precision-energy

# --- stopped, and on from there ----------------------------------------------------------------------
for signal in INT TERM; do
    tried=$((tried + 1))
    rm -f stopped/runs/leapfrog@0.000001/steps.csv
    env --default-signal=INT "$STIFFWATER" compare "$scenes/dam-break.scene" spacing=0.025 \
        --until 0.02 --methods cks43,leapfrog@0.000001 --tols 1e-1 -o stopped >said 2>&1 &
    pid=$!
    waited=0
    until grep -q -s '^cks43' stopped/compare.csv && [ -s stopped/runs/leapfrog@0.000001/steps.csv ] ||
        [ $waited = 200 ]; do
        sleep 0.1
        waited=$((waited + 1))
    done
    kill -s $signal $pid
    wait $pid
    found=$?
    what="SIG$signal"
    [ $found = 3 ] || complain "SIG$signal: exit status $found instead of 3"
    row stopped cks43 1e-1 status "done"
    [ -z "$(field stopped leapfrog@0.000001 nan status)" ] || complain "a row of what was stopped"
    grep -q '"status": "stopped"' stopped/runs/leapfrog@0.000001/run.json ||
        complain "SIG$signal: the run was not stopped in order"
done
grep -q "3 of them\|1 of them" said || complain "what was done is done again"

# --- accidents ------------------------------------------------------------------------------------
# begin DIR: a comparison of a run that takes for ever, in the background, when it is at it
begin()
{
    tried=$((tried + 1))
    "$STIFFWATER" compare "$scenes/dam-break.scene" spacing=0.025 --until 0.02 \
        --methods leapfrog@0.000001 -q -o "$1" >said 2>&1 &
    pid=$!
    waited=0
    until [ -s "$1/runs/leapfrog@0.000001/steps.csv" ] || [ $waited = 200 ]; do
        sleep 0.1
        waited=$((waited + 1))
    done
    child=$(cat /proc/$pid/task/$pid/children)
    child=${child% }
}

begin killed
kill -KILL "$child"
wait $pid
row killed leapfrog@0.000001 nan status failed
grep -q 'ended by signal 9' killed/compare.csv || complain "no word of the signal"
expect 0 "$scenes/dam-break.scene" spacing=0.025 --until 0.02 --methods leapfrog@0.000001 -q \
    --budget 1 -o killed
row killed leapfrog@0.000001 nan status stopped

# A comparison that is killed leaves no run behind.
begin orphan
kill -KILL $pid
wait $pid 2>/dev/null
waited=0
while [ -e "/proc/$child" ] && [ $waited -lt 100 ]; do
    sleep 0.1
    waited=$((waited + 1))
done
[ ! -e "/proc/$child" ] || complain "a run goes on without its comparison"
kill -KILL "$child" 2>/dev/null
grep -q '"status": "stopped"' orphan/runs/leapfrog@0.000001/run.json || complain "it did not end in order"

# --- repeats run in turns, and what is missing of them is made up for -------------------------
# shellcheck disable=SC2086
expect 0 $dam -u 0.01 --methods cks43,dv --tols 1e-1 --repeat 3 -o turns
turns=$(cd turns/runs && ls -d --sort=time --time-style=full-iso -r */scene.used | grep -v '^reference\|^check' |
    sed 's/-1e-1//; s,/.*,,' | tr '\n' ' ')
tried=$((tried + 1))
[ "$turns" = 'cks43 dv cks43-2 dv-2 cks43-3 dv-3 ' ] || complain "repeats run as $turns"
median()
{
    for run in turns/runs/dv-1e-1 turns/runs/dv-1e-1-2 turns/runs/dv-1e-1-3; do
        sed -n 's/.*"cpu_s": \([^,]*\),*/\1/p' $run/run.json
    done | sort -g | sed -n 2p
}
holds "(a / b - 1) ^ 2 < 1e-10" "$(field turns dv 1e-1 cpu_s)" "$(median)"
rm turns/runs/dv-1e-1-2/order
(cd turns && find runs -name run.json -exec ls --full-time {} + | sort >../before)
# shellcheck disable=SC2086
expect 0 $dam -u 0.01 --methods cks43,dv --tols 1e-1 --repeat 3 -o turns
(cd turns && find runs -name run.json -exec ls --full-time {} + | sort >../after)
tried=$((tried + 1))
[ "$(comm -13 before after | sed 's/.* //')" = runs/dv-1e-1-2/run.json ] ||
    complain "other runs than the one that is missing: $(comm -13 before after)"
holds "(a / b - 1) ^ 2 < 1e-10" "$(field turns dv 1e-1 cpu_s)" "$(median)"

# --- pressures of all kinds ------------------------------------------------------------------
# shellcheck disable=SC2086 # scene and keys are words
expect 0 $dam --until 0.05 walls=own-density --methods cks43,pcisph,mps --tols 1e-2 \
    --sweep eos.type=tait,look-ahead -o pressures
for eos in tait look-ahead; do
    row pressures cks43 1e-2 status done "eos.type=$eos"
    for method in pcisph mps; do row pressures $method nan status done "eos.type=$eos"; done
done
! grep -q 'could not draw' said || complain "$what: a figure that cannot be drawn"
drawn pressures step-lengths work-precision work-precision-energy work-precision-force \
    work-precision-front work-precision-impulse work-precision-position
holds 'a < b' "$(field pressures cks43 1e-2 error_front eos.type=tait)" \
    "$(field pressures mps nan error_front eos.type=tait)"
finish
