#!/bin/sh
# resume-all.sh -- runs of every method, and of each kind of scene, that are killed in their middle
# by `kill -9' go on from a checkpoint and end with the hash and the tables of one left alone.
#
#     METHODS='cks43 mri' SCENES=no sh tests/resume-all.sh      these methods alone
#
# A run is killed as soon as it has written its fourth checkpoint of ten; one that was faster than
# the look at its directory is made again, twice as long.
. "${top_srcdir:-.}/tests/lib.sh"
scenes=$top_srcdir/data/scenes
small=$top_srcdir/tests/scenes
METHODS=${METHODS:-$("$STIFFWATER" list methods | awk '{ print $1 }')}
served=0  # methods
cut=0     # runs that were killed and went on
refused=0 # pairs of a method and a scene that it does not serve

# a box in the way of water in three dimensions
sed 's/^wall = .*/wall = { tank = { type = "frame"; };\
    rock = { type = "box"; from = [0.14, 0.02, 0.0]; to = [0.18, 0.08, 0.06]; }; };/' \
    "$small/small-3d.scene" >"$out/obstacle.scene"

# kept DIRECTORY: time of the checkpoint from which a copy of it would go on
kept() {
    rm -rf "$out/copy"
    cp -r "$1" "$out/copy"
    "$STIFFWATER" resume "$out/copy" until=1e-9 -q >"$out/said" 2>&1 || :
    sed -n 's/.*come to t = \([^ ]*\) s already.*/\1/p' "$out/said"
}

# late AT UNTIL: a busy machine looked away until the run was nearly over
late() { awk -v at="$1" -v end="$2" 'BEGIN { exit !(at >= 0.9 * end) }'; }

rows() { if [ -e "$1" ]; then grep -c '^[0-9]' "$1" || :; else echo 0; fi; }

# cut FILE UNTIL KEY=VALUE...: a run killed at its fourth checkpoint; fails when it came to its end
cut_off() {
    file=$1 until=$2
    shift 2
    rm -rf "$out/parts"
    "$STIFFWATER" run "$file" -q until="$until" output.checkpoint="$every" -o "$out/parts" "$@" \
        >"$out/said" 2>&1 &
    pid=$!
    while [ "$(rows "$out/parts/checkpoints.csv")" -lt 5 ] && kill -0 $pid 2>/dev/null; do :; done
    if kill -9 $pid 2>/dev/null; then wait $pid 2>/dev/null || :; return 0; fi
    wait $pid 2>/dev/null && return 1
    return 2
}

# same WORDS UNTIL: hashes and tables
same() {
    for table in "$out"/whole/*.csv; do
        cmp -s "$table" "$out/parts/$(basename "$table")" ||
            { wrong "$1: $(basename "$table") differs"; return; }
    done
    claim "$1, killed, gone on from $at of $2 s" \
        "\"$(hash parts)\" == \"$(hash whole)\" && \"$(hash whole)\" != \"\" && $at > 0 && $at < 0.9 * $2"
}

# again WORDS FILE UNTIL KEY=VALUE...; $code 2: refused, and nothing was run
again() {
    words=$1 from=$2 end=$3
    shift 3
    for longer in 1 2 4 8 16; do
        until=$(awk "BEGIN { print $longer * $end }")
        every=$(awk "BEGIN { print $until / 10 }")
        code=0
        cut_off "$from" "$until" "$@" || code=$?
        [ $code != 0 ] || at=$(kept "$out/parts")
        if [ $code = 0 ] && late "$at" "$until"; then code=1; fi
        [ $code = 1 ] || break
    done
    if [ $code != 0 ]; then
        grep -q 'cannot serve\|Cause\|methods that do' "$out/said" || cat "$out/said"
        return
    fi
    "$STIFFWATER" resume "$out/parts" -q >"$out/said" 2>&1 &&
        "$STIFFWATER" run "$from" -q until="$until" output.checkpoint="$every" -o "$out/whole" "$@" \
            >"$out/said" 2>&1 || { wrong "$words: $(cat "$out/said")"; return; }
    cut=$((cut + 1))
    same "$words" "$until"
    rm -rf "$out/whole"
}

# --- every method ---------------------------------------------------------------------------
# with METHOD FILE UNTIL KEY=VALUE...: where the method serves the scene
with() {
    method=$1 of=$2 length=$3
    shift 3
    again "$method, $(basename "$of" .scene) $*" "$of" "$length" method="$method" "$@"
    if [ $code = 0 ]; then serves=yes; else refused=$((refused + 1)); fi
}

for method in $METHODS; do
    serves=
    with "$method" "$small/small-2d.scene" 0.04 beam.plate.E=1e5
    with "$method" "$out/obstacle.scene" 0.08
    [ -n "$serves" ] || with "$method" "$small/small-2d.scene" 0.04 walls=own-density beam.plate=off
    [ -n "$serves" ] || with "$method" "$small/block-falls.scene" 0.3
    [ -n "$serves" ] || with "$method" "$scenes/beam-alone.scene" 0.02
    if [ -n "$serves" ]; then served=$((served + 1)); else wrong "no scene for $method: $(cat "$out/said")"; fi
done

# --- each kind of scene ---------------------------------------------------------------------
if [ "${SCENES:-yes}" = yes ]; then
    viscous='effects.laminar-viscosity.mu=5 effects.laminar-viscosity.side=implicit'
    again 'a beam in two dimensions' "$scenes/soft-gate.scene" 0.05
    again 'implicit viscosity with a beam' "$small/small-2d.scene" 0.02 $viscous
    again 'implicit viscosity in 3D' "$out/obstacle.scene" 0.04 $viscous
    again 'bodies that float' "$scenes/floating-box.scene" 0.2
    again 'bodies with contacts' "$scenes/block-heap.scene" 0.4
    again 'bodies with joints and springs' "$small/driven-flap.scene" 0.2
    again 'a body in 3D' "$small/falling-cube.scene" 0.2
    again 'mps' "$scenes/mps-dam-break.scene" 0.1 spacing=7.3e-3
    again 'mps in 3D' "$out/obstacle.scene" 0.1 method=mps walls=own-density
    again 'pcisph in 3D' "$out/obstacle.scene" 0.1 method=pcisph walls=own-density
    again 'pcisph with a beam' "$small/small-2d.scene" 0.04 method=pcisph walls=own-density
    again 'mri with a beam' "$small/small-2d.scene" 0.04 method=mri
    again 'mri-rigid' "$small/block-falls.scene" 0.3 method=mri-rigid body.block.softness=0.003
    again 'pressure ahead' "$small/small-2d.scene" 0.04 eos.type=look-ahead walls=own-density
    again 'an elastica' "$small/small-2d.scene" 0.04 beam.plate.theory=elastica beam.plate.E=1e6
    again 'a pendulum gate' "$scenes/pendulum-gate.scene" 0.1
    again 'pairs in single precision' "$small/small-2d.scene" 0.04 precision=single
    again 'filtered densities' "$out/obstacle.scene" 0.08 effects.shepard-filter.steps=5
fi
echo "resume-all: $cut runs were killed and went on, $served methods, $refused times a method did not serve a scene"
finish
