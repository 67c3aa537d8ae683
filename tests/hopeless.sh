#!/bin/sh
# hopeless.sh -- scenes that lead nowhere are told before they run, those that are well are not, and
# a refusal leaves no file; `check' says what effects and files cost.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
cd "$out" || exit 99
dam=$top_srcdir/data/scenes/dam-break.scene

# check NAME KEY=VALUE...: of the dam break
check() {
    name=$1
    shift
    "$STIFFWATER" check "$dam" spacing=0.01 "$@" >"$name.said" 2>&1
    code=$?
}

# warns NAME WORDS / still NAME: it does, it does not
still() {
    if grep -q warning "$1.said"; then wrong "$1 is quiet"; cat "$1.said"; else good "$1 is quiet"; fi
}

check well
still well
prints well 'output: about' 'shares of a right-hand side, measured' 'effects.pressure'
share=$(sed -n 's/^  effects.pressure *\(below\)* *\([0-9]*\) %/\2/p' well.said)
claim 'a share is one' "$share >= 2 && $share < 90"
check floor wall.tank=off
prints floor 'no wall lies below'
check flying wall.tank=off 'gravity=[0,0]'
still flying
check up 'gravity=[0,9.81]'
prints up 'gravity points up, along y'
"$STIFFWATER" check "$top_srcdir/data/scenes/dam-break-3d.scene" spacing=0.0555 'gravity=[0,-9.81,0]' \
    fluid.back.initial=rest fluid.front.initial=rest >side.said 2>&1
prints side 'gravity is along y, and in 3D z points up'
check slow eos.c0=4
prints slow 'Mach 0.5' 'eos.c0 = 20'
# In a wall; on its face; in a corner of faces; beside the water.
check inside probe.a.what=pressure 'probe.a.at=[0.2,-0.015]'
prints inside 'probe.a stands inside a solid'
check inside3 probe.a.what=pressure 'probe.a.at=[0.2,-0.02]'
prints inside3 'probe.a stands inside a solid'
for place in 0.2,0 0,0 0.3,0.1 0,0.05; do
    check "face-$place" probe.a.what=pressure "probe.a.at=[$place]"
    still "face-$place"
done

# --- the disk ---------------------------------------------------------------------------------
"$STIFFWATER" run "$dam" spacing=0.01 until=1000 output.interval=1e-8 -q -o large >large.said 2>&1
claim 'files that no disk holds are refused' "$? == 2"
prints large 'and the disk has' 'output.interval'
[ ! -e large ] && good 'before anything is written' || wrong 'before anything is written'

# estimate NAME SCENE KEY=VALUE...: what `check` tells is what the run leaves; steps.csv and figures aside
estimate() {
    name=$1
    shift
    "$STIFFWATER" check "$@" >"$name-check.said" 2>&1
    "$STIFFWATER" run "$@" -q -o "$name" >"$name.said" 2>&1
    told=$(sed -n 's/^output: about \([^ ]*\) MB.*/\1/p' "$name-check.said")
    files=$(sed -n 's/^output: about .* MB in \([0-9]*\) files.*/\1/p' "$name-check.said")
    rm -f "$name/steps.csv" && rm -rf "$name/figures"
    there=$(find "$name" -type f -exec cat {} + | wc -c)
    claim "$name: the estimate is right within a third" \
        "$told * 1e6 > 0.67 * $there && $told * 1e6 < 1.5 * $there"
    found=$(find "$name" -type f | wc -l)
    claim "$name: files, but for tables that it lacks" "$files >= $found && $files - $found < 15"
}
estimate some "$dam" spacing=0.005 until=0.05 output.fields=0.002
estimate bodies "$top_srcdir/data/scenes/floating-box.scene" until=0.004 output.fields=1e-4
estimate surfaces "$top_srcdir/data/scenes/flood-one-cube.scene" spacing=0.05 until=0.004 \
    output.fields=0.002 output.snapshots=9
estimate dry "$top_srcdir/data/scenes/block-heap.scene" until=0.01 output.fields=1e-3 output.snapshots=9

# --- tables with more columns than there can be -----------------------------------------------
{
    cat "$dam"
    echo 'panel = {'
    awk 'BEGIN { for (i = 0; i < 1700; i++) printf "p%d = { of = \"tank\"; };\n", i }'
    echo '};'
} >wide.scene
for command in check 'run -q -o wide'; do
    # shellcheck disable=SC2086 # words
    "$STIFFWATER" $command wide.scene spacing=0.01 >wide.said 2>&1
    claim "$command: 8,501 columns are refused" "$? == 2"
    prints wide 'panels.csv would have 8501 columns, more than 8192'
done
[ ! -e wide ] && good 'before anything is written' || wrong 'before anything is written'

# --- a start without a right-hand side --------------------------------------------------------
"$STIFFWATER" run "$top_srcdir/data/scenes/still-water.scene" eos.c0=4 eos.highest=1.02 -q -o dense \
    >dense.said 2>&1
claim 'a start that has no answer is refused' "$? == 1"
prints dense 'the start has no right-hand side' 'particle 0' 'nothing was written' 'eos.highest'
[ ! -e dense ] && good 'before anything is written' || wrong 'before anything is written'

# --- a scene through a pipe -------------------------------------------------------------------
"$STIFFWATER" run - until=0.01 spacing=0.01 -q -o piped <"$dam" >piped.said 2>&1
claim 'a scene from standard input' "$? == 0"
"$STIFFWATER" run "$dam" until=0.01 spacing=0.01 -q -o file >file.said 2>&1
[ "$(value piped state_hash)" = "$(value file state_hash)" ] && good 'has the same bits' ||
    wrong 'has the same bits'
sed 's/^/ /' "$dam" | "$STIFFWATER" check - >piped.said 2>&1
claim 'through a pipe' "$? == 0"
finish
