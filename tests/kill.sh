#!/bin/sh
# kill.sh -- a run that is killed again and again, at any moment, loses no more than what came
# after its last checkpoint, leaves whole files, and ends with the bits of one that was left alone.
#
#     KILLS=50 SEED=7 sh tests/kill.sh      so many kills (default: 5), at moments of this seed
#     KILLS=1000 UNTIL=6 SPAN=0.3 sh tests/kill.sh
#                      in a run of 6 s (default: 0.2), each within 0.3 s of the clock from its start
#                      (default: as long as all of them need to be most of the run)
. "${top_srcdir:-.}/tests/lib.sh"
KILLS=${KILLS:-5}
SEED=${SEED:-$$}
scene=$top_srcdir/tests/scenes/small-2d.scene
keys="until=${UNTIL:-0.2} output.interval=1e-3 output.fields=0.01 output.snapshots=5 output.checkpoint=2e-3
    beam.plate.E=1e6 beam.plate.theory=linear"
echo "kill: $KILLS kills, SEED=$SEED"

begun=$(date +%s.%N)
"$STIFFWATER" run "$scene" -q $keys -o "$out/whole"
ended=$(date +%s.%N)

# moment NUMBER: by default all of them together are most of the whole run [s]
moment() {
    awk -v seed="$SEED" -v n="$1" -v all="$(awk "BEGIN { print $ended - $begun }")" 'BEGIN {
        srand(seed); for (i = 0; i < n; i++) x = rand()
        print x * ('"${SPAN:-0}"' ? '"${SPAN:-0}"' : all * 1.8 / '"$KILLS"') }'
}

# kept DIRECTORY: time of the checkpoint from which a run would go on, "none" without one; asked
# of a copy, by an end that only a run that stands at its start can reach
kept() {
    rm -rf "$out/copy"
    [ ! -e "$1" ] || cp -r "$1" "$out/copy"
    if "$STIFFWATER" resume "$out/copy" until=1e-9 -q >"$out/said" 2>&1; then echo 0
    elif grep -q 'no checkpoint to go on from\|no run in there' "$out/said"; then echo none
    else sed -n 's/.*come to t = \([^ ]*\) s already.*/\1/p' "$out/said"; fi
}

# The table has a row for a checkpoint before the checkpoint is there: the last may be missing.
before_last() {
    awk -F, '/^[0-9]/ { before = last; last = $1 } END { print before + 0 }' "$1/checkpoints.csv"
}

begin() {
    if [ "$at" = none ]; then rm -rf "$out/dir"; set -- run "$scene" $keys -o "$out/dir"
    else set -- resume "$out/dir"; fi
    exec "$STIFFWATER" "$@" -q
}

at=none
early=0
kills=0
while [ $kills -lt "$KILLS" ]; do
    kills=$((kills + 1))
    begin >"$out/began" 2>&1 &
    pid=$!
    sleep "$(moment $kills)"
    kill -9 $pid 2>/dev/null || early=$((early + 1))
    wait $pid 2>/dev/null || :
    at=$(kept "$out/dir")
    if [ "$at" = none ]; then
        if [ -e "$out/dir/checkpoint.h5" ]; then wrong "kill $kills: $(cat "$out/said")"; fi
        continue
    fi
    [ -n "$at" ] || { wrong "kill $kills: $(cat "$out/said")"; break; }
    claim "kill $kills at t = $at s" "$at >= $(before_last "$out/dir")"
    found=$(torn "$out/dir")
    [ -z "$found" ] || wrong "kill $kills: torn: $found"
    [ "$(value dir status)" = running ] || [ "$(value dir status)" = done ] ||
        [ ! -e "$out/dir/run.json" ] || wrong "kill $kills: status $(value dir status)"
done
echo "kill: $early of $kills came after the end"

if [ "$at" = none ]; then "$STIFFWATER" run "$scene" -q $keys -o "$out/dir"
else "$STIFFWATER" resume "$out/dir" -q 2>"$out/said"; fi
rm -f "$out"/dir/*.part "$out"/dir/*/*.part
for directory in whole dir; do # without warnings: one may say that a kill fell between two renames
    sed '/"warnings": \[$/,/^  \]/d; /"warnings"/d' "$out/$directory/run.json" |
        grep -v '"cpu_s"\|"wall_s"\|"threads_mean"\|"peak_rss_kb"' >"$out/$directory.json"
done
if diff -r -q -x run.json -x 'checkpoint*.h5' "$out/whole" "$out/dir" &&
    diff "$out/whole.json" "$out/dir.json"; then good "all files are those of a run left alone"
else wrong "files differ from those of a run left alone"; fi
finish
